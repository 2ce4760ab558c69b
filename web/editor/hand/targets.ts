import type { Vector3 } from 'three';
import { activeObject } from '../../model/drawing';
import { isCurve } from '../../model/figure';
import type { Pick } from '../../viewer/surface';
import type { Viewer } from '../../viewer/viewer';
import type { State } from '../state/state';

/** The target of a click at a place of the window. */
export type Target =
  /** The edited curve: the click adds a point there. */
  | { type: 'curve'; position: Vector3 }
  /** Another object, by its id: the click selects it for editing. */
  | { type: 'other'; id: number }
  /** A path that is shorter than a leg of the curve: the click makes it the leg. */
  | { type: 'shorter'; index: number }
  | { type: 'surface'; pick: Pick };

/** The largest distance from a curve, in CSS pixels, at which a click means the curve. */
export const reach = { mouse: 7, touch: 16 };

/** The largest distance from the curve, in CSS pixels, at which a click measures the curve. */
const measuredWithin = { mouse: 16, touch: 28 };

export function targetAt(
  viewer: Viewer,
  { drawing, figure: { kind }, tool, none }: State,
  place: { x: number; y: number; touch: boolean },
): Target | null {
  // A stroke ignores everything under it.
  if (tool === 'freehand') return null;
  const pick = viewer.pick(place.x, place.y);
  const lines = viewer.linesAt(place.x, place.y);
  if (tool === 'measure') {
    const near = place.touch ? measuredWithin.touch : measuredWithin.mouse;
    const position = isCurve(kind) && !none ? lines.curve(near) : null;
    if (position) return { type: 'curve', position };
    return pick && { type: 'surface', pick };
  }
  const within = place.touch ? reach.touch : reach.mouse;
  if (tool === 'mirror') return pick && { type: 'surface', pick };
  if (tool === 'select' || tool === 'transform' || tool === 'look') {
    // Selected objects come first: a new copy lies over its original.
    const { id, locked } = activeObject(drawing);
    if (!locked && lines.own(within)) return { type: 'other', id };
    const other = lines.object(within);
    if (other !== null) return { type: 'other', id: other };
    const painted = pick && viewer.pickRegion(pick.point);
    return painted === null ? null : { type: 'other', id: painted };
  }
  // The pen edits only its own path: other lines do not interrupt its curve.
  if (kind === 'pen' && tool === 'insert') {
    const own = !none && !activeObject(drawing).locked;
    const position = own ? lines.curve(within) : null;
    if (position) return { type: 'curve', position };
    const shorter = own ? lines.shorter(within) : -1;
    if (shorter >= 0) return { type: 'shorter', index: shorter };
    return pick && { type: 'surface', pick };
  }
  if (none && lines.own(within)) return { type: 'other', id: drawing.active };
  if (isCurve(kind) && !activeObject(drawing).locked) {
    const position = tool !== 'join' && lines.curve(within);
    if (position) return { type: 'curve', position };
    const shorter = tool === 'insert' ? lines.shorter(within) : -1;
    if (shorter >= 0) return { type: 'shorter', index: shorter };
  }
  const other = tool !== 'split' ? lines.object(within) : null;
  if (other !== null) return { type: 'other', id: other };
  if (tool !== 'insert') return null;
  return pick && { type: 'surface', pick };
}
