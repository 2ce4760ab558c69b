/** Plane sections of a surface in the scene, and evenly spaced places on it. */
import { Vector3 } from 'three';
import type { Vector } from '../model/figure';
import type { NearestPlace, Plane } from '../model/symmetry';
import type { Surface } from './surface';

/** The section of the surface by a plane: a line for each triangle that the plane crosses. */
export function sectionOf(surface: Surface, { normal, offset }: Plane): Float32Array[] {
  const { positions, triangles } = surface.arrays;
  const heights = new Float64Array(positions.length / 3);
  for (let i = 0; i < heights.length; i++) {
    for (let axis = 0; axis < 3; axis++) heights[i]! += normal[axis]! * positions[3 * i + axis]!;
    heights[i]! -= offset;
  }
  const lines: Float32Array[] = [];
  for (let at = 0; at < triangles.length; at += 3) {
    const line: number[] = [];
    for (let corner = 0; corner < 3; corner++) {
      const [a, b] = [triangles[at + corner]!, triangles[at + ((corner + 1) % 3)]!];
      const [low, high] = [heights[a]!, heights[b]!];
      if (low < 0 === high < 0) continue;
      const t = low / (low - high);
      for (let axis = 0; axis < 3; axis++) {
        line.push((1 - t) * positions[3 * a + axis]! + t * positions[3 * b + axis]!);
      }
    }
    if (line.length === 6) lines.push(Float32Array.from(line));
  }
  return lines;
}

/** About `count` places of the surface, spread evenly over its area. */
export function samplesOf(surface: Surface, count: number): Vector[] {
  const areas = Float64Array.from({ length: surface.triangles }, (_, face) => {
    const [a, b, c] = surface.corners(face);
    return b.sub(a).cross(c.sub(a)).length();
  });
  const step = areas.reduce((sum, area) => sum + area, 0) / count;
  const samples: Vector[] = [];
  let due = step / 2;
  for (const [face, area] of areas.entries()) {
    // A large triangle gets several places. A low-discrepancy sequence of weights spreads them out.
    for (; due < area; due += step) {
      const [u, v] = [(samples.length * 0.7549) % 1, (samples.length * 0.5698) % 1];
      const [y, z] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
      samples.push(surface.position({ face, bary: [1 - y - z, y, z] }).toArray());
    }
    due -= area;
  }
  return samples;
}

/**
 * A function that finds the place of the surface nearest to a place of the scene, with the unit
 * normal of the triangle there.
 */
export const nearestPlaceOf =
  (surface: Surface): NearestPlace =>
  (place) => {
    const point = surface.nearest(new Vector3(...place));
    const [a, b, c] = surface.corners(point.face);
    const normal = b.sub(a).cross(c.sub(a)).normalize();
    return { place: surface.position(point).toArray(), normal: normal.toArray() };
  };
