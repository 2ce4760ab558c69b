/** The worker that measures rows of Table 1, one after the other. To cancel is to end it. */

import { loadPeers } from 'karcher/peers';
import { runTable, type TableEvents, type TableOptions } from './run';

type Named<Events> = {
  [Name in keyof Events]: Events[Name] extends (...args: infer Args) => void
    ? { event: Name; args: Args }
    : never;
}[keyof Events];

export type TableMessage =
  | Named<TableEvents>
  | { event: 'done' }
  | { event: 'failure'; message: string };

const peers = loadPeers();

const send = (message: TableMessage) => self.postMessage(message);

self.onmessage = async ({ data }: MessageEvent<TableOptions>) => {
  try {
    await runTable(await peers, data, {
      row: (...args) => send({ event: 'row', args }),
      method: (...args) => send({ event: 'method', args }),
      progress: (...args) => send({ event: 'progress', args }),
      cell: (...args) => send({ event: 'cell', args }),
    });
    send({ event: 'done' });
  } catch (error) {
    send({ event: 'failure', message: error instanceof Error ? error.message : `${error}` });
  }
};
