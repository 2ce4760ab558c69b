import type { BridgedInterval, CurveSamples, Status } from 'karcher';

/** The reason why the points in a part of a curve are not centers of mass. */
export type LostReason = Exclude<Status, 'converged' | 'bridged' | 'subdivided'>;

/** A part of a segment in which the points are not centers of mass. */
export interface LostInterval {
  segment: number;
  /** Parameters of the segment at the ends of the part. */
  from: number;
  to: number;
  reason: LostReason;
  /** The number of samples in the part that did not converge. */
  samples: number;
  /** The place of the sample nearest to the part's middle. */
  position: [number, number, number];
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

/** The number of samples in the intervals. */
export const lostSamples = (intervals: readonly LostInterval[]) =>
  intervals.reduce((sum, { samples }) => sum + samples, 0);
