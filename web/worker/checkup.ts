import type { LongWorkOptions, MeshInfo } from 'karcher';
import { WorkerClient } from 'karcher/own-worker';
import type { CheckedUp } from '../model/checked_up';
import type { MeshBlobs } from '../model/mesh_blobs';

/** Checks a surface in a worker of its own. */
export async function checkedUp(
  { info, arrays }: { info: Readonly<MeshInfo>; arrays: MeshBlobs },
  work: LongWorkOptions,
): Promise<CheckedUp> {
  const worker = new WorkerClient(
    new Worker(new URL('./checkup_worker.ts', import.meta.url), { type: 'module' }),
  );
  try {
    return (await worker.call('checkUp', [info, arrays, work])) as CheckedUp;
  } finally {
    worker.dispose();
  }
}
