import type { LongWorkOptions, MeshInfo } from 'karcher';
import type { CheckUp } from 'karcher/checkup';
import { WorkerClient } from 'karcher/own-worker';

/** Looks a surface over in a worker of its own. */
export async function checkedUp(
  mesh: { info: Readonly<MeshInfo>; positions: Float64Array; triangles: Int32Array },
  work: LongWorkOptions,
): Promise<CheckUp> {
  const worker = new WorkerClient(
    new Worker(new URL('./checkup_worker.ts', import.meta.url), { type: 'module' }),
  );
  try {
    return (await worker.call('checkUp', [
      mesh.info,
      mesh.positions,
      mesh.triangles,
      work,
    ])) as CheckUp;
  } finally {
    worker.dispose();
  }
}
