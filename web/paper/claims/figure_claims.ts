import type { LineId } from '../figures/types';
import { published } from '../table/rows';
import { nearer } from './method_claims';
import type { Claim, Evidence } from './types';
import { NotMeasured } from './types';
import { degrees, ms, num, percent, sum } from './words';

const median = (evidence: Evidence, panel: string, id: LineId) =>
  evidence.deviation(panel, id).median;

/**
 * The largest turning noise, in radians, that looks smooth. Samples are a pixel or two apart, so
 * that a turn by a degree at each sample is not visible.
 */
const smoothTurning = Math.PI / 180;

/** The largest ratio of two numbers that count as alike. */
const alike = 2;
const areAlike = (a: number, b: number) => Math.max(a, b) <= alike * Math.min(a, b);

/**
 * Compares a count with even chances: 1 if it is larger, -1 if it is smaller, and 0 if the
 * difference is within two standard deviations.
 */
function moreThanChance(count: number, of: number): number {
  const beyond = count - of / 2;
  return Math.abs(beyond) > Math.sqrt(of) ? Math.sign(beyond) : 0;
}

const largeNames: Partial<Record<string, string>> = {
  paper: 'the paper, k = 6',
  karcher: 'ours',
  leveled: 'our default',
};

/** The claims of section 5: the figures and Table 1. */
export const figureClaims: readonly Claim[] = [
  {
    id: 'four-points',
    where: '5, Fig. 1',
    claim: 'The center of four points on a torus is found; in the plane it is the affine average.',
    figure: 'means',
    judge(evidence) {
      const paper = median(evidence, 'means/plane', 'paper');
      const ours = median(evidence, 'means/plane', 'karcher');
      const torus = evidence.residual('means/torus', 'paper');
      const own = evidence.residual('means/torus', 'karcher');
      const grid = evidence.deviation('plane/grid', 'paper').max;
      const measured = `In a plane of random points the paper’s center is ${num(paper)} h from the average, ours ${num(ours)} h; on a regular grid (Fig. 8) its centers are at most ${num(grid)} h away. On the torus the residuals are ${num(torus)} and ${num(own)} h.`;
      if (paper < 1e-6) return { verdict: 'holds', measured };
      return {
        verdict: 'depends',
        on:
          grid < 1e-6
            ? 'the triangles: it is on a regular grid, where rings are symmetric, and not on random points'
            : 'what is called found: it is near the average',
        measured,
      };
    },
  },
  {
    id: 'paths-averages',
    where: '5, Fig. 3',
    claim:
      'Between two points, the paths of weighted averages differ much from exact ones; the center’s do not.',
    figure: 'paths',
    judge(evidence) {
      const ids = ['weightedAverages', 'paper', 'vectorHeat', 'karcherExact'] as const;
      const at = (panel: string) => ids.map((id) => median(evidence, panel, id));
      const [fine, coarse] = [at('paths/fine'), at('paths/coarse')];
      const say = (values: number[]) => values.map((value) => num(value)).join(', ');
      const measured = `Median distance from the exact path, weighted averages, paper, vector heat, ours: ${say(fine)} h on the fine torus; ${say(coarse)} h on the coarse one.`;
      const worse = [fine, coarse].map(([averages, paper]) => averages! > 2 * paper!);
      if (worse.every(Boolean)) return { verdict: 'holds', measured };
      if (!worse.some(Boolean)) return { verdict: 'does not', measured };
      return {
        verdict: 'depends',
        on: worse[0] ? 'the mesh: on the fine one they do' : 'the mesh: on the coarse one they do',
        measured,
      };
    },
  },
  {
    id: 'paths-descent',
    where: '5, Fig. 3',
    claim: 'Descent of the piecewise linear distance gives worse paths on coarse meshes.',
    figure: 'paths',
    judge(evidence) {
      const rows = evidence.study('descent');
      const say = ({ mesh, worse, pairs, descent, paper, ours }: (typeof rows)[number]) =>
        `on the ${mesh} torus descent is farther from the exact path than the paper’s method in ${worse} of ${pairs} (medians of descent, the paper’s method and ours: ${num(descent)}, ${num(paper)} and ${num(ours)} h)`;
      const measured = `Of random pairs of points, with exact distances: ${rows.map(say).join('; ')}. A number within two deviations of even chances is no difference.`;
      const of = (name: 'coarse' | 'fine') => {
        const row = rows.find(({ mesh }) => mesh === name);
        if (!row) throw new NotMeasured(`pairs of points on the ${name} torus`);
        return moreThanChance(row.worse, row.pairs);
      };
      const [coarse, fine] = [of('coarse'), of('fine')];
      if (coarse > 0) return { verdict: 'holds', measured };
      const onFine = fine > 0 ? ', and on the fine mesh it is' : '';
      if (coarse < 0 && fine <= 0) return { verdict: 'does not', measured };
      return {
        verdict: 'depends',
        on:
          coarse < 0
            ? `the mesh: on the coarse one descent is not worse${onFine}`
            : `the pair: on the coarse mesh descent is worse as often as not${onFine}`,
        measured,
      };
    },
  },
  {
    id: 'resolution',
    where: '5, Fig. 4',
    claim:
      'On a coarse and on a fine mesh the B-splines of the paper and of weighted averages are smooth; vector heat’s is like the paper’s, but slow.',
    figure: 'resolution',
    judge(evidence) {
      const parts = ['coarse', 'fine'].map((name) => {
        const panel = `resolution/${name}`;
        const turning = (id: LineId) => evidence.turning(panel, id);
        const [paper, averages, heat] = [
          turning('paperGraph6'),
          turning('weightedAverages'),
          turning('vectorHeat'),
        ];
        const slower =
          evidence.traceMs(panel, 'vectorHeat') / evidence.traceMs(panel, 'paperGraph6');
        return { name, panel, paper, averages, heat, ours: turning('karcher'), slower };
      });
      const better = nearer(evidence, 'weightedAverages', 'paperGraph6').won;
      const nearerOn = parts.filter(({ panel }) => better.includes(panel)).map(({ name }) => name);
      const say = ({ name, paper, averages, heat, ours }: (typeof parts)[number]) =>
        `${[paper, averages, heat, ours].map(degrees).join(', ')} on ${name}`;
      const measured = `Turning noise a sample of the paper (k = 6), weighted averages, vector heat and ours: ${parts.map(say).join('; ')}; up to ${degrees(smoothTurning)} counts as smooth, up to ${alike} times the other as alike. Vector heat takes ${parts.map(({ slower }) => num(slower)).join(' and ')} times as long as the paper’s method, log maps kept. By exact paths weighted averages are nearer than the paper’s curve on: ${nearerOn.join(', ') || 'none'}.`;
      const where = (fails: (part: (typeof parts)[number]) => boolean) =>
        parts
          .filter(fails)
          .map(({ name }) => name)
          .join(' and ');
      const timesDecide = evidence.timesDecide();
      const failing = [
        ['the paper’s curve is not smooth on', where(({ paper }) => paper > smoothTurning)],
        ['weighted averages’ is not on', where(({ averages }) => averages > smoothTurning)],
        [
          'vector heat’s does not turn like the paper’s on',
          where(({ paper, heat }) => !areAlike(paper, heat)),
        ],
        [
          'vector heat, its log maps kept, is not slow on',
          timesDecide ? where(({ slower }) => slower <= alike) : '',
        ],
      ].filter(([, names]) => names);
      if (failing.length === 0) return { verdict: timesDecide ? 'holds' : 'open', measured };
      const everywhere = failing.filter(([, names]) => names === 'coarse and fine');
      if (everywhere.length === 4) return { verdict: 'does not', measured };
      const on = `the mesh: ${failing.map(([what, names]) => `${what} ${names}`).join('; ')}`;
      return { verdict: 'depends', on, measured };
    },
  },
  {
    id: 'table',
    where: 'Table 1',
    claim:
      'Preparation, tracing and updates of each method; weighted averages fail on the armadillo and the lion.',
    figure: 'table',
    judge(evidence) {
      const found = evidence.meshes().find(({ name }) => name.startsWith('armadillo'));
      if (!found) throw new NotMeasured('a mesh named armadillo');
      const averages = found.methods.find(({ method }) => method === 'weightedAverages');
      if (!averages) throw new NotMeasured('weighted averages on the armadillo');
      const { result } = averages;
      const residual = result.ruler?.residual?.median ?? null;
      const embedded = result.prepareMs !== null;
      // A method may run out of time on a busy machine, which is no failure.
      if (!embedded && /^stopped after/.test(result.reason ?? '')) {
        throw new NotMeasured(`weighted averages on the armadillo: ${result.reason}`);
      }
      const measured = embedded
        ? `Weighted averages embed the armadillo of ${found.triangles.toLocaleString('en')} triangles in ${ms(result.prepareMs)}; ${result.lost} of ${result.samples} samples are lost, the residual is ${num(residual)} h. The lion is not at hand.`
        : `Weighted averages fail on the armadillo: ${result.reason}. The lion is not at hand.`;
      if (!embedded) return { verdict: 'holds', measured };
      return {
        verdict: 'depends',
        on: 'the program: the paper’s authors’ fails there, the one that is compared here does not',
        measured,
      };
    },
  },
  {
    id: 'update',
    where: '5',
    claim: `At ${published.samples} samples on the lion an update takes ${published.updateMs} ms: ${published.fieldMs} the field, about ${published.segmentMs} a segment.`,
    judge(evidence) {
      const { fieldMs, segmentMs, triangles } = evidence.study('update');
      const share = fieldMs / (fieldMs + 4 * segmentMs);
      const measured = `Not on the lion, which is not at hand: on a torus of ${triangles.toLocaleString('en')} triangles with k = 6, the field ${ms(fieldMs)}, each of four segments ${ms(segmentMs)}. The field is ${percent(share)} of the two; in the paper’s numbers it is ${percent(published.fieldMs / (published.fieldMs + 4 * published.segmentMs))}.`;
      if (!evidence.timesDecide()) return { verdict: 'open', measured };
      return share > 0.5
        ? { verdict: 'depends', on: 'the machine and the mesh; the field is most of it', measured }
        : { verdict: 'does not', measured };
    },
  },
  {
    id: 'interactive',
    where: '5, Fig. 5',
    claim: 'Interactive on meshes of up to several hundred thousand triangles.',
    figure: 'gallery',
    judge(evidence) {
      const rows = evidence.study('large');
      const say = rows.map(({ method, dragMs, prepareMs, reason }) =>
        dragMs === null
          ? `${method}: ${reason}`
          : `${largeNames[method] ?? method}: ${ms(dragMs)} an update after ${ms(prepareMs)} of preparation`,
      );
      const paper = rows.find(({ method }) => method === 'paper');
      if (!paper) throw new NotMeasured('the paper’s method on a large mesh');
      const measured = `On a torus of ${paper.triangles.toLocaleString('en')} triangles, 128 samples a segment, in WebAssembly. ${say.join('; ')}.`;
      if (paper.dragMs === null) {
        throw new NotMeasured(`the paper’s method on a large mesh, which failed: ${paper.reason}`);
      }
      if (!evidence.timesDecide()) return { verdict: 'open', measured };
      // A drag is fluent at ten steps a second.
      if (paper.dragMs <= 100) return { verdict: 'holds', measured };
      return {
        verdict: 'depends',
        on: 'what is called interactive: one update takes longer than a tenth of a second',
        measured,
      };
    },
  },
  {
    id: 'rational',
    where: '5, Fig. 6',
    claim:
      'Rational Bézier curves (weights .05, 5, 5, .05) and barycentric ones behave as in the plane; subdivision cannot make rational curves; a new weight needs no new field.',
    figure: 'rational',
    judge(evidence) {
      const { fieldsMs, updateMs } = evidence.study('reweigh');
      const panels = ['equal', 'pulled', 'barycentric', 'loose'].map((name) => `rational/${name}`);
      const lost = sum(panels.map((panel) => evidence.lost(panel, 'paper').lost));
      const leaps = sum(panels.map((panel) => evidence.line(panel, 'paper').breaks ?? 0));
      const subdivided = evidence.line('rational/pulled', 'bSurf');
      const bySubdivision = subdivided.ok
        ? `the rational curve is made too, ${num(median(evidence, 'rational/pulled', 'bSurf'))} h from the reference`
        : `the rational curve is not made: ${subdivided.reason}`;
      const measured = `The paper’s method loses ${lost} samples of the four curves, which leap at ${leaps} places. By subdivision with weighted averages of two points ${bySubdivision}. When weights change, fields take ${ms(fieldsMs)} of ${ms(updateMs)}.`;
      const timesDecide = evidence.timesDecide();
      const failing = [
        ...(lost === 0 ? [] : ['the curves lose samples']),
        ...(leaps === 0 ? [] : ['the curves leap']),
        ...(!timesDecide || fieldsMs <= 0.1 * updateMs ? [] : ['fields are made anew']),
        ...(subdivided.ok ? ['subdivision can make rational curves'] : []),
      ];
      if (failing.length === 0) return { verdict: timesDecide ? 'holds' : 'open', measured };
      return { verdict: 'depends', on: `the part: ${failing.join('; ')}`, measured };
    },
  },
  {
    id: 'circle',
    where: '5, inset',
    claim:
      'A circle of rational arcs is much smoother than the linear isoline on a coarse mesh; how equidistant it is, is asked.',
    figure: 'circles',
    judge(evidence) {
      const panel = 'circles/circle';
      const [arcs, linear] = (['circleArcs', 'isolineLinear'] as const).map((id) => ({
        turning: evidence.turning(panel, id),
        away: median(evidence, panel, id),
      })) as [{ turning: number; away: number }, { turning: number; away: number }];
      const study = evidence.study('arcs');
      const smoother = linear.turning / Math.max(arcs.turning, 1e-12);
      const isNearer = arcs.away < linear.away;
      const measured = `The linear isoline turns ${num(smoother)} times as much to and fro as seven arcs, ${num(linear.away)} h from the radius (median) where they are ${num(arcs.away)} h. On a sphere of 20,000 triangles the largest difference from the radius is, by Eq. 4 (level 0) and by our default, ${study.map(({ arcs: count, worst, byDefault }) => `${percent(worst)} and ${percent(byDefault)} with ${count} arcs`).join(', ')}.`;
      if (smoother <= 1) return { verdict: 'does not', measured };
      const reasons = [
        ...(smoother <= alike ? ['smoother, but not much'] : []),
        ...(isNearer ? [] : ['smoother, but not nearer to the radius']),
      ];
      if (reasons.length === 0) return { verdict: 'holds', measured };
      return { verdict: 'depends', on: `what is asked: ${reasons.join('; ')}`, measured };
    },
  },
];
