import type { LineId } from '../figures/types';
import type { Claim, Evidence } from './types';
import { NotMeasured } from './types';
import { num, sum } from './words';

const lost = (evidence: Evidence, panel: string, id: LineId) => {
  const line = evidence.line(panel, id);
  return line.lost ?? 0;
};
const breaks = (evidence: Evidence, panel: string, id: LineId) =>
  evidence.line(panel, id).breaks ?? 0;
const turning = (evidence: Evidence, panel: string, id: LineId) =>
  evidence.line(panel, id).turningNoise ?? Number.POSITIVE_INFINITY;

/** Sections 5.1 to 6: what the method cannot do, and what is open. */
export const limitClaims: readonly Claim[] = [
  {
    id: 'too-far',
    where: '5.1, Fig. 7',
    claim:
      'Where points lie too far apart curves break, with vector heat and weighted averages too.',
    figure: 'far',
    judge(evidence) {
      const panels = ['far/bspline', 'far/bezier'];
      const ids = [
        'vectorHeat',
        'weightedAverages',
        'bSurf',
        'paper',
        'karcher',
        'bridged',
        'leveled',
      ] as const;
      const broken = ids.map((id) => ({
        id,
        lost: sum(panels.map((panel) => lost(evidence, panel, id))),
        breaks: sum(panels.map((panel) => breaks(evidence, panel, id))),
      }));
      const names = {
        vectorHeat: 'vector heat',
        weightedAverages: 'weighted averages',
        bSurf: 'b/Surf',
        paper: 'the paper',
        karcher: 'ours',
        bridged: 'ours, bridged',
        leveled: 'ours, with levels',
      };
      const measured = `Samples lost and leaps in both panels: ${broken.map((one) => `${names[one.id]} ${one.lost} and ${one.breaks}`).join('; ')}.`;
      const is = (id: LineId) => broken.some((one) => one.id === id && one.lost + one.breaks > 0);
      const three = (['vectorHeat', 'weightedAverages', 'paper'] as const).map(is);
      if (three.every(Boolean)) return { verdict: 'holds', measured };
      if (!three.some(Boolean)) return { verdict: 'does not', measured };
      return { verdict: 'depends', on: 'the method, and how breaks are counted', measured };
    },
  },
  {
    id: 'roughness',
    where: '5.1',
    claim: 'Resilient to roughness (the armadillo); unstable where mutual distances are large.',
    judge(evidence) {
      const rows = evidence.study('roughness').filter(({ method }) => method === 'paper');
      const ours = evidence.study('roughness').filter(({ method }) => method === 'karcher');
      const say = (all: typeof rows) =>
        all
          .map((row) => `${num(row.residual)} h and ${row.lost} lost at ${num(row.noise)} h`)
          .join(', ');
      const measured = `On a torus of 5,000 triangles with noise of a height in mean edges, residual and samples lost of ${rows[0]?.samples}: the paper, exact distances: ${say(rows)}; ours: ${say(ours)}.`;
      if (rows.length === 0) throw new NotMeasured('rough surfaces');
      const worst = rows.at(-1)!;
      if (worst.lost > 0.05 * worst.samples) return { verdict: 'does not', measured };
      return worst.lost === 0
        ? { verdict: 'holds', measured }
        : {
            verdict: 'depends',
            on: 'how rough: some samples are lost where the noise is largest',
            measured,
          };
    },
  },
  {
    id: 'regular',
    where: '5.1',
    claim: 'Most stable on fairly regular triangles with exact distances.',
    figure: 'plane',
    judge(evidence) {
      const at = (panel: string) =>
        (['paper', 'paperGraph6'] as const).map((id) => lost(evidence, panel, id));
      const [fair, random, stretched] = [
        at('plane/fair'),
        at('plane/delaunay'),
        at('plane/anisotropic'),
      ];
      const measured = `Samples lost on the plane, exact distances and k = 6: ${fair.join(' and ')} on fairly regular triangles, ${random.join(' and ')} on those of random points, ${stretched.join(' and ')} on stretched ones. Ours: ${['plane/fair', 'plane/delaunay', 'plane/anisotropic'].map((panel) => lost(evidence, panel, 'karcher')).join(', ')}.`;
      const most = fair[0]! <= Math.min(random[0]!, stretched[0]!, fair[1]!);
      return { verdict: most ? 'holds' : 'does not', measured };
    },
  },
  {
    id: 'rings',
    where: '5.1, inset',
    claim: 'With k = 2 the curve of Fig. 4 suffers; k = 6 is a good trade-off.',
    figure: 'resolution',
    judge(evidence) {
      const panels = ['resolution/coarse', 'resolution/fine', 'graph/sphere'];
      const rows = panels.map((panel) => {
        const residual = (id: LineId) =>
          evidence.line(panel, id).ruler?.residual?.median ?? Number.POSITIVE_INFINITY;
        return { panel, two: residual('paperGraph2'), six: residual('paperGraph6') };
      });
      const exact = evidence.line('graph/sphere', 'paper').ruler?.residual?.median ?? null;
      const measured = `Residuals with k = 2 and k = 6: ${rows.map(({ panel, two, six }) => `${num(two)} and ${num(six)} h (${panel})`).join('; ')}. With exact distances on the last: ${num(exact)} h.`;
      const better = rows.filter(({ two, six }) => two > 1.5 * six);
      if (better.length === rows.length) return { verdict: 'holds', measured };
      if (better.length === 0) return { verdict: 'does not', measured };
      return {
        verdict: 'depends',
        on: `the mesh: k = 6 is clearly better on ${better.map(({ panel }) => panel).join(', ')}`,
        measured,
      };
    },
  },
  {
    id: 'plane',
    where: '5.1, Fig. 8',
    claim:
      'On the plane: right on a Delaunay mesh of fairly regular points, wiggles on a triangulated grid, wiggles and breaks on an anisotropic mesh.',
    figure: 'plane',
    judge(evidence) {
      const panels = ['fair', 'delaunay', 'grid', 'anisotropic'];
      const rows = panels.map((name) => {
        const { deviation, turningNoise, lost, samples, ruler } = evidence.line(
          `plane/${name}`,
          'paper',
        );
        return {
          name,
          max: deviation?.max ?? Number.POSITIVE_INFINITY,
          turning: turningNoise ?? Number.POSITIVE_INFINITY,
          lost: lost ?? 0,
          samples,
          over: deviation?.samples ?? 0,
          ruler,
        };
      });
      const graph = evidence.line('plane/grid', 'paperGraph6');
      const ours = panels.map(
        (name) => evidence.line(`plane/${name}`, 'karcher').deviation?.max ?? null,
      );
      const measured = `The paper’s method with exact distances, largest distance from the affine curve: ${rows.map(({ name, max, lost, samples, over }) => `${name} ${num(max)} h over ${over} of ${samples}, ${lost} lost`).join('; ')}. On the grid with k = 6: ${num(graph.deviation?.max ?? null)} h. Ours: ${ours.map((value) => num(value)).join(', ')} h.`;
      const by = Object.fromEntries(rows.map((row) => [row.name, row]));
      const parts = [
        by.fair!.lost === 0 && by.fair!.max < 0.5,
        by.grid!.turning > 0.01 || turning(evidence, 'plane/grid', 'paperGraph6') > 0.01,
        by.anisotropic!.lost > 0 || by.anisotropic!.max > 1,
      ];
      if (parts.every(Boolean)) return { verdict: 'holds', measured };
      const failing = [
        'the fair mesh',
        'the grid, where it is exact with exact distances',
        'the anisotropic mesh',
      ].filter((_, i) => !parts[i]);
      return { verdict: 'depends', on: `not on ${failing.join(', ')}`, measured };
    },
  },
  {
    id: 'averages-rough',
    where: '5.2, inset',
    claim: 'Weighted averages’ curve of Fig. 5 is less smooth than the paper’s.',
    figure: 'gallery',
    judge(evidence) {
      const panels = evidence
        .panelsWith('weightedAverages', 'paper')
        .filter((name) => /^(gallery|averages)\//.test(name));
      if (panels.length === 0) throw new NotMeasured('the gallery');
      const rows = panels.map((panel) => ({
        panel,
        averages: turning(evidence, panel, 'weightedAverages'),
        paper: turning(evidence, panel, 'paper'),
        ours: turning(evidence, panel, 'karcher'),
      }));
      const measured = `Turning noise of weighted averages, the paper (exact distances) and ours, in rad: ${rows.map(({ panel, averages, paper, ours }) => `${num(averages)}, ${num(paper)}, ${num(ours)} (${panel})`).join('; ')}.`;
      const rougher = rows.filter(({ averages, paper }) => averages > paper);
      if (rougher.length === rows.length) return { verdict: 'holds', measured };
      if (rougher.length === 0) return { verdict: 'does not', measured };
      return {
        verdict: 'depends',
        on: `the surface: it is on ${rougher.map(({ panel }) => panel).join(', ')}`,
        measured,
      };
    },
  },
  {
    id: 'inverse',
    where: '6',
    claim: 'Open: the inverse problem, weights of a given point, for texture mapping and transfer.',
    judge(evidence) {
      const { cases, minima, back, farthest } = evidence.study('inverse');
      const measured = `Settled here (weightsOf): of ${cases} random points among four others, ${minima} have weights for which they are a minimum, and ${back} of these are found again within 1e-9 h (farthest ${num(farthest)} h).`;
      return minima === cases && back === minima
        ? { verdict: 'holds', measured }
        : {
            verdict: 'depends',
            on: 'the points: where the Hessian is not positive definite there is no minimum',
            measured,
          };
    },
  },
  {
    id: 'bad-meshes',
    where: '6',
    claim: 'Open: an estimator that bears bad meshes.',
    figure: 'plane',
    judge(evidence) {
      const panels = ['plane/anisotropic', 'plane/delaunay', 'resolution/coarse'];
      const rows = panels.map((panel) => ({
        panel,
        lost: lost(evidence, panel, 'karcher'),
        residual: evidence.line(panel, 'karcher').ruler?.residual?.median ?? null,
      }));
      const measured = `Ours, log vectors in place of gradients: ${rows.map(({ panel, lost: count, residual }) => `${count} lost, residual ${num(residual)} h (${panel})`).join('; ')}.`;
      const good = rows.every(
        ({ lost: count, residual }) => count === 0 && residual !== null && residual < 0.1,
      );
      return good
        ? { verdict: 'holds', measured }
        : { verdict: 'depends', on: 'how bad: see the rows that lose samples', measured };
    },
  },
];
