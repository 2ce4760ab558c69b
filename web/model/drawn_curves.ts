/** Curves as they are drawn, for files. */
import type { CurveSamples, Path } from 'karcher';
import type { WrittenFormat } from 'karcher/formats';

export type CurvesFormat = Extract<WrittenFormat, 'obj' | 'glb'> | 'csv';

/** A curve with its look. Its samples give the parameters of its points. */
export interface DrawnCurve {
  name: string;
  path: Path;
  samples: Omit<CurveSamples, 'status'> | null;
  color: [number, number, number];
  /** The radius of a tube, for GLB. */
  radius: number;
}
