import type { LineId } from '../figures/types';
import type { Claim, Evidence } from './types';
import { NotMeasured } from './types';
import { num, sum } from './words';

const lost = (evidence: Evidence, panel: string, id: LineId) => evidence.lost(panel, id).lost;

/** The number of leaps of a line; 0 for a method that failed and has no curve. */
const breaks = (evidence: Evidence, panel: string, id: LineId) =>
  evidence.line(panel, id).breaks ?? 0;

/** A curve on the plane wiggles if its turning noise, in radians for each sample, exceeds this. */
const wiggle = 0.01;

interface Stability {
  lost: number;
  samples: number;
  /** The residual of the samples that are not lost; null if all are lost. */
  residual: number | null;
}

function stabilityOf(evidence: Evidence, panel: string, id: LineId): Stability {
  const { lost, samples } = evidence.lost(panel, id);
  return { lost, samples, residual: lost < samples ? evidence.residual(panel, id) : null };
}

const stabilityText = ({ lost, samples, residual }: Stability) =>
  `${lost} of ${samples}${residual === null ? '' : ` (${num(residual)} h)`}`;

/**
 * Whether `a` loses fewer samples than `b` or, if both lose the same number, has the smaller
 * residual.
 */
function isSteadier(a: Stability, b: Stability): boolean {
  if (a.lost !== b.lost) return a.lost < b.lost;
  return a.residual !== null && b.residual !== null && a.residual < b.residual;
}

/** The largest fraction of its samples that a resilient method may lose. */
const mostLost = 0.05;

/**
 * The fraction of samples that the paper's method loses on the armadillo, with graph distances or
 * with exact distances, whichever is larger. Null if the folder of meshes has no armadillo, or no
 * results for it.
 */
function armadillo({ all: { meshes } }: Evidence): { lost: number | null; measured: string } {
  const found = meshes?.find(({ name }) => name.startsWith('armadillo'));
  const wanted = [
    ['paper', 'the paper with k = 6'],
    ['paperExact', 'with exact distances'],
    ['karcher', 'ours'],
  ] as const;
  const rows = wanted.flatMap(([method, name]) => {
    const result = found?.methods.find((one) => one.method === method)?.result;
    if (!found || !result) return [];
    const { lost, samples } = result;
    if (lost === null || !samples) return [{ method, share: 1, told: `${name} failed` }];
    const residual = num(result.ruler?.residual?.median ?? null);
    return [
      {
        method,
        share: lost / samples,
        told: `${name} ${residual} h and ${lost} lost of ${samples}`,
      },
    ];
  });
  const ofPaper = rows.filter(({ method }) => method !== 'karcher').map(({ share }) => share);
  if (!found || ofPaper.length === 0) return { lost: null, measured: '' };
  const size = found.triangles.toLocaleString('en');
  const told = rows.map((row) => row.told).join(', ');
  return {
    lost: Math.max(...ofPaper),
    measured: ` On the armadillo of ${size} triangles: ${told}.`,
  };
}

