import type { LineId } from '../figures/types';
import { asUsedMs } from '../table/rows';
import { type MeshMethod, residualOn } from './meshes';
import type { Studies } from './studies';
import type { Claim, Evidence } from './types';
import { NotMeasured } from './types';
import { middle, ms, num, percent, sum } from './words';

/** The number of samples that each method loses, over all panels that show all these methods. */
function lostOf(evidence: Evidence, ids: readonly LineId[]) {
  const panels = evidence.panelsWith(...ids);
  return ids.map((id) => {
    const lines = panels.map((panel) => evidence.lost(panel, id));
    return {
      lost: sum(lines.map(({ lost }) => lost)),
      own: sum(lines.map(({ own }) => own)),
      samples: sum(lines.map(({ samples }) => samples)),
    };
  });
}

/**
 * The panels in which the first method has a smaller residual than the second (`won`), and those in
 * which it has a larger one (`lost`). A failed method has an infinite residual. Panels with equal
 * residuals are in neither list.
 */
export function nearer(evidence: Evidence, first: LineId, second: LineId) {
  const panels = evidence.panelsWith(first, second);
  const residual = (panel: string, id: LineId) => {
    const { ok, ruler } = evidence.line(panel, id);
    return ok ? (ruler?.residual?.median ?? null) : Number.POSITIVE_INFINITY;
  };
  const measured = panels.flatMap((name) => {
    const [one, other] = [residual(name, first), residual(name, second)];
    return one === null || other === null ? [] : [{ name, one, other }];
  });
  if (measured.length === 0) throw new NotMeasured(`residuals of ${first} and ${second}`);
  return {
    won: measured.filter(({ one, other }) => one < other).map(({ name }) => name),
    lost: measured.filter(({ one, other }) => one > other).map(({ name }) => name),
    of: measured.length,
  };
}

/**
 * The paper's time divided by the time of weighted averages, for each curve with its fields: in the
 * figures and in Table 1.
 */
function slowerThanAverages(evidence: Evidence) {
  const isWhole = (panel: string) =>
    (['paper', 'weightedAverages'] as const).every((id) => evidence.line(panel, id).ok);
  const panels = evidence.panelsWith('paper', 'weightedAverages').filter(isWhole);
  const inFigures = panels.flatMap((panel) => {
    const averages = evidence.traceMs(panel, 'weightedAverages');
    return averages > 0 ? [evidence.traceMs(panel, 'paper') / averages] : [];
  });
  if (inFigures.length === 0) throw new NotMeasured('times of both');
  const cells = evidence.all.table.filter(({ segments, result }) => segments > 1 && result.ok);
  const inTable = cells.flatMap(({ row, method, result }) => {
    if (method !== 'paper') return [];
    const other = cells.find((cell) => cell.row === row && cell.method === 'weightedAverages');
    return result.traceMs && other?.result.traceMs ? [result.traceMs / other.result.traceMs] : [];
  });
  return { inFigures, inTable };
}

/**
 * The comparison of `nearer` on the meshes of a folder. It compares the paper's method, with graph
 * and with exact distances, to weighted averages. Without a folder there are no cases.
 */
function nearerOnMeshes({ all: { meshes } }: Evidence) {
  const shown = (meshes ?? []).flatMap((mesh) => {
    const residuals = meshMethodsShown.map(([method]) => residualOn(mesh, method));
    const [paper, exact, averages] = residuals;
    if (residuals.includes(null)) return [];
    const name = mesh.name.replace(/\.obj$/, '');
    return [{ name, residuals, cases: [paper! < averages!, exact! < averages!] }];
  });
  const cases = shown.flatMap(({ cases }) => cases);
  const failed = (value: number | null) =>
    value === Number.POSITIVE_INFINITY ? 'failed' : num(value);
  const list = shown.map(({ name, residuals }) => `${name} ${residuals.map(failed).join(', ')}`);
  const names = shown.filter(({ cases }) => !cases.some(Boolean)).map(({ name }) => name);
  const methods = meshMethodsShown.map(([, name]) => name).join(', ');
  return {
    won: cases.filter(Boolean).length,
    of: cases.length,
    measured:
      shown.length === 0
        ? ''
        : ` On meshes that are not the project’s weighted averages are nearer than the paper’s method both ways on ${names.join(', ') || 'none'}; residuals in h of ${methods}: ${list.join('; ')}.`,
  };
}

const meshMethodsShown = [
  ['paper', 'the paper with k = 6'],
  ['paperExact', 'with exact distances'],
  ['weightedAverages', 'weighted averages'],
  ['karcher', 'ours'],
  ['leveled', 'our default'],
  ['bSurf', 'b/Surf'],
] as const satisfies readonly [MeshMethod, string][];

