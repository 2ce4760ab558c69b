// The engine in a worker, in Node and in a page: progress, a cancelled call, and the end of the
// worker.
import { loadInWorker } from 'karcher/worker';

const karcher = await loadInWorker();
const mesh = await karcher.shape('knot', 20_000);

await mesh.prepare(
  { solver: 'graph', rings: 2 },
  { progress: (done, stage) => done === 1 && console.log(`${stage}: done`) },
);

const controller = new AbortController();
const call = mesh.distance({ vertex: 0 }, {}, { signal: controller.signal });
controller.abort(new Error('not wanted any more'));
await call.catch((reason) => console.log(`given up: ${reason.message}`));

const curve = await mesh.curve({
  kind: 'bezier',
  points: [{ vertex: 0 }, { vertex: 50 }, { vertex: 99 }],
});
console.log(`length ${(await curve.length).toFixed(3)}`);
karcher.dispose();
