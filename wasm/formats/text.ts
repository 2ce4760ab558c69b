import { badFile, counted } from './failures.js';

const [newline, space, hash, carriageReturn] = [10, 32, 35, 13];
const longestWord = 200;
/** The powers of ten that are exact doubles. */
const powers = Float64Array.from({ length: 23 }, (_, power) => Number(`1e${power}`));
const decimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
/**
 * The words that C, Python and Windows print for numbers that are not finite: nan, -nan(ind), inf,
 * 1.#QNAN.
 */
const notFinite = /^[+-]?(nan|inf$|infinity$|1\.#)/i;

/** Whether a byte ends a line. Systems end lines with \n, \r\n or \r. */
export const isLineEnd = (byte: number | undefined) => byte === newline || byte === carriageReturn;

/** The length of the line end at a place, 0 to 2 bytes. */
export function lineEndAt(bytes: Uint8Array, at: number): number {
  if (bytes[at] === newline) return 1;
  if (bytes[at] !== carriageReturn) return 0;
  return bytes[at + 1] === newline ? 2 : 1;
}

/**
 * The words of a text. They are read from its bytes, one after the other, so that a text of many
 * megabytes need not become a string. A `#` that begins a word starts a comment. Inside a word it
 * is an ordinary character, as in `1.#QNAN`, which some programs write for NaN.
 */
export class Words {
  readonly #bytes: Uint8Array;
  readonly #end: number;
  /** The place where the search for the next word begins. */
  at: number;
  /** The line of the last word, from 1. */
  line: number;
  #from = 0;
  #to = 0;

  constructor(bytes: Uint8Array, at = 0, line = 1) {
    this.#bytes = bytes;
    this.#end = bytes.length;
    this.at = at;
    this.line = line;
  }

  /** Moves to the next word, on whatever line. Returns false at the end of the text. */
  next(): boolean {
    const bytes = this.#bytes;
    let at = this.at;
    for (; at < this.#end; at++) {
      const byte = bytes[at]!;
      if (byte === newline) this.line++;
      else if (byte === carriageReturn) {
        if (bytes[at + 1] !== newline) this.line++;
      } else if (byte === hash) {
        while (at + 1 < this.#end && !isLineEnd(bytes[at + 1])) at++;
      } else if (byte > space) break;
    }
    this.#from = at;
    while (at < this.#end && bytes[at]! > space) at++;
    this.#to = at;
    this.at = at;
    return this.#to > this.#from;
  }

  /** Moves to the next word of this line. Returns false at the end of the line. */
  nextInLine(): boolean {
    let at = this.at;
    while (at < this.#end && this.#bytes[at]! <= space && !isLineEnd(this.#bytes[at])) at++;
    if (at === this.#end || isLineEnd(this.#bytes[at]) || this.#bytes[at] === hash) {
      this.at = at;
      return false;
    }
    return this.next();
  }

  /** Moves to the next word if it is the given one. */
  nextIs(word: string): boolean {
    const { at, line } = this;
    if (this.next() && this.word === word) return true;
    [this.at, this.line] = [at, line];
    return false;
  }

  /**
   * Moves back by some bytes of the last word. These bytes are then read again as a separate word.
   */
  back(bytes: number): void {
    this.at -= bytes;
  }

  /** Skips the rest of the line, and returns it. */
  restOfLine(): string {
    const from = this.at;
    while (this.at < this.#end && !isLineEnd(this.#bytes[this.at])) this.at++;
    return ascii(this.#bytes, from, this.at).trim();
  }

  /** The last word. */
  get word(): string {
    return ascii(this.#bytes, this.#from, this.#to);
  }

  /** Throws `KarcherError` badFile with the line, and with what must be there. */
  fail(wanted: string): never {
    const met = this.#to > this.#from ? `not '${shortened(this.word)}'` : 'but the file ends';
    throw badFile(`line ${this.line}: there must be ${wanted}, ${met}`);
  }

  /** Skips the next word, which need not be a number. */
  skip(what: string): void {
    if (!this.next()) this.fail(what);
  }

  /** The next word as a number; NaN for a number that is not finite. */
  number(what: string): number {
    if (!this.next()) this.fail(what);
    return this.asNumber(what);
  }

  /** The last word as a number. */
  asNumber(what: string): number {
    const short = this.#shortNumber();
    if (!Number.isNaN(short)) return short;
    const text = this.word;
    if (text.length < longestWord && decimal.test(text)) return Number(text);
    if (!notFinite.test(text)) this.fail(what);
    return Number.NaN;
  }

  /** The next word as a whole number of at least 0. */
  count(what: string): number {
    this.skip(what);
    return this.asCount(what);
  }

  /** The last word as a whole number of at least 0. */
  asCount(what: string): number {
    const value = this.asNumber(what);
    if (!Number.isInteger(value) || value < 0 || value > 0x7fffffff) this.fail(what);
    return value;
  }

  /**
   * Reads a number of at most 15 digits with a small power of ten. Its digits and the power are
   * exact doubles, so that their quotient or product is the double nearest to the number. Returns
   * NaN for any other number.
   */
  #shortNumber(): number {
    const bytes = this.#bytes;
    let at = this.#from;
    const first = bytes[at];
    if (first === 43 || first === 45) at++;
    let value = 0;
    let digits = 0;
    let power = 0;
    let point = false;
    for (; at < this.#to; at++) {
      const digit = bytes[at]! - 48;
      if (digit >= 0 && digit <= 9) {
        value = 10 * value + digit;
        digits++;
        if (point) power--;
      } else if (digit === -2 && !point) point = true;
      else break;
    }
    if (digits === 0 || digits > 15) return Number.NaN;
    if (at < this.#to) {
      if ((bytes[at]! | 32) !== 101) return Number.NaN;
      at++;
      const sign = bytes[at] === 45 ? -1 : 1;
      if (bytes[at] === 43 || bytes[at] === 45) at++;
      const start = at;
      let exponent = 0;
      for (; at < this.#to; at++) {
        const digit = bytes[at]! - 48;
        if (digit < 0 || digit > 9) return Number.NaN;
        exponent = 10 * exponent + digit;
      }
      if (at === start || at > start + 3) return Number.NaN;
      power += sign * exponent;
    }
    if (power < -22 || power > 22) return Number.NaN;
    const size = power < 0 ? value / powers[-power]! : value * powers[power]!;
    return first === 45 ? -size : size;
  }
}

/**
 * The rows of a table in a text. A row may continue on further lines. If a row is one line, further
 * words after its numbers have no effect. If it spans several lines, further words after its
 * numbers are an error: the row's first line then lacks a number.
 */
export class TextRows {
  readonly words: Words;
  #inRow = false;
  /**
   * The error for a value that is missing at the end of the row's first line; null unless the row
   * continues on other lines.
   */
  #missing: string | null = null;
  /** The number of rows that have further words after their numbers. */
  longer = 0;

  constructor(words: Words) {
    this.words = words;
  }

  /** Whether the row has continued on another line. */
  get isSplit(): boolean {
    return this.#missing !== null;
  }

  /** Moves to the row's next word. */
  next(what: string): void {
    const { words } = this;
    if (this.#inRow) {
      if (words.nextInLine()) return;
      this.#missing ??= `line ${words.line} ends where there must be ${what}`;
    }
    this.#inRow = true;
    if (words.next()) return;
    throw badFile(`line ${words.line}: the file ends where there must be ${what}`);
  }

  number(what: string): number {
    this.next(what);
    return this.words.asNumber(what);
  }

  /** Begins a new row, even if the last one is incomplete. */
  restart(): void {
    this.#inRow = false;
    this.#missing = null;
  }

  end(): void {
    if (this.words.nextInLine()) {
      if (this.#missing) throw badFile(this.#missing);
      this.words.restOfLine();
      this.longer++;
    }
    this.restart();
  }
}

/** A sentence about rows that have further words after their numbers. */
export const longerRows = (rows: number, numbers: string) =>
  `Numbers beyond ${numbers} were left out, in ${counted(rows)} ${rows === 1 ? 'row' : 'rows'}.`;

const shortened = (text: string) => (text.length > 30 ? `${text.slice(0, 27)}...` : text);

/** Bytes as characters. Bytes that are not ASCII become question marks. */
export function ascii(bytes: Uint8Array, from: number, to: number): string {
  let text = '';
  for (let at = from; at < to && text.length < longestWord; at++) {
    const byte = bytes[at]!;
    text += byte >= space && byte < 127 ? String.fromCharCode(byte) : '?';
  }
  return text;
}

/** The first bytes of a file, each as a character. */
export const startOf = (bytes: Uint8Array) => String.fromCharCode(...bytes.subarray(0, 1000));
