/**
 * The edits of a drawing: `apply` returns the drawing after a command, and `invert` the command
 * that undoes it. After both, the drawing is the same to the last byte of its JSON. `applyToFigure`
 * and `invertFigureCommand` do the same for a figure.
 */
import { type Drawing, type DrawnObject, indexOf, type Properties } from './drawing';
import {
  type CircleForm,
  type CircleShape,
  type ControlPoint,
  type CurveSettings,
  type Figure,
  type FillRule,
  type Inside,
  type Kind,
  withFittingKnots,
  withInside,
  withRule,
} from './figure';
import { withFittingLegs } from './legs';

export type FigureCommand =
  | { type: 'insert'; index: number; point: ControlPoint }
  | { type: 'remove'; index: number; point: ControlPoint }
  /** Moves a point to another index. */
  | { type: 'reorder'; from: number; to: number }
  /** Changes a point's place, parameters, handles or leg. */
  | { type: 'change'; index: number; from: ControlPoint; to: ControlPoint }
  | { type: 'kind'; from: Kind; to: Kind }
  | { type: 'settings'; from: CurveSettings; to: CurveSettings }
  | { type: 'circle'; from: CircleShape | null; to: CircleShape | null }
  | { type: 'circleForm'; from: CircleForm; to: CircleForm }
  | { type: 'inside'; from: Inside | undefined; to: Inside | undefined }
  | { type: 'rule'; from: FillRule; to: FillRule }
  | { type: 'replace'; from: Figure; to: Figure };

export type Command =
  | { type: 'figure'; id: number; edit: FigureCommand }
  | { type: 'add'; index: number; object: DrawnObject }
  | { type: 'delete'; index: number; object: DrawnObject }
  /** Moves an object to another place of the order. */
  | { type: 'order'; from: number; to: number }
  | { type: 'properties'; id: number; from: Partial<Properties>; to: Partial<Properties> }
  /** Selects another object for editing. */
  | { type: 'activate'; from: number; to: number }
  /** Replaces the drawing by another one. */
  | { type: 'draw'; from: Drawing; to: Drawing }
  /** Several commands as one. */
  | { type: 'steps'; steps: readonly Command[] };

/** Throws if the command belongs to another drawing. */
export function apply(drawing: Drawing, command: Command): Drawing {
  const { objects } = drawing;
  const changed = (id: number, change: (object: DrawnObject) => DrawnObject): Drawing => {
    const index = indexOf(drawing, id);
    if (index < 0) throw new Error(`the drawing has no object ${id}`);
    return { ...drawing, objects: objects.with(index, change(objects[index]!)) };
  };
  switch (command.type) {
    case 'figure':
      return changed(command.id, (object) => ({
        ...object,
        figure: applyToFigure(object.figure, command.edit),
      }));
    case 'add':
      return { ...drawing, objects: objects.toSpliced(command.index, 0, command.object) };
    case 'delete':
      return { ...drawing, objects: objects.toSpliced(command.index, 1) };
    case 'order': {
      const left = objects.toSpliced(command.from, 1);
      return { ...drawing, objects: left.toSpliced(command.to, 0, objects[command.from]!) };
    }
    case 'properties':
      return changed(command.id, (object) => ({ ...object, ...command.to }));
    case 'activate':
      return { ...drawing, active: command.to };
    case 'draw':
      return command.to;
    case 'steps':
      return command.steps.reduce(apply, drawing);
  }
}

export function invert(command: Command): Command {
  switch (command.type) {
    case 'figure':
      return { ...command, edit: invertFigureCommand(command.edit) };
    case 'add':
      return { ...command, type: 'delete' };
    case 'delete':
      return { ...command, type: 'add' };
    case 'steps':
      return { ...command, steps: command.steps.toReversed().map(invert) };
    default:
      return swapped(command);
  }
}

/** Joins commands into one. */
export const joined = (steps: readonly Command[]): Command =>
  steps.length === 1 ? steps[0]! : { type: 'steps', steps };

/** The single commands of a command, in order. */
const stepsOf = (command: Command): readonly Command[] =>
  command.type === 'steps' ? command.steps.flatMap(stepsOf) : [command];

const isBeside = (command: Command) =>
  command.type === 'activate' || (command.type === 'figure' && command.edit.type === 'inside');

/**
 * The edit of an object's figure, if the command changes nothing else; otherwise null. The command
 * may also select an object for editing or set the enclosed side.
 */
export function onlyEditOf(command: Command, id: number): FigureCommand | null {
  const [only, ...more] = stepsOf(command).filter((one) => !isBeside(one));
  return more.length === 0 && only?.type === 'figure' && only.id === id ? only.edit : null;
}

export function applyToFigure(figure: Figure, command: FigureCommand): Figure {
  const { points } = figure;
  switch (command.type) {
    case 'insert':
      return { ...figure, points: points.toSpliced(command.index, 0, command.point) };
    case 'remove':
      return { ...figure, points: points.toSpliced(command.index, 1) };
    case 'reorder': {
      const left = points.toSpliced(command.from, 1);
      return { ...figure, points: left.toSpliced(command.to, 0, points[command.from]!) };
    }
    case 'change':
      return { ...figure, points: points.with(command.index, command.to) };
    case 'kind':
      return { ...figure, kind: command.to };
    case 'settings':
      return { ...figure, settings: command.to };
    case 'circle':
      return { ...figure, circle: command.to };
    case 'circleForm':
      return { ...figure, circleForm: command.to };
    case 'inside':
      return withInside(figure, command.to);
    case 'rule':
      return withRule(figure, command.to);
    case 'replace':
      return command.to;
  }
}

/** The result of a command, with fitting legs and knots. A replacing figure keeps its legs. */
export function fitted(to: Figure, from: Figure, command: FigureCommand): Figure {
  return withFittingKnots(command.type === 'replace' ? to : withFittingLegs(to, from));
}

/** The command in the opposite direction, with its two values swapped. */
export const swapped = <Change extends { from: unknown; to: unknown }>(change: Change): Change => ({
  ...change,
  from: change.to,
  to: change.from,
});

export function invertFigureCommand(command: FigureCommand): FigureCommand {
  switch (command.type) {
    case 'insert':
      return { ...command, type: 'remove' };
    case 'remove':
      return { ...command, type: 'insert' };
    default:
      return swapped(command);
  }
}
