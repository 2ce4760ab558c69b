import type { SurfacePoint } from 'karcher';
import { type CircleHandle, handleNames, isCircleHandle } from '../model/circle';
import { activeObject } from '../model/drawing';
import { isRound } from '../model/figure';
import type { Handle } from '../viewer/handles';
import type { Surface } from '../viewer/surface';
import type { Selection, State } from './editor';
import type { View } from './session';

/**
 * The handles of what is edited: one a control point, or those of a circle or an ellipse; none of
 * what is locked or not shown.
 */
export function handlesOf(
  { drawing, figure, selection }: State,
  view: View,
  surface: Surface,
): Handle[] {
  const { locked, visible } = activeObject(drawing);
  if (locked || !visible) return [];
  const { kind, points, circle } = figure;
  if (!isRound(kind)) {
    const name = kind === 'center' || kind === 'points' ? 'Point' : 'Control point';
    return points.map((point, i) => ({
      id: idOf(i),
      position: surface.position(point),
      label: `${name} ${i + 1} of ${points.length}`,
      tag: `${i + 1}`,
      look: 'point',
      selected: selection === i,
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

export function idOf(selection: NonNullable<Selection>): string {
  return typeof selection === 'number' ? `point-${selection}` : selection;
}

export function selectionOf(id: string): NonNullable<Selection> {
  return isCircleHandle(id) ? id : Number(id.slice('point-'.length));
}
