import { checkOptions } from './check.js';
import type { MeshHandle } from './engine.js';
import { checkLongWork, engineFieldOptions, fieldOptionNames } from './options.js';
import { checkGraphFits, checkGraphGoesOn } from './room.js';
import type { FieldOptions, LongWorkOptions } from './types.js';

/** The longest time, in milliseconds, for which a slice may keep the thread busy. */
export const sliceTime = 8;
/** The number of vertices between two looks at the clock. */
const batch = 32;

/** The fraction of a graph that is built between two looks at its memory. */
const lookEvery = 0.1;

/** Lets the thread do its waiting tasks, such as messages and drawing. */
export function pause(): Promise<void> {
  if (typeof setImmediate === 'function') return new Promise((resolve) => setImmediate(resolve));
  // A timeout would take 4 ms or more in a page.
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}

/**
 * Prepares a mesh's data for fields. `triangles` is the mesh's number of triangles. `Mesh`
 * documents the function.
 */
export async function prepareFields(
  mesh: MeshHandle,
  triangles: number,
  options: FieldOptions,
  work: LongWorkOptions,
): Promise<void> {
  checkOptions(options, fieldOptionNames);
  checkLongWork(work);
  const field = engineFieldOptions(options);
  if (field.solver === 'graph') await prepareGraph(mesh, triangles, field.rings, work);
  mesh.call((target) => target.prepareFields(field));
}

/** Builds a mesh's k-ring graph in slices, unless it has one. Returns the milliseconds of work. */
export async function prepareGraph(
  mesh: MeshHandle,
  triangles: number,
  rings: number,
  { progress, signal }: LongWorkOptions,
): Promise<number> {
  if (mesh.call((target) => target.hasRingGraph(rings))) return 0;
  const inUse = mesh.engine.allocatedBytes;
  checkGraphFits(triangles, rings, inUse);
  const before = inUse();
  let looked = 0;
  const start = performance.now();
  const builder = mesh.made('the graph', (target) => target.graphBuilder(rings));
  let worked = performance.now() - start;
  try {
    for (let done = false; !done; ) {
      signal?.throwIfAborted();
      const sliceStart = performance.now();
      const end = sliceStart + sliceTime;
      // While the slices pause, the mesh may be disposed of.
      mesh.check();
      while (!done && performance.now() < end)
        done = builder.call((target) => target.advance(batch));
      worked += performance.now() - sliceStart;
      const made = builder.call((target) => target.progress());
      if (made >= looked + lookEvery) {
        looked = made;
        checkGraphGoesOn(triangles, rings, { bytes: inUse() - before, done: made }, inUse);
      }
      progress?.(made, 'graph');
      if (!done) await pause();
    }
  } finally {
    builder.dispose();
  }
  return worked;
}
