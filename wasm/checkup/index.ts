import type { EngineKept } from '../karcher-engine.mjs';
import { checkLongWork } from '../options.js';
import { Slices } from '../slices.js';
import type { LongWorkOptions, MeshInfo, RepairKind } from '../types.js';
import { type NearBoundaries, nearBoundaries } from './near_boundaries.js';
import { shapesOf } from './shapes.js';

export type { NearBoundaries } from './near_boundaries.js';
export { type Solid, solidOf } from './solid.js';
export { type Thickened, thickened } from './thicken.js';

/** The measurements of a mesh's triangles, and the places that do not suit curves. */
export interface CheckUp {
  /** The length of the shortest edge. */
  shortestEdge: number;
  /** The length of the longest edge. */
  longestEdge: number;
  /** The smallest angle of a triangle, in degrees. */
  smallestAngle: number;
  /** The largest angle of a triangle, in degrees. */
  largestAngle: number;
  /** The indices of triangles with an angle below 2 degrees and none above 170 degrees. */
  needles: Int32Array;
  /** The indices of triangles with an angle above 170 degrees. */
  caps: Int32Array;
  /** The edges that belong to only one face: x, y, z of both ends, six numbers for each edge. */
  boundary: Float64Array;
  /** Boundaries that lie near each other without being joined; null if there are none. */
  nearBoundaries: NearBoundaries | null;
  /** Sentences about what to expect of curves. */
  expected: string[];
}

/** A mesh in this thread or in a worker. */
export interface CheckedMesh {
  /** The counts of the mesh's elements, its sizes and its repairs, as in `Mesh.info`. */
  readonly info: Readonly<MeshInfo>;
  /** The positions of the vertices, as `Mesh.positions` returns them. */
  positions(): Float64Array | Promise<Float64Array>;
  /** Three vertex numbers for each triangle, as `Mesh.triangles` returns them. */
  triangles(): Int32Array | Promise<Int32Array>;
  /** @internal What remains of the triangles, as `Mesh.kept` returns it. */
  kept(): EngineKept | Promise<EngineKept>;
}

/**
 * Checks a mesh, in slices of some milliseconds. Two million triangles take two seconds. Faces have
 * the caller's numbers; the check skips faces that the import omitted or flipped away. Rejects with
 * the signal's reason when the signal is aborted, and with `KarcherError` disposed.
 */
export async function checkUp(mesh: CheckedMesh, work: LongWorkOptions = {}): Promise<CheckUp> {
  checkLongWork(work);
  const slices = new Slices(work, 'checking');
  const [positions, triangles] = [await mesh.positions(), await mesh.triangles()];
  const { areFaces, boundary: ends } = await mesh.kept();
  const { info } = mesh;
  const isRepaired = (wanted: RepairKind) => info.repairs.some(({ kind }) => kind === wanted);
  const { shortest, ...shapes } = await shapesOf(positions, triangles, areFaces, slices);
  const near = await nearBoundaries(
    {
      ...{ positions, boundary: ends, shortest },
      ...{ diagonal: info.diagonal, isWelded: isRepaired('welded') },
    },
    slices,
  );
  const boundary = placesOf(positions, ends);
  const found = { ...shapes, boundary, nearBoundaries: near };
  return { ...found, expected: expectedOf(info, found) };
}

function placesOf(positions: Float64Array, ends: Int32Array): Float64Array {
  const places = new Float64Array(3 * ends.length);
  for (let k = 0; k < places.length; k++) {
    places[k] = positions[3 * ends[Math.floor(k / 3)]! + (k % 3)]!;
  }
  return places;
}

/**
 * The largest ratio of edge lengths at which distances keep all correct digits (see the gallery in
 * `docs/gallery.md`).
 */
const widestRange = 1e8;

function expectedOf(info: Readonly<MeshInfo>, found: Omit<CheckUp, 'expected'>): string[] {
  const { nearBoundaries: near, needles, caps, shortestEdge, longestEdge } = found;
  const sentences: string[] = [];
  if (info.components > 1) {
    sentences.push(`No curve goes from one of the ${info.components} parts to another.`);
  }
  if (near) {
    sentences.push(
      `Boundaries lie on each other and are not joined, so that paths go around: a weld of ${near.weld} joins them.`,
    );
  } else if (info.boundaryLoops > 0) {
    sentences.push('Paths keep to the boundary where they meet it, and a center may lie on it.');
  }
  if (needles.length + caps.length > 0) {
    sentences.push(
      'Distances are right across thin triangles; the directions there are less accurate.',
    );
  }
  if (longestEdge > widestRange * shortestEdge) {
    sentences.push('Its edges differ so widely in length that distances have fewer right digits.');
  }
  if (sentences.length === 0) sentences.push('No defect disturbs curves.');
  return sentences;
}
