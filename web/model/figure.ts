/** The figure of one object of a drawing: a value, which is never changed in place. */
import type { CurveKind, CurveLevels, Parametrization, SurfacePoint } from 'karcher';
import { type Derived, type DerivedKind, isDerived } from './derived';

/** The side of a line, seen along it, that is inside what it encloses. */
export type Inside = 'left' | 'right';

/** A curve with control points; a basis of one's own is for programs. */
export type SplineKind = Exclude<CurveKind, 'custom'>;
/** `pen` is a curve of anchors with handles; `center` is no curve: the center of mass of the points; `points` are the points alone. */
export type Kind = SplineKind | 'pen' | RoundKind | 'center' | 'points' | DerivedKind;
/** Around a center. */
export type RoundKind = 'circle' | 'ellipse';
export type Vector = [number, number, number];

/** Where a circle ends: at a point of the surface, or a length away along a direction. */
export type Rim = SurfacePoint | { radius: number; direction: Vector };

/**
 * An ellipse's radius across its first one: a length, or the distance at which a point of the surface lies in
 * that direction.
 */
export type Across = SurfacePoint | { radius: number };

/** A control point's number beside its place. */
export type ParameterName = 'weight' | 'beta';

/** The side of an anchor of the pen on which a handle is. */
export type Side = 'before' | 'after';

/**
 * The place of a handle: a point of the surface, the end of a vector in the anchor's tangent plane, or opposite
 * to the anchor's other handle, at a given length or (null) at the same one.
 */
export type Tangent =
  | SurfacePoint
  | { readonly direction: Vector; readonly length: number }
  | { readonly length: number | null };

export type Tangents = { readonly [Which in Side]?: Tangent };

/** A point that the user placed; what is not given is 1. */
export type ControlPoint = SurfacePoint & { readonly [Name in ParameterName]?: number } & {
  /**
   * Points that the way to the next point goes through, where it is not the shortest; of an anchor of the pen
   * the way from the handle after it to the one before the next anchor.
   */
  readonly leg?: readonly SurfacePoint[];
  /** Of an anchor of the pen. */
  readonly tangents?: Tangents;
};

/** The shape of a circle and of an ellipse. A circle keeps the fields of an ellipse, so that it can become one again. */
export interface CircleShape {
  center: SurfacePoint;
  rim: Rim;
  /** Used by ellipses only; the default is a part of the radius to the rim. */
  across?: Across;
}

/**
 * The construction of a circle: rational quadratic arcs, or the isoline of the distance from its center,
 * interpolated in triangles or exact.
 */
export type CircleType = 'arcs' | 'linear' | 'exact';

/** The settings of a circle beside its shape; kept while another kind is shown. */
export interface CircleForm {
  readonly type: CircleType;
  /** How many rational arcs, 3 to 24, or as many as keep to the radius. */
  readonly arcs: number | 'auto';
}

/** The settings of a spline beside its points; kept while another kind is shown. */
export interface CurveSettings {
  readonly closed: boolean;
  /** The degree of a B-spline, 1 to 5. */
  readonly degree: number;
  /** Whether an open B-spline's knots are repeated at its ends, which the curve then reaches. */
  readonly clamped: boolean;
  /** The knots of a B-spline, if they are neither even nor clamped; their number follows from its points. */
  readonly knots: readonly number[] | null;
  /** The parametrization of a Catmull-Rom curve. */
  readonly parametrization: Parametrization;
  /** A segment, where there is no tolerance. */
  readonly samples: number;
  /**
   * The tolerance between samples, as a part of the surface's size; the engine takes as many samples as it
   * needs.
   */
  readonly tolerance: number | null;
  /** How many points are marked evenly along the curve. */
  readonly marks: number;
  /** The steadiness of a curve on rough surfaces, from the mean of all its points to the limit of subdivision. */
  readonly levels: CurveLevels;
  /** The least levels during a drag, which keeps the most that it has had; never saved. */
  readonly leastLevels?: number;
  /** Used during a drag: whether levels may move the curve as far as they do; never saved. */
  readonly draft?: boolean;
}

