/** The parts of lines that the surface does not hide. */
import { DoubleSide, Matrix4, Ray, Vector3 } from 'three';
import type { MeshBVH } from 'three-mesh-bvh';
import { type Mesh, outlineOf } from './outline';

/** The step along lines between tests of visibility, in the scene; a surface's diagonal is 2. */
const step = 0.008;
/**
 * A face hides a line only if it is nearer than the line by at least this distance, in the scene.
 * The faces on which the line lies thus do not hide it.
 */
const grain = 0.004;
/**
 * The distance, in mean edges, from a contour to two places beside it, one on each side. The
 * contour counts as visible if one of the places is visible. Where the surface turns away, facets
 * may hide the contour itself, but one of the places is off the surface.
 */
const asideEdges = 0.4;
const [leastAside, mostAside] = [0.002, 0.02];
/** Shorter gaps are closed, and shorter visible pieces are dropped: they come from facets. */
const speck = 0.02;
/** The least length of a crease; on a rough surface shorter ones are only grain. */
const shortestCrease = 0.06;

export interface Sight {
  eye: [number, number, number];
  /** The matrix from the scene to normalized device coordinates, in column order. */
  matrix: number[];
  /** The size of the stage, in CSS pixels. */
  width: number;
  height: number;
}

/** The lines of the surface's visible outline: x, y of their points, in CSS pixels of the stage. */
export function seenOutline(mesh: Mesh, tree: MeshBVH, sight: Sight): Float32Array[] {
  const { contours, creases, boundary } = outlineOf(mesh, sight.eye);
  const aside = Math.min(mostAside, Math.max(leastAside, asideEdges * meanEdge(mesh)));
  const parts = [
    ...contours.flatMap((line) => visibleParts(line, tree, sight, aside)),
    ...[...creases.filter((line) => lengthOf(line) >= shortestCrease), ...boundary].flatMap(
      (line) => visibleParts(line, tree, sight, 0),
    ),
  ];
  return parts.map((part) => onStage(part, sight));
}

/**
 * The visible parts of a line in front of the camera. If `aside` is positive, the function tests
 * places at this distance on both sides instead of the line. One visible place suffices.
 */
export function visibleParts(
  line: Float32Array,
  tree: MeshBVH,
  { eye, matrix }: Pick<Sight, 'eye' | 'matrix'>,
  aside: number,
): Float32Array[] {
  const places = subdivided(line);
  const ray = new Ray(new Vector3(...eye));
  const seen = new Matrix4().fromArray(matrix);
  const [middle, beside, place] = [new Vector3(), new Vector3(), new Vector3()];
  const isInFront = (at: Vector3) => place.copy(at).applyMatrix4(seen).z <= 1;
  const isSeen = (i: number) => {
    middle.addVectors(places[i]!, places[i + 1]!).multiplyScalar(0.5);
    beside
      .subVectors(places[i + 1]!, places[i]!)
      .cross(ray.direction.subVectors(middle, ray.origin));
    beside.setLength(beside.lengthSq() > 0 ? aside : 0);
    const isOpen = (side: number) => {
      place.copy(middle).addScaledVector(beside, side);
      const away = place.distanceTo(ray.origin);
      ray.direction.copy(place).sub(ray.origin).divideScalar(away);
      return (tree.raycastFirst(ray, DoubleSide)?.distance ?? Infinity) >= away - grain;
    };
    const visible = isOpen(1) || (aside > 0 && isOpen(-1));
    return visible && isInFront(places[i]!) && isInFront(places[i + 1]!);
  };
  const lengths = places.slice(1).map((place, i) => place.distanceTo(places[i]!));
  const runs: { first: number; end: number; seen: boolean; length: number }[] = [];
  for (const [i, length] of lengths.entries()) {
    const visible = isSeen(i);
    const last = runs.at(-1);
    if (last?.seen === visible) [last.end, last.length] = [i + 1, last.length + length];
    else runs.push({ first: i, end: i + 1, seen: visible, length });
  }
  for (const [i, run] of runs.entries()) {
    const between = i > 0 && i < runs.length - 1;
    if (!run.seen && between && run.length < speck) run.seen = true;
  }
  const parts: { first: number; end: number; length: number }[] = [];
  for (const { first, end, seen: visible, length } of runs) {
    const last = parts.at(-1);
    if (visible && last?.end === first) [last.end, last.length] = [end, last.length + length];
    else if (visible) parts.push({ first, end, length });
  }
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  return parts
    .filter(({ length }) => length >= Math.min(speck, whole))
    .map(({ first, end }) =>
      Float32Array.from(places.slice(first, end + 1).flatMap((place) => place.toArray())),
    );
}

function lengthOf(line: Float32Array): number {
  let length = 0;
  for (let i = 3; i < line.length; i += 3) {
    const along = (axis: number) => line[i + axis]! - line[i - 3 + axis]!;
    length += Math.hypot(along(0), along(1), along(2));
  }
  return length;
}

function subdivided(line: Float32Array): Vector3[] {
  const places = [new Vector3().fromArray(line)];
  for (let i = 3; i < line.length; i += 3) {
    const [from, to] = [places.at(-1)!, new Vector3().fromArray(line, i)];
    const pieces = Math.max(1, Math.ceil(from.distanceTo(to) / step));
    for (let k = 1; k <= pieces; k++) places.push(from.clone().lerp(to, k / pieces));
  }
  return places;
}

function onStage(line: Float32Array, { matrix, width, height }: Sight): Float32Array {
  const seen = new Matrix4().fromArray(matrix);
  const result = new Float32Array((line.length / 3) * 2);
  const place = new Vector3();
  for (let i = 0; i < line.length / 3; i++) {
    place.fromArray(line, 3 * i).applyMatrix4(seen);
    result[2 * i] = ((place.x + 1) / 2) * width;
    result[2 * i + 1] = ((1 - place.y) / 2) * height;
  }
  return result;
}

function meanEdge({ positions, triangles }: Mesh): number {
  let sum = 0;
  for (let i = 0; i < triangles.length; i++) {
    const [p, q] = [triangles[i]!, triangles[i % 3 === 2 ? i - 2 : i + 1]!];
    const x = positions[3 * p]! - positions[3 * q]!;
    const y = positions[3 * p + 1]! - positions[3 * q + 1]!;
    const z = positions[3 * p + 2]! - positions[3 * q + 2]!;
    sum += Math.sqrt(x * x + y * y + z * z);
  }
  return sum / Math.max(1, triangles.length);
}
