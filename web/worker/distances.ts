/** Distances from a point in the form that the page draws: values at the vertices, and isolines. */
import type { DistanceOptions, Mesh, PointLike } from 'karcher';
import { levelLines, roundStep } from '../model/level_lines';
import type { TracedDistances } from '../model/traced';

/** The approximate number of isolines. */
const lineCount = 12;

export function tracedDistances(
  mesh: Mesh,
  from: PointLike,
  options: DistanceOptions,
): TracedDistances {
  const distances = mesh.distance(from, options);
  const [positions, triangles] = [mesh.positions(), mesh.triangles()];
  let most = 0;
  for (const value of distances) if (value > most) most = value;
  const step = roundStep(most, lineCount);
  const levels: number[] = [];
  for (let i = 1; i * step < most; i++) levels.push(i * step);
  const lines = levelLines(
    positions,
    triangles,
    (corner) => distances[triangles[corner]!]!,
    levels,
  );
  // Vertices without a triangle have no distance and are invisible.
  const complete = triangles.every((vertex) => Number.isFinite(distances[vertex]!));
  const values = Float32Array.from(distances, (value) => (Number.isFinite(value) ? value : -most));
  return { values, most, step, lines, complete };
}