/** A curve with control points. */
export interface Spline {
  readonly kind: SplineKind;
  readonly settings: CurveSettings;
  readonly points: readonly ControlPoint[];
}

/** A figure that another one is made of, and its object's id. */
export interface Operand {
  readonly id: number;
  readonly figure: Figure;
}

/** A curve, a circle, a center or points: what is drawn of it is its kind's part. */
export interface Figure {
  readonly kind: Kind;
  readonly settings: CurveSettings;
  /** The points of all kinds but the round ones; kept while one of those is shown. */
  readonly points: readonly ControlPoint[];
  readonly circle: CircleShape | null;
  readonly circleForm: CircleForm;
  /** The side that the figure encloses: the smaller one until a side is chosen or a drag begins. */
  readonly inside?: Inside;
  /** Used only by figures that are made of others. */
  readonly derived?: Derived;
  /** The figures of these, if they are filled in (`resolvedFigure`); never saved. */
  readonly operands?: readonly Operand[];
}

export const opposite = (side: Inside): Inside => (side === 'left' ? 'right' : 'left');

export function withInside(figure: Figure, side: Inside | undefined): Figure {
  const { inside: _, ...rest } = figure;
  return side ? { ...rest, inside: side } : rest;
}

export const defaultSettings: CurveSettings = {
  closed: false,
  degree: 3,
  clamped: true,
  knots: null,
  parametrization: 'centripetal',
  samples: 128,
  tolerance: null,
  marks: 0,
  levels: 'auto',
};

/** The levels of a curve as the engine takes them. */
export const askedLevels = ({ levels, leastLevels = 0, draft = false }: CurveSettings) => ({
  levels: draft ? { tolerance: Infinity } : levels,
  ...(leastLevels > 0 && { leastLevels }),
});

/** The ranges of the settings' numbers. */
export const samplesRange = { least: 2, most: 5000 };
export const toleranceRange = { least: 1e-6, most: 0.1 };
/** One alone would be no even spacing. */
export const marksRange = { least: 2, most: 1000 };
export const mostLevels = 8;
/**
 * The engine describes a leg by a few points, or by one at each edge that it crosses, which makes thousands on
 * a large surface.
 */
export const mostLegPoints = 20_000;

export const fewestArcs = 3;
export const mostArcs = 24;

export const defaultCircleForm: CircleForm = { type: 'arcs', arcs: 'auto' };

export const emptyFigure: Figure = {
  kind: 'bspline',
  settings: defaultSettings,
  points: [],
  circle: null,
  circleForm: defaultCircleForm,
};

/** The kinds in the menu's order. */
export const kinds: readonly Kind[] = [
  'bspline',
  'bezier',
  'catmullrom',
  'rational',
  'barycentric',
  'polyline',
  'circle',
  'ellipse',
  'center',
  'points',
  'pen',
  'offset',
  'union',
  'intersection',
  'difference',
  'exclusion',
  'cut',
];

/** Whether a kind is a curve with control points. */
export function isSpline(kind: Kind): kind is SplineKind {
  const isOther = kind === 'center' || kind === 'points' || kind === 'pen';
  return !isOther && !isRound(kind) && !isDerived(kind);
}

/** Whether a kind is a curve through or near its points, which may be closed. */
export const isCurve = (kind: Kind) => isSpline(kind) || kind === 'pen';

export function isRound(kind: Kind): kind is RoundKind {
  return kind === 'circle' || kind === 'ellipse';
}

/** Points that are needed before there is anything to show. */
export function pointsNeeded({ kind, settings }: Figure): number {
  if (kind === 'center' || kind === 'points') return 1;
  if (kind === 'pen') return 2;
  if (settings.closed) return 3;
  return kind === 'bspline' ? settings.degree + 1 : 2;
}

