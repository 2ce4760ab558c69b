// The page's editor, session and engine without a browser: this thread runs the worker's code.
import { load as loadEngine } from 'karcher';
import { pageModule } from './page_module.mjs';

/** The only worker, which holds one surface. */
class InThisThread {
  #hear = {};

  constructor() {
    globalThis.postMessage = (reply, transfer) => {
      const data = structuredClone(reply, { transfer });
      queueMicrotask(() => this.#hear.message?.({ data }));
    };
  }

  addEventListener(type, hear) {
    this.#hear[type] = hear;
  }

  postMessage(request) {
    const data = structuredClone(request);
    queueMicrotask(() => InThisThread.served({ data }));
  }

  terminate() {
    this.#hear = {};
  }
}

/** The positions and triangles of a built-in shape. */
export async function arraysOfShape(name, triangles) {
  const mesh = (await loadEngine()).shape(name, triangles);
  return { positions: mesh.positions(), triangles: mesh.triangles() };
}

/**
 * The page's modules, with a method that needs no second engine, on a sphere of this many triangles
 * or on a surface given as arrays.
 */
export async function openPage(surface) {
  globalThis.addEventListener = (_, hear) => {
    InThisThread.served = hear;
  };
  globalThis.Worker = InThisThread;
  await pageModule('../../web/worker/engine.ts');
  const parts = await pageModule('./page_parts.ts');
  const editor = new parts.Editor();
  const session = new parts.Session();
  const edits = new parts.CurveEdits(editor, session);
  const failures = [];
  session.onFailure = (error) => failures.push(error.message);
  editor.setMethod('karcher-fast');
  const isSphere = typeof surface === 'number';
  editor.open(isSphere ? `sphere:${surface}` : 'arrays', parts.emptyDrawing);
  const arrays = parts.blobsOf(isSphere ? await arraysOfShape('sphere', surface) : surface);
  session.use(await parts.EngineClient.load({ kind: 'arrays', arrays }));
  editor.subscribe((state, before) => {
    const ended = before.dragging && !state.dragging;
    if (state.revision !== before.revision || ended) session.update(state);
  });
  const settled = async () => {
    while (!session.settled || session.view.revision !== editor.state.revision) {
      await new Promise(setImmediate);
    }
    return session.view;
  };
  return { ...parts, editor, session, edits, failures, settled };
}
