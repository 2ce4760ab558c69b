import type { SurfacePoint } from 'karcher';
import type { LineId, LineResult, Vector } from '../figures/types';
import { emptyLine, type Task } from './task';
import { at, cross, length, scaled, subtract } from './vectors';

/** Three ways to a circle about the first point, through the second. */

const rays = 720;

const median = (values: readonly number[]) =>
  values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)]!;

const radiusOf = ({ scene, points }: Task) =>
  scene.mesh.shortestPath(points[0]!, points[1]!).length;

/** How far points are from the radius, in mean edges, by exact shortest paths. */
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
  return { median: median(errors), max: Math.max(...errors) };
}

/** Rational quadratic arcs, each a center of mass of three points. */
export function circleArcs(task: Task, id: LineId): LineResult {
  const radius = radiusOf(task);
  const arcs = task.curve.kind === 'circle' ? task.curve.arcs : 7;
  const start = performance.now();
  const circle = task.scene.mesh.circle({ center: task.points[0]!, radius, arcs, samples: 16 });
  const traceMs = performance.now() - start;
  const { count, face, bary, status } = circle.samples;
  const on = Array.from({ length: count }, (_, i) => ({ face: face[i]!, bary: at(bary, i) }));
  return {
    ...emptyLine(id),
    traceMs,
    samples: count,
    lost: status.filter((name) => name !== 'converged').length,
    deviation: deviationOf(task, radius, on),
    polylines: [circle.polyline],
  };
}

/** The isoline of exact distances at the vertices, linear in each face. */
export function isolineLinear(task: Task, id: LineId): LineResult {
  const { scene, points } = task;
  const radius = radiusOf(task);
  const start = performance.now();
  const distances = scene.mesh.distance(points[0]!);
  const polylines: Float32Array[] = [];
  const on: SurfacePoint[] = [];
  for (let face = 0; face < scene.triangles.length / 3; face++) {
    const corners = [0, 1, 2].map((k) => scene.triangles[3 * face + k]!);
    const crossings: { place: Vector; bary: Vector }[] = [];
    for (let k = 0; k < 3; k++) {
      const next = (k + 1) % 3;
      const [from, to] = [distances[corners[k]!]! - radius, distances[corners[next]!]! - radius];
      if (from < 0 === to < 0) continue;
      const s = from / (from - to);
      const bary: Vector = [0, 0, 0];
      bary[k] = 1 - s;
      bary[next] = s;
      const [a, b] = [at(scene.positions, corners[k]!), at(scene.positions, corners[next]!)];
      crossings.push({ bary, place: [0, 1, 2].map((c) => a[c]! + s * (b[c]! - a[c]!)) as Vector });
    }
    if (crossings.length !== 2) continue;
    polylines.push(Float32Array.from([...crossings[0]!.place, ...crossings[1]!.place]));
    const [first, second] = crossings.map(({ bary }) => bary) as [Vector, Vector];
    // Between its ends an isoline bends and its chord does not.
    const middle = first.map((weight, k) => (weight + second[k]!) / 2) as Vector;
    on.push({ face, bary: first }, { face, bary: middle });
  }
  const traceMs = performance.now() - start;
  if (on.length === 0) return { ...emptyLine(id), ok: false, reason: 'no face is crossed' };
  return { ...emptyLine(id), traceMs, polylines, deviation: deviationOf(task, radius, on) };
}

/** The ends of straightest geodesics in all directions, where these are the shortest ways. */
export function isolineExact(task: Task, id: LineId): LineResult {
  const { scene, points } = task;
  const radius = radiusOf(task);
  const center = points[0]!;
  const corner = (k: number) => at(scene.positions, scene.triangles[3 * center.face + k]!);
  const x = subtract(corner(1), corner(0));
  const normal = cross(x, subtract(corner(2), corner(0)));
  const y = scaled(cross(normal, x), 1 / length(normal));
  const ends: number[] = [];
  const tolerance = 1e-6 * scene.mesh.info.meanEdge;
  const polylines: Float32Array[] = [];
  const close = () => {
    if (ends.length > 3) polylines.push(Float32Array.from(ends));
    ends.length = 0;
  };
  for (let i = 0; i <= rays; i++) {
    const angle = (2 * Math.PI * i) / rays;
    const direction = [0, 1, 2].map((c) => Math.cos(angle) * x[c]! + Math.sin(angle) * y[c]!);
    const { end, remaining } = scene.mesh.straightest(center, direction, radius);
    const shortest =
      remaining === 0 && scene.mesh.shortestPath(center, end).length > radius - tolerance;
    if (shortest) ends.push(...scene.mesh.position(end));
    else close();
  }
  close();
  return { ...emptyLine(id), polylines };
}
