/** The engine's results for a drawing, as the page draws and shows them. */
import type { CurvePoints, CurveSamples, DrawnLeg, Path, SurfacePoint } from 'karcher';
import type { Inside } from './figure';
import type { LostInterval } from './lost';

/** A region as it is painted: faces that lie in it as a whole, and triangles that fill its part of others. */
export interface Region {
  whole: Int32Array;
  /** The face of each triangle, in order. */
  parts: Int32Array;
  /** Two numbers for each corner of a triangle: its second and third weight in the triangle's face. */
  corners: Float32Array;
  area: number;
  /** Closed lines that have it to their left. */
  boundary: readonly Path[];
  /** The side of the first line that it lies on; null of what is made of several regions. */
  side: Inside | null;
}

/** A region's triangles with distances at their corners, between which these are linear. */
export interface Pattern {
  faces: Int32Array;
  /** As those of a region. */
  corners: Float32Array;
  values: Float32Array;
}

/** The most lines or bands of a pattern, by the root of its region's area. */
export const mostLines = 1000;

/** Whether a pattern has too many lines to be drawn: the fill is solid then. */
export const isTooFine = (spacing: number, { area }: Pick<Region, 'area'>) =>
  !(Math.sqrt(area) <= mostLines * spacing);

/** The region that closed lines enclose, or a sentence that says why they enclose nothing. */
export type Fill = { region: Region; problem: null } | { region: null; problem: string | null };

/** A curve as the page draws it. */
export interface TracedCurve {
  polyline: Float32Array;
  /** One number for each vertex of the polyline; 1 if its sample did not converge. */
  polylineStatus: Uint8Array;
  /** Without the statuses: `lost` has those. */
  samples: Omit<CurveSamples, 'status'>;
  /** The knots of a B-spline, also where they follow a rule; empty for other curves. */
  knots: Float64Array;
  /** Points at equal lengths along the curve; their number is that of the request. */
  marks: CurvePoints | null;
  /** How many levels the curve has, or the arcs of a circle. */
  levels: number;
  /** The legs of its control polygon, where it has a use for them. */
  legs: readonly Float32Array[];
  /** The same as the engine continues them. */
  drawnLegs: readonly DrawnLeg[];
  /** Where the curve is no center of mass: it is bridged there, by subdivision. */
  lost: LostInterval[];
  /** A circle's arcs whose geodesics from the center stopped being shortest. */
  arcsNotShortest: number;
  /** How far a circle of arcs is from its radius, as a part of the radius. */
  deviation: number | null;
  length: number;
  milliseconds: number;
  /** Null where it was not asked for. */
  fill: Fill | null;
  /** The paths of which other objects are made; null if they were not requested. */
  outlines: readonly Path[] | null;
}

/** A shorter way from a control point to the next than the one that the curve takes. */
export interface ShorterLeg {
  /** The number of the control point. */
  index: number;
  polyline: Float32Array;
  /** Its length as a part of the leg's. */
  part: number;
}

/** The lines of points at one distance, as the page draws them. */
export interface TracedIsolines {
  /** Open ones end at the boundary. */
  lines: { closed: boolean; length: number; polyline: Float32Array }[];
  /** The length of all lines. */
  length: number;
  milliseconds: number;
  /** Null where it was not asked for. */
  fill: Fill | null;
  outlines: readonly Path[];
}

/** A point of a curve, with what is worth knowing there. */
export interface Measured {
  parameter: number;
  point: SurfacePoint;
  position: [number, number, number];
  /** From the curve's start, and of all of it. */
  length: number;
  wholeLength: number;
  /** The derivative by the parameter. */
  tangent: [number, number, number];
}

/** Distances along the surface from a point, as the page draws them. */
export interface TracedDistances {
  /** At the vertices, in the caller's order; minus the farthest where no path leads. */
  values: Float32Array;
  /** The farthest. */
  most: number;
  /** From one line to the next. */
  step: number;
  /** The lines of each multiple of the step, from the first. */
  lines: Float32Array[][];
  /** Whether a path leads to every vertex. */
  complete: boolean;
}
