/**
 * The outline of a mesh as a camera sees it. Where the surface is smooth, it is the line on which normals,
 * told at the triangles' corners and linear in between, are at right angles to the view (Hertzmann and
 * Zorin, Illustrating smooth surfaces); smoother than the edges between front and back faces. Where it is
 * not, it is creases, and the boundary.
 */
import { joined, levelLines } from '../model/level_lines';

/** Faces that meet at a larger angle have a crease between them, in radians. */
const creaseAngle = (45 * Math.PI) / 180;

export interface Mesh {
  /** x, y, z each. */
  positions: Float32Array;
  triangles: Uint32Array;
}

export interface Outline {
  /** Lines where the surface turns away. */
  contours: Float32Array[];
  creases: Float32Array[];
  boundary: Float32Array[];
}

/** The lines that a camera at `eye` may see, also those that the surface hides. */
export function outlineOf(mesh: Mesh, eye: readonly [number, number, number]): Outline {
  const { positions, triangles } = mesh;
  const normals = faceNormals(mesh);
  const edges = edgesOf(mesh);
  const cornerNormals = smoothNormals(mesh, normals, edges);
  const facing = (corner: number) => {
    const at = 3 * triangles[corner]!;
    let sum = 0;
    for (let axis = 0; axis < 3; axis++) {
      sum += cornerNormals[3 * corner + axis]! * (eye[axis]! - positions[at + axis]!);
    }
    return sum;
  };
  const [contours] = levelLines(positions, triangles, facing, [0]);
  const isCrease = (edge: Edge) => edge.next >= 0 && isSharp(normals, edge);
  return {
    contours: contours!,
    creases: linesOf(mesh, edges.filter(isCrease)),
    boundary: linesOf(
      mesh,
      edges.filter(({ next }) => next < 0),
    ),
  };
}

/** The side of a triangle behind one of its corners, and the one of another triangle; -1 without one. */
interface Edge {
  side: number;
  next: number;
}

const follower = (corner: number) => (corner % 3 === 2 ? corner - 2 : corner + 1);

/** Not of unit length: as long as twice the area. */
function faceNormals({ positions, triangles }: Mesh): Float64Array {
  const normals = new Float64Array(triangles.length);
  for (let first = 0; first < triangles.length; first += 3) {
    const [p, q, r] = [0, 1, 2].map((i) => 3 * triangles[first + i]!) as [number, number, number];
    const between = (to: number, axis: number) => positions[to + axis]! - positions[p + axis]!;
    for (let axis = 0; axis < 3; axis++) {
      const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
      normals[first + axis] =
        between(q, next) * between(r, last) - between(q, last) * between(r, next);
    }
  }
  return normals;
}

/** Of more than two triangles at one edge, those beyond the second have an edge of their own. */
function edgesOf({ positions, triangles }: Mesh): Edge[] {
  const vertices = positions.length / 3;
  const open = new Map<number, number>();
  const edges: Edge[] = [];
  for (let side = 0; side < triangles.length; side++) {
    const [p, q] = [triangles[side]!, triangles[follower(side)]!];
    const key = Math.min(p, q) * vertices + Math.max(p, q);
    const known = open.get(key);
    if (known === undefined) {
      open.set(key, edges.length);
      edges.push({ side, next: -1 });
    } else {
      edges[known]!.next = side;
      open.delete(key);
    }
  }
  return edges;
}

function isSharp(normals: Float64Array, { side, next }: Edge): boolean {
  const [a, b] = [side - (side % 3), next - (next % 3)];
  const dot = (p: number, q: number) =>
    normals[p]! * normals[q]! +
    normals[p + 1]! * normals[q + 1]! +
    normals[p + 2]! * normals[q + 2]!;
  return dot(a, b) < Math.cos(creaseAngle) * Math.sqrt(dot(a, a) * dot(b, b));
}

/** At each corner, of unit length, the sum of the normals of the faces that meet there without a crease between them. */
function smoothNormals({ triangles }: Mesh, normals: Float64Array, edges: readonly Edge[]) {
  // Corners that share a normal are in one set, each with the corner that leads to its first.
  const leads = Uint32Array.from(triangles.keys());
  const firstOf = (corner: number) => {
    let at = corner;
    while (leads[at] !== at) {
      leads[at] = leads[leads[at]!]!;
      at = leads[at]!;
    }
    return at;
  };
  for (const edge of edges) {
    if (edge.next < 0 || isSharp(normals, edge)) continue;
    const { side, next } = edge;
    for (const a of [side, follower(side)]) {
      for (const b of [next, follower(next)]) {
        if (triangles[a] === triangles[b]) leads[firstOf(a)] = firstOf(b);
      }
    }
  }
  const sums = new Float64Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [into, face] = [3 * firstOf(corner), corner - (corner % 3)];
    for (let axis = 0; axis < 3; axis++) sums[into + axis]! += normals[face + axis]!;
  }
  const unit = new Float64Array(sums.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const from = 3 * firstOf(corner);
    const length = Math.hypot(sums[from]!, sums[from + 1]!, sums[from + 2]!) || 1;
    for (let axis = 0; axis < 3; axis++) unit[3 * corner + axis] = sums[from + axis]! / length;
  }
  return unit;
}

/** Edges as lines. */
function linesOf({ positions, triangles }: Mesh, edges: readonly Edge[]): Float32Array[] {
  const end = (corner: number) => {
    const vertex = triangles[corner]!;
    const at = (axis: number) => positions[3 * vertex + axis]!;
    return { edge: vertex, place: [at(0), at(1), at(2)] as const };
  };
  return joined(edges.map(({ side }) => [end(side), end(follower(side))]));
}
