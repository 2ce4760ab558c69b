import { checkNumber } from '../check.js';
import { KarcherError } from '../errors.js';
import { cross, dot, subtract, type Vector, at as vectorAt } from '../vectors.js';

/** A closed shell: triangles, a moved copy of them, and walls. */
export interface Thickened {
  /**
   * x, y, z for each vertex: first the given vertices, then the same vertices moved by the
   * thickness.
   */
  positions: Float64Array;
  /**
   * Three vertex numbers for each triangle of the part, of its reversed copy, and of the walls
   * along the boundary.
   */
  triangles: Int32Array;
  /**
   * The largest thickness that the shape allows, since a thicker shell intersects itself; null if
   * the given thickness fits.
   */
  most: number | null;
}

interface Triangles {
  positions: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

/**
 * The closed shell between triangles and a copy of them. The copy is moved along the vertices'
 * normals by the thickness: outwards, or inwards if the thickness is negative. Walls close the open
 * sides. The triangles must be oriented, as `mesh.cut` returns them.
 *
 * For a part that `mesh.cut` returned, pass the mesh as `whole`: the part then has the normals of
 * the mesh. Along the cut, the part's own triangles are so small that their normals would not
 * describe the shape. The mesh's triangles may have any orientation, since the part's orientation
 * counts. Throws `KarcherError` badArgument for a thickness of 0.
 */
export function thickened(part: Triangles, thickness: number): Thickened;
export function thickened(
  part: Triangles & { faces: ArrayLike<number> },
  thickness: number,
  whole: Triangles,
): Thickened;
export function thickened(
  part: Triangles & { faces?: ArrayLike<number> },
  thickness: number,
  whole?: Triangles,
): Thickened {
  checkNumber(thickness, 'the thickness');
  if (thickness === 0) throw new KarcherError('badArgument', 'the thickness must not be 0');
  const { positions, triangles } = part;
  const count = positions.length / 3;
  const { faces } = part;
  const { shape, around } = whole
    ? turnedLike(part, faces!, united(whole))
    : { shape: part, around: triangles };
  const shapeNormals = vertexNormals(shape.positions, around);
  const normals = whole ? carried(part, faces!, shape, shapeNormals) : shapeNormals;
  const bounding = whole ? facesOf(shape.triangles, faces!) : triangles;
  const moved = Float64Array.from(positions, (value, i) => value + thickness * normals[i]!);
  const both = new Float64Array(2 * positions.length);
  both.set(Float64Array.from(positions));
  both.set(moved, positions.length);
  // The outer sheet keeps the orientation of the triangles.
  const [outer, inner] = thickness > 0 ? [count, 0] : [0, count];
  const all: number[] = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = cornersOf(triangles, i);
    all.push(a + outer, b + outer, c + outer, c + inner, b + inner, a + inner);
  }
  for (const [a, b] of rims(triangles, count)) {
    all.push(a + inner, b + inner, b + outer, a + inner, b + outer, a + outer);
  }
  const bound = Math.min(
    Math.abs(thickness),
    unfolded(shape.positions, bounding, shapeNormals, thickness),
    ballBound(shape.positions, bounding, shapeNormals, thickness),
  );
  const most = bound < Math.abs(thickness) ? bound : null;
  return { positions: both, triangles: Int32Array.from(all), most };
}

/**
 * The same triangles, with one vertex at each place. Files and meshes may have several vertices at
 * a place.
 */
function united({ positions, triangles }: Triangles): Triangles {
  const order = Int32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
  const apart = (a: number, b: number) =>
    positions[3 * a]! - positions[3 * b]! ||
    positions[3 * a + 1]! - positions[3 * b + 1]! ||
    positions[3 * a + 2]! - positions[3 * b + 2]!;
  order.sort(apart);
  const same = new Int32Array(order.length);
  order.forEach((vertex, i) => {
    const before = order[i - 1];
    same[vertex] = before !== undefined && apart(before, vertex) === 0 ? same[before]! : vertex;
  });
  return { positions, triangles: Int32Array.from(triangles, (vertex) => same[vertex]!) };
}

/**
 * The whole mesh with the orientation of the part: at the part's faces, and at the other faces
 * around their corners as far as edges of two faces connect them with the part. These are also
 * returned alone, since further faces at the same places belong to other fans. Of faces that lie on
 * each other only one counts, as in the engine, which omits the others.
 */