/** The largest ratio of times that counts as 'slightly slower'. */
const slightly = 2;

/** The slope of a line fitted to the logarithm of time over the logarithm of triangles. */
function growth(points: readonly [number, number][]): number {
  if (points.length < 2) throw new NotMeasured('two sizes');
  const logs = points.map(([x, y]) => [Math.log(x), Math.log(y)] as const);
  const mean = (k: 0 | 1) => sum(logs.map((one) => one[k])) / logs.length;
  const [mx, my] = [mean(0), mean(1)];
  return sum(logs.map(([x, y]) => (x - mx) * (y - my))) / sum(logs.map(([x]) => (x - mx) ** 2));
}

const growthMethods = [
  ['vectorHeat', 'vector heat'],
  ['weightedAverages', 'weighted averages'],
  ['paper', 'the paper'],
  ['karcher', 'ours'],
  ['leveled', 'our default'],
] as const;

/**
 * Compares the growth of the paper's time with the growth of another method's time, over the sizes
 * at which neither method failed. An empty list if fewer than two sizes remain.
 */
function comparedGrowth(rows: Studies['growth'], method: 'vectorHeat' | 'weightedAverages') {
  const timesOf = (id: string) =>
    new Map(
      rows.flatMap((row) =>
        row.method === id && row.ms !== null ? [[row.triangles, row.ms]] : [],
      ),
    );
  const [own, other] = [timesOf('paper'), timesOf(method)];
  const shared = [...own.keys()].filter((triangles) => other.has(triangles));
  if (shared.length < 2) return [];
  const slopeOf = (times: Map<number, number>) =>
    growth(shared.map((triangles): [number, number] => [triangles, times.get(triangles)!]));
  const [paper, slope] = [slopeOf(own), slopeOf(other)];
  const largest = Math.max(...shared);
  const grows = paper < slope;
  const shorter = own.get(largest)! < other.get(largest)!;
  const name = growthMethods.find(([id]) => id === method)![1];
  const result = grows && shorter ? 'holds' : grows || shorter ? 'depends' : 'does not';
  const words = {
    holds: 'it holds',
    depends: grows
      ? 'it grows more slowly, but takes longer'
      : 'it is quicker at these sizes, but does not grow more slowly',
    'does not': 'it does not',
  }[result];
  return [{ name, paper, slope, result, words }];
}

/** Two radii count as not far from each other if their ratio is at most this. */
const farTimes = 2;

const surfaceOf = ({ surface, noise }: Studies['radius'][number]) =>
  noise > 0 ? `${surface} with bumps of ${num(noise)} h` : `smooth ${surface}`;

/** The largest number of iterations that counts as few. */
const fewSteps = 10;

type NewtonSum = 'searches' | 'converged' | 'traced' | 'shortened' | 'needed' | 'stuck' | 'inside';

