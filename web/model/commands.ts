/**
 * The edits of a drawing: `apply` returns the drawing after a command, and `invert` the command
 * that undoes it. After both, the drawing is the same to the last byte of its JSON.
 */
import { type Drawing, type DrawnObject, indexOf, type Properties } from './drawing';
import { applyToFigure, type FigureCommand, invertFigureCommand, swapped } from './figure_commands';

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
