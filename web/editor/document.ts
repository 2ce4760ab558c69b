/**
 * What the user makes on one surface, and the commands that change it. A document is never changed
 * in place: `apply` gives a new one, and `invert` gives the command that takes it back.
 */
import type { CurveKind, SurfacePoint } from 'karcher';

export type Kind = CurveKind | 'circle';
export type Vector = [number, number, number];

/** Where a circle ends: at a point of the surface, or a length away along a direction. */
export type Rim = SurfacePoint | { radius: number; direction: Vector };

export interface CircleShape {
  center: SurfacePoint;
  rim: Rim;
}

export interface CurveDocument {
  readonly kind: Kind;
  /** The control points of the splines; kept while a circle is shown. */
  readonly points: readonly SurfacePoint[];
  readonly circle: CircleShape | null;
}

export type Command =
  | { type: 'insert'; index: number; point: SurfacePoint }
  | { type: 'remove'; index: number; point: SurfacePoint }
  | { type: 'move'; index: number; from: SurfacePoint; to: SurfacePoint }
  | { type: 'kind'; from: Kind; to: Kind }
  | { type: 'circle'; from: CircleShape | null; to: CircleShape | null }
  | { type: 'replace'; from: CurveDocument; to: CurveDocument };

export const emptyDocument: CurveDocument = { kind: 'bspline', points: [], circle: null };

/** Control points a curve of this kind needs before there is a curve. */
export const pointsNeeded: Record<CurveKind, number> = { bspline: 4, bezier: 2 };

/** The point of a face with these weights of its corners 1 and 2, of a sum of at most 1. */
export function surfacePoint(face: number, u: number, v: number): SurfacePoint {
  return { face, bary: [Math.max(0, 1 - u - v), u, v] };
}

export function apply(document: CurveDocument, command: Command): CurveDocument {
  const { points } = document;
  switch (command.type) {
    case 'insert':
      return { ...document, points: points.toSpliced(command.index, 0, command.point) };
    case 'remove':
      return { ...document, points: points.toSpliced(command.index, 1) };
    case 'move':
      return { ...document, points: points.with(command.index, command.to) };
    case 'kind':
      return { ...document, kind: command.to };
    case 'circle':
      return { ...document, circle: command.to };
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
    case 'move':
      return { ...command, from: command.to, to: command.from };
    case 'kind':
      return { ...command, from: command.to, to: command.from };
    case 'circle':
      return { ...command, from: command.to, to: command.from };
    case 'replace':
      return { ...command, from: command.to, to: command.from };
  }
}

/** Whether the user has put nothing on the surface yet, for the kind that is shown. */
export function isEmpty({ kind, points, circle }: CurveDocument): boolean {
  return kind === 'circle' ? circle === null : points.length === 0;
}

/** Removes everything of the kind that is shown. */
export function cleared(document: CurveDocument): CurveDocument {
  return document.kind === 'circle' ? { ...document, circle: null } : { ...document, points: [] };
}
