import type { Mesh, MeshInfo } from 'karcher';
import type { CheckUp } from 'karcher/checkup';
import type { MeshBlobs } from './mesh_blobs';

/** The largest number of places of one kind that the page draws at once. */
export const mostPlaces = 20_000;

/** What remains of a surface's triangles after the import. */
export type Kept = ReturnType<Mesh['kept']>;

/** The surface to check. */
export interface CheckedSurface {
  readonly info: Readonly<MeshInfo>;
  readonly arrays: MeshBlobs;
  readonly mesh: { kept(): Promise<Kept> };
  /** The surface's file; null if the surface does not come from a file. */
  readonly file: object | null;
}

/** A check-up, with its triangles as they are drawn. */
export interface CheckedUp extends CheckUp {
  outlines: Record<'needles' | 'caps', Float32Array>;
}

/** The number of coordinates of a triangle's outline, whose last corner is its first one again. */
export const outlineLength = 12;
