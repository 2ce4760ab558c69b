// Workers that end with the test that started them, even if it fails: Node waits for running ones.
import { loadInWorker } from 'karcher/worker';

/**
 * Loads the library in a worker, and disposes of it at the end of `test` (the context that Node
 * passes).
 */
export async function loadForTest(test, options) {
  const karcher = await loadInWorker(options);
  test.after(() => karcher.dispose());
  return karcher;
}
