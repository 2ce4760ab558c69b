import type { Writable } from 'node:stream';
import { printable } from './output.js';

const clearLine = '\r\u001b[K';

/**
 * The output on standard error: sentences and, if it is a terminal, one line with the progress of
 * reading a mesh.
 */
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

  /** If standard error is a terminal, shows this progress in place of the last one. */
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