/** Whether there are points of it already, but too few to show anything of them. */
export function isUnfinished(figure: Figure): boolean {
  const { kind, points } = figure;
  if (isRound(kind) || isDerived(kind)) return false;
  return points.length > 0 && points.length < pointsNeeded(figure);
}

/** The number that a kind's points have beside their places. */
export function parameterOf(kind: Kind): ParameterName | null {
  if (kind === 'barycentric') return 'beta';
  return kind === 'center' || kind === 'rational' || kind === 'bspline' ? 'weight' : null;
}

/** The range in which sliders set numbers of points: as far from 1 one way as the other. */
export const parameterRange = { least: 1 / 16, most: 16 };

/** The point with one of its numbers changed; 1 is what is not said. */
export function withParameter(
  point: ControlPoint,
  name: ParameterName,
  value: number,
): ControlPoint {
  if ((point[name] ?? 1) === value) return point;
  const { [name]: _, ...rest } = point;
  return value === 1 ? rest : { ...rest, [name]: value };
}

/** Another way to the next point than the shortest, which is the default. */
export function withLeg(
  point: ControlPoint,
  leg: readonly SurfacePoint[] | null | undefined,
): ControlPoint {
  if ((leg ?? undefined) === point.leg) return point;
  const { leg: _, ...rest } = point;
  return leg ? { ...rest, leg } : rest;
}

/** The point of a face with these weights of its corners 1 and 2, of a sum of at most 1. */
export function surfacePoint(face: number, u: number, v: number): SurfacePoint {
  return { face, bary: [Math.max(0, 1 - u - v), u, v] };
}

/** The place of a point, without its other properties. */
export const plain = ({ face, bary }: SurfacePoint): SurfacePoint => ({ face, bary });

/** Whether nothing of the figure's kind is on the surface yet. */
export function isEmpty({ kind, points, circle, derived }: Figure): boolean {
  if (isDerived(kind)) return (derived?.sources.length ?? 0) === 0;
  return isRound(kind) ? circle === null : points.length === 0;
}

/** The figure without the points and settings of its kind. */
export function cleared(figure: Figure): Figure {
  if (isRound(figure.kind)) return { ...figure, circle: null };
  if (isDerived(figure.kind)) {
    const { derived: _, ...rest } = figure;
    return { ...rest, points: [] };
  }
  return withFittingKnots({ ...figure, points: [] });
}

function withTangentPlaces(
  { before, after }: Tangents,
  move: (point: SurfacePoint) => SurfacePoint,
): Tangents {
  const moved = (tangent: Tangent) => ('face' in tangent ? move(tangent) : tangent);
  return { ...(before && { before: moved(before) }), ...(after && { after: moved(after) }) };
}

/** The figure with each of its places on the surface taken to another one. */
export function withPlaces(figure: Figure, move: (point: SurfacePoint) => SurfacePoint): Figure {
  const { circle } = figure;
  const moved = (point: ControlPoint): ControlPoint => ({
    ...point,
    ...move(point),
    ...(point.leg && { leg: point.leg.map(move) }),
    ...(point.tangents && { tangents: withTangentPlaces(point.tangents, move) }),
  });
  const reached = <Place extends object>(place: Place | SurfacePoint) =>
    'face' in place ? move(place) : place;
  return {
    ...figure,
    points: figure.points.map(moved),
    circle: circle && {
      center: move(circle.center),
      rim: reached(circle.rim),
      ...(circle.across && { across: reached(circle.across) }),
    },
  };
}

/** Whether the number of knots fits the points; knots that follow a rule always fit. */
export function knotsFit({ settings, points }: Pick<Spline, 'settings' | 'points'>): boolean {
  const { knots, closed, degree } = settings;
  return !knots || knots.length === points.length + 1 + (closed ? 0 : degree);
}

/** The figure without its own knots if they are for another number of points; it then has even ones. */
export function withFittingKnots<Of extends Pick<Spline, 'settings' | 'points'>>(spline: Of): Of {
  if (knotsFit(spline)) return spline;
  return { ...spline, settings: { ...spline.settings, knots: null } };
}
