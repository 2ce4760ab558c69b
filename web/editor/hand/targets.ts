import type { Vector3 } from 'three';
import { activeObject } from '../../model/drawing';
import { isCurve } from '../../model/figure';
import type { Pick } from '../../viewer/surface';
import type { Viewer } from '../../viewer/viewer';
import type { State } from '../state/editor';

/** What a click at a place of the window would act on. */
export type Target =
  /** The curve that is edited: a point is put on it there. */
  | { type: 'curve'; position: Vector3 }
  /** An object beside it, by its id: that one is edited next. */
  | { type: 'other'; id: number }
  /** A shorter way than a leg of the curve: the leg takes it. */
  | { type: 'shorter'; index: number }
  | { type: 'surface'; pick: Pick };

/** How near to a curve, in CSS pixels, its clicks are. */
export const reach = { mouse: 7, touch: 16 };

/** What is measured need not be hit. */
const measuredWithin = { mouse: 16, touch: 28 };

export function targetAt(
  viewer: Viewer,
  { drawing, figure: { kind }, tool, none }: State,
  place: { x: number; y: number; touch: boolean },
): Target | null {
  // A stroke goes over all there is.
  if (tool === 'freehand') return null;
  const pick = viewer.pick(place.x, place.y);
  if (tool === 'measure') {
    const near = place.touch ? measuredWithin.touch : measuredWithin.mouse;
    const position = isCurve(kind) && !none ? viewer.pickCurve(place.x, place.y, near) : null;
    if (position) return { type: 'curve', position };
    return pick && { type: 'surface', pick };
  }
  const within = place.touch ? reach.touch : reach.mouse;
  if (tool === 'mirror') return pick && { type: 'surface', pick };
  if (tool === 'select' || tool === 'transform' || tool === 'look') {
    // What was just duplicated lies over what it is a copy of.
    const { id, locked } = activeObject(drawing);
    if (!locked && viewer.pickOwn(place.x, place.y, within)) return { type: 'other', id };
    const other = viewer.pickObject(place.x, place.y, within);
    if (other !== null) return { type: 'other', id: other };
    const painted = pick && viewer.pickRegion(pick.point);
    return painted === null ? null : { type: 'other', id: painted };
  }
  // The pen edits its own path: over another line it goes on as over the surface.
  if (kind === 'pen' && tool === 'insert') {
    const own = !none && !activeObject(drawing).locked;
    const position = own ? viewer.pickCurve(place.x, place.y, within) : null;
    if (position) return { type: 'curve', position };
    const shorter = own ? viewer.pickShorter(place.x, place.y, within) : -1;
    if (shorter >= 0) return { type: 'shorter', index: shorter };
    return pick && { type: 'surface', pick };
  }
  if (none && viewer.pickOwn(place.x, place.y, within))
    return { type: 'other', id: drawing.active };
  if (isCurve(kind) && !activeObject(drawing).locked) {
    const position = tool !== 'join' && viewer.pickCurve(place.x, place.y, within);
    if (position) return { type: 'curve', position };
    const shorter = tool === 'insert' ? viewer.pickShorter(place.x, place.y, within) : -1;
    if (shorter >= 0) return { type: 'shorter', index: shorter };
  }
  const other = tool !== 'split' ? viewer.pickObject(place.x, place.y, within) : null;
  if (other !== null) return { type: 'other', id: other };
  if (tool !== 'insert') return null;
  return pick && { type: 'surface', pick };
}
