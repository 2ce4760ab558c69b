import type { MeshInfo, SurfacePoint } from 'karcher';
import type { MeshBlobs } from '../../model/mesh_blobs';
import type { LineId, MeshSpec, Panel, Vector } from '../figures/types';

/** A panel to trace: its points, and the lines to compute. */
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

/**
 * A drawing around a place of the source, and the control points on source and target that carry
 * the drawing.
 */
export interface CarryJob {
  source: MeshSpec;
  target: MeshSpec;
  middle: Vector;
  points: { source: readonly Vector[]; target: readonly Vector[] };
}

export interface DrawnMesh {
  info: MeshInfo;
  arrays: MeshBlobs;
}
