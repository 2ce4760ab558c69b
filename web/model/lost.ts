import type { Status } from 'karcher';

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

/** The number of samples in the intervals. */
export const lostSamples = (intervals: readonly LostInterval[]) =>
  intervals.reduce((sum, { samples }) => sum + samples, 0);
