import type { CutPart, SurfacePoint } from '../types.js';
import type { FileCurve, FilePath } from './curves.js';
import { type Place, weightsIn } from './part_marks.js';

/** A part that was cut out of a surface. */
type Part = Pick<CutPart, 'positions' | 'triangles' | 'faces'>;

/** A surface in the arrays of its mesh. */
interface Surface {
  positions: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

/**
 * The engine merges points that are nearer to each other than this, relative to an edge's length or
 * a face's height. A point this near to a part is on the part's border.
 */
const together = 2 ** -32;

/** Coordinates in a face: the second and third weight. */
type Flat = readonly [x: number, y: number];

/** A place on a surface: the weights of vertices. */
type Weights = ReadonlyMap<number, number>;

/** A triangle of a part, in the coordinates of its face. */
interface Piece {
  triangle: number;
  corners: readonly [Flat, Flat, Flat];
}

/**
 * Points of a surface as points of a part that was cut out of it; null for those that lie
 * elsewhere. A point on the part's border lies on the part. `surface` has the positions and
 * triangles of the mesh that was cut.
 *
 * @example
 * ```ts
 * const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
 * const [part] = mesh.cut([outline]);
 * const [point] = pointsOnPart(part!, surface, [{ face: 12, bary: [0.2, 0.3, 0.5] }]);
 * ```
 */
export function pointsOnPart(
  part: Part,
  surface: Surface,
  points: readonly SurfacePoint[],
): (SurfacePoint | null)[] {
  const { find } = finderOn(part, surface);
  return points.map((point) => find(weightsAt(surface, point)));
}

const cornersIn = (surface: Surface, face: number) =>
  [0, 1, 2].map((k) => surface.triangles[3 * face + k]!);

const weightsAt = (surface: Surface, { face, bary }: SurfacePoint): Weights =>
  new Map(cornersIn(surface, face).map((corner, k) => [corner, bary[k]!]));

/** The vertices on which a place depends. */
const cornersAt = (weights: Weights): number[] =>
  [...weights].filter(([, weight]) => weight > together).map(([corner]) => corner);

/** Places on a part. */
interface Finder {
  /** A place as a point of the part, or null if it lies elsewhere. */
  find(weights: Weights): SurfacePoint | null;
  /** Whether the part has the whole segment between two places of a face. */
  covers(from: Weights, to: Weights): boolean;
}

function finderOn(part: Part, surface: Surface): Finder {
  const cornersOf = (face: number) => cornersIn(surface, face);
  const trianglesOf = new Map<number, number[]>();
  part.faces.forEach((face, i) => {
    addTo(trianglesOf, face, i);
  });
  const facesOf = new Map<number, number[]>();
  for (const face of trianglesOf.keys()) {
    for (const corner of cornersOf(face)) addTo(facesOf, corner, face);
  }
  const piecesOf = new Map<number, Piece[]>();
  const piecesIn = (face: number): Piece[] => {
    const known = piecesOf.get(face);
    if (known) return known;
    const places = cornersOf(face).map((vertex) => at(surface.positions, vertex));
    const pieces = (trianglesOf.get(face) ?? []).map((triangle): Piece => {
      const corners = [0, 1, 2].map((k): Flat => {
        const place = at(part.positions, part.triangles[3 * triangle + k]!);
        const [, x, y] = weightsIn(places, place);
        return [x, y];
      });
      return { triangle, corners: corners as [Flat, Flat, Flat] };
    });
    piecesOf.set(face, pieces);
    return pieces;
  };
  const found = (weights: Weights, face: number): Found | null => {
    const [, x, y] = cornersOf(face).map((corner) => weights.get(corner) ?? 0);
    let best: Found | null = null;
    for (const piece of piecesIn(face)) {
      const candidate = inPiece(piece, [x!, y!]);
      if (!best || candidate.outside < best.outside) best = candidate;
    }
    return best;
  };
  /** The part's faces that have all these corners. */
  const facesWith = (corners: readonly number[]): number[] => {
    const [first, ...more] = corners.map((corner) => facesOf.get(corner) ?? []);
    return first!.filter((face) => more.every((faces) => faces.includes(face)));
  };
  const find = (weights: Weights) => {
    for (const face of facesWith(cornersAt(weights))) {
      const one = found(weights, face);
      if (one && one.outside <= together) return one.point;
    }
    return null;
  };
  const covers = (from: Weights, to: Weights) => {
    const corners = [...new Set([...cornersAt(from), ...cornersAt(to)])];
    const intervals = facesWith(corners).flatMap((face) => {
      const [p, q] = [from, to].map((weights): Flat => {
        const [, x, y] = cornersOf(face).map((corner) => weights.get(corner) ?? 0);
        return [x!, y!];
      });
      return piecesIn(face).flatMap((piece) => intervalIn(piece, p!, q!) ?? []);
    });
    let reached = 0;
    for (const { low, high } of intervals.sort((a, b) => a.low - b.low)) {
      if (low <= reached + together) reached = Math.max(reached, high);
    }
    return reached >= 1 - together;
  };
  return { find, covers };
}

function addTo(lists: Map<number, number[]>, key: number, value: number): void {
  const list = lists.get(key);
  if (list) list.push(value);
  else lists.set(key, [value]);
}

interface Found {
  point: SurfacePoint;
  /** The distance from the triangle in the face's coordinates; 0 inside it. */
  outside: number;
}

/**
 * The point of a triangle at a place, with the distance of the place from the triangle. For a place
 * outside, negative weights become 0.
 */
function inPiece({ triangle: face, corners: [a, b, c] }: Piece, place: Flat): Found {
  const whole = across(a, b, c);
  const sides = [
    [b, c],
    [c, a],
    [a, b],
  ] as const;
  const areas = sides.map(([p, q]) => across(p, q, place));
  const outside = sides.map(([p, q], k) => {
    const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    return length > 0 ? (-areas[k]! * Math.sign(whole)) / length : Infinity;
  });
  const weights = areas.map((area) => Math.max(0, area * Math.sign(whole)));
  const sum = weights.reduce((total, weight) => total + weight, 0);
  const bary = weights.map((weight) => weight / sum) as [number, number, number];
  return { point: { face, bary }, outside: sum > 0 ? Math.max(0, ...outside) : Infinity };
}

/** A part of a segment; 0 is its start, and 1 its end. */
interface Interval {
  low: number;
  high: number;
}

/** The part of a segment that lies in a triangle or on its border, or null if no part does. */
function intervalIn({ corners: [a, b, c] }: Piece, from: Flat, to: Flat): Interval | null {
  const way = Math.sign(across(a, b, c));
  if (way === 0) return null;
  let [low, high] = [0, 1];
  for (const [p, q] of [[a, b] as const, [b, c] as const, [c, a] as const]) {
    const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    const inside = (place: Flat) => (way * across(p, q, place)) / length + together;
    const [start, end] = [inside(from), inside(to)];
    if (start < 0 && end < 0) return null;
    if (start < 0) low = Math.max(low, start / (start - end));
    if (end < 0) high = Math.min(high, start / (start - end));
  }
  return low <= high ? { low, high } : null;
}

/** Twice the area of a triangle, negative if its corners run clockwise. */
const across = (p: Flat, q: Flat, r: Flat) =>
  (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);

const at = (of: ArrayLike<number>, vertex: number): Place => [
  of[3 * vertex]!,
  of[3 * vertex + 1]!,
  of[3 * vertex + 2]!,
];

/**
 * The pieces of curves that lie on a part of a cut surface, for `meshFile`. A curve that leaves the
 * part and comes back has several pieces; each has the name and look of its curve. The pieces
 * consist of whole segments of the curve's path: a segment that crosses the part's border belongs
 * to no part.
 *
 * @example
 * ```ts
 * const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
 * for (const part of mesh.cut(paths)) {
 *   const curves = curvesOnPart(part, surface, [{ name: 'seam', path: curve.path() }]);
 *   const bytes = meshFile({ ...part, curves }, 'obj');
 * }
 * ```
 */
export function curvesOnPart(
  part: Part,
  surface: Surface,
  curves: readonly FileCurve[],
): FileCurve[] {
  const { find, covers } = finderOn(part, surface);
  return curves.flatMap((curve) => {
    const { path, parameters } = curve;
    const places = path.points().map((point) => weightsAt(surface, point));
    const points = places.map(find);
    const isOn = points.map((point, i) => {
      const next = points[i + 1];
      if (!point || !next) return false;
      if (point.face === next.face) return true;
      const [from, to] = [places[i]!, places[i + 1]!];
      // The places between are unknown if the ends have no face in common.
      return new Set([...cornersAt(from), ...cornersAt(to)]).size > 3 || covers(from, to);
    });
    return runsOf(isOn).map(([first, end]): FileCurve => {
      const cut = <Values extends ArrayLike<number>>(values: Values) =>
        Array.from(values).slice(first, end);
      return {
        ...curve,
        path: pieceOf(path, points as SurfacePoint[], first, end),
        ...(parameters && { parameters: cut(parameters) }),
      };
    });
  });
}

/**
 * The runs of points that segments connect. `isOn` says of each point whether the segment to the
 * next point belongs to a run. A run has its first index, and the index after its last one.
 */
function runsOf(isOn: readonly boolean[]): [first: number, end: number][] {
  const runs: [number, number][] = [];
  for (let first = 0; first < isOn.length; first++) {
    let last = first;
    while (isOn[last]) last++;
    if (last > first) runs.push([first, last + 1]);
    first = last;
  }
  return runs;
}

function pieceOf(
  path: FilePath,
  points: readonly SurfacePoint[],
  first: number,
  end: number,
): FilePath {
  return {
    closed: path.closed && first === 0 && end === points.length,
    count: end - first,
    points: () => points.slice(first, end),
    polyline: (options) => path.polyline(options).slice(3 * first, 3 * end),
    lengths: () => {
      const lengths = path.lengths().slice(first, end);
      return lengths.map((length) => length - lengths[0]!);
    },
  };
}