function turnedLike(
  part: Triangles,
  faces: ArrayLike<number>,
  whole: Triangles,
): { shape: Triangles; around: Int32Array } {
  const { positions } = whole;
  const triangles = Int32Array.from(whole.triangles);
  const turn = (face: number) => triangles.subarray(3 * face, 3 * face + 3).reverse();
  const agreement = new Map<number, number>();
  for (let i = 0; i < faces.length; i++) {
    const face = faces[i]!;
    const agrees = dot(acrossOf(part, 3 * i), acrossOf(whole, 3 * face));
    agreement.set(face, (agreement.get(face) ?? 0) + agrees);
  }
  const isCorner = new Uint8Array(positions.length / 3);
  for (const [face, agrees] of agreement) {
    if (agrees < 0) turn(face);
    for (const vertex of cornersOf(triangles, 3 * face)) isCorner[vertex] = 1;
  }
  const facesAt = new Map<number, number[]>();
  const edgesOf = (face: number) => {
    const corners = cornersOf(triangles, 3 * face);
    return corners.map((tail, k): [number, number] => [tail, corners[(k + 1) % 3]!]);
  };
  const keyOf = (a: number, b: number) => Math.min(a, b) * isCorner.length + Math.max(a, b);
  const placeOf = (face: number) => `${cornersOf(triangles, 3 * face).sort((a, b) => a - b)}`;
  const known = new Set(Array.from(agreement.keys(), placeOf));
  for (let face = 0; 3 * face < triangles.length; face++) {
    if (!cornersOf(triangles, 3 * face).some((vertex) => isCorner[vertex])) continue;
    const place = placeOf(face);
    if (known.has(place)) continue;
    known.add(place);
    for (const [a, b] of edgesOf(face)) {
      if (!isCorner[a] && !isCorner[b]) continue;
      const others = facesAt.get(keyOf(a, b));
      if (others) others.push(face);
      else facesAt.set(keyOf(a, b), [face]);
    }
  }
  for (const face of agreement.keys()) {
    for (const [a, b] of edgesOf(face)) facesAt.get(keyOf(a, b))?.push(face);
  }
  const reached = new Set(agreement.keys());
  // The loop also visits the faces that it adds.
  for (const face of reached) {
    for (const [a, b] of edgesOf(face)) {
      const pair = facesAt.get(keyOf(a, b));
      if (pair?.length !== 2) continue;
      const other = pair[0] === face ? pair[1]! : pair[0]!;
      if (reached.has(other)) continue;
      if (edgesOf(other).some(([tail, head]) => tail === a && head === b)) turn(other);
      reached.add(other);
    }
  }
  return { shape: { positions, triangles }, around: facesOf(triangles, [...reached]) };
}

/** The triangles with these face numbers. A repeated number counts once. */
const facesOf = (triangles: ArrayLike<number>, faces: ArrayLike<number>): Int32Array =>
  Int32Array.from(
    [...new Set(Array.from(faces))].flatMap((face) => cornersOf(triangles, 3 * face)),
  );

/**
 * The normals at a part's vertices. They are interpolated from the normals at the corners of the
 * whole mesh's faces, so that they vary continuously.
 */
function carried(
  part: Triangles,
  faces: ArrayLike<number>,
  whole: Triangles,
  normals: Float64Array,
): Float64Array {
  const own = new Float64Array(part.positions.length);
  for (let i = 0; i < part.triangles.length; i++) {
    const corners = cornersOf(whole.triangles, 3 * faces[Math.floor(i / 3)]!);
    const [a, b, c] = corners.map((vertex) => vectorAt(whole.positions, vertex));
    const [u, v] = [subtract(b!, a!), subtract(c!, a!)];
    const to = subtract(vectorAt(part.positions, part.triangles[i]!), a!);
    const across = cross(u, v);
    const square = dot(across, across) || 1;
    const [second, third] = [
      dot(cross(to, v), across) / square,
      dot(cross(u, to), across) / square,
    ];
    const weights = [1 - second - third, second, third];
    for (let axis = 0; axis < 3; axis++) {
      own[3 * part.triangles[i]! + axis] = corners.reduce(
        (sum, vertex, k) => sum + weights[k]! * normals[3 * vertex + axis]!,
        0,
      );
    }
  }
  return own;
}

const cornersOf = (triangles: ArrayLike<number>, i: number): Vector => [
  triangles[i]!,
  triangles[i + 1]!,
  triangles[i + 2]!,
];

/** A vector along the normal of the triangle whose corners begin at `i`, of twice its area. */
function acrossOf({ positions, triangles }: Triangles, i: number): Vector {
  const [a, b, c] = cornersOf(triangles, i).map((vertex) => vectorAt(positions, vertex));
  return cross(subtract(b!, a!), subtract(c!, a!));
}

/**
 * Unit normals at vertices. Each triangle's normal is weighted by the triangle's angle at the
 * vertex, so that the triangulation does not matter.
 */
