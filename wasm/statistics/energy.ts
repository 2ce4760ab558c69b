import { checkArray, checkNumber, toFloat64 } from '../check.js';
import { KarcherError } from '../errors.js';
import type { Mesh } from '../mesh.js';
import type { PointLike } from '../types.js';
import { dot, subtract, type Vector, at as vectorAt } from '../vectors.js';
import type { RemoteMesh } from '../worker/remote.js';

/** A mesh in this thread or in a worker. */
export type AnyMesh = Mesh | RemoteMesh;

/** The energy of points at a place, and its first derivatives there. */
export interface Energy {
  /** The weighted sum of squared distances to the points. */
  energy: number;
  /**
   * The gradient, a vector in the plane of the face: -2 times the weighted sum of the log vectors.
   */
  gradient: Vector;
}

/** The second derivatives of the energy at a point inside a face. */
export interface Hessian {
  /** Two unit vectors in the plane of the face, at right angles. */
  axes: [Vector, Vector];
  /** The second derivatives of the energy along these axes: xx, xy and yy. */
  matrix: [number, number, number];
}

/**
 * The energy and its gradient at a point, by locally shortest paths (`Mesh.logMap`). This is the
 * gradient on the polyhedron. For a point on an edge or at a vertex, it lies in the plane of the
 * face that the point names. At a center of mass inside a face it is small but not zero, since the
 * search for centers uses fields, which smooth these paths.
 *
 * Rejects as `Mesh.logMap` does, and with `KarcherError` badWeights unless there is one weight for
 * each point, or notFinite for a weight that is not finite.
 */
export async function energyAt(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: ArrayLike<number>,
  at: PointLike,
): Promise<Energy> {
  const masses = checkWeights(points, weights);
  const { vectors } = await mesh.logMap(at, points);
  const gradient: Vector = [0, 0, 0];
  let energy = 0;
  masses.forEach((mass, i) => {
    for (let k = 0; k < 3; k++) {
      const part = vectors[3 * i + k]!;
      energy += mass * part ** 2;
      gradient[k]! -= 2 * mass * part;
    }
  });
  return { energy, gradient };
}

/** A copy of the weights. Throws unless there is one finite weight for each point. */
export function checkWeights(
  points: readonly PointLike[],
  weights: ArrayLike<number>,
): Float64Array {
  const { length } = checkArray(points, 'the points');
  const masses = toFloat64(weights, 'the weights');
  if (masses.length !== length) {
    const sentence = `there are ${length} points but ${masses.length} weights`;
    throw new KarcherError('badWeights', sentence);
  }
  masses.forEach((mass, i) => {
    checkNumber(mass, `weight ${i}`);
  });
  return masses;
}

/**
 * The Hessian of the energy at a point inside a face, by central differences of gradients. On a
 * plane its matrix is twice the sum of the weights times the identity. The energy has no Hessian
 * where several shortest paths lead to one of the points, or where a shortest path changes from one
 * side of a vertex to the other.
 *
 * Rejects with `KarcherError` badArgument for a point on an edge or at a vertex; otherwise as
 * `energyAt` does.
 */
export async function hessianAt(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: ArrayLike<number>,
  at: PointLike,
): Promise<Hessian> {
  const face = await faceOf(mesh, at);
  const { axes, step } = face;
  const gradients = await Promise.all(
    axes.map(async (axis) => {
      const [before, after] = await Promise.all(
        [-step, step].map((length) => energyAt(mesh, points, weights, face.moved(axis, length))),
      );
      const change = after!.gradient.map(
        (x, k) => (x - before!.gradient[k]!) / (2 * step),
      ) as Vector;
      return axes.map((other) => dot(change, other));
    }),
  );
  const [[xx, xy], [yx, yy]] = gradients as [[number, number], [number, number]];
  return { axes, matrix: [xx, (xy + yx) / 2, yy] };
}

/**
 * The derivatives of a center of mass with respect to each weight, with the other weights fixed.
 * Each is a vector in the plane of the center's face, in units of the mesh. `center` is the center
 * of mass with these weights.
 *
 * They are derivatives on the polyhedron, and exact on a plane. Differences of computed centers,
 * whose fields are smoothed, deviated from these derivatives by up to 15 % on a torus of 2,000
 * triangles.
 *
 * Rejects as `hessianAt` does, and with badArgument where the Hessian is not positive definite.
 */
export async function weightDerivatives(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: ArrayLike<number>,
  center: PointLike,
): Promise<Vector[]> {
  const moveOf = await pulled(mesh, points, weights, center);
  const { vectors } = await mesh.logMap(center, points);
  return points.map((_, i) => moveOf(vectorAt(vectors, i), 1));
}

/** The derivatives of a center of mass with respect to one of its points. */
export interface PointDerivative {
  /** Two unit vectors in the plane of the point's face, at right angles. */
  axes: [Vector, Vector];
  /** The center's moves, in the plane of its face, as the point moves along each axis by 1. */
  moves: [Vector, Vector];
}

