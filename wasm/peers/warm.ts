import type { PointLike } from '../types.js';
import type { Peers } from './peers.js';
import type { MethodOptions } from './types.js';

const triangles = 500;
const rounds = 3;
const samples = 17;
/** The number of landmarks, which suffices to run all the code of an embedding. */
const landmarks = 50;

const warmed = new WeakMap<Peers, Map<string, Promise<void>>>();

/**
 * Runs a method on a small mesh before its first measurement. Browsers compile the method's part of
 * the WebAssembly module on first use. This takes longer than the method itself takes on thousands
 * of triangles.
 */
export function warm(peers: Peers, options: MethodOptions): Promise<void> {
  const done = warmed.get(peers) ?? new Map<string, Promise<void>>();
  warmed.set(peers, done);
  const key = JSON.stringify(options);
  const ready = done.get(key) ?? run(peers, options);
  done.set(key, ready);
  return ready;
}

async function run(peers: Peers, options: MethodOptions): Promise<void> {
  const few = options.method === 'weightedAverages' ? { landmarks } : {};
  for (let round = 0; round < rounds; round++) {
    const mesh = peers.karcher.shape('sphere', triangles);
    const method = await peers.prepare(mesh, { ...options, ...few });
    const [a, b] = mesh.triangles();
    const inside = (face: number): PointLike => ({ face, bary: [0.5, 0.25, 0.25] });
    const points: PointLike[] = [{ vertex: a! }, inside(8), { vertex: b! }, inside(16)];
    if (options.method === 'descent') points.length = 2;
    const curve = method.curve(peers.plan(points, samples));
    await curve.trace();
    curve.dispose();
    method.dispose();
    mesh.dispose();
  }
}
