import { type Engine, Handle } from './engine.js';
import type { EngineMesh } from './karcher-engine.mjs';
import type { LongWorkOptions } from './types.js';

/** How long a slice may keep the thread busy, in milliseconds. */
export const sliceTime = 8;
/** Vertices between two looks at the clock. */
const batch = 32;

/** Lets the thread do what waits: messages, drawing. */
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

/** Builds a mesh's k-ring graph in slices, unless it has one: the milliseconds of work. */
export async function prepareGraph(
  engine: Engine,
  mesh: Handle<EngineMesh>,
  rings: number,
  { progress, signal }: LongWorkOptions,
): Promise<number> {
  if (mesh.call((target) => target.hasRingGraph(rings))) return 0;
  const start = performance.now();
  const builder = new Handle(
    engine,
    'the graph',
    mesh.call((target) => target.graphBuilder(rings)),
    mesh,
  );
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
      progress?.(
        builder.call((target) => target.progress()),
        'graph',
      );
      if (!done) await pause();
    }
  } finally {
    builder.dispose();
  }
  return worked;
}
