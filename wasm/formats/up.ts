import type { MeshFormat, UpAxis } from './types.js';

/**
 * The largest height of a triangle of the sole above the lowest place, relative to the whole
 * height.
 */
const soleHeight = 0.02;
/** The cosine of the largest angle by which a sole's triangle leans. */
const flat = 0.94;
/**
 * The least area of a sole, relative to the face of the bounding box, and the factor by which a
 * sole must be larger than that of the other axis.
 */
const [leastSole, muchMore] = [0.06, 2];

/**
 * The axis that points up if the shape does not show it: the axis that most programs use with the
 * format.
 */
const usual: Readonly<Record<MeshFormat, UpAxis>> = {
  obj: 'y',
  gltf: 'y',
  off: 'y',
  ply: 'y',
  stl: 'z',
};

/**
 * The axis of a file's coordinates that points up, y or z. It is the axis along which the surface
 * stands on a flat sole, or on the rim of an opening at its bottom. If this is not clear, it is the
 * usual axis of the format. For glTF, which prescribes the axis, it is y.
 */
export function guessUp(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  format: MeshFormat,
): UpAxis {
  if (format === 'gltf') return 'y';
  const [y, z] = soles(positions, triangles);
  if (Math.max(y, z) < leastSole) return usual[format];
  if (y > muchMore * z) return 'y';
  return z > muchMore * y ? 'z' : usual[format];
}

/**
 * The areas on which the surface stands along y and along z, relative to the face of the bounding
 * box. An area consists of flat triangles at the bottom and of openings there.
 */
function soles(positions: ArrayLike<number>, triangles: ArrayLike<number>): [number, number] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < triangles.length; i++) {
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * triangles[i]! + axis]!;
      if (value < low[axis]!) low[axis] = value;
      if (value > high[axis]!) high[axis] = value;
    }
  }
  const size = low.map((value, axis) => high[axis]! - value) as [number, number, number];
  const soleOf = (axis: 1 | 2) => {
    const [b, c] = [(axis + 1) % 3, (axis + 2) % 3] as [number, number];
    const box = size[b]! * size[c]!;
    // A shape without height does not stand.
    if (!(box > 0) || size[axis] < 0.02 * Math.max(...size)) return 0;
    const floor = low[axis]! + soleHeight * size[axis];
    const at = (corner: number, along: number) => positions[3 * triangles[corner]! + along]!;
    let sum = 0;
    for (let i = 0; i < triangles.length; i += 3) {
      if (at(i, axis) > floor || at(i + 1, axis) > floor || at(i + 2, axis) > floor) continue;
      sum += flatArea(
        [at(i, b), at(i, c), at(i, axis)],
        [at(i + 1, b), at(i + 1, c), at(i + 1, axis)],
        [at(i + 2, b), at(i + 2, c), at(i + 2, axis)],
      );
    }
    return (sum + openArea(positions, triangles, { axis, b, c, floor, low })) / box;
  };
  return [soleOf(1), soleOf(2)];
}

type Place = [number, number, number];

/** The area of a triangle, seen along its last coordinate; 0 if the triangle leans too much. */
function flatArea(p: Place, q: Place, r: Place): number {
  const [ux, uy, uz] = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
  const [vx, vy, vz] = [r[0] - p[0], r[1] - p[1], r[2] - p[2]];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx] as const;
  const along = Math.abs(normal[2]);
  return along >= flat * Math.hypot(...normal) ? along / 2 : 0;
}

/** The area that closed loops of boundary edges at the bottom enclose, seen from below. */
function openArea(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  { axis, b, c, floor, low }: { axis: number; b: number; c: number; floor: number; low: number[] },
): number {
  const isLow = (vertex: number) => positions[3 * vertex + axis]! <= floor;
  const open = new Map<string, Edge>();
  const nameOf = (vertex: number) =>
    `${positions[3 * vertex]},${positions[3 * vertex + 1]},${positions[3 * vertex + 2]}`;
  for (let i = 0; i < triangles.length; i += 3) {
    for (let corner = 0; corner < 3; corner++) {
      const from = triangles[i + corner]!;
      const to = triangles[i + ((corner + 1) % 3)]!;
      if (!isLow(from) || !isLow(to)) continue;
      const [one, other] = [nameOf(from), nameOf(to)];
      const key = one < other ? `${one} ${other}` : `${other} ${one}`;
      // An edge of two faces is not on the boundary.
      if (!open.delete(key)) open.set(key, { from, to, start: one, end: other });
    }
  }
  let twice = 0;
  // Places are relative to the box's corner, so that the sum does not depend on where the mesh
  // lies.
  const at = (vertex: number, along: number) => positions[3 * vertex + along]! - low[along]!;
  for (const { from, to } of inLoops([...open.values()])) {
    twice += at(from, b) * at(to, c) - at(from, c) * at(to, b);
  }
  return Math.abs(twice) / 2;
}

/** An edge with the names of its ends' places. */
interface Edge {
  from: number;
  to: number;
  start: string;
  end: string;
}

/** The edges of closed loops. Edges of open chains are left out, since they enclose no area. */
function inLoops(edges: readonly Edge[]): Edge[] {
  const touching = new Map<string, Edge[]>();
  const ends = new Map<string, { out: number; in: number }>();
  for (const edge of edges) {
    for (const place of [edge.start, edge.end]) {
      if (!ends.has(place)) {
        ends.set(place, { out: 0, in: 0 });
        touching.set(place, []);
      }
      touching.get(place)!.push(edge);
    }
    ends.get(edge.start)!.out++;
    ends.get(edge.end)!.in++;
  }
  const left = new Set(edges);
  const isEnd = (place: string) => ends.get(place)!.out === 0 || ends.get(place)!.in === 0;
  const waiting = [...ends.keys()].filter(isEnd);
  for (let place = waiting.pop(); place !== undefined; place = waiting.pop()) {
    for (const edge of touching.get(place)!) {
      if (!left.delete(edge)) continue;
      ends.get(edge.start)!.out--;
      ends.get(edge.end)!.in--;
      waiting.push(...[edge.start, edge.end].filter(isEnd));
    }
  }
  return [...left];
}
