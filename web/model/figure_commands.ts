/**
 * The edits of a figure: `applyToFigure` returns the figure after a command, and
 * `invertFigureCommand` the command that undoes it.
 */
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