function vertexNormals(positions: ArrayLike<number>, triangles: ArrayLike<number>): Float64Array {
  const normals = new Float64Array(positions.length);
  for (let i = 0; i < triangles.length; i += 3) {
    const corners = cornersOf(triangles, i);
    const places = corners.map((vertex) => vectorAt(positions, vertex)) as [Vector, Vector, Vector];
    const across = acrossOf({ positions, triangles }, i);
    const length = Math.hypot(...across);
    if (length === 0) continue;
    for (let k = 0; k < 3; k++) {
      const here = places[k]!;
      const [u, v] = [subtract(places[(k + 1) % 3]!, here), subtract(places[(k + 2) % 3]!, here)];
      const angle = Math.atan2(length, dot(u, v));
      for (let axis = 0; axis < 3; axis++) {
        normals[3 * corners[k]! + axis]! += (angle * across[axis]!) / length;
      }
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!) || 1;
    for (let axis = 0; axis < 3; axis++) normals[i + axis]! /= length;
  }
  return normals;
}

/** The directed edges whose reverse belongs to no other triangle. */
function rims(triangles: ArrayLike<number>, count: number): [number, number][] {
  const open = new Set<number>();
  for (let i = 0; i < triangles.length; i++) {
    const [a, b] = [triangles[i]!, triangles[i % 3 === 2 ? i - 2 : i + 1]!];
    if (!open.delete(b * count + a)) open.add(a * count + b);
  }
  return [...open].map((edge) => [Math.floor(edge / count), edge % count]);
}

/** The distance that vertices can move along their normals before the first triangle turns over. */
function unfolded(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  normals: Float64Array,
  thickness: number,
): number {
  const way = Math.sign(thickness);
  let least = Infinity;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = cornersOf(triangles, i);
    const [u, v] = [b, c].map((to) => subtract(vectorAt(positions, to), vectorAt(positions, a)));
    const [du, dv] = [b, c].map((to) => subtract(vectorAt(normals, to), vectorAt(normals, a)));
    const across = cross(u!, v!);
    // The triangle's area, seen along its normal, is a quadratic function of the distance.
    const [p, q] = [cross(du!, v!), cross(u!, dv!)];
    const linear = way * (dot(across, p) + dot(across, q));
    const root = firstRoot(dot(across, across), linear, dot(across, cross(du!, dv!)));
    least = Math.min(least, root);
  }
  return least;
}

/** The least positive t with c + b t + a t² = 0, for a positive c; infinite if none exists. */
function firstRoot(c: number, b: number, a: number): number {
  const under = b * b - 4 * a * c;
  if (c <= 0 || under < 0) return Infinity;
  // This formula avoids the difference of two numbers of similar size.
  const half = -(b + Math.sign(b || 1) * Math.sqrt(under)) / 2;
  const roots = [half / a, c / half].filter((root) => root > 0);
  return Math.min(Infinity, ...roots);
}

/**
 * The radius of the smallest ball that touches the surface at a vertex, on the side to which the
 * vertex moves, and passes through another vertex. The result is at most the thickness.
 */
function ballBound(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  normals: Float64Array,
  thickness: number,
): number {
  const way = Math.sign(thickness);
  const used = Int32Array.from(new Set(Array.from(triangles)));
  let least = Math.abs(thickness);
  const size = 2 * least;
  const cellOf = (vertex: number, axis: number) => Math.floor(positions[3 * vertex + axis]! / size);
  // Several cells may share a bucket. Comparisons with the vertices of these further cells do not
  // change the least radius.
  const buckets = 2 ** Math.ceil(Math.log2(used.length + 1));
  const bucketOf = (x: number, y: number, z: number) =>
    (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) & (buckets - 1);
  const keys = used.map((vertex) =>
    bucketOf(cellOf(vertex, 0), cellOf(vertex, 1), cellOf(vertex, 2)),
  );
  const starts = new Int32Array(buckets + 1);
  for (const key of keys) starts[key + 1]!++;
  for (let key = 0; key < buckets; key++) starts[key + 1]! += starts[key]!;
  const next = starts.slice();
  const listed = new Int32Array(used.length);
  keys.forEach((key, i) => {
    listed[next[key]!++] = used[i]!;
  });
  for (const vertex of used) {
    const [x, y, z] = [0, 1, 2].map((axis) => cellOf(vertex, axis)) as Vector;
    const at = 3 * vertex;
    const [px, py, pz] = [positions[at]!, positions[at + 1]!, positions[at + 2]!];
    const [nx, ny, nz] = [way * normals[at]!, way * normals[at + 1]!, way * normals[at + 2]!];
    for (let n = 0; n < 27; n++) {
      const key = bucketOf(
        x + (n % 3) - 1,
        y + (Math.floor(n / 3) % 3) - 1,
        z + Math.floor(n / 9) - 1,
      );
      for (let i = starts[key]!; i < starts[key + 1]!; i++) {
        const other = 3 * listed[i]!;
        const dx = positions[other]! - px;
        const dy = positions[other + 1]! - py;
        const dz = positions[other + 2]! - pz;
        const ahead = dx * nx + dy * ny + dz * nz;
        if (ahead > 0) least = Math.min(least, (dx * dx + dy * dy + dz * dz) / (2 * ahead));
      }
    }
  }
  return least;
}
