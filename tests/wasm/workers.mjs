// Workers that end with the test that began them, also where it fails: Node waits for those that run.
import { loadInWorker } from 'karcher/worker';

/** `loadInWorker`, disposed of once `test` (the context that Node gives it) is over. */
export async function loadForTest(test, options) {
  const karcher = await loadInWorker(options);
  test.after(() => karcher.dispose());
  return karcher;
}
