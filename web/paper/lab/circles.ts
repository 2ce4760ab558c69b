import type { CurveSamples, Path, SurfacePoint } from 'karcher';
import { isThere, vectors } from 'karcher/peers';
import type { LineId, LineResult, Vector } from '../figures/types';
import { emptyLine } from './empty_line';
import { alongPolyline, middle } from './nearest';
import type { Scene } from './scene';
import type { Task } from './task';
import { timed } from './timed';

const { add, at, cross, distance, dot } = vectors;

/**
 * This file draws the circle around the first point through the second, as rational arcs and as
 * isolines.
 */

const median = (values: readonly number[]) =>
  values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)]!;

const radiusOf = ({ scene, points }: Task) =>
  scene.mesh.shortestPath(points[0]!, points[1]!).length;

/** How far the points' exact distances from the center differ from the radius, in mean edges. */
function deviationOf(
  { scene, points }: Task,
  radius: number,
  on: readonly SurfacePoint[],
): LineResult['deviation'] {
  const errors = on.map(
    (point) =>
      Math.abs(scene.mesh.shortestPath(points[0]!, point).length - radius) /
      scene.mesh.info.meanEdge,
  );
  return { median: median(errors), max: Math.max(...errors), samples: errors.length };
}

const placesOf = (polyline: ArrayLike<number>): Vector[] =>
  Array.from({ length: polyline.length / 3 }, (_, i) => at(polyline, i));

/** Twice the vector area that a closed line encloses. */
const areaOf = (places: readonly Vector[]) =>
  places
    .slice(1)
    .reduce((sum, place, i) => add(sum, cross(places[i]!, place)), [0, 0, 0] as Vector);

/** The number of samples along a closed line that measure its turning. */
const turns = 128;

/** Samples of a closed line, evenly spaced, from its point nearest to `start`. */
function loopSamples(scene: Scene, line: readonly Vector[], start: Vector): CurveSamples {
  const ring = line.slice(1);
  const away = ring.map((place) => distance(place, start));
  const first = away.indexOf(Math.min(...away));
  const turned = [...ring.slice(first), ...ring.slice(0, first + 1)].flat();
  const t = Float64Array.from({ length: turns }, (_, i) => i / turns);
  const places = [...t].map((part) => alongPolyline(turned, part));
  const points = places.map((place) => scene.nearest.point(place));
  return {
    count: turns,
    segment: new Int32Array(turns),
    t,
    face: Int32Array.from(points, ({ face }) => face),
    bary: Float64Array.from(points.flatMap(({ bary }) => bary)),
    position: Float64Array.from(places.flat()),
    status: points.map(() => 'converged'),
  };
}

/**
 * The turning noise of a closed line, measured against the exact isoline. Null unless the line and
 * the exact isoline are a single loop each.
 */
function turningNoiseOf(
  { scene, points, places }: Task,
  radius: number,
  lines: readonly ArrayLike<number>[],
): number | null {
  const exact: Path[] = scene.mesh.isolines(points[0]!, { radius });
  if (lines.length !== 1 || exact.length !== 1 || !exact[0]!.closed) return null;
  const [line, truth] = [placesOf(lines[0]!), placesOf(exact[0]!.polyline({ bits: 64 }))];
  const same = dot(areaOf(line), areaOf(truth)) > 0;
  const samples = (loop: readonly Vector[]) => loopSamples(scene, loop, places[1]!);
  const measured = samples(same ? line : line.toReversed());
  return scene.meter.measure(measured, samples(truth)).turningNoise;
}

/** A circle of rational quadratic arcs. At level 0 a sample is a center of mass of three points. */
function arcsAt(task: Task, id: LineId, levels: 0 | 'auto'): LineResult {
  const radius = radiusOf(task);
  const arcs = task.curve.kind === 'circle' ? task.curve.arcs : 7;
  const [circle, traceMs] = timed(task, radius, (mesh, center, _, radius) =>
    mesh.circle(center, { radius, arcs, samples: 16, levels }),
  );
  const { count, face, bary, status } = circle.samples;
  const on = Array.from({ length: count }, (_, i) => ({ face: face[i]!, bary: at(bary, i) }));
  return {
    ...emptyLine(id),
    traceMs,
    samples: count,
    lost: status.filter((name) => !isThere(name)).length,
    deviation: deviationOf(task, radius, on),
    turningNoise: turningNoiseOf(task, radius, [circle.path.polyline({ bits: 64 })]),
    polylines: [circle.path.polyline()],
  };
}

/** The arcs without levels: each point is a center of mass of its arc's three points. */
export const circleArcs = (task: Task, id: LineId): LineResult => arcsAt(task, id, 0);

/** The arcs with as many levels as our default takes. */
export const circleDefault = (task: Task, id: LineId): LineResult => arcsAt(task, id, 'auto');

/** The isolines of the distance from the first point. */
function isolines(task: Task, id: LineId, type: 'exact' | 'linear'): LineResult {
  const { nearest } = task.scene;
  const radius = radiusOf(task);
  const [lines, traceMs] = timed(task, radius, (mesh, center, _, radius) =>
    mesh.isolines(center, { radius, type }),
  );
  if (lines.length === 0) return { ...emptyLine(id), ok: false, reason: 'no face is crossed' };
  const polylines = lines.map((line) => line.polyline({ bits: 64 }));
  const on = polylines.flatMap((polyline) => {
    const places = placesOf(polyline);
    // The chords of a linear isoline lie on it, so their middles count, too. An exact isoline bends
    // away from its chords.
    const between = places.slice(1).map((place, i) => middle([places[i]!, place]));
    return [...places, ...(type === 'linear' ? between : [])].map((place) => nearest.point(place));
  });
  return {
    ...emptyLine(id),
    traceMs,
    deviation: deviationOf(task, radius, on),
    turningNoise: turningNoiseOf(task, radius, polylines),
    polylines: lines.map((line) => line.polyline()),
  };
}

/** The isoline of distances that are exact at the vertices and linear in each face. */
export const isolineLinear = (task: Task, id: LineId): LineResult => isolines(task, id, 'linear');

/** The points whose distance is the radius: circular arcs in each face. */
export const isolineExact = (task: Task, id: LineId): LineResult => isolines(task, id, 'exact');
