/** The figure of one object of a drawing: an immutable value. */
import type { CurveKind, CurveLevels, Parametrization, SurfacePoint } from 'karcher';
import { type Derived, type DerivedKind, isDerived } from './derived';

/** The side of a line that is its inside, as seen along the line. */
export type Inside = 'left' | 'right';

/** The rules by which lines that cross themselves enclose a region, as in SVG. */
export const fillRules = ['evenOdd', 'nonZero'] as const;
export type FillRule = (typeof fillRules)[number];

/** A curve with control points. Curves with a basis of the user's own are for programs only. */
export type SplineKind = Exclude<CurveKind, 'custom'>;
/**
 * The kind of a figure. `pen` is a curve of anchors with handles; `center` is no curve but the
 * center of mass of the points; `points` are the points alone.
 */
export type Kind = SplineKind | 'pen' | RoundKind | 'center' | 'points' | DerivedKind;
/** A kind of closed line around a center. */
export type RoundKind = 'circle' | 'ellipse';
export type Vector = [number, number, number];

/** The end of a circle's radius: a point of the surface, or a length along a direction. */
export type Rim = SurfacePoint | { radius: number; direction: Vector };

/**
 * An ellipse's second radius, in the direction across the first one: a length, or a point of the
 * surface. The radius is then the distance of the point in this direction.
 */
export type Across = SurfacePoint | { radius: number };

/** The name of a control point's parameter besides its place. */
export type ParameterName = 'weight' | 'beta';

/** The side of a pen anchor on which a handle lies. */
export type Side = 'before' | 'after';

/**
 * The place of a handle: a point of the surface, the end of a vector in the anchor's tangent plane,
 * or the place opposite to the anchor's other handle. An opposite handle has a length of its own,
 * or the other handle's length if its `length` is null.
 */
export type Tangent =
  | SurfacePoint
  | { readonly direction: Vector; readonly length: number }
  | { readonly length: number | null };

export type Tangents = { readonly [Which in Side]?: Tangent };

/** A point that the user placed. Its weight and its beta default to 1. */
export type ControlPoint = SurfacePoint & { readonly [Name in ParameterName]?: number } & {
  /**
   * Points on the path to the next point, if this path is not the shortest. For the pen, the path
   * leads from the handle after this anchor to the handle before the next anchor.
   */
  readonly leg?: readonly SurfacePoint[];
  /** The handles of an anchor of the pen. */
  readonly tangents?: Tangents;
  /** The origin of the piece to the next point, if the curve has replaced other objects. */
  readonly origin?: Origin;
};

/**
 * The origin of a piece of a curve: the name of the object from which it comes, and the ends of the
 * piece on this object's line, from 0 at the line's start to 1 at its end.
 */
export interface Origin {
  readonly of: string;
  readonly from: number;
  readonly to: number;
}

/** The shape of a circle and of an ellipse. A circle keeps the fields of an ellipse, so that it can become one again. */
export interface CircleShape {
  center: SurfacePoint;
  rim: Rim;
  /** The radius across of an ellipse; the default is a fixed fraction of the radius to the rim. */
  across?: Across;
}

/**
 * The construction of a circle: rational quadratic arcs, or the isoline of the distance from its
 * center, linear in each triangle or exact.
 */
export type CircleType = 'arcs' | 'linear' | 'exact';

/** The settings of a circle besides its shape; other kinds keep them. */
export interface CircleForm {
  readonly type: CircleType;
  /**
   * The number of rational arcs, 3 to 24; 'auto' for as many as the tolerance of the radius needs.
   */
  readonly arcs: number | 'auto';
}

/** The settings of a spline besides its points; other kinds keep them. */
export interface CurveSettings {
  readonly closed: boolean;
  /** The degree of a B-spline, 1 to 5. */
  readonly degree: number;
  /** Whether an open B-spline begins and ends at its end points, since its knots repeat there. */
  readonly clamped: boolean;
  /**
   * The B-spline's own knots; null if they are uniform or clamped. Their number follows from the
   * number of points.
   */
  readonly knots: readonly number[] | null;
  /** The parametrization of a Catmull-Rom curve. */
  readonly parametrization: Parametrization;
  /** The number of samples for each segment, if there is no tolerance. */
  readonly samples: number;
  /**
   * The tolerance between samples, relative to the surface's size, or null. The engine takes as
   * many samples as the tolerance needs.
   */
  readonly tolerance: number | null;
  /** The number of evenly spaced marks along the curve. */
  readonly marks: number;
  /**
   * The levels of subdivision, or 'auto' or 'limit'. With 0 a sample is the mean of all points;
   * more levels make the curve steadier on rough surfaces.
   */
  readonly levels: CurveLevels;
  /** The least number of levels during a drag, so that the number never falls; never in files. */
  readonly leastLevels?: number;
  /**
   * Whether the curve is a draft of a drag. Its levels may then lie at any distance from the curve
   * of level 0. Never in files.
   */
  readonly draft?: boolean;
}

/** A curve with control points. */
export interface Spline {
  readonly kind: SplineKind;
  readonly settings: CurveSettings;
  readonly points: readonly ControlPoint[];
}

/** A source of a figure, with its object's id. */
export interface Operand {
  readonly id: number;
  readonly figure: Figure;
}

