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
  const way = Math.sign(thickness);
  const fold = unfolded(shape.positions, bounding, shapeNormals, way);
  const least = Math.min(Math.abs(thickness), fold);
  const bound = ballBound(shape.positions, bounding, shapeNormals, way, least);
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
  way: number,
): number {
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
 * vertex moves, and passes through another vertex. The result is at most `most`.
 */
function ballBound(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  normals: Float64Array,
  way: number,
  most: number,
): number {
  const { order, patches } = patchTree(positions, triangles, normals);
  let least = most;
  for (const vertex of order) {
    const here = vectorAt(positions, vertex);
    const normal = vectorAt(normals, vertex).map((value) => way * value) as Vector;
    for (let number = 0; number < patches.length; ) {
      const { center, across, radius, low, high, from, to, after } = patches[number]!;
      // A place at d from the vertex is within the ball of radius r about r n if d·(d - 2 r n) < 0.
      // `value` is at most this product, for all places within the cylinder.
      const [x, y, z] = [center[0] - here[0], center[1] - here[1], center[2] - here[2]];
      const [u, v, w] = [x - least * normal[0], y - least * normal[1], z - least * normal[2]];
      const rise = u * across[0] + v * across[1] + w * across[2];
      const slope = Math.sqrt(Math.max(0, u * u + v * v + w * w - rise * rise));
      const aside = Math.min(radius, slope);
      const up = Math.min(Math.max(-rise, low), high);
      const atCenter =
        x * (u - least * normal[0]) + y * (v - least * normal[1]) + z * (w - least * normal[2]);
      const value = atCenter + aside * (aside - 2 * slope) + up * (up + 2 * rise);
      number = value < 0 ? number + 1 : after;
      if (value >= 0 || number < after) continue;
      for (let i = from; i < to; i++) {
        const other = 3 * order[i]!;
        const dx = positions[other]! - here[0];
        const dy = positions[other + 1]! - here[1];
        const dz = positions[other + 2]! - here[2];
        const ahead = dx * normal[0] + dy * normal[1] + dz * normal[2];
        if (ahead > 0) least = Math.min(least, (dx * dx + dy * dy + dz * dz) / (2 * ahead));
      }
    }
  }
  return least;
}

/**
 * Vertices within a flat cylinder: its axis is the mean normal, along which they lie between `low`
 * and `high` from the center. A cylinder fits a patch of a smooth surface so closely that few
 * patches intersect a ball which the whole surface touches.
 */
interface Patch {
  center: Vector;
  across: Vector;
  radius: number;
  low: number;
  high: number;
  /** The range of the patch's vertices in their order. */
  from: number;
  to: number;
  /** The number of the first later patch that is not part of this one. */
  after: number;
}

/** The vertices of triangles in the order of a tree of patches. A patch comes before its parts. */
function patchTree(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  normals: Float64Array,
): { order: Int32Array; patches: Patch[] } {
  const order = Int32Array.from(new Set(Array.from(triangles)));
  const patches: Patch[] = [];
  const add = (from: number, to: number): void => {
    const least: Vector = [Infinity, Infinity, Infinity];
    const most: Vector = [-Infinity, -Infinity, -Infinity];
    const sum: Vector = [0, 0, 0];
    for (const vertex of order.subarray(from, to)) {
      for (let axis = 0; axis < 3; axis++) {
        const value = positions[3 * vertex + axis]!;
        least[axis] = Math.min(least[axis]!, value);
        most[axis] = Math.max(most[axis]!, value);
        sum[axis]! += normals[3 * vertex + axis]!;
      }
    }
    const sizes = subtract(most, least);
    const center = least.map((value, axis) => value + sizes[axis]! / 2) as Vector;
    const length = Math.hypot(...sum) || 1;
    const across = sum.map((value) => value / length) as Vector;
    const patch = { center, across, radius: 0, low: Infinity, high: -Infinity, from, to, after: 0 };
    const widest = sizes.indexOf(Math.max(...sizes));
    let split = from;
    for (let i = from; i < to; i++) {
      const vertex = order[i]!;
      const away = subtract(vectorAt(positions, vertex), center);
      const up = dot(away, across);
      patch.low = Math.min(patch.low, up);
      patch.high = Math.max(patch.high, up);
      patch.radius = Math.max(patch.radius, Math.sqrt(Math.max(0, dot(away, away) - up * up)));
      if (away[widest]! >= 0) continue;
      order[i] = order[split]!;
      order[split++] = vertex;
    }
    patches.push(patch);
    if (to - from > 4 && split > from) {
      add(from, split);
      add(split, to);
    }
    patch.after = patches.length;
  };
  add(0, order.length);
  return { order, patches };
}
