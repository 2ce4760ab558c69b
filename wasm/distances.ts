/**
 * Distances on a mesh, and the lines at a distance: circles, ellipses, isolines, offsets. `Mesh`
 * documents them.
 */
import {
  badArgument,
  checkArray,
  checkNumber,
  checkOneOf,
  checkOptions,
  toVector,
} from './check.js';
import type { MeshHandle } from './engine.js';
import { KarcherError } from './errors.js';
import type { EngineCircle } from './karcher-engine.mjs';
import {
  checkRadius,
  circleOptionNames,
  cornerShapes,
  distanceOptionNames,
  ellipseOptionNames,
  engineArcs,
  engineFieldOptions,
  isolineOptionNames,
  offsetOptionNames,
  offsetSides,
} from './options.js';
import { Path } from './path.js';
import type { Circle, Ellipse, Outline } from './path_types.js';
import { wirePoint, wirePoints, wirePointsOrArrays } from './points.js';
import { wireOutlines } from './region.js';
import { checkDistancesFit } from './room.js';
import type {
  CircleOptions,
  DistanceOptions,
  EllipseOptions,
  IsolineOptions,
  OffsetOptions,
  PointArrays,
  PointLike,
  RadiusOptions,
} from './types.js';
import { CurveView } from './view.js';

/** Distances to all vertices of a mesh. `vertices` is their number. */
export function distance(
  mesh: MeshHandle,
  vertices: number,
  from: PointLike | readonly PointLike[],
  options: DistanceOptions & RadiusOptions,
): Float64Array {
  checkOptions(options, distanceOptionNames);
  const radius = checkRadius(options);
  const wire = Array.isArray(from) ? wirePoints(from) : wirePoint(from as PointLike);
  if (wire.length === 0) {
    throw new KarcherError('tooFewPoints', 'distances are from at least one point');
  }
  const field = engineFieldOptions({ ...options, solver: options.solver ?? 'exact' });
  checkDistancesFit(vertices, mesh.engine.allocatedBytes);
  return mesh.call((target) => target.distance(wire, field, radius));
}

export function distanceFromPaths(
  mesh: MeshHandle,
  paths: readonly Outline[],
  points: readonly PointLike[] | PointArrays,
): Float64Array {
  const outlines = wireOutlines(paths);
  const places = wirePointsOrArrays(points);
  return mesh.call((target) => target.distanceFromPaths(outlines, places));
}

export function shortestPath(mesh: MeshHandle, from: PointLike, to: PointLike): Path {
  const wireFrom = wirePoint(from, 'the first point');
  const wireTo = wirePoint(to, 'the second point');
  return new Path(mesh.call((target) => target.shortestPath(wireFrom, wireTo)));
}

export function circle(mesh: MeshHandle, center: PointLike, options: CircleOptions): Circle {
  checkOptions(options, circleOptionNames);
  const wire = wirePoint(center, 'the center');
  const radius = checkNumber(options.radius, 'the radius');
  const tolerance = checkNumber(options.tolerance ?? 1e-3, 'the tolerance');
  const arcs = engineArcs(options);
  return toCircle(
    mesh,
    mesh.call((target) => target.circle(wire, radius, ...arcs, tolerance)),
  );
}

export function ellipse(mesh: MeshHandle, center: PointLike, options: EllipseOptions): Ellipse {
  checkOptions(options, ellipseOptionNames);
  const wire = wirePoint(center, 'the center');
  const radii = checkArray(options.radii, 'the radii').map((radius, i) =>
    checkNumber(radius, `radius ${i}`),
  );
  if (radii.length !== 2) throw badArgument('an ellipse takes two radii');
  const [along, across] = radii as [number, number];
  const direction = toVector(options.direction, 'the direction');
  const arcs = engineArcs(options);
  return toCircle(
    mesh,
    mesh.call((target) => target.ellipse(wire, along, across, direction, ...arcs)),
  );
}

export function isolines(mesh: MeshHandle, center: PointLike, options: IsolineOptions): Path[] {
  checkOptions(options, isolineOptionNames);
  const wire = wirePoint(center, 'the center');
  const radius = checkNumber(options.radius, 'the radius');
  const type = checkOneOf(options.type ?? 'exact', ['exact', 'linear'], 'the type of isolines');
  for (const name of ['solver', 'rings'] as const) {
    if (type === 'linear' || options[name] === undefined) continue;
    throw badArgument(
      `isolines of the type 'exact' take no ${name}; those of the type 'linear' do`,
    );
  }
  const { solver = 'exact', rings } = options;
  const field = engineFieldOptions({ solver, rings });
  return mesh
    .call((target) => target.isolines(wire, radius, type === 'exact', field))
    .map((line) => new Path(line));
}

export function offset(
  mesh: MeshHandle,
  paths: readonly Outline[],
  options: OffsetOptions,
): Path[] {
  checkOptions(options, offsetOptionNames);
  const outlines = wireOutlines(paths);
  const given: unknown = options.distance;
  const distances = Float64Array.from(
    Array.isArray(given) ? checkArray(given, 'the distances') : [given],
    (distance) => checkNumber(distance, 'the distance'),
  );
  const side = checkOneOf(options.side ?? 'both', offsetSides, 'the side');
  const shape = checkOneOf(options.corners ?? 'round', cornerShapes, 'the corners');
  const corners = cornerShapes.indexOf(shape);
  const miterLimit = checkNumber(options.miterLimit ?? 4, 'the miterLimit');
  return mesh
    .call((target) =>
      target.offset(outlines, distances, offsetSides.indexOf(side) - 1, corners, miterLimit),
    )
    .map((line) => new Path(line));
}

function toCircle({ engine }: MeshHandle, made: EngineCircle): Circle {
  const view = new CurveView({ bytes: made.view, statusNames: engine.statusNames });
  const { samples, bridged, unconverged, levels } = view;
  const { deviation } = made;
  const notShortest = [...made.notShortest];
  return { samples, bridged, path: view.path(), unconverged, levels, notShortest, deviation };
}
