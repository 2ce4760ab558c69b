import { Places } from '../places.js';
import { checkMeshFits } from '../room.js';
import { batchMask, Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { badFile, counted } from './failures.js';
import { GrowingInts } from './growing.js';
import { startOf, Words } from './text.js';
import type { FilePart, Polygons } from './types.js';

const headerBytes = 84;
const triangleBytes = 50;

/** Whether bytes are a binary STL file, by their number; text may begin with anything. */
export function isBinaryStl(bytes: Uint8Array): boolean {
  if (bytes.length < headerBytes) return false;
  const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  return count > 0 && bytes.length === headerBytes + triangleBytes * count;
}

/** Whether they begin as one of text does. */
export function isTextStl(start: string): boolean {
  return /^\s*solid\b/i.test(start) && /\b(facet|endsolid)\b/i.test(start);
}

/**
 * Reads an STL file, binary or of text, whose solids are its parts. Corners at exactly the same place
 * are one vertex, numbered in the order in which they come; the normals are not read.
 *
 * Rejects with `KarcherError` badFile, naming the line or byte, or the signal's reason.
 */
export async function readStl(
  bytes: Uint8Array,
  wanted: (part: number) => boolean,
  work: LongWorkOptions,
): Promise<Polygons> {
  const slices = new Slices(work, 'reading');
  const places = new Places();
  const corners = new GrowingInts();
  const isText = !isBinaryStl(bytes) && isTextStl(startOf(bytes));
  const reader = isText ? readText : readBinary;
  const { parts, notRead } = await reader(bytes, wanted, places, corners, slices);
  const info = { format: 'stl', parts, notRead } as const;
  return { positions: places.positions, corners: corners.values, sizes: null, info };
}

type Reader = (
  bytes: Uint8Array,
  wanted: (part: number) => boolean,
  places: Places,
  corners: GrowingInts,
  slices: Slices,
) => Promise<{ parts: FilePart[]; notRead: string[] }>;

const readBinary: Reader = async (bytes, wanted, places, corners, slices) => {
  if (bytes.length < headerBytes) {
    throw badFile(
      `the file ends at byte ${bytes.length}; a binary STL file has at least ${headerBytes} bytes`,
    );
  }
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = view.getUint32(80, true);
  const end = headerBytes + triangleBytes * count;
  if (end > bytes.length) {
    throw badFile(
      `the STL file tells of ${counted(count)} triangles, which take ${counted(end)} bytes, but it has ${counted(bytes.length)}`,
    );
  }
  const parts = [{ name: 'solid', triangles: count }];
  const more = bytes.length - end;
  const notRead = more > 0 ? [`${counted(more)} bytes after the last triangle were left out.`] : [];
  if (!wanted(0)) return { parts, notRead };
  checkMeshFits(0, count, 'the STL file has');
  for (let face = 0; face < count; face++) {
    if ((face & batchMask) === 0 && slices.over) await slices.rest(face / count);
    for (let corner = 1; corner <= 3; corner++) {
      const at = headerBytes + triangleBytes * face + 12 * corner;
      const [x, y, z] = [0, 4, 8].map((axis) => view.getFloat32(at + axis, true));
      corners.push(places.number(x!, y!, z!));
    }
  }
  return { parts, notRead };
};

const readText: Reader = async (bytes, wanted, places, corners, slices) => {
  const words = new Words(bytes);
  const parts: FilePart[] = [];
  const coordinate = 'a coordinate';
  while (words.next()) {
    if (!isWord(words, 'solid')) words.fail("'solid'");
    const name = words.restOfLine() || `solid ${parts.length + 1}`;
    const isWanted = wanted(parts.length);
    let triangles = 0;
    while (words.next() && isWord(words, 'facet')) {
      if ((triangles & batchMask) === 0 && slices.over) await slices.rest(words.at / bytes.length);
      expect(words, 'normal');
      for (let axis = 0; axis < 3; axis++) words.number('a component of a normal');
      expect(words, 'outer');
      expect(words, 'loop');
      for (let corner = 0; corner < 3; corner++) {
        expect(words, 'vertex');
        const x = words.number(coordinate);
        const y = words.number(coordinate);
        const z = words.number(coordinate);
        if (isWanted) corners.push(places.number(x, y, z));
      }
      expect(words, 'endloop');
      expect(words, 'endfacet');
      triangles++;
    }
    if (!isWord(words, 'endsolid')) words.fail("'facet' or 'endsolid'");
    words.restOfLine();
    parts.push({ name, triangles });
  }
  return { parts, notRead: [] };
};

const isWord = (words: Words, keyword: string) => words.word.toLowerCase() === keyword;

function expect(words: Words, keyword: string): void {
  if (!words.next() || !isWord(words, keyword)) words.fail(`'${keyword}'`);
}
