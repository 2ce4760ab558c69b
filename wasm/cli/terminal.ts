import type { Writable } from 'node:stream';
import { printable } from './output.js';

const clearLine = '\r\u001b[K';

/** Standard error: sentences, and on a terminal one line that says how far a mesh is read. */
export class Terminal {
  readonly #stream: Writable;
  readonly #isTerminal: boolean;
  #shown = '';

  constructor(stream: Writable) {
    this.#stream = stream;
    this.#isTerminal = (stream as { isTTY?: boolean }).isTTY === true;
  }

  tell(sentence: string): void {
    this.clear();
    this.#stream.write(`karcher: ${printable(sentence)}\n`);
  }

  /** Takes the place of what was shown before; nothing where standard error is no terminal. */
  show(done: number, stage: string): void {
    const text = `${stage}, ${Math.floor(100 * done)} %`;
    if (!this.#isTerminal || text === this.#shown) return;
    this.#shown = text;
    this.#stream.write(`${clearLine}${printable(text)}`);
  }

  clear(): void {
    if (this.#shown !== '') this.#stream.write(clearLine);
    this.#shown = '';
  }
}
