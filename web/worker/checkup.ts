import type { LongWorkOptions } from 'karcher';
import { WorkerClient } from 'karcher/own-worker';
import type { CheckedSurface, CheckedUp } from '../model/checked_up';

/** Checks a surface in a worker of its own. */
export async function checkedUp(
  { info, arrays, mesh }: CheckedSurface,
  work: LongWorkOptions,
): Promise<CheckedUp> {
  const worker = new WorkerClient(
    new Worker(new URL('./checkup_worker.ts', import.meta.url), { type: 'module' }),
  );
  try {
    return (await worker.call('checkUp', [info, arrays, await mesh.kept(), work])) as CheckedUp;
  } finally {
    worker.dispose();
  }
}
