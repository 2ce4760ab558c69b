import { Places } from '../places.js';
import { checkMeshFits } from '../room.js';
import { batchMask, Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { badFile, counted } from './failures.js';
import { GrowingInts } from './growing.js';
import { partOfEach } from './marks.js';
import { startOf, Words } from './text.js';
import type { FilePart, Polygons } from './types.js';

const headerBytes = 84;
const triangleBytes = 50;

/**
 * Whether bytes are a binary STL file. The length of the file decides, since the first 80 bytes are
 * arbitrary and may look like a text file.
 */
export function isBinaryStl(bytes: Uint8Array): boolean {
  if (bytes.length < headerBytes) return false;
  const count = viewOf(bytes).getUint32(80, true);
  return count > 0 && (bytes.length === headerBytes + triangleBytes * count || hasMore(bytes));
}

const viewOf = (bytes: Uint8Array) =>
  new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

/**
 * Whether the last two bytes of each triangle state how many extra bytes follow it. The last
 * triangle and its extra bytes must then end at the file's end. If the triangles alone fill the
 * file, the two bytes are not such a number, but a color that some programs store there.
 */
function hasMore(bytes: Uint8Array): boolean {
  const view = viewOf(bytes);
  const count = view.getUint32(80, true);
  if (bytes.length <= headerBytes + triangleBytes * count) return false;
  let at = headerBytes;
  for (let face = 0; face < count; face++) {
    if (at + triangleBytes > bytes.length) return false;
    at += triangleBytes + view.getUint16(at + triangleBytes - 2, true);
  }
  return at === bytes.length;
}

/** Whether bytes begin as text STL does. Comments may come first, and `solid` may be missing. */
export function isTextStl(start: string): boolean {
  const begin = /^\s*(?:#[^\r\n]*[\r\n]\s*)*(solid|facet\s+normal)\b/i.exec(start);
  return begin !== null && /\b(facet|endsolid)\b/i.test(start.slice(begin.index));
}

/**
 * Reads an STL file, binary or text. The solids of the file are its parts. Corners at exactly the
 * same place are one vertex; vertices have numbers in the order of their first occurrence. Normals
 * are skipped. Rejects with `KarcherError` badFile, with the line or byte, or the signal's reason.
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
  const partOf = partOfEach(parts, wanted);
  const info = { format: 'stl', parts, partOf, notRead } as const;
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
  const view = viewOf(bytes);
  const count = view.getUint32(80, true);
  const withMore = hasMore(bytes);
  const end = headerBytes + triangleBytes * count;
  if (end > bytes.length) {
    throw badFile(
      `the STL file declares ${counted(count)} triangles, which take ${counted(end)} bytes, but it has ${counted(bytes.length)}`,
    );
  }
  const parts = [{ name: 'solid', triangles: count }];
  const more = bytes.length - end;
  const where = withMore ? 'the triangles' : 'the last triangle';
  const notRead = more > 0 ? [`${counted(more)} bytes after ${where} were left out.`] : [];
  if (!wanted(0)) return { parts, notRead };
  checkMeshFits(0, count, 'the STL file has');
  let at = headerBytes;
  for (let face = 0; face < count; face++) {
    if ((face & batchMask) === 0 && slices.over) await slices.rest(face / count);
    for (let corner = 1; corner <= 3; corner++) {
      const [x, y, z] = [0, 4, 8].map((axis) => view.getFloat32(at + 12 * corner + axis, true));
      corners.push(places.number(x!, y!, z!));
    }
    at += triangleBytes + (withMore ? view.getUint16(at + triangleBytes - 2, true) : 0);
  }
  return { parts, notRead };
};

const readText: Reader = async (bytes, wanted, places, corners, slices) => {
  const words = new Words(bytes);
  const parts: FilePart[] = [];
  const coordinate = 'a coordinate';
  while (words.next()) {
    // Some programs write only facets.
    const isSolid = isWord(words, 'solid');
    if (!isSolid && (parts.length > 0 || !isWord(words, 'facet'))) words.fail("'solid'");
    const name = (isSolid && words.restOfLine()) || `solid ${parts.length + 1}`;
    if (isSolid) words.next();
    const isWanted = wanted(parts.length);
    let triangles = 0;
    for (; isWord(words, 'facet'); words.next()) {
      if ((triangles & batchMask) === 0 && slices.over) await slices.rest(words.at / bytes.length);
      expect(words, 'normal');
      for (let axis = 0; axis < 3; axis++) words.skip('a component of a normal');
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
    const isEnd = isWord(words, 'endsolid') || (!isSolid && words.word === '');
    if (!isEnd) words.fail("'facet' or 'endsolid'");
    words.restOfLine();
    parts.push({ name, triangles });
  }
  return { parts, notRead: [] };
};

const isWord = (words: Words, keyword: string) => words.word.toLowerCase() === keyword;

function expect(words: Words, keyword: string): void {
  if (!words.next() || !isWord(words, keyword)) words.fail(`'${keyword}'`);
}
