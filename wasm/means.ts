/**
 * Centers of mass on a mesh, and weights for which a point is the center of mass. `Mesh` documents
 * them.
 */
import { badArgument, checkArray, checkBoolean, checkOptions, toFloat64 } from './check.js';
import { numbersOrNone } from './curve_options.js';
import type { MeshHandle } from './engine.js';
import { KarcherError } from './errors.js';
import type { EngineMean } from './karcher-engine.mjs';
import {
  centerOptionNames,
  centersOptionNames,
  engineFieldOptions,
  startOptionNames,
  weightsOptionNames,
} from './options.js';
import { toPointArrays, toSurfacePoint, wirePoint, wirePoints } from './points.js';
import type {
  CenterOfMass,
  CenterOptions,
  CentersOfMass,
  CentersOptions,
  MeanWeights,
  PointLike,
  StartOptions,
  WeightsOptions,
} from './types.js';

export function centerOfMass(
  mesh: MeshHandle,
  points: readonly PointLike[],
  weights: ArrayLike<number>,
  options: CenterOptions,
): CenterOfMass {
  checkOptions(options, centerOptionNames);
  const places = wirePoints(points);
  const masses = toFloat64(weights, 'the weights');
  const start = wireStart(options);
  const field = engineFieldOptions(options);
  const normalize = checkBoolean(options.normalize ?? false, 'normalize');
  const looks = checkBoolean(options.uniqueness ?? false, 'uniqueness');
  const certifies = checkBoolean(options.certificate ?? false, 'certificate');
  return toCenterOfMass(
    mesh.call((target) =>
      target.centerOfMass(places, masses, start, normalize, looks, certifies, field),
    ),
  );
}

export function centersOfMass(
  mesh: MeshHandle,
  points: readonly PointLike[],
  rows: ArrayLike<number> | readonly ArrayLike<number>[],
  options: CentersOptions,
): CentersOfMass {
  checkOptions(options, centersOptionNames);
  const places = wirePoints(points);
  const weights = toRows(rows, points.length);
  const start = wireStart(options);
  const field = engineFieldOptions(options);
  const normalize = checkBoolean(options.normalize ?? false, 'normalize');
  const checks = checkBoolean(options.check ?? false, 'check');
  const { point, ...centers } = mesh.call((target) =>
    target.centersOfMass(places, weights, start, normalize, checks, field),
  );
  return { count: point.length / 4, ...toPointArrays(point), ...centers };
}

export function weightsOf(
  mesh: MeshHandle,
  point: PointLike,
  points: readonly PointLike[],
  options: WeightsOptions,
): MeanWeights {
  checkOptions(options, weightsOptionNames);
  const place = wirePoint(point);
  const places = wirePoints(points);
  const given = numbersOrNone(options.weights, 'the given weights');
  const nonNegative = checkBoolean(options.nonNegative ?? false, 'nonNegative');
  const field = engineFieldOptions(options);
  return mesh.call((target) => target.weightsOf(place, places, given, nonNegative, field));
}

export function centerOfMassOfDistances(
  mesh: MeshHandle,
  distances: readonly ArrayLike<number>[],
  weights: ArrayLike<number>,
  options: StartOptions,
): CenterOfMass {
  checkOptions(options, startOptionNames);
  const vertices = mesh.call((target) => target.inputVertices());
  const arrays = checkArray(distances, 'the distances');
  const all = rowsInOne(
    arrays,
    vertices,
    (i) => `array ${i} of the distances`,
    (i, count) =>
      badArgument(`array ${i} must hold a distance a vertex: ${vertices}, not ${count}`),
  );
  const masses = toFloat64(weights, 'the weights');
  const start = wireStart(options);
  const normalize = checkBoolean(options.normalize ?? false, 'normalize');
  return toCenterOfMass(
    mesh.call((target) => target.centerOfMassOfDistances(all, masses, start, normalize)),
  );
}

/** The start of a search in the engine's form: empty for the engine's choice. */
const wireStart = ({ start }: StartOptions): Float64Array =>
  start === undefined ? new Float64Array() : wirePoint(start, 'the start');

/** Rows of weights one after the other. */
function toRows(rows: unknown, width: number): Float64Array {
  if (!Array.isArray(rows) || typeof rows[0] !== 'object') return toFloat64(rows, 'the weights');
  return rowsInOne(
    rows,
    width,
    (i) => `row ${i} of the weights`,
    (i, count) =>
      new KarcherError('badWeights', `row ${i}: there are ${width} points but ${count} weights`),
  );
}

/**
 * Rows of equal length in one array, one after the other. `named` returns the name of a row for
 * errors, and `wrong` the error for a row of another length.
 */
function rowsInOne(
  rows: readonly unknown[],
  width: number,
  named: (i: number) => string,
  wrong: (i: number, count: number) => KarcherError,
): Float64Array {
  const all = new Float64Array(width * rows.length);
  for (let i = 0; i < rows.length; i++) {
    const row = toFloat64(rows[i], named(i));
    if (row.length !== width) throw wrong(i, row.length);
    all.set(row, width * i);
  }
  return all;
}

function toCenterOfMass(mean: EngineMean): CenterOfMass {
  const others = mean.otherMinima.map((other) => ({
    ...other,
    point: toSurfacePoint(other.point),
  }));
  const otherMinima = mean.uniqueness === 'notLooked' ? 'notLooked' : others;
  return { ...mean, point: toSurfacePoint(mean.point), otherMinima };
}
