/**
 * Figures that move together, each in a frame of its own: a pair of perpendicular directions at the
 * figure's middle. The frame moves on the surface, and the figure keeps its places relative to it.
 * From a single pivot, far figures would become narrower or wider, since geodesics of a curved
 * surface converge or diverge.
 */
import type { MappedPoints, Mesh, PointLike, SurfacePoint } from 'karcher';
import type { Vector } from '../model/figure';
import { cross, scaled } from '../model/vectors';

/** Places with a direction at each place: x, y, z, or 0, 0, 0 if there is none. */
export interface DirectedPlaces {
  places: readonly SurfacePoint[];
  directions: Float64Array;
}

/**
 * A frame at the middle of places, with the places' log vectors and directions in this frame. Each
 * vector and each direction has two coordinates.
 */
export interface Framed {
  middle: SurfacePoint;
  /** The frame's two axes in the plane of the middle's face, as x, y, z of both. */
  axes: Float64Array;
  vectors: Float64Array;
  directions: Float64Array;
}

/**
 * A step of a move. The vectors and directions belong to the place `from`, which moves to `to`; it
 * stays if `to` is null.
 */
export interface Step {
  from: PointLike;
  to: PointLike | null;
  vectors: Float64Array;
  directions: Float64Array;
  /**
   * The figures in frames. `vectors` and `directions` begin with two entries for each figure: in
   * `vectors` its middle, twice, and in `directions` the two axes of its frame.
   */
  framed: readonly Framed[];
  /** The scale of the figures in their frames. */
  scale: number;
}

/**
 * The number of rounds, and the largest number of places in a round. Each round brings the middle
 * nearer to the center of mass of these places. The middle need not be exact, since any place amid
 * a figure serves.
 */
const rounds = 3;
const mostCompared = 64;

/**
 * The coordinates of places and directions in a frame at the middle of the places. Throws if no path
 * leads from the middle to a place.
 */
export function framedAt(mesh: Mesh, { places, directions }: DirectedPlaces): Framed {
  const every = Math.ceil(places.length / mostCompared);
  const some = places.filter((_, i) => i % every === 0);
  let middle = places[0]!;
  for (let round = 0; round < rounds; round++) {
    const { vectors } = mesh.logMap(middle, some);
    const mean = [0, 1, 2].map(
      (axis) => some.reduce((sum, _, i) => sum + vectors[3 * i + axis]!, 0) / some.length,
    );
    middle = mesh.expMap(middle, mean).points[0]!;
  }
  const axes = axesOf(mesh.normal(middle));
  const logs = mesh.logMap(middle, places, directions);
  return {
    middle,
    axes,
    vectors: coordinatesIn(axes, logs.vectors),
    directions: coordinatesIn(axes, logs.directions),
  };
}

/**
 * The points to which a step leads: first the places of the framed figures, then the ends of the
 * other vectors. The results also have the directions there and the missing lengths.
 */
export function putDown(
  mesh: Mesh,
  { from, to, vectors, directions, framed, scale }: Step,
): MappedPoints {
  const ends = endsOf(mesh, { from, to, vectors, directions });
  if (framed.length === 0) return ends;
  const laid = framed.map((figure, i) => {
    const axes = ends.directions.subarray(6 * i, 6 * i + 6);
    return mesh.expMap(
      ends.points[2 * i]!,
      vectorsIn(axes, figure.vectors, scale),
      vectorsIn(axes, figure.directions, 1),
    );
  });
  const rest = 2 * framed.length;
  return {
    points: [...laid.flatMap(({ points }) => points), ...ends.points.slice(rest)],
    directions: Float64Array.from([
      ...laid.flatMap((figure) => [...figure.directions]),
      ...ends.directions.subarray(3 * rest),
    ]),
    // A frame that meets the boundary stops there, so the missing length counts for its whole
    // figure.
    remaining: Float64Array.from([
      ...laid.flatMap(({ remaining }, i) =>
        [...remaining].map((left) => left + ends.remaining[2 * i]!),
      ),
      ...ends.remaining.subarray(rest),
    ]),
  };
}

function endsOf(
  mesh: Mesh,
  { from, to, vectors, directions }: Omit<Step, 'framed' | 'scale'>,
): MappedPoints {
  if (to === null) return mesh.expMap(from, vectors, directions);
  const carried = mesh.transport(from, to, [...vectors, ...directions]);
  const { length } = vectors;
  return mesh.expMap(to, carried.subarray(0, length), carried.subarray(length));
}

/** Two perpendicular directions in the plane with a unit normal. */
function axesOf(normal: Vector): Float64Array {
  // The coordinate axis farthest from the normal gives the first direction.
  const sizes = normal.map(Math.abs);
  const farthest = sizes.indexOf(Math.min(...sizes));
  const aside = cross(normal, [+(farthest === 0), +(farthest === 1), +(farthest === 2)]);
  const first = scaled(aside, 1 / Math.hypot(...aside));
  return Float64Array.of(...first, ...cross(normal, first));
}

function coordinatesIn(axes: Float64Array, vectors: Float64Array): Float64Array {
  const coordinates = new Float64Array((2 * vectors.length) / 3);
  for (const i of coordinates.keys()) {
    const [from, axis] = [3 * (i >> 1), 3 * (i & 1)];
    for (let k = 0; k < 3; k++) coordinates[i]! += axes[axis + k]! * vectors[from + k]!;
  }
  return coordinates;
}

function vectorsIn(axes: Float64Array, coordinates: Float64Array, scale: number): Float64Array {
  const vectors = new Float64Array((3 * coordinates.length) / 2);
  for (const i of vectors.keys()) {
    const [at, k] = [2 * Math.floor(i / 3), i % 3];
    vectors[i] = scale * (coordinates[at]! * axes[k]! + coordinates[at + 1]! * axes[3 + k]!);
  }
  return vectors;
}
