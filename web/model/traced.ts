/** The engine's results for a drawing, as the page draws and shows them. */
import type { CurvePoints, CurveSamples, DrawnLeg, Path, SurfacePoint } from 'karcher';
import type { Inside } from './figure';
import type { LostInterval } from './lost';

/** A painted region: whole faces, and triangles that fill the region's parts of other faces. */
export interface Region {
  whole: Int32Array;
  /** The face of each triangle, in order. */
  parts: Int32Array;
  /** Two numbers for each corner of a triangle: its second and third weight in the triangle's face. */
  corners: Float64Array;
  area: number;
  /** Closed lines with the region on their left. */
  boundary: readonly Path[];
  /** The side of the first line on which the region lies; null for a union of several regions. */
  side: Inside | null;
}

/**
 * A region's triangles with distances at their corners. The distances are linear in each triangle.
 */
export interface Pattern {
  faces: Int32Array;
  /** The weights of the triangles' corners, as in a region. */
  corners: Float64Array;
  values: Float32Array;
}

/**
 * The largest number of lines or bands of a pattern across a square with the area of its region.
 */
export const mostLines = 1000;

/** Whether a pattern has too many lines. The page then draws a solid fill. */
export const isTooFine = (spacing: number, { area }: Pick<Region, 'area'>) =>
  !(Math.sqrt(area) <= mostLines * spacing);

/** The region that closed lines enclose, or a sentence that says why they enclose nothing. */
export type Fill = { region: Region; problem: null } | { region: null; problem: string | null };

/** A curve as the page draws it. */
export interface TracedCurve {
  polyline: Float32Array;
  /** One number for each vertex of the polyline; 1 if its sample did not converge. */
  polylineStatus: Uint8Array;
  /** The samples without their statuses, which `lost` summarizes. */
  samples: Omit<CurveSamples, 'status'>;
  /** The knots of a B-spline, even if they follow a rule; empty for other curves. */
  knots: Float64Array;
  /** Points at equal arc lengths along the curve, as many as requested. */
  marks: CurvePoints | null;
  /** The number of levels of the curve, or of the arcs of a circle. */
  levels: number;
  /** The legs of the curve's control polygon, if it uses them. */
  legs: readonly Float32Array[];
  /** The legs in the form that the engine continues. */
  drawnLegs: readonly DrawnLeg[];
  /**
   * The parts in which the curve's points are not centers of mass, even if a bridge replaces them.
   */
  lost: LostInterval[];
  /** The number of a circle's arcs whose geodesics from the center are no longer shortest. */
  arcsNotShortest: number;
  /** The largest deviation of a circle of arcs from its radius, as a fraction of the radius. */
  deviation: number | null;
  length: number;
  milliseconds: number;
  /** The fill; null if it was not requested. */
  fill: Fill | null;
  /** The outlines from which other objects derive; null if nobody requested them. */
  outlines: readonly Path[] | null;
}

/** A path from a control point to the next that is shorter than the curve's leg. */
export interface ShorterLeg {
  /** The index of the control point. */
  index: number;
  polyline: Float32Array;
  /** The path's length relative to the leg's length. */
  part: number;
}

/** The isolines of a circle, or the lines of a derived object, as the page draws them. */
export interface TracedIsolines {
  /**
   * The lines. An open isoline ends at the boundary. An open offset ends at the boundary or beside
   * an end of its line.
   */
  lines: { closed: boolean; length: number; polyline: Float32Array }[];
  /** The length of all lines. */
  length: number;
  milliseconds: number;
  /** The fill; null if it was not requested. */
  fill: Fill | null;
  outlines: readonly Path[];
}

/** A point of a curve with its measurements. */
export interface Measured {
  parameter: number;
  point: SurfacePoint;
  position: [number, number, number];
  /** The length from the curve's start, and the length of the curve. */
  length: number;
  wholeLength: number;
  /** The derivative with respect to the parameter. */
  tangent: [number, number, number];
}

/** Distances along the surface from a point, in the form that the page draws. */
export interface TracedDistances {
  /**
   * Distances at the vertices, in the caller's order; a vertex without a path has minus the largest
   * distance.
   */
  values: Float32Array;
  /** The largest distance. */
  most: number;
  /** The step from one line to the next. */
  step: number;
  /** The lines for each multiple of the step, from the first. */
  lines: Float32Array[][];
  /** Whether every vertex has a path. */
  complete: boolean;
}
