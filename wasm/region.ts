import {
  badArgument,
  checkArray,
  checkBoolean,
  checkNumber,
  checkOneOf,
  checkOptions,
  namesOf,
  shown,
  toFloat64,
  toInt32,
} from './check.js';
import type { MeshHandle } from './engine.js';
import { KarcherError } from './errors.js';
import type { EngineRegion } from './karcher-engine.mjs';
import { regionOptionNames } from './options.js';
import { listed, Path } from './path.js';
import type { Outline, RegionShape } from './path_types.js';
import type { PathValue, RegionValue } from './path_values.js';
import { wirePoint, wirePointArrays, wirePoints } from './points.js';
import type { RegionOptions, SurfacePoint } from './types.js';

const shapeNames = namesOf<RegionShape>({ outlines: true, inside: true });

/** A part of the surface. A region keeps its data, needs no mesh and has no `dispose`. */
export class Region {
  readonly #data: EngineRegion;

  /** @internal Meshes return regions. */
  constructor(data: EngineRegion) {
    this.#data = data;
  }

  /**
   * The region of a value that `toJSON` returned. The value is copied.
   *
   * @throws {KarcherError} badArgument for anything else.
   * @example
   * ```ts
   * const again = Region.from(JSON.parse(JSON.stringify(region)));
   * ```
   */
  static from(value: RegionValue): Region {
    const { area, perimeter, boundary, share, triangles, sides, isLeft } = Object(
      value,
    ) as RegionValue;
    return new Region({
      area: checkNumber(area, 'area'),
      perimeter: checkNumber(perimeter, 'perimeter'),
      boundary: checkArray(boundary, 'boundary').map((path) => Path.from(path as PathValue).data()),
      share: Uint8Array.from(toInt32(share, 'share')),
      triangles: toInt32(triangles, 'triangles'),
      sides: toFloat64(sides, 'sides'),
      ...(isLeft !== undefined && { isLeft: checkBoolean(isLeft, 'isLeft') }),
    });
  }

  /** The area, in squared units of the mesh. */
  get area(): number {
    return this.#data.area;
  }

  /** The length of the region's boundary, which includes parts of the surface's boundary. */
  get perimeter(): number {
    return this.#data.perimeter;
  }

  /**
   * Closed paths with the region to their left: the outer outlines of the region, and the outlines
   * of its holes.
   */
  boundary(): Path[] {
    return this.#data.boundary.map((path) => new Path(path));
  }

  /**
   * Whether a point (as `mesh.surfacePoint` returns it) lies in the region. For a point on the
   * boundary, the result may be either.
   */
  contains(point: SurfacePoint): boolean {
    const [face, , x, y] = wirePoint(point) as unknown as number[];
    const { share, triangles, sides } = this.#data;
    const whole = share[face!];
    if (Number.isNaN(face)) {
      const sentence = 'the point must have a face, as mesh.surfacePoint gives it, not a vertex';
      throw badArgument(sentence);
    }
    if (whole === undefined) {
      throw new KarcherError(
        'badIndex',
        `there is no triangle ${shown(point.face)}: the mesh has ${share.length}`,
      );
    }
    if (whole < 2) return whole === 1;
    let inside = false;
    for (let i = firstOf(triangles, face!); triangles[i] === face; i++) {
      const [ax, ay, bx, by] = sides.subarray(4 * i, 4 * i + 4) as unknown as Four;
      // A side counts if the line from the point along y crosses it.
      if (ax <= x! === bx <= x!) continue;
      if (ay + ((x! - ax) / (bx - ax)) * (by - ay) > y!) inside = !inside;
    }
    return inside;
  }

  /**
   * The region as a value for JSON, from which `Region.from` creates the region again.
   *
   * @example
   * ```ts
   * const text = JSON.stringify(region);
   * ```
   */
  toJSON(): RegionValue {
    return {
      ...listed<RegionValue>(this.#data),
      boundary: this.#data.boundary.map(listed<PathValue>),
    };
  }

  /** @internal The region's data, which nobody may change. */
  data(): EngineRegion {
    return this.#data;
  }
}

type Four = [number, number, number, number];

/** In a sorted array, the index of the first number that is at least `value`. */
function firstOf(sorted: Int32Array, value: number): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Whether a value is a `PathValue`. */
const isPath = (value: unknown): value is PathValue => Object(value).face !== undefined;

export const wireOutline = (outline: unknown, what: string): Float64Array => {
  const arrays = outline instanceof Path ? outline.data() : outline;
  const points = isPath(arrays) ? wirePointArrays(arrays) : wirePoints(outline, what);
  if (points.length > 4) return points;
  throw badArgument(`${what} must have at least two points`);
};

/** Paths in the form for the engine. */
export const wireOutlines = (paths: unknown): Float64Array[] =>
  checkArray(paths, 'the paths').map((path, i) => wireOutline(path, `path ${i}`));

export function regions(
  mesh: MeshHandle,
  shapes: readonly (Outline | RegionShape)[],
  options: RegionOptions,
): Region[] {
  checkOptions(options, regionOptionNames);
  const rule = checkOneOf(options.rule ?? 'evenOdd', ['evenOdd', 'nonZero'], 'the rule');
  const combine = checkOneOf(
    options.combine ?? 'none',
    ['none', 'union', 'intersection', 'difference', 'exclusion'],
    'what combines',
  );
  const { outlines, counts, insides } = wireShapes(shapes);
  return mesh
    .call((target) => target.regions(outlines, counts, insides, rule, combine))
    .map((region) => new Region(region));
}

/**
 * Shapes in the form for the engine: all outlines, the number of outlines of each shape, and for
 * each shape an array with a point inside or with the inner side, or an empty array.
 */
function wireShapes(shapes: unknown) {
  const outlines: Float64Array[] = [];
  const counts: number[] = [];
  const insides: Float64Array[] = [];
  const all = checkArray(shapes, 'the shapes');
  if (all.length === 0) throw badArgument('there must be at least one shape');
  all.forEach((shape, i) => {
    if (shape instanceof Path || Array.isArray(shape) || isPath(shape)) {
      outlines.push(wireOutline(shape, `shape ${i}`));
      counts.push(1);
      insides.push(new Float64Array(0));
      return;
    }
    checkOptions(shape, shapeNames);
    const { outlines: own, inside } = shape as { outlines: unknown; inside?: unknown };
    const listed = checkArray(own, `the outlines of shape ${i}`);
    if (listed.length === 0) {
      throw badArgument(`shape ${i} must have at least one outline`);
    }
    listed.forEach((outline, k) => {
      outlines.push(wireOutline(outline, `outline ${k} of shape ${i}`));
    });
    counts.push(listed.length);
    insides.push(
      inside === undefined
        ? new Float64Array(0)
        : inside === 'left' || inside === 'right'
          ? Float64Array.of(+(inside === 'left'))
          : wirePoint(inside as SurfacePoint, `the point inside shape ${i}`),
    );
  });
  return { outlines, counts: Int32Array.from(counts), insides };
}
