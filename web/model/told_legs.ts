/** Legs that the engine tells of a drag after it has ended, when more may have been done already. */
import type { SurfacePoint } from 'karcher';
import { apply, type Command, invert, joined, stepsOf } from './commands';
import { type Drawing, objectOf } from './drawing';
import { type Figure, withLeg } from './figure';
import type { FigureCommand } from './figure_commands';
import type { History } from './history';
import { endsOf } from './legs';

/** So many of the newest steps are looked at: more is not done while legs are told. */
const mostSteps = 16;

/** The legs that a drag of points drew out: those that meet there, by the point that each leaves. */
export interface ToldLegs {
  /** The figure that the drag led to. */
  readonly figure: Figure;
  readonly dragged: readonly number[];
  readonly legs: readonly (readonly SurfacePoint[] | null)[];
}

/** The legs of a figure that meet some of its points. */
export const legsAt = ({ points }: Figure, at: readonly number[]): number[] => [
  ...new Set(at.flatMap((i) => [i, (i + points.length - 1) % points.length])),
];

/** The figure with the told legs where they join the same two places and no leg is told. */
function withTold(figure: Figure, { figure: to, dragged, legs }: ToldLegs): Figure {
  const told = legsAt(to, dragged).flatMap((i) =>
    legs[i] ? [{ leg: legs[i], ends: endsOf(to, i) }] : [],
  );
  const points = figure.points.map((point, i) => {
    const found = point.leg ? undefined : told.find(({ ends }) => ends === endsOf(figure, i));
    return found ? withLeg(point, found.leg) : point;
  });
  return points.every((point, i) => point === figure.points[i]) ? figure : { ...figure, points };
}

/** Whether an edit made the dragged points what they are in the figure. */
function made(edit: FigureCommand, { figure, dragged }: ToldLegs): boolean {
  const { points } = figure;
  if (edit.type === 'replace') return dragged.every((i) => edit.to.points[i] === points[i]);
  if (edit.type !== 'change' && edit.type !== 'insert') return false;
  const point = edit.type === 'change' ? edit.to : edit.point;
  return dragged.includes(edit.index) && point === points[edit.index];
}

/** Whether a command holds an object as a whole, which may be the one that the legs are of. */
const holdsObject = (command: Command, id: number): boolean =>
  command.type === 'draw' ||
  ((command.type === 'add' || command.type === 'delete') && command.object.id === id);

/**
 * Makes legs part of the drag that drew them out, and of what was done since: the drawing then. Null, with
 * nothing changed, where that drag is none of the newest steps or its object was made or removed since.
 */
export function tellLegs(history: History, drawing: Drawing, told: ToldLegs): Drawing | null {
  const newest = history.done.slice(-mostSteps).map(stepsOf);
  const singles = [...newest.flat(), ...history.activated];
  const first = singles.findIndex((step) => step.type === 'figure' && made(step.edit, told));
  const drag = singles[first];
  if (drag?.type !== 'figure') return null;
  const { id } = drag;
  if (singles.slice(first + 1).some((step) => holdsObject(step, id))) return null;
  // The figure after each step from the drag on, and before it.
  const undone = singles.slice(first).toReversed();
  const figures = [objectOf(drawing, id)!.figure];
  let back = drawing;
  for (const step of undone) {
    back = apply(back, invert(step));
    figures.unshift(objectOf(back, id)!.figure);
  }
  const kept = figures.map((figure, i) => (i === 0 ? figure : withTold(figure, told)));
  const instead = new Map<Command, Command>();
  for (const [i, step] of singles.slice(first).entries()) {
    if (step.type !== 'figure' || step.id !== id) continue;
    const edit: FigureCommand = { type: 'replace', from: kept[i]!, to: kept[i + 1]! };
    instead.set(step, { ...step, edit });
  }
  const replaced = (steps: readonly Command[]) => steps.map((step) => instead.get(step) ?? step);
  history.done.splice(-newest.length, newest.length, ...newest.map((s) => joined(replaced(s))));
  return replaced(singles.slice(first)).reduce(apply, back);
}
