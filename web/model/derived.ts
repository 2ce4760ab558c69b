/**
 * Derived objects, which follow other objects of their drawing: offsets, booleans and cuts. They
 * store only their settings and the ids of these objects, called their sources; their lines follow
 * from the lines of the sources.
 */
import type { SurfacePoint } from 'karcher';

export const booleans = ['union', 'intersection', 'difference', 'exclusion'] as const;
export type BooleanKind = (typeof booleans)[number];
export type DerivedKind = BooleanKind | 'offset' | 'cut';

/** The side of an offset. For an open curve, inwards is its left. */
export const offsetSides = ['outwards', 'inwards', 'both'] as const;
export type OffsetSide = (typeof offsetSides)[number];

/** The shape of corners on their outer side. Drawings do not store the default, round. */
export const cornerShapes = ['round', 'miter', 'bevel'] as const;
export type CornerShape = (typeof cornerShapes)[number];

export interface Offset {
  readonly distance: number;
  /**
   * The distance at the end of an open curve, and halfway round a closed one, if it differs from
   * the distance at the start.
   */
  readonly end?: number | undefined;
  readonly side: OffsetSide;
  readonly corners?: CornerShape | undefined;
}

/** A choice for a part of a cut surface. Files contain hidden parts, too. */
export type PartState = 'hidden' | 'deleted';

/** A choice for the part of a cut surface that contains a point. */
export interface PartChoice {
  readonly point: SurfacePoint;
  readonly state: PartState;
}

export interface Derived {
  /** The ids of the sources, in order: a difference is the first minus the others. */
  readonly sources: readonly number[];
  /** The distance, side and corners of an offset. */
  readonly offset?: Offset;
  /** The choices for parts of a cut; parts without a choice stay. */
  readonly parts?: readonly PartChoice[];
  /** The thickness of the parts of a cut in saved files; with 0 they are surfaces. */
  readonly thickness?: number;
}

export const mostParts = 1000;

/**
 * An offset without its defaults. If its distance at the end differs, the offset's corners are
 * round.
 */
export function plainOffset({ distance, end = distance, side, corners = 'round' }: Offset): Offset {
  const isEven = end === distance;
  return {
    distance,
    ...(!isEven && { end }),
    side,
    ...(isEven && corners !== 'round' && { corners }),
  };
}

export const isBoolean = (kind: string): kind is BooleanKind =>
  (booleans as readonly string[]).includes(kind);

export const isDerived = (kind: string): kind is DerivedKind =>
  isBoolean(kind) || kind === 'offset' || kind === 'cut';
