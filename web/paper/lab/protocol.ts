import type { MeshInfo, SurfacePoint } from 'karcher';
import type { LineId, Panel, Vector } from '../figures/types';

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
