/**
 * The edits of a document: `apply` gives the document after one, and `invert` the command that takes
 * it back.
 */
import type {
  CircleForm,
  CircleShape,
  ControlPoint,
  CurveDocument,
  CurveSettings,
  Kind,
} from './document';

export type Command =
  | { type: 'insert'; index: number; point: ControlPoint }
  | { type: 'remove'; index: number; point: ControlPoint }
  /** Makes a point the one of another number. */
  | { type: 'reorder'; from: number; to: number }
  /** A point's place, or a number of it. */
  | { type: 'change'; index: number; from: ControlPoint; to: ControlPoint }
  | { type: 'kind'; from: Kind; to: Kind }
  | { type: 'settings'; from: CurveSettings; to: CurveSettings }
  | { type: 'circle'; from: CircleShape | null; to: CircleShape | null }
  | { type: 'circleForm'; from: CircleForm; to: CircleForm }
  | { type: 'replace'; from: CurveDocument; to: CurveDocument };

export function apply(document: CurveDocument, command: Command): CurveDocument {
  const { points } = document;
  switch (command.type) {
    case 'insert':
      return { ...document, points: points.toSpliced(command.index, 0, command.point) };
    case 'remove':
      return { ...document, points: points.toSpliced(command.index, 1) };
    case 'reorder': {
      const left = points.toSpliced(command.from, 1);
      return { ...document, points: left.toSpliced(command.to, 0, points[command.from]!) };
    }
    case 'change':
      return { ...document, points: points.with(command.index, command.to) };
    case 'kind':
      return { ...document, kind: command.to };
    case 'settings':
      return { ...document, settings: command.to };
    case 'circle':
      return { ...document, circle: command.to };
    case 'circleForm':
      return { ...document, circleForm: command.to };
    case 'replace':
      return command.to;
  }
}

export function invert(command: Command): Command {
  switch (command.type) {
    case 'insert':
      return { ...command, type: 'remove' };
    case 'remove':
      return { ...command, type: 'insert' };
    case 'reorder':
      return { ...command, from: command.to, to: command.from };
    case 'change':
      return { ...command, from: command.to, to: command.from };
    case 'kind':
      return { ...command, from: command.to, to: command.from };
    case 'settings':
      return { ...command, from: command.to, to: command.from };
    case 'circle':
      return { ...command, from: command.to, to: command.from };
    case 'circleForm':
      return { ...command, from: command.to, to: command.from };
    case 'replace':
      return { ...command, from: command.to, to: command.from };
  }
}
