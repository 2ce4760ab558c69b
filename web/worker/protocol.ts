/** The messages between the page and the worker that runs the engine. */
import type {
  CenterOfMass,
  CenterOptions,
  CircleOptions,
  CurveOptions,
  EllipseOptions,
  ErrorCode,
  FieldOptions,
  IsolineOptions,
  MeshInfo,
  PointLike,
  Solver,
} from 'karcher';
import type { MeshSource } from '../model/meshes';
import type {
  Measured,
  TracedCurve,
  TracedIsolines,
  TracedPath,
  TracedStraightestPath,
} from '../model/traced';
import type { Reshape, Reshaped } from './reshape';

export interface LoadedMesh {
  info: MeshInfo;
  positions: Float64Array;
  triangles: Int32Array;
}

type Vector = [number, number, number];

export interface CurveWork {
  keep: boolean;
  /** How many points to mark along it. */
  marks?: number;
}

/** What can be asked of the worker; the names and arguments are the engine's own. */
export interface Calls {
  load(source: MeshSource): LoadedMesh;
  prepare(options: FieldOptions): void;
  /** The curve that is edited, by its smallest change; or one that is traced and not kept. */
  curve(options: CurveOptions, work?: CurveWork): TracedCurve;
  /**
   * A B-spline's knots after an edit, which makes it one of other points, or closes or opens it; it
   * is then the curve that is edited.
   */
  knots(from: CurveOptions, to: CurveOptions): number[];
  /** The curve with these options, which is the one that is edited, where it is nearest to a place. */
  measure(options: CurveOptions, near: Vector): Measured;
  /** The curves that an edit makes of the one with these options. */
  reshape(options: CurveOptions, edit: Reshape): Reshaped;
  circle(center: PointLike, options: CircleOptions): TracedCurve;
  ellipse(center: PointLike, options: EllipseOptions): TracedCurve;
  isolines(center: PointLike, options: IsolineOptions): TracedIsolines;
  centerOfMass(points: PointLike[], weights: number[], options?: CenterOptions): CenterOfMass;
  distance(point: PointLike, options?: { solver?: Solver; rings?: number }): Float64Array;
  shortestPath(from: PointLike, to: PointLike): TracedPath;
  straightest(from: PointLike, direction: Vector, length: number): TracedStraightestPath;
}

export type CallName = keyof Calls;

export type Request =
  | { [Name in CallName]: { id: number; call: Name; args: Parameters<Calls[Name]> } }[CallName]
  | { id: number; call: 'cancel' };

export interface Failure {
  message: string;
  code?: ErrorCode;
  /** The engine broke, and can't be relied on. */
  fatal?: boolean;
}

export type Reply =
  | { id: number; result: unknown }
  | { id: number; failure: Failure }
  | { id: number; progress: number; stage: string };
