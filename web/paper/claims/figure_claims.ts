import type { LineId } from '../figures/types';
import { published } from '../table/rows';
import { nearer } from './method_claims';
import type { Claim, Evidence } from './types';
import { NotMeasured } from './types';
import { ms, num, percent, sum } from './words';

const median = (evidence: Evidence, panel: string, id: LineId) =>
  evidence.line(panel, id).deviation?.median ?? Number.POSITIVE_INFINITY;
const turning = (evidence: Evidence, panel: string, id: LineId) =>
  evidence.line(panel, id).turningNoise ?? Number.POSITIVE_INFINITY;

/** Section 5: the figures and Table 1. */
export const figureClaims: readonly Claim[] = [
  {
    id: 'four-points',
    where: '5, Fig. 1',
    claim: 'The center of four points on a torus is found; in the plane it is the affine average.',
    figure: 'means',
    judge(evidence) {
      const paper = median(evidence, 'means/plane', 'paper');
      const ours = median(evidence, 'means/plane', 'karcher');
      const torus = evidence.line('means/torus', 'paper').ruler?.residual?.median ?? null;
      const own = evidence.line('means/torus', 'karcher').ruler?.residual?.median ?? null;
      const measured = `In a plane of random points the paper’s center is ${num(paper)} h from the average, ours ${num(ours)} h. On the torus the residuals are ${num(torus)} and ${num(own)} h.`;
      if (paper < 1e-6) return { verdict: 'holds', measured };
      return {
        verdict: 'depends',
        on: 'the triangles: its gradients are exact on symmetric rings only',
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
      const [descent, paper, ours] = (['descent', 'paper', 'karcherExact'] as const).map((id) =>
        median(evidence, 'paths/coarse', id),
      ) as [number, number, number];
      const measured = `On the coarse torus descent is ${num(descent)} h from the exact path (median), the paper’s method ${num(paper)} h, ours ${num(ours)} h.`;
      return { verdict: descent > paper ? 'holds' : 'does not', measured };
    },
  },
  {
    id: 'resolution',
    where: '5, Fig. 4',
    claim:
      'On a coarse and on a fine mesh the B-splines of the paper and of weighted averages are smooth; vector heat’s is like the paper’s, but slow.',
    figure: 'resolution',
    judge(evidence) {
      const panels = ['resolution/coarse', 'resolution/fine'];
      const parts = panels.map((panel) => {
        const at = (['paperGraph6', 'weightedAverages', 'vectorHeat', 'karcher'] as const).map(
          (id) => turning(evidence, panel, id),
        );
        const [paper, heat] = (['paperGraph6', 'vectorHeat'] as const).map((id) =>
          evidence.line(panel, id),
        );
        return { panel, at, slower: (heat!.traceMs ?? 0) / Math.max(paper!.traceMs ?? 0, 0.1) };
      });
      const better = nearer(evidence, 'weightedAverages', 'paperGraph6').won.filter((name) =>
        panels.includes(name),
      );
      const measured = `Turning noise of the paper (k = 6), weighted averages, vector heat and ours: ${parts.map(({ panel, at }) => `${at.map((value) => num(value)).join(', ')} rad on ${panel.slice(11)}`).join('; ')}. Vector heat takes ${parts.map(({ slower }) => num(slower)).join(' and ')} times as long as the paper’s method, log maps kept. By exact paths weighted averages are nearer than the paper’s curve on: ${better.map((name) => name.slice(11)).join(', ') || 'none'}.`;
      // A tenth of a degree a sample is hardly seen.
      const smooth = parts.map(({ at }) => Math.max(at[0]!, at[1]!) < 0.1);
      if (smooth.every(Boolean) && parts.every(({ slower }) => slower > 1))
        return { verdict: 'holds', measured };
      return {
        verdict: 'depends',
        on: 'the triangles: on few of uneven shape the curves turn to and fro',
        measured,
      };
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
      const { result } = found.methods.find(({ method }) => method === 'weightedAverages')!;
      const residual = result.ruler?.residual?.median ?? null;
      const embedded = result.prepareMs !== null;
      const measured = embedded
        ? `Weighted averages embed the armadillo of ${found.triangles.toLocaleString('en')} triangles in ${ms(result.prepareMs)}; ${result.lost} of ${result.samples} samples are lost, the residual is ${num(residual)} h. The lion is not at hand.`
        : `Weighted averages fail on the armadillo: ${result.reason}. The lion is not at hand.`;
      return { verdict: embedded ? 'does not' : 'holds', measured };
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
          : `${method === 'paper' ? 'the paper, k = 6' : 'ours'}: ${ms(dragMs)} an update after ${ms(prepareMs)} of preparation`,
      );
      const paper = rows.find(({ method }) => method === 'paper')!;
      const measured = `On a torus of ${paper.triangles.toLocaleString('en')} triangles, 128 samples a segment, in WebAssembly. ${say.join('; ')}.`;
      // Ten a second.
      if (paper.dragMs !== null && paper.dragMs <= 100) return { verdict: 'holds', measured };
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
      const lost = sum(
        ['rational/equal', 'rational/pulled', 'rational/barycentric', 'rational/loose'].map(
          (panel) => evidence.line(panel, 'paper').lost ?? 0,
        ),
      );
      const subdivided = evidence.line('rational/pulled', 'bSurf');
      const measured = `The paper’s method loses ${lost} samples of the four curves. By subdivision with weighted averages of two points the rational curve is made too, ${num(subdivided.deviation?.median ?? null)} h from the reference. When weights change, fields take ${ms(fieldsMs)} of ${ms(updateMs)}.`;
      const kept = fieldsMs <= 0.1 * updateMs;
      if (!subdivided.ok && kept && lost === 0) return { verdict: 'holds', measured };
      return {
        verdict: 'depends',
        on: `the part: the curves ${lost === 0 ? 'behave' : 'lose samples'}, fields are ${kept ? 'kept' : 'made anew'}, but subdivision ${subdivided.ok ? 'can' : 'cannot'} make rational curves`,
        measured,
      };
    },
  },
  {
    id: 'circle',
    where: '5, inset',
    claim:
      'A circle of rational arcs is much smoother than the linear isoline on a coarse mesh; how equidistant it is, is asked.',
    figure: 'circles',
    judge(evidence) {
      const arcs = evidence.line('circles/circle', 'circleArcs');
      const linear = evidence.line('circles/circle', 'isolineLinear');
      const study = evidence.study('arcs');
      const smoother = (linear.turningNoise ?? 0) / Math.max(arcs.turningNoise ?? 0, 1e-12);
      const measured = `Seven arcs turn ${num(smoother)} times less to and fro than the linear isoline, but are farther from the radius: ${num(arcs.deviation?.median ?? null)} h against ${num(linear.deviation?.median ?? null)} h (median). On a sphere of 20,000 triangles the largest difference from the radius is ${study.map(({ arcs: count, worst }) => `${percent(worst)} with ${count} arcs`).join(', ')}.`;
      if (smoother < 1) return { verdict: 'does not', measured };
      const equidistant = (arcs.deviation?.median ?? 0) <= (linear.deviation?.median ?? 0);
      return equidistant
        ? { verdict: 'holds', measured }
        : {
            verdict: 'depends',
            on: 'what is asked: smoother, but not nearer to the radius',
            measured,
          };
    },
  },
];