/** The claims of sections 5.1 to 6: the method's limits and the open questions. */
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
      const dragged = ids.flatMap((id) => {
        const drags = panels.flatMap((panel) => evidence.line(panel, id).drag ?? []);
        if (drags.length < panels.length) return [];
        const most = Math.max(...drags.map((drag) => drag.most ?? 0));
        const steps = sum(drags.map((drag) => drag.steps));
        const leaps = sum(drags.map((drag) => drag.leaps));
        return [`${names[id]} ${leaps} of ${steps} (×${num(most)})`];
      });
      const underDrags =
        dragged.length > 0
          ? ` Steps of a drag in which a sample moves more than five times as far as the hand, and the farthest: ${dragged.join('; ')}.`
          : '';
      const measured = `Samples lost and leaps in both panels: ${broken.map((one) => `${names[one.id]} ${one.lost} and ${one.breaks}`).join('; ')}.${underDrags}`;
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
          .map(({ residual, lost, samples, noise }) => {
            const found = samples > 0 ? `${num(residual)} h and ${lost} lost` : 'failed';
            return `${found} at ${num(noise)} h`;
          })
          .join(', ');
      const rough = armadillo(evidence);
      const apart = evidence.study('spread');
      const farthest = apart.filter(({ method }) => method === 'paper').at(-1);
      if (!farthest) throw new NotMeasured('points far apart on a rough surface');
      const sayApart = (id: LineId) =>
        apart
          .filter(({ method }) => method === id)
          .map(({ apart, lost, breaks }) => `${lost} and ${breaks} at ${num(apart)} h`)
          .join(', ');
      const far = ['far/bspline', 'far/bezier'];
      const lostFar = sum(far.map((panel) => lost(evidence, panel, 'paper')));
      const measured = `On a torus of 5,000 triangles with noise of a height in mean edges, residual and samples lost of ${rows[0]?.samples}: the paper, exact distances: ${say(rows)}; ours: ${say(ours)}.${rough.measured} Samples lost and leaps, of ${farthest.samples}, where neighbouring points lie so far apart on tori with noise of ${num(farthest.noise)} h: the paper ${sayApart('paper')}; ours ${sayApart('karcher')}; our default ${sayApart('leveled')}. In Fig. 7, on a smooth surface, the paper’s method loses ${lostFar}.`;
      if (rows.length === 0) throw new NotMeasured('rough surfaces');
      const worst = rows.at(-1)!;
      if (worst.samples === 0)
        throw new NotMeasured('the paper’s method where the noise is largest');
      const places = [
        { name: 'where the noise is largest', share: worst.lost / worst.samples },
        ...(rough.lost === null ? [] : [{ name: 'on the armadillo', share: rough.lost }]),
      ];
      const losing = places.filter(({ share }) => share > 0).map(({ name }) => name);
      const isUnstable = farthest.breaks > 0 || farthest.lost > 0;
      if (losing.length === 0 && isUnstable) return { verdict: 'holds', measured };
      const isResilient = places.some(({ share }) => share <= mostLost);
      if (!isResilient && !isUnstable) return { verdict: 'does not', measured };
      const reasons = [
        ...(isResilient ? [] : ['it is not resilient']),
        ...(isResilient && losing.length > 0
          ? [`how rough: some samples are lost ${losing.join(' and ')}`]
          : []),
        ...(isUnstable
          ? []
          : [
              lostFar > 0
                ? 'how large distances are: it is stable at those measured on tori, and not in Fig. 7'
                : 'it is stable where distances are large, too',
            ]),
      ];
      return { verdict: 'depends', on: reasons.join('; '), measured };
    },
  },
  {
    id: 'regular',
    where: '5.1',
    claim: 'Most stable on fairly regular triangles with exact distances.',
    figure: 'plane',
    judge(evidence) {
      const kinds = {
        fair: 'of fairly regular points',
        delaunay: 'of random points',
        anisotropic: 'that are stretched',
      };
      const rows = Object.entries(kinds).map(([name, triangles]) => {
        const panel = `plane/${name}`;
        const [exact, graph, ours] = (['paper', 'paperGraph6', 'karcher'] as const).map((id) =>
          stabilityOf(evidence, panel, id),
        ) as [Stability, Stability, Stability];
        return { triangles, exact, graph, ours };
      });
      const told = rows.map(
        ({ triangles, exact, graph }) =>
          `${stabilityText(exact)} and ${stabilityText(graph)} on triangles ${triangles}`,
      );
      const measured = `Samples lost on the plane, and the residual of the others, with exact distances and with k = 6: ${told.join('; ')}. Ours: ${rows.map(({ ours }) => stabilityText(ours)).join(', ')}.`;
      const [fair, ...others] = rows as [(typeof rows)[0], ...typeof rows];
      const onFair = (['exact', 'graph'] as const).every((distances) =>
        others.every((row) => isSteadier(fair[distances], row[distances])),
      );
      const notExact = rows.filter(({ exact, graph }) => !isSteadier(exact, graph));
      if (onFair && notExact.length === 0) return { verdict: 'holds', measured };
      if (!onFair && notExact.length === rows.length) return { verdict: 'does not', measured };
      const where = notExact.map(({ triangles }) => triangles).join(' or ');
      const reasons = [
        ...(onFair ? [] : ['fairly regular points are not the best']),
        ...(where ? [`exact distances are not steadier than k = 6 on triangles ${where}`] : []),
      ];
      return { verdict: 'depends', on: `the part: ${reasons.join('; ')}`, measured };
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
        const residual = (id: LineId) => evidence.residual(panel, id);
        return { panel, two: residual('paperGraph2'), six: residual('paperGraph6') };
      });
      const exact = evidence.residual('graph/sphere', 'paper');
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
      const names = ['fair', 'delaunay', 'grid', 'anisotropic'] as const;
      const at = (name: (typeof names)[number], id: LineId) => {
        const panel = `plane/${name}`;
        const { lost, samples } = evidence.lost(panel, id);
        if (lost === samples) return { name, lost, samples, max: null, turning: null, over: 0 };
        const { max, samples: over } = evidence.deviation(panel, id);
        return { name, lost, samples, max, turning: evidence.turning(panel, id), over };
      };
      type Row = ReturnType<typeof at>;
      const by = (id: LineId) => names.map((name) => at(name, id));
      const [fair, delaunay, grid, stretched] = by('paperGraph6') as [Row, Row, Row, Row];
      const ours = names.map((name) => at(name, 'karcher').max);
      const say = ({ name, max, turning, lost, samples, over }: Row) =>
        `${name} ${num(max)} h and ${num(turning)} rad over ${over} of ${samples}, ${lost} lost`;
      const measured = `The paper’s method with distances on the graph of k = 6, as in its figure, largest distance from the affine curve and turning noise a sample: ${[fair, delaunay, grid, stretched].map(say).join('; ')}. With exact distances: ${by('paper').map(say).join('; ')}. Right is here what loses no sample, lies within half an edge and does not wiggle; wiggles are more than ${wiggle} rad. Ours: ${ours.map((value) => num(value)).join(', ')} h.`;
      const isRight = fair.lost === 0 && fair.max !== null && fair.max < 0.5;
      const wiggles = ({ turning }: Row) => turning !== null && turning > wiggle;
      const allLost = stretched.lost === stretched.samples;
      const failing = [
        ...(isRight ? [] : ['not right on the fair mesh']),
        ...(isRight && wiggles(fair) ? ['wiggles on the fair mesh, too'] : []),
        ...(wiggles(grid) ? [] : ['no wiggles on the grid']),
        ...(allLost || wiggles(stretched) ? [] : ['no wiggles on the anisotropic mesh']),
        ...(stretched.lost > 0 ? [] : ['no breaks on the anisotropic mesh']),
      ];
      if (failing.length === 0) return { verdict: 'holds', measured };
      if (failing.length >= 4) return { verdict: 'does not', measured };
      return { verdict: 'depends', on: `the part: ${failing.join('; ')}`, measured };
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
        averages: evidence.turning(panel, 'weightedAverages'),
        paper: evidence.turning(panel, 'paper'),
        ours: evidence.turning(panel, 'karcher'),
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
      const measured = `By weightsOf: of ${cases} random points among four others, ${minima} have weights for which they are a minimum, and ${back} of these are found again within 1e-9 h (farthest ${num(farthest)} h).`;
      return minima === cases && back === minima
        ? { verdict: 'settled here', measured }
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
        ...stabilityOf(evidence, panel, 'karcher'),
      }));
      const told = rows.map((row) => `${stabilityText(row)} on ${row.panel}`);
      const measured = `Ours, log vectors in place of gradients: samples lost, and the residual of the others, ${told.join('; ')}.`;
      const good = rows.every(
        (row) => row.lost === 0 && row.residual !== null && row.residual < 0.1,
      );
      return good
        ? { verdict: 'settled here', measured }
        : { verdict: 'depends', on: 'how bad: see the rows that lose samples', measured };
    },
  },
];
