import type { SurfacePoint } from 'karcher';
import { Vector3 } from 'three';
import { type Figure, isEmpty, isRound } from '../../model/figure';
import type { Pick } from '../../viewer/surface';
import type { Viewer } from '../../viewer/viewer';
import type { Editor } from '../state/editor';

/** The target to which a place snaps. */
export type SnapKind = 'anchor' | 'point' | 'center' | 'curve' | 'vertex' | 'edge';

export interface Snapped extends Pick {
  /** The target; null if the place is the pointer's own. */
  kind: SnapKind | null;
}

/** The largest distance from a target, in CSS pixels, at which a place snaps to the target. */
const within = { mouse: 9, touch: 18 };
/**
 * Corners and sides of a triangle are targets only if each side is at least this long on the stage,
 * in CSS pixels.
 */
const leastSide = 30;

interface Where {
  x: number;
  y: number;
  touch?: boolean;
  /** Whether Ctrl or Cmd is down; nothing snaps then. */
  control: boolean;
}

/** The magnet: it snaps places to nearby points, curves, vertices and edges. */
export class Snapping {
  on = false;

  constructor(
    private readonly editor: Editor,
    private readonly viewer: Viewer,
  ) {}

  /**
   * Whether a click on another object places a point there: the magnet is on, and a curve is under
   * construction.
   */
  placesOn(control: boolean): boolean {
    const { tool, figure, selection } = this.editor.state;
    const goesOn = !isEmpty(figure) && !figure.settings.closed && selection !== null;
    return this.on && !control && tool === 'insert' && this.editor.isOpen && goesOn;
  }

  /**
   * The surface's point for a place of the window, snapped to a target if one is near. The held
   * point of the edited object is no target. Null outside the silhouette.
   */
  pick(where: Where, held: number | string | null = null): Snapped | null {
    const { viewer } = this;
    const free = viewer.pick(where.x, where.y);
    if (!free) return null;
    const own = { ...free, kind: null };
    if (!this.on || where.control) return own;
    const reach = where.touch ? within.touch : within.mouse;
    const place = { x: where.x - viewer.box.left, y: where.y - viewer.box.top };
    return (
      this.#pointNear(place, reach, held) ??
      this.#curveNear(where, reach) ??
      this.#cornerNear(place, reach, free) ??
      own
    );
  }

  #pointNear(
    place: { x: number; y: number },
    reach: number,
    held: number | string | null,
  ): Snapped | null {
    const { viewer } = this;
    const { objects, active } = this.editor.state.drawing;
    let best: { found: Snapped; distance: number } | null = null;
    for (const { id, visible, figure } of objects) {
      if (!visible) continue;
      for (const { point, kind, which } of placesOf(figure)) {
        if (id === active && which === held) continue;
        const position = viewer.surface!.position(point);
        const { x, y, hidden } = viewer.project(position);
        const distance = Math.hypot(x - place.x, y - place.y);
        if (hidden || distance > (best?.distance ?? reach)) continue;
        const { face, bary } = point;
        best = { found: { point: { face, bary }, position, kind }, distance };
      }
    }
    return best?.found ?? null;
  }

  #curveNear({ x, y }: Where, reach: number): Snapped | null {
    const position = this.viewer.linesAt(x, y).nearestOnObjects(reach);
    if (!position) return null;
    const { surface } = this.viewer;
    const point = surface!.nearest(position);
    return { point, position: surface!.position(point), kind: 'curve' };
  }

  /** A corner or a side of the triangle under the pointer, if the triangle is large enough. */
  #cornerNear(place: { x: number; y: number }, reach: number, free: Pick): Snapped | null {
    const { viewer } = this;
    const { face } = free.point;
    const corners = viewer.surface!.corners(face);
    const seen = corners.map((corner) => viewer.project(corner));
    const sides = [0, 1, 2].map((i) => {
      const [from, to] = [seen[i]!, seen[(i + 1) % 3]!];
      return { i, from, dx: to.x - from.x, dy: to.y - from.y };
    });
    if (sides.some(({ dx, dy }) => Math.hypot(dx, dy) < leastSide)) return null;
    const at = (weights: [number, number, number], kind: SnapKind): Snapped => {
      const point: SurfacePoint = { face, bary: weights };
      return { point, position: viewer.surface!.position(point, new Vector3()), kind };
    };
    const near = seen.findIndex(({ x, y }) => Math.hypot(x - place.x, y - place.y) <= reach);
    if (near >= 0) return at([0, 1, 2].map((i) => Number(i === near)) as Weights, 'vertex');
    const found = sides
      .map(({ i, from, dx, dy }) => {
        const along = (place.x - from.x) * dx + (place.y - from.y) * dy;
        const part = Math.min(1, Math.max(0, along / (dx * dx + dy * dy)));
        const off = Math.hypot(from.x + part * dx - place.x, from.y + part * dy - place.y);
        return { i, part, off };
      })
      .sort((a, b) => a.off - b.off)[0]!;
    if (found.off > reach / 2) return null;
    const weights: Weights = [0, 0, 0];
    weights[found.i] = 1 - found.part;
    weights[(found.i + 1) % 3] = found.part;
    return at(weights, 'edge');
  }
}

type Weights = [number, number, number];

/** The places of a figure that points can snap to. */
function placesOf({ kind, points, circle }: Figure): {
  point: SurfacePoint;
  kind: SnapKind;
  which: number | string;
}[] {
  if (isRound(kind))
    return circle ? [{ point: circle.center, kind: 'center', which: 'center' }] : [];
  const name = kind === 'pen' ? 'anchor' : 'point';
  return points.map((point, which) => ({ point, kind: name, which }));
}
