import { Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import type { FilePart, Polygons } from './types.js';

const [newline, space] = [10, 32];

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
  let lines = 0;
  for (let at = 0; at < bytes.length; ) {
    if ((++lines & 0xffff) === 0 && slices.over) await slices.rest(at / bytes.length);
    let end = bytes.indexOf(newline, at);
    if (end < 0) end = bytes.length;
    while (at < end && bytes[at]! <= space) at++;
    const letter = bytes[at];
    const isKeyword = at + 1 === end || bytes[at + 1]! <= space;
    if (isKeyword && (letter === 111 || letter === 103)) {
      const text = new TextDecoder().decode(bytes.subarray(at + 1, Math.min(end, at + 200)));
      const name = text.replace(/#.*/, '').trim();
      if (letter === 111) Object.assign(named, { o: name, g: '' });
      else named.g = name;
      current = -1;
    } else if (isKeyword && letter === 102) {
      if (current < 0) current = numberOf([named.o, named.g].filter(Boolean).join(', '));
      parts[current]!.triangles += Math.max(0, wordsIn(bytes, at + 1, end) - 2);
      if (wanted && !wanted(current)) {
        kept ??= bytes.slice();
        kept.fill(space, at, continued(bytes, end));
      }
    }
    at = end + 1;
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

/** The end of a line, or of the one that it goes on with after a backslash. */
function continued(bytes: Uint8Array, end: number): number {
  let at = end;
  while (bytes[at - 1] === 13) at--;
  return bytes[at - 1] === 92 && end < bytes.length
    ? continued(bytes, Math.max(end + 1, bytes.indexOf(newline, end + 1)))
    : end;
}

function wordsIn(bytes: Uint8Array, from: number, end: number): number {
  let words = 0;
  for (let at = from; at < end && bytes[at] !== 35; at++) {
    if (bytes[at]! > space && bytes[at - 1]! <= space) words++;
  }
  return words;
}

/** Polygons as an OBJ file, so that the engine cuts them as it cuts those of any. */
export async function objOf(polygons: Polygons, work: LongWorkOptions): Promise<Uint8Array> {
  const { positions, corners, sizes } = polygons;
  const slices = new Slices(work, 'cutting');
  const encoder = new TextEncoder();
  const chunks: Uint8Array[] = [];
  let text = '';
  const flush = async (done: number) => {
    chunks.push(encoder.encode(text));
    text = '';
    if (slices.over) await slices.rest(done);
  };
  for (let at = 0; at < positions.length; at += 3) {
    text += `v ${positions[at]} ${positions[at + 1]} ${positions[at + 2]}\n`;
    if (text.length > 1 << 16) await flush((0.5 * at) / positions.length);
  }
  let corner = 0;
  for (const [face, size] of sizes!.entries()) {
    text += 'f';
    for (const end = corner + size; corner < end; corner++) text += ` ${corners[corner]! + 1}`;
    text += '\n';
    if (text.length > 1 << 16) await flush(0.5 + (0.5 * face) / sizes!.length);
  }
  await flush(1);
  const bytes = new Uint8Array(chunks.reduce((sum, chunk) => sum + chunk.length, 0));
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.length;
  }
  return bytes;
}
