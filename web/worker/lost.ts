import type { CurveSamples, Status } from 'karcher';

/** Neighbouring samples of one segment whose searches ended alike, and not at a center of mass. */
export interface LostInterval {
  segment: number;
  /** The parameters of the first and the last of them. */
  from: number;
  to: number;
  status: Exclude<Status, 'converged'>;
  samples: number;
  /** Where the middle one is. */
  position: [number, number, number];
}

/** The intervals of a curve without centers of mass, in the curve's order. */
export function lostIntervals({ segment, t, position, status }: CurveSamples): LostInterval[] {
  const intervals: LostInterval[] = [];
  let first = 0;
  for (let next = 1; next <= status.length; next++) {
    const same = status[next] === status[first] && segment[next] === segment[first];
    if (next < status.length && same) continue;
    const ended = status[first]!;
    if (ended !== 'converged') {
      const middle = 3 * ((first + next - 1) >> 1);
      intervals.push({
        segment: segment[first]!,
        from: t[first]!,
        to: t[next - 1]!,
        status: ended,
        samples: next - first,
        position: [position[middle]!, position[middle + 1]!, position[middle + 2]!],
      });
    }
    first = next;
  }
  return intervals;
}

/** How many samples the intervals hold. */
export const lostSamples = (intervals: readonly LostInterval[]) =>
  intervals.reduce((sum, { samples }) => sum + samples, 0);
