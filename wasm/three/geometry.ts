import { BufferAttribute, BufferGeometry, Color, type Matrix4, Vector3 } from 'three';
import { checkPositive } from '../check.js';
import { Path } from '../path.js';
import type { PathValue } from '../path_values.js';
import { ribbonAlong, type Tube, type TubeLine, tubeAlong } from '../tube.js';
import type { AnyMesh, Surface } from './surface.js';

/** A range of a geometry's index that has its own material. */
export interface GeometryGroup {
  /** The first place in the index. */
  start: number;
  /** The number of places in the index. */
  count: number;
  /** The number of the material. */
  materialIndex?: number | undefined;
}

/**
 * The geometry of a surface: positions in 32 bits, an index of 32 bits in the order of the mesh's
 * faces, and normals. The corners of all faces are counterclockwise as seen from above
 * (`Surface.normal`). Vertices keep their numbers. Of several vertices at one place that the mesh
 * has welded, the index names the first. Welded vertices have one normal, so that normals are
 * smooth across seams. The geometry has the given `groups`, such as those of the original geometry.
 */
export function geometryOf(
  surface: Surface<AnyMesh>,
  { groups = [] }: { groups?: readonly GeometryGroup[] } = {},
): BufferGeometry {
  const { triangles } = surface;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(triangles.positions), 3));
  const corners = surface.cornersFromAbove();
  const setIndex = (vertexOf: (vertex: number) => number) =>
    geometry.setIndex(new BufferAttribute(Uint32Array.from(corners, vertexOf), 1));
  for (const { start, count, materialIndex } of groups) {
    geometry.addGroup(start, count, materialIndex);
  }
  const { welded } = triangles;
  setIndex((v) => welded[v]!);
  geometry.computeVertexNormals();
  const normals = geometry.getAttribute('normal') as BufferAttribute;
  for (let v = 0; v < normals.count; v++) normals.copyAt(v, normals, welded[v]!);
  return setIndex((v) => triangles.drawn(v));
}

/** The shape of a tube. */
export interface TubeOptions {
  /** The radius; 0.004 of the surface's diagonal by default. */
  radius?: number | undefined;
  /** The number of sides of a cross section, 3 to 64; 8 by default. */
  sides?: number | undefined;
}

/**
 * A tube along a path on the surface. It has a ring at each point of the path. The surface's
 * normals orient the rings, so that the tube does not twist. Tubes of closed paths are closed;
 * others are open at their ends.
 */
export function tubeGeometry(
  surface: Surface<AnyMesh>,
  along: Path | PathValue,
  options: TubeOptions = {},
): BufferGeometry {
  const radius = checkPositive(options.radius ?? 0.004 * surface.diagonal, 'the radius');
  const { sides } = options;
  return geometryOfBand(
    tubeAlong(lineOf(surface, along), { radius, ...(sides !== undefined && { sides }) }),
  );
}

/** The shape of a ribbon. */
export interface RibbonOptions {
  /** The width; 0.01 of the surface's diagonal by default. */
  width?: number | undefined;
}

/**
 * A flat ribbon along a path. At each point it lies across the path, in the plane of the surface.
 * The ribbon faces up (`Surface.normal`). Where the surface bends across the path, the sides of a
 * wide ribbon leave the surface. The texture coordinate u grows by 1 for each width along the
 * ribbon; v runs from 0 on its left side to 1 on its right side.
 *
 * @throws {KarcherError} badArgument for a width that is not positive.
 * @example
 * ```ts
 * const ribbon = ribbonGeometry(surface, mesh.shortestPath(a, b), { width: 0.05 });
 * ```
 */
export function ribbonGeometry(
  surface: Surface<AnyMesh>,
  along: Path | PathValue,
  { width = 0.01 * surface.diagonal }: RibbonOptions = {},
): BufferGeometry {
  const ribbon = ribbonAlong(lineOf(surface, along), width);
  const geometry = geometryOfBand(ribbon);
  return geometry.setAttribute('uv', new BufferAttribute(Float32Array.from(ribbon.uvs), 2));
}

/** A path's places, with the surface's normals. */
function lineOf(surface: Surface<AnyMesh>, along: Path | PathValue): TubeLine {
  const path = along instanceof Path ? along : Path.from(along);
  return {
    places: path.polyline({ bits: 64 }),
    normals: path.points().flatMap((point) => surface.normal(point).toArray()),
    closed: path.closed,
  };
}

function geometryOfBand({ positions, normals, triangles }: Tube): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(normals), 3));
  return geometry.setIndex(new BufferAttribute(triangles, 1));
}

/** The options for colors of numbers. */
export interface ColorOptions {
  /**
   * A function that sets the color of a number. It receives the number divided by the largest one,
   * from 0 to 1. By default the colors run from yellow to blue.
   */
  ramp?: (part: number, color: Color) => void;
  /** The number that has the last color; by default the largest of all. */
  most?: number;
}

