import { KarcherError } from '../errors.js';
import { batchMask, Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { badFile, counted } from './failures.js';
import { GrowingPolygons } from './growing.js';
import { colorByte } from './marks.js';
import { isLineEnd, lineEndAt, longerRows, TextRows, Words } from './text.js';
import type { Polygons } from './types.js';

/**
 * A keyword such as OFF, COFF, STNOFF, 4OFF. It lists the data that a vertex has beside its place.
 * A count may follow.
 */
const keyword = /^(ST)?(C)?(N)?(4)?(n)?OFF(\d+)?$/;

export const isOff = (start: string) => keyword.test(/^\s*(?:#.*\s+)*(\S+)/.exec(start)?.[1] ?? '');

/** A reader of an OFF file's numbers, in text or binary. */
interface Source {
  /** The next coordinate. */
  coordinate(what: string): number;
  /** The next whole number of at least 0. */
  count(what: string): number;
  /**
   * Ends the header, after the numbers of vertices and faces. `rows` is the number of rows that
   * follow.
   */
  endHeader(rows: number): void;
  /**
   * Reads the rest of a vertex, after its three coordinates. Returns its color as in the file; null
   * if it has none.
   */
  endVertex(): readonly number[] | null;
  /** Skips the rest of a face, which is its color. */
  endFace(): void;
  /** Throws if the file continues. */
  end(): void;
  /** The place of the last number: "line 12", "byte 240". */
  place(): string;
  /** The least numbers of bytes of a vertex, and of a face without corners. */
  least: { vertex: number; face: number };
  /** The number of bytes that follow. */
  room(): number;
  notRead(): string[];
}

/** The numbers that a vertex has beside its place, in this order. */
interface Beside {
  normal: number;
  color: number;
  texture: number;
}

/**
 * The colors of vertices as bytes; null if no vertex has one. A vertex without a color, whose
 * numbers are NaN, is white. In the file, colors range up to 255 if a number exceeds 1, else up to
 * 1.
 */
function colorBytes(colors: Float64Array): Uint8Array | null {
  if (colors.every(Number.isNaN)) return null;
  const most = colors.some((value) => value > 1) ? 255 : 1;
  return Uint8Array.from(colors, (value) => (Number.isNaN(value) ? 255 : colorByte(value / most)));
}

/**
 * Reads an OFF file, text or binary. Skips normals, texture coordinates and the colors of faces.
 * Rejects with `KarcherError` badFile or badIndex, with the line or byte, or the signal's reason.
 */
export async function readOff(bytes: Uint8Array, work: LongWorkOptions): Promise<Polygons> {
  const words = new Words(bytes);
  words.next();
  const [, texture, color, normal, four, many, glued] =
    keyword.exec(words.word) ?? words.fail("'OFF'");
  if (four || many) {
    throw badFile(`the file is ${words.word}, of another dimension than 3, which is not read`);
  }
  // OFF3 is a keyword and a number.
  if (glued) words.back(glued.length);
  const beside = { normal: normal ? 3 : 0, color: color ? 4 : 0, texture: texture ? 2 : 0 };
  const isBinary = words.nextIs('BINARY');
  const source = isBinary
    ? new BinarySource(bytes, words, beside)
    : new TextSource(bytes, words, beside);
  const vertices = source.count('the number of vertices');
  const faces = source.count('the number of faces');
  source.endHeader(vertices + faces);
  const { least } = source;
  const room = source.room();
  if (least.vertex * vertices + least.face * faces - 1 > room) {
    throw badFile(
      `the OFF file declares ${counted(vertices)} vertices and ${counted(faces)} faces, but only ${counted(room)} bytes follow`,
    );
  }
  const slices = new Slices(work, 'reading');
  const done = () => 1 - source.room() / bytes.length;
  const positions = new Float64Array(3 * vertices);
  const colored = color ? new Float64Array(3 * vertices).fill(Number.NaN) : null;
  for (let vertex = 0; vertex < vertices; vertex++) {
    if ((vertex & batchMask) === 0 && slices.over) await slices.rest(done());
    for (let axis = 0; axis < 3; axis++) {
      positions[3 * vertex + axis] = source.coordinate(`a coordinate of vertex ${vertex}`);
    }
    const row = source.endVertex();
    if (row) colored?.set(row, 3 * vertex);
  }
  const polygons = new GrowingPolygons();
  for (let face = 0; face < faces; face++) {
    if ((face & batchMask) === 0 && slices.over) await slices.rest(done());
    const size = source.count(`the number of corners of face ${face}`);
    for (let corner = 0; corner < size; corner++) {
      const vertex = source.count(`a vertex of face ${face}`);
      if (vertex >= vertices) {
        throw new KarcherError(
          'badIndex',
          `${source.place()}: face ${face} uses vertex ${vertex}, but the file has ${counted(vertices)}`,
        );
      }
      if (size >= 3) polygons.corner(vertex);
    }
    polygons.end(size);
    source.endFace();
  }
  source.end();
  const parts = [{ name: 'mesh', triangles: polygons.triangles }];
  const notRead = [...polygons.notRead, ...source.notRead()];
  const colors = colored && colorBytes(colored);
  const info = { format: 'off', parts, colors, notRead } as const;
  return { positions, corners: polygons.corners, sizes: polygons.sizes, info };
}

class TextSource implements Source {
  readonly #bytes: Uint8Array;
  readonly #words: Words;
  readonly #beside: Beside;
  readonly #rows: TextRows;
  /** Whether each vertex and face begins on a separate line. If not, line ends have no meaning. */
  #inRows = true;
  #longer = 0;
  /**
   * A vertex takes at least three digits, and a face without corners one; a separator follows each.
   */
  readonly least = { vertex: 6, face: 2 };

  constructor(bytes: Uint8Array, words: Words, beside: Beside) {
    this.#bytes = bytes;
    this.#words = words;
    this.#beside = beside;
    this.#rows = new TextRows(words);
  }

  coordinate(what: string): number {
    return this.#inRows ? this.#rows.number(what) : this.#words.number(what);
  }

  count(what: string): number {
    this.#rows.next(what);
    return this.#words.asCount(what);
  }

  /**
   * Ends the header. If the counts stand on one line, the number of edges may be missing, since it
   * has no effect.
   */
  endHeader(rows: number): void {
    if (this.#rows.isSplit) this.#words.skip('the number of edges');
    else this.#words.nextInLine();
    this.#rows.restart();
    this.#inRows = this.#hasLines(rows);
  }

  /**
   * Reads the rest of a vertex. The end of the line shows whether a color has three or four
   * numbers. If vertices do not begin on separate lines, this is unknown, and the color is left
   * out.
   */
  endVertex(): readonly number[] | null {
    const what = 'a number of a vertex';
    const { normal, color, texture } = this.#beside;
    const skip = (count: number) => {
      for (let i = 0; i < count; i++) {
        if (this.#inRows) this.#rows.next(what);
        else this.#words.skip(what);
      }
    };
    skip(normal);
    const rest: number[] = [];
    while (color && this.#inRows && rest.length < color + texture && this.#words.nextInLine()) {
      rest.push(Number(this.#words.word));
    }
    skip(color ? texture - rest.length : texture);
    if (this.#inRows) this.#rows.end();
    else if (color) this.#words.restOfLine();
    this.#longer = this.#rows.longer;
    return rest.length >= 3 + texture ? rest.slice(0, 3) : null;
  }

  endFace = () => this.#rows.end();

  end(): void {
    if (this.#words.next()) this.#words.fail('the end of the file');
  }

  place = () => `line ${this.#words.line}`;
  room = () => this.#bytes.length - this.#words.at;

  notRead(): string[] {
    if (this.#longer === 0 || this.#beside.color > 0) return [];
    return [longerRows(this.#longer, 'the places of vertices')];
  }

  /** Whether at least this number of the lines that follow are neither empty nor comments. */
  #hasLines(wanted: number): boolean {
    const bytes = this.#bytes;
    let lines = 0;
    let isEmpty = true;
    let isComment = false;
    for (let at = this.#words.at; at < bytes.length && lines < wanted; at++) {
      const byte = bytes[at]!;
      if (isLineEnd(byte)) [isEmpty, isComment] = [true, false];
      else if (byte > 32 && isEmpty && !isComment) {
        isComment = byte === 35;
        if (isComment) continue;
        isEmpty = false;
        lines++;
      }
    }
    return lines >= wanted;
  }
}

/** Numbers of four bytes, the most significant byte first, after the line with BINARY. */
class BinarySource implements Source {
  readonly #view: DataView;
  readonly #beside: Beside;
  #at: number;
  readonly least: { vertex: number; face: number };

  constructor(bytes: Uint8Array, words: Words, beside: Beside) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    words.restOfLine();
    this.#at = words.at + lineEndAt(bytes, words.at);
    this.#beside = beside;
    const { normal, color, texture } = beside;
    this.least = { vertex: 4 * (3 + normal + color + texture), face: 8 };
  }

  #next(what: string): number {
    const at = this.#at;
    if (at + 4 > this.#view.byteLength) {
      throw badFile(`the file ends at byte ${at}, where there must be ${what}`);
    }
    this.#at += 4;
    return at;
  }

  coordinate(what: string): number {
    return this.#view.getFloat32(this.#next(what));
  }

  count(what: string): number {
    const value = this.#view.getInt32(this.#next(what));
    if (value < 0) throw badFile(`byte ${this.#at - 4}: there must be ${what}, not ${value}`);
    return value;
  }

  /** Skips the number of edges. */
  endHeader(): void {
    this.#next('the number of edges');
  }

  endVertex(): readonly number[] | null {
    const { normal, color, texture } = this.#beside;
    const rest = Array.from({ length: normal + color + texture }, () =>
      this.coordinate('a number of a vertex'),
    );
    return color ? rest.slice(normal, normal + 3) : null;
  }

  /** Skips the components of a face's color. The number of components comes before them. */
  endFace(): void {
    const count = this.count('the number of components of a color');
    if (4 * count > this.room()) {
      throw badFile(`byte ${this.#at - 4}: a color cannot have ${counted(count)} components`);
    }
    this.#at += 4 * count;
  }

  end(): void {
    if (this.room() > 0) throw badFile(`byte ${this.#at}: there must be the end of the file`);
  }

  place = () => `byte ${this.#at - 4}`;
  room = () => this.#view.byteLength - this.#at;
  notRead = (): string[] => [];
}
