import type { SurfacePoint } from 'karcher';
import { type CircleHandle, handleNames, isCircleHandle } from '../../model/circle';
import { activeObject } from '../../model/drawing';
import type { Side } from '../../model/figure';
import { type ControlPoint, isRound } from '../../model/figure';
import type { UnderPointer } from '../../model/pen_hints';
import type { Handle } from '../../viewer/handles';
import type { Surface } from '../../viewer/surface';
import type { View } from '../engine/view';
import type { Selection, State } from '../state/state';

/**
 * The handles of the edited object: one for each control point, or those of a circle or an ellipse.
 * Locked, hidden and unselected objects have none.
 */
export function handlesOf(
  { drawing, figure, selection, more, none }: State,
  view: View,
  surface: Surface,
): Handle[] {
  const { locked, visible } = activeObject(drawing);
  if (locked || !visible || none) return [];
  const { kind, points, circle } = figure;
  if (kind === 'pen') return penHandles(points, view, surface, selection, more);
  if (!isRound(kind)) {
    const name = kind === 'center' || kind === 'points' ? 'Point' : 'Control point';
    return points.map((point, i) => ({
      id: idOf(i),
      position: surface.position(point),
      label: `${name} ${i + 1} of ${points.length}`,
      tag: `${i + 1}`,
      look: 'point',
      selected: selection === i || more.includes(i),
    }));
  }
  if (!circle) return [];
  const names = handleNames(kind);
  const handle = (which: CircleHandle, point: SurfacePoint | undefined, name: string): Handle[] =>
    point
      ? [
          {
            id: idOf(which),
            position: surface.position(point),
            label: `${name} of the ${kind}`,
            tag: names[which],
            look: which === 'center' ? 'center' : 'rim',
            selected: selection === which,
          },
        ]
      : [];
  const rim = 'face' in circle.rim ? circle.rim : view.circle?.rim;
  if (kind === 'circle') {
    return [...handle('center', circle.center, 'Center'), ...handle('rim', rim, 'Radius')];
  }
  return [
    ...handle('center', circle.center, 'Center'),
    ...handle('rim', rim, 'Radius along and direction'),
    ...handle('across', view.circle?.across?.rim, 'Radius across'),
  ];
}

/** The handles of all anchors, and the tangent handles of the selected anchor. */
function penHandles(
  points: readonly ControlPoint[],
  view: View,
  surface: Surface,
  selection: Selection,
  more: readonly number[],
): Handle[] {
  const anchors = points.map(
    (point, i): Handle => ({
      id: idOf(i),
      position: surface.position(point),
      label: `Anchor ${i + 1} of ${points.length}`,
      tag: `${i + 1}`,
      look: 'anchor',
      selected: selection === i || more.includes(i),
    }),
  );
  const anchor = typeof selection === 'number' ? points[selection] : undefined;
  const drawn = typeof selection === 'number' ? view.tangents?.[selection] : undefined;
  if (!anchor || !drawn) return anchors;
  const sides: Side[] = ['before', 'after'];
  const tangents = sides.flatMap((side): Handle[] => {
    const told = anchor.tangents?.[side];
    // A dragged handle appears at its place in the drag, before the engine has answered.
    const point = told && ('face' in told ? told : drawn[side]?.point);
    if (!point) return [];
    return [
      {
        id: tangentId(side, selection as number),
        position: surface.position(point),
        label: `Handle ${side} anchor ${(selection as number) + 1}`,
        tag: side,
        look: 'tangent',
        selected: false,
      },
    ];
  });
  // The tangent handles come right after their anchor in the list, since Tab follows this order.
  return anchors.toSpliced((selection as number) + 1, 0, ...tangents);
}

const tangentId = (side: Side, anchor: number) => `${side}-${anchor}`;

/** The tangent handle with an id; null if the id names something else. */
export function tangentOf(id: string): { side: Side; anchor: number } | null {
  const [, side, anchor] = /^(before|after)-(\d+)$/.exec(id) ?? [];
  return side ? { side: side as Side, anchor: Number(anchor) } : null;
}

export function idOf(selection: NonNullable<Selection>): string {
  return typeof selection === 'number' ? `point-${selection}` : selection;
}

export function selectionOf(id: string): NonNullable<Selection> {
  const tangent = tangentOf(id);
  if (tangent) return tangent.anchor;
  return isCircleHandle(id) ? id : Number(id.slice('point-'.length));
}

/** The part of the pen's curve that the handle with this id represents; null if there is none. */
export function underHandle(id: string): UnderPointer | null {
  const tangent = tangentOf(id);
  if (tangent) return { type: 'handle', side: tangent.side };
  const index = selectionOf(id);
  return typeof index === 'number' && !Number.isNaN(index) ? { type: 'anchor', index } : null;
}

/** The part of the pen's curve that an element represents; null if there is none. */
export function underPointer(element: EventTarget | null): UnderPointer | null {
  const handle = element instanceof Element ? element.closest('.handle') : null;
  return handle instanceof HTMLElement ? underHandle(handle.dataset.id ?? '') : null;
}