/** The claims of the abstract, the introduction and sections 2 to 4. */
export const methodClaims: readonly Claim[] = [
  {
    id: 'against-vector-heat',
    where: 'Abstract, 1',
    claim: 'More stable than the vector heat method, and faster by several orders of magnitude.',
    figure: 'table',
    judge(evidence) {
      const [heat, paper] = lostOf(evidence, ['vectorHeat', 'paper']) as [
        ReturnType<typeof lostOf>[0],
        ReturnType<typeof lostOf>[0],
      ];
      const pairs = evidence.cells('vectorHeat').flatMap((cell) => {
        const own = evidence.cells('paper').find(({ row }) => row === cell.row);
        const { traceMs } = cell.result;
        const used = asUsedMs(cell.result);
        if (!cell.result.ok || !own?.result.ok) return [];
        if (!own.result.traceMs || !traceMs || used === null) return [];
        return [{ kept: traceMs / own.result.traceMs, used: used / own.result.traceMs }];
      });
      if (pairs.length === 0) throw new NotMeasured('times of both');
      const used = Math.min(...pairs.map((one) => one.used));
      const kept = Math.max(...pairs.map((one) => one.kept));
      const measured = `In the figures vector heat loses ${heat.lost} of ${heat.samples} samples (by its library’s rule ${heat.own}), the paper’s method ${paper.lost} of ${paper.samples}. In Table 1 vector heat takes at least ${num(used)} times as long where a log map is computed at each evaluation, and at most ${num(kept)} times where one is kept for each vertex.`;
      const steadier = [heat.lost, heat.own].map((lost) => paper.lost < lost);
      if (!steadier.some(Boolean)) return { verdict: 'does not', measured };
      const timesDecide = evidence.timesDecide();
      const orders = 100;
      const reasons = [];
      if (!steadier.every(Boolean)) {
        const rule = steadier[0] ? 'by its library’s rule' : 'by our rule';
        reasons.push(`how lost samples are counted: ${rule} vector heat loses fewer`);
      }
      if (timesDecide && used < orders) reasons.push(`the time: ${num(used)} times is no orders`);
      if (timesDecide && used >= orders && kept < orders) {
        reasons.push(
          'whether log maps are kept; as the library has it, vector heat is slower by orders of magnitude',
        );
      }
      if (reasons.length > 0) return { verdict: 'depends', on: reasons.join('; '), measured };
      return { verdict: timesDecide ? 'holds' : 'open', measured };
    },
  },
  {
    id: 'against-averages',
    where: 'Abstract, 1',
    claim: 'More accurate than weighted averages, and slightly slower.',
    figure: 'resolution',
    judge(evidence) {
      const exact = nearer(evidence, 'paper', 'weightedAverages');
      const graph = nearer(evidence, 'paperGraph6', 'weightedAverages');
      const ours = nearer(evidence, 'karcher', 'weightedAverages');
      const onMeshes = nearerOnMeshes(evidence);
      const { inFigures, inTable } = slowerThanAverages(evidence);
      const times = [
        { where: 'in the figures with exact distances', ratio: middle(inFigures) },
        ...(inTable.length > 0 ? [{ where: 'in Table 1 with k = 6', ratio: middle(inTable) }] : []),
      ];
      const told = times.map(({ where, ratio }) => `${num(ratio)} times as long ${where}`);
      const averagesAt = [
        { with: 'exact distances', panels: exact.lost },
        { with: 'k = 6', panels: graph.lost },
      ].filter(({ panels }) => panels.length > 0);
      const list = averagesAt.map((one) => `with ${one.with} on ${one.panels.join(', ')}`);
      const measured = `By exact paths the paper’s method is nearer in ${exact.won.length} of ${exact.of} panels with exact distances and in ${graph.won.length} of ${graph.of} with k = 6; weighted averages are nearer ${list.join('; ') || 'in none'}. Ours is nearer in ${ours.won.length} of ${ours.of}. A curve with its fields takes the paper’s method ${told.join(' and ')} (medians; up to ${slightly} is slightly here), without the embedding, which it does not need.${onMeshes.measured}`;
      const won = exact.won.length + graph.won.length + onMeshes.won;
      const of = exact.of + graph.of + onMeshes.of;
      if (won === 0) return { verdict: 'does not', measured };
      const reasons = [];
      if (won < of) {
        reasons.push(`the surface: the paper’s method is not nearer in ${of - won} of ${of} cases`);
      }
      const timesDecide = evidence.timesDecide();
      const slow = times.filter(({ ratio }) => ratio > slightly);
      if (timesDecide && slow.length > 0) {
        const where = slow.length < times.length ? ` ${slow[0]!.where}` : '';
        const ratio = Math.min(...slow.map((one) => one.ratio));
        const least = slow.length > 1 ? 'at least ' : '';
        reasons.push(
          `the time: ${least}${num(ratio)} times as long${where} is not slightly slower`,
        );
      }
      if (reasons.length > 0) return { verdict: 'depends', on: reasons.join('; '), measured };
      return { verdict: timesDecide ? 'holds' : 'open', measured };
    },
  },
  {
    id: 'scales',
    where: '1',
    claim:
      'Scales better with the mesh than both: vector heat factorises a system of its size, weighted averages embed it for minutes.',
    figure: 'table',
    judge(evidence) {
      const rows = evidence.study('growth');
      const against = (['vectorHeat', 'weightedAverages'] as const).flatMap((method) =>
        comparedGrowth(rows, method),
      );
      if (against.length === 0) throw new NotMeasured('two sizes at which no method failed');
      const told = growthMethods.map(([method, name]) => {
        const times = rows.filter((row) => row.method === method);
        return `${name} ${times.map((row) => (row.ms === null ? 'failed' : ms(row.ms))).join(', ')}`;
      });
      const sizes = [...new Set(rows.map(({ triangles }) => triangles.toLocaleString('en')))];
      const measured = `Preparation and first curve on a torus of ${sizes.join(', ')} triangles, and on no larger one: ${told.join('; ')}. Where both are there, times grow with the triangles to the power of ${against.map(({ name, slope, paper }) => `${num(paper)} with the paper’s method (k = 6) and ${num(slope)} with ${name}`).join('; ')}. Sizes at which a method failed decide nothing.`;
      if (!evidence.timesDecide()) return { verdict: 'open', measured };
      const all = against.length === 2;
      if (all && against.every(({ result }) => result === 'holds')) {
        return { verdict: 'holds', measured };
      }
      if (against.every(({ result }) => result === 'does not')) {
        return { verdict: 'does not', measured };
      }
      const on = against.map(({ name, words }) => `against ${name} ${words}`);
      return { verdict: 'depends', on: `the other method: ${on.join('; ')}`, measured };
    },
  },
  {
    id: 'one-center',
    where: '1',
    claim: 'One center of mass costs nothing beside the distance fields.',
    judge(evidence) {
      const { fieldsMs, centerMs } = evidence.study('oneCenter');
      const measured = `Four exact fields on a torus of 20,000 triangles: ${ms(fieldsMs)}; another center of mass in them: ${ms(centerMs)}.`;
      if (!evidence.timesDecide()) return { verdict: 'open', measured };
      return { verdict: centerMs < 0.05 * fieldsMs ? 'holds' : 'does not', measured };
    },
  },
  {
    id: 'log-maps',
    where: '2',
    claim:
      'Splines by vector heat are slow because each step computes a log map at another point, and they are sensitive to that.',
    figure: 'resolution',
    judge(evidence) {
      const cells = evidence
        .cells('vectorHeat')
        .filter(({ result }) => result.ok && result.logMaps);
      if (cells.length === 0) throw new NotMeasured('log maps in Table 1');
      const asked = sum(cells.map(({ result }) => result.logMaps!.asked));
      const made = sum(cells.map(({ result }) => result.logMaps!.made));
      const samples = sum(cells.map(({ result }) => result.samples ?? 0));
      const lost = sum(cells.map(({ result }) => result.lost ?? 0));
      const measured = `In Table 1 a sample asks for ${num(asked / samples)} log maps, of which ${percent(made / asked)} are from new vertices; ${lost} of ${samples} samples are lost; whether for that reason is not measured.`;
      if (asked / samples <= 1) return { verdict: 'does not', measured };
      const reasons = [
        ...(made < 0.5 * asked ? ['whether the log maps of vertices are kept'] : []),
        'the part: that splines are sensitive to it is not tested',
      ];
      return { verdict: 'depends', on: reasons.join('; '), measured };
    },
  },
  {
    id: 'far-stronger',
    where: '3',
    claim:
      'Solutions are found where points are not too far apart and the space between is not too bumpy; Karcher’s condition is far stronger than needed.',
    judge(evidence) {
      const cases = evidence.study('radius');
      const surfaces = [...new Set(cases.map(surfaceOf))].map((name) => {
        const rows = cases.filter((row) => surfaceOf(row) === name);
        const { condition, noise } = rows[0]!;
        const [alike, found] = (['same', 'found'] as const).map((key) => {
          const end = rows.findIndex((row) => row[key] < row.cases);
          const last = rows.at(end < 0 ? -1 : end - 1)!;
          return end === 0 ? 0 : last.radius / condition;
        }) as [number, number];
        const told = `on a ${name}, where the condition ends at ${num(condition)}, all are found up to ${num(found)} and alike up to ${num(alike)} times that radius`;
        return { name, noise, alike, told };
      });
      if (surfaces.length === 0) throw new NotMeasured('points in balls');
      const measured = `Four random points in geodesic balls of ever larger radius, ${cases[0]!.cases} a radius, searched from each of the four: how many have a center of mass, and from all four the same one. Karcher’s condition is a radius of half the injectivity radius and of π/(2√K) with the largest curvature K, on bumps by the angle missing at a vertex: ${surfaces.map(({ told }) => told).join('; ')}. Far is more than ${farTimes} times.`;
      if (surfaces.every(({ alike }) => alike > farTimes)) return { verdict: 'holds', measured };
      if (surfaces.every(({ alike }) => alike <= 1)) return { verdict: 'does not', measured };
      const reach = surfaces.map(({ name, alike }) => `${num(alike)} times on a ${name}`);
      const on = `the surface: the radius is ${reach.join(', ')}`;
      return { verdict: 'depends', on, measured };
    },
  },
  {
    id: 'newton',
    where: '4',
    claim:
      'Newton’s method with a warm start takes few steps; the least gradient over the joints of the geodesic is its line search, and a zero inside a triangle ends it.',
    judge(evidence) {
      const all = evidence.study('newton');
      const warm = all.filter(({ start }) => start === 'warm');
      if (warm.length === 0) throw new NotMeasured('searches with a warm start');
      const of = (rows: typeof all, key: NewtonSum) => sum(rows.map((row) => row[key]));
      const most = (rows: typeof all, key: 'half' | 'nearlyAll' | 'most') =>
        Math.max(...rows.map((row) => row[key]));
      const lostOn = (rows: typeof all) => {
        const list = rows.flatMap(({ mesh, distances, searches, converged }) =>
          converged < searches ? [`${searches - converged} on ${mesh}, ${distances}`] : [],
        );
        return list.length > 0 ? ` (${list.join('; ')})` : '';
      };
      const steps = (rows: typeof all, start: string) =>
        `with a ${start} start half of ${of(rows, 'searches').toLocaleString('en')} searches take at most ${most(rows, 'half')} iterations, 99 in 100 ${most(rows, 'nearlyAll')} and all ${most(rows, 'most')}, on the worst mesh, and ${of(rows, 'searches') - of(rows, 'converged')} are lost${lostOn(rows)}`;
      const cold = all.filter(({ start }) => start === 'cold');
      const names = [...new Set(all.map(({ mesh }) => mesh))];
      const [traced, shortened, needed, stuck] = (
        ['traced', 'shortened', 'needed', 'stuck'] as const
      ).map((key) => of(all, key)) as [number, number, number, number];
      const [converged, inside] = [of(all, 'converged'), of(all, 'inside')];
      const orders = all.flatMap(({ order }) => (order === null ? [] : [order]));
      const ordered =
        orders.length > 0
          ? ` Where three iterations show it, the gradient falls with an order of ${num(Math.min(...orders))} to ${num(Math.max(...orders))} (medians of ${orders.length} rows): the field has a crease at each edge, and its zero in a triangle is found at once.`
          : '';
      const measured = `B-splines of random polygons with legs of a tenth of the diagonal on ${names.join(', ')}, with exact distances and with k = 6: ${[steps(warm, 'warm'), ...(cold.length > 0 ? [steps(cold, 'cold')] : [])].join('; ')}. Of ${traced.toLocaleString('en')} geodesics ${shortened.toLocaleString('en')} are taken to a joint before their end, ${needed} of these since the end has no smaller gradient; on ${stuck} no joint has one. A zero inside a triangle ends ${inside.toLocaleString('en')} of ${converged.toLocaleString('en')} searches; the others end where each of the triangles beside an edge or around a vertex has it in another one, for which Algorithm 1 has no rule, and ours is taken.${ordered} Few is here at most ${fewSteps}.`;
      const on = (fails: (row: (typeof all)[number]) => boolean) =>
        names.filter((name) => all.some((row) => row.mesh === name && fails(row)));
      const lost = on((row) => row.converged < row.searches);
      const long = on((row) => row.start === 'warm' && row.nearlyAll > fewSteps);
      const between = on((row) => row.inside < row.converged);
      const without = on((row) => row.stuck > 0);
      const parts = [
        ['searches are lost on', lost],
        ['they take many steps on', long],
        ['no joint has a smaller gradient, now and then, on', without],
        ['zeros between triangles end some on', between],
      ] as const;
      const failing = parts.filter(([, where]) => where.length > 0);
      if (failing.length === 0) return { verdict: 'holds', measured };
      if (lost.length === names.length || long.length === names.length) {
        return { verdict: 'does not', measured };
      }
      const reasons = failing.map(([what, where]) => {
        const others = names.filter((name) => !where.includes(name));
        if (others.length === 0) return `${what} all`;
        return where.length > others.length
          ? `${what} all but ${others.join(', ')}`
          : `${what} ${where.join(', ')}`;
      });
      return { verdict: 'depends', on: `the mesh: ${reasons.join('; ')}`, measured };
    },
  },
  {
    id: 'oblivious',
    where: '4',
    claim: 'The method does not care how distances are computed.',
    figure: 'graph',
    judge(evidence) {
      const panel = 'graph/sphere';
      const ids = ['paperGraph2', 'paperGraph6', 'paper'] as const;
      const [two, six, exact] = ids.map((id) => evidence.residual(panel, id)) as [
        number,
        number,
        number,
      ];
      const lost = sum(ids.map((id) => evidence.lost(panel, id).lost));
      const measured = `On the sphere it takes distances with k = 2, with k = 6 and exact ones, and loses ${lost} samples in all; the residuals are ${num(two)}, ${num(six)} and ${num(exact)} h.`;
      if (lost > 0) {
        return { verdict: 'depends', on: 'the distances: with some it loses samples', measured };
      }
      const spread = Math.max(two, six) / Math.max(exact, 1e-12);
      return spread < 2
        ? { verdict: 'holds', measured }
        : {
            verdict: 'depends',
            on: 'what is asked: it runs with any, but is as accurate as they are',
            measured,
          };
    },
  },
];
