import type { Mesh, PointLike } from 'karcher';
import type { Task } from './task';

const triangles = 500;
const rounds = 3;

/**
 * The result of work with a panel's points, and its milliseconds. Like methods, the work first runs
 * on a small mesh (`warm` of karcher/peers).
 */
export function timed<Result>(
  { peers, scene, points }: Task,
  radius: number,
  work: (mesh: Mesh, from: PointLike, to: PointLike, radius: number) => Result,
): [Result, number] {
  const small = peers.karcher.shape('sphere', triangles);
  for (let round = 0; round < rounds; round++) work(small, { vertex: 0 }, { vertex: 9 }, 0.5);
  small.dispose();
  const start = performance.now();
  const result = work(scene.mesh, points[0]!, points[1]!, radius);
  return [result, performance.now() - start];
}
