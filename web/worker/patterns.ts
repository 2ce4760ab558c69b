/** Regions as triangles with distances for lines and bands. */
import type { Mesh, SurfacePoint } from 'karcher';
import type { FillPattern } from '../model/drawing';
import type { Vector } from '../model/figure';
import { isTooFine, type Pattern, type Region } from '../model/traced';
import { cross, minus } from '../model/vectors';

/**
 * The longest side of a triangle, relative to the spacing. It is short, since distances are linear
 * in each triangle.
 */
const sidePart = 1 / 3;
/**
 * The approximate largest number of triangles. If the spacing needs more, the triangles become
 * larger.
 */
const mostTriangles = 150_000;
/**
 * The distances of a hatching start from a geodesic through the region's middle. This is its length
 * to each side, relative to the distance from the middle to the region's farthest triangle.
 */
const reachPart = 1.5;

type Corner = { weights: Vector; place: Vector };

const lengthOf = (a: Vector) => Math.hypot(...a);
const halfway = (a: Vector, b: Vector) => a.map((value, i) => (value + b[i]!) / 2) as Vector;
const areaOf = ([a, b, c]: readonly [Corner, Corner, Corner]) =>
  lengthOf(cross(minus(b.place, a.place), minus(c.place, a.place))) / 2;

/**
 * The pattern of a region. A hatched pattern has the distances from a geodesic through the region's
 * middle, and a striped pattern the distances from the region's border. Null if the pattern has too
 * many lines, or if there is no geodesic or border.
 */
export function patternOf(
  mesh: Mesh,
  region: Omit<Region, 'boundary'> & { boundary: SurfacePoint[][] },
  kind: Exclude<FillPattern, 'solid'>,
  spacing: number,
): Pattern | null {
  if (isTooFine(spacing, region)) return null;
  const side = Math.max(sidePart * spacing, Math.sqrt((2 * region.area) / mostTriangles));
  const triangles = mesh.triangles();
  const pieces = new Pieces(side, triangles);
  for (const [face, corners] of trianglesOf(mesh.positions(), triangles, region)) {
    pieces.add(face, corners);
  }
  const lines = kind === 'striped' ? region.boundary : middleLine(mesh, pieces);
  if (lines.length === 0) return null;
  const { face, bary, number } = pieces;
  const distances = mesh.distanceFromPaths(lines, {
    face: Int32Array.from(face),
    bary: Float64Array.from(bary),
  });
  return {
    faces: Int32Array.from(pieces.faces),
    corners: Float64Array.from(pieces.corners),
    values: Float32Array.from(number, (of) => distances[of]!),
  };
}

/** Triangles, bisected along their longest sides until these are short. */
class Pieces {
  readonly faces: number[] = [];
  /** The second and third weight of each corner. */
  readonly corners: number[] = [];
  /** The distinct points that need distances, and each corner's index among them. */
  readonly face: number[] = [];
  readonly bary: number[] = [];
  readonly number: number[] = [];
  readonly middles: { face: number; weights: Vector; place: Vector; area: number }[] = [];
  readonly #numbers = new Map<string | number, number>();

  constructor(
    private readonly side: number,
    private readonly triangles: Int32Array,
  ) {}

  add(face: number, triangle: readonly [Corner, Corner, Corner]): void {
    const open = [triangle];
    for (let next = open.pop(); next; next = open.pop()) {
      const [a, b, c] = next;
      const [ab, bc, ca] = [
        lengthOf(minus(a.place, b.place)),
        lengthOf(minus(b.place, c.place)),
        lengthOf(minus(c.place, a.place)),
      ];
      const longest = Math.max(ab, bc, ca);
      if (longest <= this.side) this.#keep(face, next);
      else if (longest === ab) open.push(...halves(a, b, c));
      else if (longest === bc) open.push(...halves(b, c, a));
      else open.push(...halves(c, a, b));
    }
  }