/** A figure of any kind. The kind decides which of the other fields the page uses. */
export interface Figure {
  readonly kind: Kind;
  readonly settings: CurveSettings;
  /** The points. Circles and ellipses keep them, but do not use them. */
  readonly points: readonly ControlPoint[];
  readonly circle: CircleShape | null;
  readonly circleForm: CircleForm;
  /** The side that the figure encloses; by default the smaller one. A choice or a drag sets it. */
  readonly inside?: Inside;
  /** The rule by which the figure encloses a region; even-odd, the default, is not stored. */
  readonly rule?: 'nonZero';
  /** The derivation; only derived figures use it. */
  readonly derived?: Derived;
  /** The figures of the sources, after `resolvedFigure` has added them; never in files. */
  readonly operands?: readonly Operand[];
}

export const opposite = (side: Inside): Inside => (side === 'left' ? 'right' : 'left');

export function withInside(figure: Figure, side: Inside | undefined): Figure {
  const { inside: _, ...rest } = figure;
  return side ? { ...rest, inside: side } : rest;
}

export function withRule(figure: Figure, rule: FillRule): Figure {
  const { rule: _, ...rest } = figure;
  return rule === 'nonZero' ? { ...rest, rule } : rest;
}

/** The side and the rule by which a figure's lines enclose a region, without defaults. */
export type Enclosing = Pick<Figure, 'inside' | 'rule'>;
export const enclosingOf = ({ inside, rule }: Figure): Enclosing => ({
  ...(inside && { inside }),
  ...(rule && { rule }),
});

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

/** The levels of a curve in the engine's form. */
export const askedLevels = ({ levels, leastLevels = 0, draft = false }: CurveSettings) => ({
  levels: draft ? { tolerance: Infinity } : levels,
  ...(leastLevels > 0 && { leastLevels }),
});

/** The ranges of the settings' numbers. */
export const samplesRange = { least: 2, most: 5000 };
export const toleranceRange = { least: 1e-6, most: 0.1 };
/** The range of the number of marks. A single mark would be no even spacing. */
export const marksRange = { least: 2, most: 1000 };
export const mostLevels = 8;
/**
 * The largest number of points of a leg. The engine describes a leg by a few points, or by a point
 * at each edge that the leg crosses: thousands of points on a large surface.
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

/** Whether a kind is a curve through or near its points, and so may be closed. */
export const isCurve = (kind: Kind) => isSpline(kind) || kind === 'pen';

export function isRound(kind: Kind): kind is RoundKind {
  return kind === 'circle' || kind === 'ellipse';
}

/** The least number of points with which the figure is visible. */
export function pointsNeeded({ kind, settings }: Figure): number {
  if (kind === 'center' || kind === 'points') return 1;
  if (kind === 'pen') return 2;
  if (settings.closed) return 3;
  return kind === 'bspline' ? settings.degree + 1 : 2;
}

/** Whether the figure has points, but too few to be visible. */
export function isUnfinished(figure: Figure): boolean {
  const { kind, points } = figure;
  if (isRound(kind) || isDerived(kind)) return false;
  return points.length > 0 && points.length < pointsNeeded(figure);
}

/** The parameter that points of a kind have besides their places; null if they have none. */
export function parameterOf(kind: Kind): ParameterName | null {
  if (kind === 'barycentric') return 'beta';
  return kind === 'center' || kind === 'rational' || kind === 'bspline' ? 'weight' : null;
}

/**
 * The range of the sliders for weights and betas. It extends by the same factor below and above 1.
 */
export const parameterRange = { least: 1 / 16, most: 16 };

/** The point with another value of a parameter; the default, 1, is not stored. */
export function withParameter(
  point: ControlPoint,
  name: ParameterName,
  value: number,
): ControlPoint {
  if ((point[name] ?? 1) === value) return point;
  const { [name]: _, ...rest } = point;
  return value === 1 ? rest : { ...rest, [name]: value };
}

/**
 * The point with another path to the next point. The shortest path, the default, is not stored, and
 * neither is a path without points of its own, which is the shortest.
 */
export function withLeg(
  point: ControlPoint,
  leg: readonly SurfacePoint[] | null | undefined,
): ControlPoint {
  const stored = leg?.length ? leg : undefined;
  if (stored === point.leg) return point;
  const { leg: _, ...rest } = point;
  return stored ? { ...rest, leg: stored } : rest;
}

/**
 * The point of a face with the weights `u` and `v` of its corners 1 and 2. Their sum is at most 1.
 */
export function surfacePoint(face: number, u: number, v: number): SurfacePoint {
  return { face, bary: [Math.max(0, 1 - u - v), u, v] };
}

/** The place of a point, without its other properties. */
export const plain = ({ face, bary }: SurfacePoint): SurfacePoint => ({ face, bary });

/** Whether the figure has no points, circle or sources yet, whichever its kind has. */
export function isEmpty({ kind, points, circle, derived }: Figure): boolean {
  if (isDerived(kind)) return (derived?.sources.length ?? 0) === 0;
  return isRound(kind) ? circle === null : points.length === 0;
}

/**
 * The figure without its points, circle or sources, whichever its kind has, and without the inside
 * of its line. Its settings stay, except knots that no longer fit.
 */
export function cleared(whole: Figure): Figure {
  const figure = withInside(whole, undefined);
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

/** The figure with `move` applied to each of its places on the surface. */
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

/** Whether the number of knots fits the points. Uniform and clamped knots always fit. */
export function knotsFit({ settings, points }: Pick<Spline, 'settings' | 'points'>): boolean {
  const { knots, closed, degree } = settings;
  return !knots || knots.length === points.length + 1 + (closed ? 0 : degree);
}

/** The figure, with uniform or clamped knots if its own knots are for another number of points. */
export function withFittingKnots<Of extends Pick<Spline, 'settings' | 'points'>>(spline: Of): Of {
  if (knotsFit(spline)) return spline;
  return { ...spline, settings: { ...spline.settings, knots: null } };
}
