import { checkInteger, checkNumber, toFloat64 } from './check.js';
import { type Engine, Handle } from './engine.js';
import { KarcherError } from './errors.js';
import type { EngineMesh } from './karcher-engine.mjs';
import { toSurfacePoint, wirePoint } from './points.js';
import type { MeshInfo, PointLike, StraightestPath, SurfacePoint } from './types.js';

/**
 * A triangle mesh. It lives in the engine's memory until `dispose`.
 *
 * Every method throws `KarcherError`: disposed after `dispose`; badIndex for a face or vertex that
 * does not exist or a vertex that was dropped; badPoint for weights outside the face; notFinite for
 * NaN or infinity; badArgument for anything else out of range.
 */
export class Mesh {
  readonly #engine: Engine;
  readonly #handle: Handle<EngineMesh>;

  /** What the mesh consists of, and what was mended while it was read. */
  readonly info: MeshInfo;

  /** @internal `Karcher` makes meshes. */
  constructor(engine: Engine, target: EngineMesh) {
    this.#engine = engine;
    this.#handle = new Handle(engine, 'the mesh', target);
    this.info = this.#handle.call((mesh) => mesh.info());
  }

  /**
   * x, y, z of each vertex, in the caller's order, as a new array. Welded vertices repeat their
   * place; dropped ones keep theirs.
   */
  positions(): Float64Array {
    return this.#handle.call((mesh) => mesh.positions());
  }

  /** The vertices of each triangle, in the caller's order and numbers, as a new array. */
  triangles(): Int32Array {
    return this.#handle.call((mesh) => mesh.triangles());
  }

  /**
   * The mesh refined by Loop subdivision: four triangles for each, `levels` times (1 to 6). The new
   * mesh has a numbering of its own and is disposed of on its own.
   */
  subdivide(levels = 1): Mesh {
    checkInteger(levels, 'the number of levels');
    return new Mesh(
      this.#engine,
      this.#handle.call((mesh) => mesh.subdivided(levels)),
    );
  }

  /**
   * The point of a face with the given weights of its corners, checked and cleaned: weights that
   * leave the face by no more than 1e-6, from rounding, are moved onto it.
   */
  pointAt(face: number, bary: ArrayLike<number>): SurfacePoint {
    return toSurfacePoint(wirePoint(this.#handle, { face, bary } as PointLike));
  }

  /** The place of a point in space. */
  position(point: PointLike): [number, number, number] {
    const wire = wirePoint(this.#handle, point);
    return this.#handle.call((mesh) => mesh.position(wire));
  }

  /**
   * The straightest geodesic that leaves a point along a direction in space, which is projected onto
   * the point's face, for the given length. At the boundary it stops: `remaining` tells how much of
   * the length was left.
   *
   * Throws `KarcherError` badArgument where the direction is perpendicular to the face or the length
   * is negative.
   */
  straightest(from: PointLike, direction: ArrayLike<number>, length: number): StraightestPath {
    const wire = wirePoint(this.#handle, from);
    checkNumber(length, 'the length');
    const vector = toFloat64(direction, 'the direction');
    if (vector.length !== 3) {
      throw new KarcherError(
        'badArgument',
        `the direction must be 3 numbers, not ${vector.length}`,
      );
    }
    vector.forEach((component, i) => {
      checkNumber(component, `component ${i} of the direction`);
    });
    const path = this.#handle.call((mesh) => mesh.straightest(wire, vector, length));
    return { ...path, end: toSurfacePoint(path.end) };
  }

  /** Gives the memory back. Safe to repeat. */
  dispose(): void {
    this.#handle.dispose();
  }
}