  #keep(face: number, triangle: readonly [Corner, Corner, Corner]): void {
    this.faces.push(face);
    const sum = (of: (corner: Corner) => Vector) =>
      [0, 1, 2].map((i) => triangle.reduce((all, one) => all + of(one)[i]! / 3, 0)) as Vector;
    const [weights, place] = [sum((one) => one.weights), sum((one) => one.place)];
    this.middles.push({ face, weights, place, area: areaOf(triangle) });
    for (const { weights } of triangle) {
      this.corners.push(weights[1], weights[2]);
      const vertex = weights.indexOf(1);
      const key = vertex < 0 ? `${face} ${weights}` : this.triangles[3 * face + vertex]!;
      let number = this.#numbers.get(key);
      if (number === undefined) {
        number = this.face.length;
        this.#numbers.set(key, number);
        this.face.push(face);
        this.bary.push(...weights);
      }
      this.number.push(number);
    }
  }
}

function halves(a: Corner, b: Corner, c: Corner): [Corner, Corner, Corner][] {
  const middle = { weights: halfway(a.weights, b.weights), place: halfway(a.place, b.place) };
  return [
    [a, middle, c],
    [middle, b, c],
  ];
}

const unitWeights: readonly Vector[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

function* trianglesOf(
  positions: Float64Array,
  triangles: Int32Array,
  { whole, parts, corners }: Pick<Region, 'whole' | 'parts' | 'corners'>,
): Generator<[number, [Corner, Corner, Corner]]> {
  const cornerOf = (face: number, weights: Vector): Corner => {
    const place: Vector = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const at = 3 * triangles[3 * face + k]!;
      for (let axis = 0; axis < 3; axis++) place[axis]! += weights[k]! * positions[at + axis]!;
    }
    return { weights, place };
  };
  for (const face of whole) {
    yield [face, unitWeights.map((weights) => cornerOf(face, weights)) as [Corner, Corner, Corner]];
  }
  for (const [i, face] of parts.entries()) {
    const three = [0, 2, 4].map((k) => {
      const [b, c] = [corners[6 * i + k]!, corners[6 * i + k + 1]!];
      return cornerOf(face, [Math.max(0, 1 - b - c), b, c]);
    });
    yield [face, three as [Corner, Corner, Corner]];
  }
}

/**
 * A geodesic through the middle of a region and beyond, oblique to the y axis as seen from outside.
 */
function middleLine(mesh: Mesh, { middles }: Pieces): SurfacePoint[][] {
  if (middles.length === 0) return [];
  const center: Vector = [0, 0, 0];
  const area = middles.reduce((sum, one) => sum + one.area, 0);
  for (const { place, area: part } of middles) {
    for (let axis = 0; axis < 3; axis++) center[axis]! += (part / area) * place[axis]!;
  }
  const farFrom = (place: Vector) => (one: (typeof middles)[0]) =>
    lengthOf(minus(one.place, place));
  const off = middles.map(farFrom(center));
  const middle = middles[off.reduce((best, one, i) => (one < off[best]! ? i : best), 0)]!;
  const reach = middles.map(farFrom(middle.place)).reduce((most, one) => Math.max(most, one), 0);
  const point = mesh.surfacePoint(middle.face, middle.weights);
  const normal = mesh.normal(point);
  const across = cross([0, 1, 0], normal);
  const level = lengthOf(across) > 0.1 ? across : cross([0, 0, -1], normal);
  const along = level.map((value) => value / lengthOf(level)) as Vector;
  const up = cross(normal, along);
  const way = along.map((value, i) => value + up[i]!) as Vector;
  const length = reachPart * reach;
  if (!(length > 0)) return [];
  const ahead = mesh.straightest(point, way, length).path.points();
  const behind = mesh.straightest(point, way.map((value) => -value) as Vector, length).path;
  return [[...behind.points().toReversed(), ...ahead.slice(1)]];
}
