import type { MeshInfo, SurfacePoint } from 'karcher';
import type { LineId, LineResult, MeshSpec, Panel, Vector } from '../figures/types';

/** A panel to be traced: its points, and which of its lines are wanted. */
export interface TraceJob {
  panel: Panel;
  points: readonly Vector[];
  lines: readonly LineId[];
}

/** A panel's points on its mesh. */
export interface Placed {
  points: SurfacePoint[];
  places: Vector[];
}

export interface DrawnMesh {
  info: MeshInfo;
  positions: Float64Array;
  triangles: Int32Array;
}

export type Request =
  | { id: number; call: 'mesh'; mesh: MeshSpec }
  | { id: number; call: 'trace'; job: TraceJob }
  | { id: number; call: 'cancel' };

/** A trace answers with its points, its lines one by one, and `done`. */
export type Reply =
  | { id: number; mesh: DrawnMesh }
  | { id: number; placed: Placed }
  | { id: number; line: LineResult }
  | { id: number; progress: number; stage: string }
  | { id: number; done: true }
  | { id: number; failure: string };