/**
 * The derivatives of a center of mass with respect to each of its points, with the other points
 * fixed. `center` is the center of mass of the points with these weights; it and all points lie
 * inside faces. The log vector of a point changes as the point moves, and the Hessian of the energy
 * determines how far the center follows. The change of the log vector is computed as a central
 * difference. If the path to the point only crosses edges, the change is the move of the point,
 * transported to the center.
 *
 * They are derivatives on the polyhedron, as those of `weightDerivatives`. On a plane, the center
 * moves by the move of the point times the point's fraction of the weights.
 *
 * @throws {KarcherError} badArgument for a point on an edge or at a vertex, and where the Hessian
 *   is not positive definite; otherwise as `energyAt`.
 * @example
 * ```ts
 * const [{ axes, moves }] = await pointDerivatives(mesh, points, weights, center.point);
 * ```
 */
export async function pointDerivatives(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: ArrayLike<number>,
  center: PointLike,
): Promise<PointDerivative[]> {
  const moveOf = await pulled(mesh, points, weights, center);
  const faces = await Promise.all(points.map((point) => faceOf(mesh, point)));
  const changes = await Promise.all(
    [0, 1].map(async (k) => {
      const [before, after] = await Promise.all(
        [-1, 1].map((side) => {
          const moved = faces.map((face) => face.moved(face.axes[k]!, side * face.step));
          return mesh.logMap(center, moved);
        }),
      );
      return faces.map(({ step }, i) => {
        const change = subtract(vectorAt(after!.vectors, i), vectorAt(before!.vectors, i));
        return change.map((x) => x / (2 * step)) as Vector;
      });
    }),
  );
  return faces.map(({ axes }, i) => {
    const moves = changes.map((change) => moveOf(change[i]!, weights[i]!));
    return { axes, moves: moves as [Vector, Vector] };
  });
}

/**
 * A function that returns how far a center of mass moves if the weighted sum of the log vectors
 * changes by `weight` times `pull`.
 */
async function pulled(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: ArrayLike<number>,
  center: PointLike,
): Promise<(pull: Vector, weight: number) => Vector> {
  const { axes, matrix } = await hessianAt(mesh, points, weights, center);
  const [xx, xy, yy] = matrix;
  const determinant = xx * yy - xy ** 2;
  if (!(determinant > 0 && xx > 0)) {
    throw new KarcherError(
      'badArgument',
      'the point is no minimum: the Hessian is indefinite there',
    );
  }
  return (pull, weight) => {
    const [x, y] = axes.map((axis) => 2 * weight * dot(pull, axis)) as [number, number];
    const along = (yy * x - xy * y) / determinant;
    const across = (xx * y - xy * x) / determinant;
    return [0, 1, 2].map((k) => along * axes[0][k]! + across * axes[1][k]!) as Vector;
  };
}

const unit = (a: Vector): Vector => a.map((x) => x / Math.hypot(...a)) as Vector;

/**
 * The face of a point: two axes, a step for differences, and a function for points near the point.
 */
async function faceOf(mesh: AnyMesh, at: PointLike) {
  const inside = 'face' in at && Math.min(...at.bary) > 1e-9;
  if (!inside) {
    throw new KarcherError('badArgument', 'the energy has derivatives inside faces only');
  }
  const { face, bary } = at;
  const [a, b, c] = await Promise.all(
    [0, 1, 2].map((corner) =>
      mesh.position({ face, bary: [0, 1, 2].map((k) => +(k === corner)) as Vector }),
    ),
  );
  const [ab, ac] = [subtract(b!, a!), subtract(c!, a!)];
  const along = unit(ab);
  const height = dot(ac, along);
  const across = unit(ac.map((x, k) => x - height * along[k]!) as Vector);
  // The gradients of the weights of corners b and c with respect to places.
  const toC = 1 / dot(ac, across);
  const toB = 1 / dot(ab, along);
  const change = (axis: Vector, length: number): Vector => {
    const third = length * dot(axis, across) * toC;
    const second = length * dot(axis, along) * toB - third * height * toB;
    return [-second - third, second, third];
  };
  // The step stays within the face, and is so short that paths seldom change on the way.
  const reach = Math.min(
    ...[along, across].flatMap((axis) =>
      change(axis, 1).map((slope, k) => bary[k]! / Math.max(Math.abs(slope), Number.MIN_VALUE)),
    ),
  );
  return {
    axes: [along, across] as [Vector, Vector],
    step: Math.min(reach / 2, 1e-3 * Math.hypot(...ab)),
    moved: (axis: Vector, length: number): PointLike => {
      const moves = change(axis, length);
      return { face, bary: bary.map((weight, k) => weight + moves[k]!) as Vector };
    },
  };
}
