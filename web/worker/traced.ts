/** The engine's results in the form that the page draws. */
import type {
  BridgedInterval,
  Circle,
  CurvePoints,
  CurveSamples,
  CurveView,
  Ellipse,
  Path,
} from 'karcher';
import type { LostInterval, LostReason } from '../model/lost';
import type { Fill, TracedCurve, TracedIsolines } from '../model/traced';

export function tracedCurve(
  view: CurveView,
  marks: CurvePoints | null,
  fill: Fill | null,
): TracedCurve {
  const { samples, bridged, knots, levels, legs, drawnLegs, length, times } = view;
  return {
    polyline: view.polyline as Float32Array,
    polylineStatus: view.unconverged,
    samples,
    lost: lostIntervals(samples, bridged),
    knots,
    levels,
    legs: legs as readonly Float32Array[],
    drawnLegs,
    marks,
    arcsNotShortest: 0,
    deviation: null,
    length,
    milliseconds: Object.values(times).reduce((sum, time) => sum + time, 0),
    fill,
    outlines: null,
  };
}

export function tracedCircle(
  circle: Ellipse & Partial<Circle>,
  milliseconds: () => number,
  fill: Fill | null,
): TracedCurve {
  const { path, unconverged, samples, bridged, levels, notShortest } = circle;
  return {
    polyline: path.polyline(),
    polylineStatus: unconverged,
    samples,
    lost: lostIntervals(samples, bridged),
    knots: new Float64Array(),
    levels,
    legs: [],
    drawnLegs: [],
    marks: null,
    arcsNotShortest: notShortest.length,
    deviation: circle.deviation ?? null,
    length: path.length,
    milliseconds: milliseconds(),
    fill,
    outlines: [path],
  };
}

export function tracedLines(
  paths: readonly Path[],
  milliseconds: number,
  fill: Fill | null,
): TracedIsolines {
  const lines = paths.map((line) => ({
    ...{ closed: line.closed, length: line.length },
    polyline: line.polyline(),
  }));
  const length = lines.reduce((sum, line) => sum + line.length, 0);
  return { lines, length, milliseconds, fill, outlines: paths };
}

type Samples = Pick<CurveSamples, 'segment' | 't' | 'position' | 'status'>;

/**
 * The parts of a curve in which its points are not centers of mass, in the curve's order. Bridged
 * parts count, too. Pieces that subdivision alone defines are right and do not count.
 */
export function lostIntervals(
  samples: Samples,
  bridged: readonly BridgedInterval[],
): LostInterval[] {
  const intervals = bridged
    .filter(({ reason }) => reason !== 'subdivided')
    .map(({ segment, t0, t1, reason }) => describe(samples, segment, t0, t1, reason as LostReason));
  const { segment, t, status } = samples;
  let first = 0;
  for (let next = 1; next <= status.length; next++) {
    const same = status[next] === status[first] && segment[next] === segment[first];
    if (next < status.length && same) continue;
    const ended = status[first]!;
    if (ended !== 'converged' && ended !== 'bridged' && ended !== 'subdivided') {
      intervals.push(describe(samples, segment[first]!, t[first]!, t[next - 1]!, ended));
    }
    first = next;
  }
  return intervals.sort((a, b) => a.segment - b.segment || a.from - b.from);
}

function describe(
  { segment, t, position, status }: Samples,
  number: number,
  from: number,
  to: number,
  reason: LostReason,
): LostInterval {
  const middle = (from + to) / 2;
  let samples = 0;
  let nearest = -1;
  for (let i = 0; i < t.length; i++) {
    if (segment[i] !== number) continue;
    if (from <= t[i]! && t[i]! <= to && status[i] !== 'converged') samples++;
    if (nearest < 0 || Math.abs(t[i]! - middle) < Math.abs(t[nearest]! - middle)) nearest = i;
  }
  const place = [0, 1, 2].map((axis) => position[3 * nearest + axis]!);
  return {
    segment: number,
    from,
    to,
    reason,
    samples,
    position: place as [number, number, number],
  };
}
