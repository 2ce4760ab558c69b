/**
 * The outline of a mesh in a camera's view. On smooth parts it is the line on which normals are at
 * right angles to the view (Hertzmann and Zorin, Illustrating smooth surfaces). Normals are linear
 * between the corners of a triangle, so that the line is smoother than the edges between front and
 * back faces. Creases and the boundary belong to the outline, too.
 */
import { joinedSegments } from 'karcher/statistics';
import { levelLines } from '../model/level_lines';

/** The least angle of a crease between two faces, in radians. */
const creaseAngle = (45 * Math.PI) / 180;

export interface Mesh {
  /** x, y, z of each vertex. */
  positions: Float32Array;
  triangles: Uint32Array;
}

export interface Outline {
  /** Lines where the surface turns away from the eye. */
  contours: Float32Array[];
  creases: Float32Array[];
  boundary: Float32Array[];
}

/** The lines that may be visible from `eye`, including those that the surface hides. */
export function outlineOf(mesh: Mesh, [x, y, z]: readonly [number, number, number]): Outline {
  const { positions, triangles } = mesh;
  const normals = faceNormals(mesh);
  const across = sidesAcross(mesh);
  const cornerNormals = smoothNormals(mesh, normals, across);
  const facing = (corner: number) => {
    const [at, to] = [3 * triangles[corner]!, 3 * corner];
    return (
      cornerNormals[to]! * (x - positions[at]!) +
      cornerNormals[to + 1]! * (y - positions[at + 1]!) +
      cornerNormals[to + 2]! * (z - positions[at + 2]!)
    );
  };
  const [contours] = levelLines(positions, triangles, facing, [0]);
  const [creases, boundary]: [number[], number[]] = [[], []];
  for (let side = 0; side < across.length; side++) {
    const other = across[side]!;
    if (other < 0) boundary.push(side);
    else if (side < other && isSharp(normals, side, other)) creases.push(side);
  }
  return {
    contours: contours!,
    creases: linesOf(mesh, creases),
    boundary: linesOf(mesh, boundary),
  };
}

// The next corner of the same triangle. A side has the index of the corner at its start.

const follower = (corner: number) => (corner % 3 === 2 ? corner - 2 : corner + 1);

/** The normals of the triangles, twice as long as their areas. */
function faceNormals({ positions, triangles }: Mesh): Float64Array {
  const normals = new Float64Array(triangles.length);
  for (let first = 0; first < triangles.length; first += 3) {
    const p = 3 * triangles[first]!;
    const q = 3 * triangles[first + 1]!;
    const r = 3 * triangles[first + 2]!;
    for (let axis = 0; axis < 3; axis++) {
      const next = axis === 2 ? 0 : axis + 1;
      const last = axis === 0 ? 2 : axis - 1;
      normals[first + axis] =
        (positions[q + next]! - positions[p + next]!) *
          (positions[r + last]! - positions[p + last]!) -
        (positions[q + last]! - positions[p + last]!) *
          (positions[r + next]! - positions[p + next]!);
    }
  }
  return normals;
}

/**
 * For each side of a triangle, the matching side of the neighboring triangle; -1 on the boundary.
 * Where more than two triangles meet at an edge, their sides form pairs. An odd last side has -1.
 */
function sidesAcross({ positions, triangles }: Mesh): Int32Array {
  const across = new Int32Array(triangles.length).fill(-1);
  // Each vertex has a list of unpaired sides. A side is in the list of its end that has the lower
  // index.
  const firstAt = new Int32Array(positions.length / 3).fill(-1);
  const behind = new Int32Array(triangles.length);
  for (let side = 0; side < triangles.length; side++) {
    const [p, q] = [triangles[side]!, triangles[follower(side)]!];
    const [low, high] = p < q ? [p, q] : [q, p];
    let [before, at] = [-1, firstAt[low]!];
    while (at >= 0 && triangles[at] !== high && triangles[follower(at)] !== high) {
      before = at;
      at = behind[at]!;
    }
    if (at < 0) {
      behind[side] = firstAt[low]!;
      firstAt[low] = side;
      continue;
    }
    if (before < 0) firstAt[low] = behind[at]!;
    else behind[before] = behind[at]!;
    across[side] = at;
    across[at] = side;
  }
  return across;
}

const leastCosine = Math.cos(creaseAngle);

/** Whether the faces at two sides have a crease between them. */
function isSharp(normals: Float64Array, side: number, other: number): boolean {
  const [a, b] = [side - (side % 3), other - (other % 3)];
  const [ax, ay, az] = [normals[a]!, normals[a + 1]!, normals[a + 2]!];
  const [bx, by, bz] = [normals[b]!, normals[b + 1]!, normals[b + 2]!];
  const lengths = Math.sqrt((ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz));
  return ax * bx + ay * by + az * bz < leastCosine * lengths;
}

/**
 * The unit normal at each corner: the direction of a sum of normals. The sum is over the faces that
 * meet at the corner without a crease between them.
 */
function smoothNormals({ triangles }: Mesh, normals: Float64Array, across: Int32Array) {
  // Corners that share a normal form a set. Each corner leads to the first corner of its set.
  const leads = new Uint32Array(triangles.length);
  for (let corner = 0; corner < leads.length; corner++) leads[corner] = corner;
  const firstOf = (corner: number) => {
    let at = corner;
    while (leads[at] !== at) {
      leads[at] = leads[leads[at]!]!;
      at = leads[at]!;
    }
    return at;
  };
  const unite = (a: number, b: number) => {
    if (triangles[a] === triangles[b]) leads[firstOf(a)] = firstOf(b);
  };
  for (let side = 0; side < across.length; side++) {
    const other = across[side]!;
    if (other < side || isSharp(normals, side, other)) continue;
    const [end, otherEnd] = [follower(side), follower(other)];
    unite(side, other);
    unite(side, otherEnd);
    unite(end, other);
    unite(end, otherEnd);
  }
  const sums = new Float64Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [into, face] = [3 * firstOf(corner), corner - (corner % 3)];
    for (let axis = 0; axis < 3; axis++) sums[into + axis]! += normals[face + axis]!;
  }
  const unit = new Float64Array(sums.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [from, to] = [3 * firstOf(corner), 3 * corner];
    const [x, y, z] = [sums[from]!, sums[from + 1]!, sums[from + 2]!];
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    [unit[to], unit[to + 1], unit[to + 2]] = [x / length, y / length, z / length];
  }
  return unit;
}

/** The sides of triangles as lines. */
function linesOf({ positions, triangles }: Mesh, sides: readonly number[]): Float32Array[] {
  const end = (corner: number) => {
    const vertex = triangles[corner]!;
    const at = (axis: number) => positions[3 * vertex + axis]!;
    return { edge: vertex, place: [at(0), at(1), at(2)] as const };
  };
  const lines = joinedSegments(sides.map((side) => [end(side), end(follower(side))] as const));
  return lines.map((line) => Float32Array.from(line.flatMap(({ place }) => place)));
}
