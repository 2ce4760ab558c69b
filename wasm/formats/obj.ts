import { Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { isLineEnd, lineEndAt } from './text.js';
import type { FilePart } from './types.js';

const [tab, space, hash, backslash] = [9, 32, 35, 92];
const [letterF, letterG, letterO] = [102, 103, 111];

/**
 * The parts of an OBJ file, as its lines `o` and `g` begin them, and the file without the faces of those
 * that are not wanted; the engine reads it. A name that comes again goes on with its part.
 */
export async function objParts(
  bytes: Uint8Array,
  wanted: ((part: number) => boolean) | null,
  work: LongWorkOptions,
): Promise<{ parts: FilePart[]; bytes: Uint8Array }> {
  const slices = new Slices(work, 'reading');
  const parts: FilePart[] = [];
  const numbers = new Map<string, number>();
  const named = { o: '', g: '' };
  let current = -1;
  let kept: Uint8Array | null = null;
  const line = new ObjLine(bytes);
  for (let lines = 0; line.next < bytes.length; ) {
    if ((++lines & 0xffff) === 0 && slices.over) await slices.rest(line.next / bytes.length);
    line.take();
    const { keyword, from, end } = line;
    if (keyword === letterO || keyword === letterG) {
      const text = new TextDecoder().decode(bytes.subarray(from + 1, Math.min(end, from + 200)));
      const name = text.trim();
      if (keyword === letterO) Object.assign(named, { o: name, g: '' });
      else named.g = name;
      current = -1;
    } else if (keyword === letterF) {
      if (current < 0) current = numberOf([named.o, named.g].filter(Boolean).join(', '));
      // Corners beside the keyword.
      parts[current]!.triangles += Math.max(0, line.words - 3);
      if (wanted && !wanted(current)) {
        kept ??= bytes.slice();
        // Lines stay lines: later ones keep their numbers.
        for (let at = from; at < end; at++) if (!isLineEnd(kept[at])) kept[at] = space;
      }
    }
  }
  return { parts, bytes: kept ?? bytes };

  function numberOf(name: string): number {
    let number = numbers.get(name);
    if (number === undefined) {
      number = parts.length;
      numbers.set(name, number);
      parts.push({ name: name || 'mesh', triangles: 0 });
    }
    return number;
  }
}

/** Lines of an OBJ file, one after the other, each with those that it goes on with after a backslash. */
class ObjLine {
  readonly #bytes: Uint8Array;
  /** Where its first word begins. */
  from = 0;
  /** Where it ends, or its comment begins. */
  end = 0;
  /** Where the next one begins. */
  next = 0;
  words = 0;
  /** The first word, if that is one byte; else 0. */
  keyword = 0;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  /** Goes on to the next line. As the engine, takes a # inside of a word for a part of it. */
  take(): void {
    const bytes = this.#bytes;
    const { length } = bytes;
    let at = this.next;
    let words = 0;
    let inWord = false;
    this.from = at;
    this.keyword = 0;
    for (; at < length; at++) {
      const byte = bytes[at]!;
      if (byte === space || byte === tab) {
        inWord = false;
        continue;
      }
      if (byte <= backslash) {
        if (isLineEnd(byte) || (byte === hash && !inWord)) break;
        const goesOn = byte === backslash ? lineEndAt(bytes, at + 1) : 0;
        if (goesOn > 0) {
          inWord = false;
          at += goesOn;
          continue;
        }
      }
      if (inWord) continue;
      inWord = true;
      if (++words > 1) continue;
      this.from = at;
      if (isGap(bytes, at + 1)) this.keyword = byte;
    }
    this.end = at;
    this.words = words;
    while (at < length && !isLineEnd(bytes[at])) at++;
    this.next = at + lineEndAt(bytes, at);
  }
}

/** Whether a word ends there. */
function isGap(bytes: Uint8Array, at: number): boolean {
  const byte = bytes[at];
  if (byte === undefined || byte === space || byte === tab || isLineEnd(byte)) return true;
  return byte === backslash && lineEndAt(bytes, at + 1) > 0;
}