/**
 * Distances, or other numbers of at least 0, one for each vertex, as an attribute `color` for a
 * material with `vertexColors`. Vertices without a number (NaN) are gray.
 */
export function vertexColors(
  numbers: ArrayLike<number>,
  { ramp = yellowToBlue, most }: ColorOptions = {},
): BufferAttribute {
  let largest = most ?? 0;
  if (most === undefined) {
    for (let v = 0; v < numbers.length; v++) {
      if (numbers[v]! > largest) largest = numbers[v]!;
    }
  }
  const colors = new Float32Array(3 * numbers.length);
  const color = new Color();
  for (let v = 0; v < numbers.length; v++) {
    const part = largest > 0 ? numbers[v]! / largest : 0;
    if (Number.isNaN(part)) color.setScalar(0.5);
    else ramp(Math.min(1, Math.max(0, part)), color);
    color.toArray(colors, 3 * v);
  }
  return new BufferAttribute(colors, 3);
}

const [yellow, blue] = [new Color(0xffe08a), new Color(0x21409a)];
const yellowToBlue = (part: number, color: Color) => color.lerpColors(yellow, blue, part);

/**
 * Log vectors of the vertices as an attribute `uv`, which lays a picture round the point where the
 * vectors start. The picture is twice `radius` wide, and upright along the y axis of `frame`. Pass
 * the frame of the point (`Surface.frame`), rotated about the normal as you like. Outside the
 * picture, uv lies outside 0 to 1, and far outside for vertices without a vector (NaN).
 */
export function logMapUvs(
  vectors: ArrayLike<number>,
  frame: Matrix4,
  radius: number,
): BufferAttribute {
  checkPositive(radius, 'the radius');
  const [x, y] = [new Vector3(), new Vector3()];
  frame.extractBasis(x, y, new Vector3());
  const uvs = new Float32Array((2 * vectors.length) / 3);
  const vector = new Vector3();
  for (let v = 0; 3 * v < vectors.length; v++) {
    vector.set(vectors[3 * v]!, vectors[3 * v + 1]!, vectors[3 * v + 2]!);
    const part = (axis: Vector3) => {
      const coordinate = 0.5 + vector.dot(axis) / (2 * radius);
      return Number.isNaN(coordinate) ? -1e3 : coordinate;
    };
    uvs.set([part(x), part(y)], 2 * v);
  }
  return new BufferAttribute(uvs, 2);
}

/** The options for decals. */
export interface DecalOptions {
  /**
   * The largest stretch: the decal omits a triangle if a side of its picture is more than this many
   * times as long as on the surface. The default is 4, which a picture on a sphere reaches at four
   * fifths of the way to the opposite point.
   */
  stretch?: number | undefined;
}

/**
 * The part of a surface that a picture round a point covers, as a separate geometry with normals
 * and the `uv` of `logMapUvs`. Lay it over the surface with a transparent material. It has the
 * triangles that the picture reaches, except those that would show the picture as a streak: the
 * shortest paths to their corners arrive from different sides. Triangles at the picture's edge are
 * whole. There the texture repeats its outermost pixels, which should be transparent.
 */
export function decalGeometry(
  surface: Surface<AnyMesh>,
  vectors: ArrayLike<number>,
  frame: Matrix4,
  radius: number,
  { stretch = 4 }: DecalOptions = {},
): BufferGeometry {
  checkPositive(stretch, 'the stretch');
  const geometry = geometryOf(surface);
  const uvs = logMapUvs(vectors, frame, radius);
  const corners = surface.cornersFromAbove();
  const { positions } = surface.triangles;
  const index: number[] = [];
  const sideOf = (values: ArrayLike<number>, size: number, a: number, b: number) =>
    Math.hypot(
      ...Array.from({ length: size }, (_, k) => values[size * a + k]! - values[size * b + k]!),
    );
  for (let at = 0; at < corners.length; at += 3) {
    const face = [corners[at]!, corners[at + 1]!, corners[at + 2]!];
    // The picture may reach the triangle unless all corners lie beyond the same side of the
    // picture.
    const isReached = [0, 1].every((k) => {
      const places = face.map((v) => uvs.getComponent(v, k));
      return Math.max(...places) > 0 && Math.min(...places) < 1;
    });
    const isWhole = face.every((a, k) => {
      const b = face[(k + 1) % 3]!;
      return 2 * radius * sideOf(uvs.array, 2, a, b) <= stretch * sideOf(positions, 3, a, b);
    });
    if (isReached && isWhole) index.push(...face);
  }
  geometry.setAttribute('uv', uvs);
  geometry.setIndex(new BufferAttribute(Uint32Array.from(index), 1));
  return geometry;
}
