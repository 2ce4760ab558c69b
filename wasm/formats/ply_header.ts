import { badFile, counted } from './failures.js';
import { lineEndAt, Words } from './text.js';

/** The layout of a number in a binary file. */
export interface NumberType {
  bytes: 1 | 2 | 4 | 8;
  get: 'Int8' | 'Uint8' | 'Int16' | 'Uint16' | 'Int32' | 'Uint32' | 'Float32' | 'Float64';
}

const types = new Map<string, NumberType>([
  ['char', { bytes: 1, get: 'Int8' }],
  ['int8', { bytes: 1, get: 'Int8' }],
  ['uchar', { bytes: 1, get: 'Uint8' }],
  ['uint8', { bytes: 1, get: 'Uint8' }],
  ['short', { bytes: 2, get: 'Int16' }],
  ['int16', { bytes: 2, get: 'Int16' }],
  ['ushort', { bytes: 2, get: 'Uint16' }],
  ['uint16', { bytes: 2, get: 'Uint16' }],
  ['int', { bytes: 4, get: 'Int32' }],
  ['int32', { bytes: 4, get: 'Int32' }],
  ['uint', { bytes: 4, get: 'Uint32' }],
  ['uint32', { bytes: 4, get: 'Uint32' }],
  ['float', { bytes: 4, get: 'Float32' }],
  ['float32', { bytes: 4, get: 'Float32' }],
  ['double', { bytes: 8, get: 'Float64' }],
  ['float64', { bytes: 8, get: 'Float64' }],
]);

export interface PlyProperty {
  name: string;
  type: NumberType;
  /** The type of the length of a list; null for a single number. */
  length: NumberType | null;
}

export interface PlyElement {
  name: string;
  count: number;
  properties: PlyProperty[];
}

export interface PlyHeader {
  encoding: 'ascii' | 'little' | 'big';
  elements: PlyElement[];
  /** The place where the data begins, and its line. */
  end: number;
  line: number;
}

const encodings = new Map<string, PlyHeader['encoding']>([
  ['ascii', 'ascii'],
  ['binary_little_endian', 'little'],
  ['binary_big_endian', 'big'],
]);

/** The largest length of a header, in bytes. A longer text is not a header. */
const longestHeader = 1 << 16;

/** Reads a PLY file's header. Throws `KarcherError` badFile with the line. */
export function plyHeader(bytes: Uint8Array): PlyHeader {
  const words = new Words(bytes.subarray(0, longestHeader));
  const elements: PlyElement[] = [];
  let encoding: PlyHeader['encoding'] | undefined;
  words.next();
  words.restOfLine();
  for (;;) {
    if (!words.next()) throw badFile("the PLY file's header does not end with 'end_header'");
    const keyword = words.word;
    if (keyword === 'end_header') break;
    if (keyword === 'comment' || keyword === 'obj_info') words.restOfLine();
    else if (keyword === 'format') {
      if (!words.nextInLine()) words.fail('the format');
      encoding = encodings.get(words.word);
      if (!encoding) words.fail(`one of ${[...encodings.keys()].join(', ')}`);
      words.restOfLine();
    } else if (keyword === 'element') elements.push(element(words));
    else if (keyword === 'property') property(words, elements.at(-1));
    else words.fail('a line of a PLY header');
  }
  if (!encoding) throw badFile("the PLY file's header has no line 'format'");
  const end = dataStart(bytes, words.at);
  const header = { encoding, elements, end, line: words.line + 1 };
  for (const one of elements) checkRoom(header, one, bytes.length - end);
  return header;
}

/** The place after the end of the line `end_header`. Everything after it is data. */
function dataStart(bytes: Uint8Array, from: number): number {
  let at = from;
  while (bytes[at] === 32 || bytes[at] === 9) at++;
  const length = lineEndAt(bytes, at);
  if (length === 0) throw badFile("the line 'end_header' has no end");
  // If the lines of the file end with \r, a \n after the header is data.
  const isShort = bytes[3] === 13 && lineEndAt(bytes, 3) === 1;
  return at + (isShort ? 1 : length);
}

function element(words: Words): PlyElement {
  if (!words.nextInLine()) words.fail('the name of an element');
  const name = words.word;
  return { name, count: words.count(`the number of elements '${name}'`), properties: [] };
}

function property(words: Words, of: PlyElement | undefined): void {
  const element = of ?? words.fail("a line 'element' before the first property");
  const type = () => {
    if (!words.nextInLine()) words.fail('a type of numbers');
    return types.get(words.word) ?? words.fail(`one of ${[...types.keys()].join(', ')}`);
  };
  if (!words.nextInLine()) words.fail('a type of numbers');
  const isList = words.word === 'list';
  const first = isList ? type() : (types.get(words.word) ?? words.fail('a type of numbers'));
  const last = isList ? type() : first;
  if (isList && first.get.startsWith('Float')) words.fail('a list whose length is a whole number');
  if (!words.nextInLine()) words.fail('the name of a property');
  element.properties.push({ name: words.word, type: last, length: isList ? first : null });
}

/**
 * Rejects a count for which the rest of the file is too short, before memory is allocated for it.
 */
function checkRoom({ encoding }: PlyHeader, { name, count, properties }: PlyElement, room: number) {
  if (properties.length === 0 && count > 0) {
    throw badFile(`the PLY file's element '${name}' has no properties`);
  }
  const bytes = properties.reduce(
    // In text, a number takes at least a character and a space.
    (sum, { type, length }) => sum + (encoding === 'ascii' ? 2 : (length ?? type).bytes),
    encoding === 'ascii' ? -1 : 0,
  );
  if (count * bytes <= room) return;
  throw badFile(
    `the PLY file's header declares ${counted(count)} elements '${name}', of at least ${bytes} bytes ` +
      `each, but only ${counted(room)} bytes follow`,
  );
}
