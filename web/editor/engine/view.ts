import type { Quality } from '../../model/methods';
import type { ShorterLeg } from '../../model/traced';
import type { Beside } from './beside';
import { nothing, type Shift, type Shown } from './compute';

/** The engine's results for a state of the editor. */
export interface View extends Shown {
  /** The revision of the state. */
  revision: number;
  /** The quality of the view; null for the paper's methods, or without a visible result. */
  quality: Quality | null;
  /** Whether a better answer is to come. */
  refining: boolean;
  /** The distance of the exact answer from the draft that it replaced, in mean edges. */
  shift: Shift | null;
  /** A sentence that says why a draft is final. */
  notRefined: string | null;
  /**
   * Geodesics between neighbouring points, from a center of mass to its points, or along a radius.
   */
  legs: readonly Float32Array[];
  /** Paths between neighbouring points that are noticeably shorter than the curve's legs. */
  shorter: readonly ShorterLeg[];
  /** The drawing's other objects that are visible. */
  others: readonly Beside[];
  /** Whether only the polygon is visible, since the curve has too few points. */
  polygonOnly: boolean;
}

export const emptyView: View = {
  ...nothing,
  revision: 0,
  quality: null,
  refining: false,
  shift: null,
  notRefined: null,
  legs: [],
  shorter: [],
  others: [],
  polygonOnly: false,
};
