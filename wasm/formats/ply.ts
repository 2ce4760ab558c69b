import { KarcherError } from '../errors.js';
import { batchMask, Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { badFile, counted } from './failures.js';
import { GrowingPolygons } from './growing.js';
import { colorByte } from './marks.js';
import { type PlyElement, type PlyProperty, plyHeader } from './ply_header.js';
import { longerRows, TextRows, Words } from './text.js';
import type { Polygons } from './types.js';

/** A reader of the numbers in an element's rows, one after the other. */
interface Rows {
  /** The next number; `length` is true for the length of a list. */
  number(property: PlyProperty, what: string, length?: boolean): number;
  /** Skips a value, which need not be a number. */
  skip(property: PlyProperty, what: string): void;
  /** Ends a row. */
  endRow(): void;
  /** The number of rows with more numbers than the header declares. */
  longer: number;
  /** The place of the reader: "line 12", "byte 240". */
  place(): string;
  /** The fraction of the file up to the reader. */
  done(): number;
}

class AsciiRows implements Rows {
  readonly #rows: TextRows;
  readonly #length: number;

  constructor(bytes: Uint8Array, at: number, line: number) {
    this.#rows = new TextRows(new Words(bytes, at, line));
    this.#length = bytes.length;
  }

  number = (_: PlyProperty, what: string) => this.#rows.number(what);
  skip = (_: PlyProperty, what: string) => this.#rows.next(what);
  endRow = () => this.#rows.end();
  place = () => `line ${this.#rows.words.line}`;
  done = () => this.#rows.words.at / this.#length;

  get longer(): number {
    return this.#rows.longer;
  }
}

class BinaryRows implements Rows {
  readonly #view: DataView;
  readonly #little: boolean;
  #at: number;

  constructor(bytes: Uint8Array, at: number, little: boolean) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#at = at;
    this.#little = little;
  }

  number({ type, length }: PlyProperty, what: string, isLength = false): number {
    const { bytes, get } = isLength ? length! : type;
    const at = this.#at;
    if (at + bytes > this.#view.byteLength) {
      throw badFile(`the file ends at byte ${at}, where there must be ${what}`);
    }
    this.#at += bytes;
    switch (get) {
      case 'Float32':
        return this.#view.getFloat32(at, this.#little);
      case 'Int32':
        return this.#view.getInt32(at, this.#little);
      case 'Uint8':
        return this.#view.getUint8(at);
      case 'Uint32':
        return this.#view.getUint32(at, this.#little);
      case 'Float64':
        return this.#view.getFloat64(at, this.#little);
      case 'Int8':
        return this.#view.getInt8(at);
      case 'Int16':
        return this.#view.getInt16(at, this.#little);
      case 'Uint16':
        return this.#view.getUint16(at, this.#little);
    }
  }

  skip = this.number;

  endRow(): void {}
  readonly longer = 0;
  place = () => `byte ${this.#at}`;
  done = () => this.#at / this.#view.byteLength;
}

/**
 * Reads a PLY file: text, or binary with either order of bytes. Positions are the properties x, y,
 * z of `vertex`. Polygons are the list `vertex_indices` (or `vertex_index`) of `face`. Rejects with
 * `KarcherError` badFile or badIndex, with the line or byte, or the signal's reason.
 */
export async function readPly(bytes: Uint8Array, work: LongWorkOptions): Promise<Polygons> {
  const { encoding, elements, end, line } = plyHeader(bytes);
  checkElements(elements);
  const rows =
    encoding === 'ascii'
      ? new AsciiRows(bytes, end, line)
      : new BinaryRows(bytes, end, encoding === 'little');
  const slices = new Slices(work, 'reading');
  let places: Vertices = { positions: new Float64Array(), colors: null };
  const polygons = new GrowingPolygons();
  const vertices = elements.find(({ name }) => name === 'vertex')!.count;
  for (const element of elements) {
    if (element.name === 'vertex') places = await readVertices(element, rows, slices);
    else if (element.name === 'face') await readFaces(element, rows, vertices, polygons, slices);
    else await skip(element, rows, slices);
    // Elements after the faces and vertices do not matter.
    if (places.positions.length > 0 && polygons.count > 0) break;
  }
  const notRead = [
    ...polygons.notRead,
    ...(rows.longer > 0 ? [longerRows(rows.longer, 'those of the header')] : []),
    ...elements
      .filter(({ name, count }) => !['vertex', 'face'].includes(name) && count > 0)
      .map(({ name, count }) => `The file’s '${name}' (${counted(count)}) was left out.`),
  ];
  const parts = [{ name: 'mesh', triangles: polygons.triangles }];
  const { positions, colors } = places;
  const info = { format: 'ply', parts, colors, notRead } as const;
  return { positions, corners: polygons.corners, sizes: polygons.sizes, info };
}

const indexNames = ['vertex_indices', 'vertex_index'];

const isIndexList = ({ name, length }: PlyProperty) => length !== null && indexNames.includes(name);

/** Throws `KarcherError` badFile, with the reason, if the elements are no mesh. */
function checkElements(elements: readonly PlyElement[]): void {
  const [vertex, face] = ['vertex', 'face'].map((wanted) =>
    elements.find(({ name }) => name === wanted),
  );
  for (const name of ['vertex', 'face']) {
    if (elements.filter((one) => one.name === name).length > 1) {
      throw badFile(`the PLY file has two elements '${name}'`);
    }
  }
  const scalar = (name: string) =>
    vertex?.properties.some((one) => one.name === name && one.length === null);
  if (!vertex || !['x', 'y', 'z'].every(scalar)) {
    throw badFile("the PLY file has no element 'vertex' with properties x, y and z");
  }
  if (!face || face.count === 0) {
    const strips = elements.some(({ name }) => name === 'tristrips');
    throw badFile(
      strips
        ? 'the PLY file has triangle strips, which are not read: save it with faces'
        : `the PLY file is a cloud of ${counted(vertex.count)} points: it has no faces`,
    );
  }
  if (!face.properties.some(isIndexList)) {
    throw badFile("the PLY file's faces have no list 'vertex_indices'");
  }
}

interface Vertices {
  positions: Float64Array;
  /** The colors, three bytes for each vertex. */
  colors: Uint8Array | null;
}

/** The names that programs use for red, green and blue. */
const colorNames = [
  ['red', 'green', 'blue'],
  ['diffuse_red', 'diffuse_green', 'diffuse_blue'],
  ['r', 'g', 'b'],
];

/** The color channel of each property: 0 to 2 for red, green and blue, -1 for other properties. */
function channelsOf({ properties }: PlyElement): number[] {
  const has = (name: string) => properties.some((one) => one.name === name && one.length === null);
  const names = colorNames.find((three) => three.every(has)) ?? [];
  return properties.map(({ name }) => names.indexOf(name));
}

/** The divisor of a color's numbers. Whole numbers range up to the greatest of their type. */
const mostOf = ({ type: { get, bytes } }: PlyProperty) =>
  get.startsWith('Float') ? 1 : 2 ** (8 * bytes - (get.startsWith('Int') ? 1 : 0)) - 1;

async function readVertices(element: PlyElement, rows: Rows, slices: Slices): Promise<Vertices> {
  const positions = new Float64Array(3 * element.count);
  const channels = channelsOf(element);
  const colors = channels.some((channel) => channel >= 0) ? new Uint8Array(positions.length) : null;
  const axes = element.properties.map(({ name, length }) =>
    length === null ? ['x', 'y', 'z'].indexOf(name) : -1,
  );
  for (let vertex = 0; vertex < element.count; vertex++) {
    if ((vertex & batchMask) === 0 && slices.over) await slices.rest(rows.done());
    for (let i = 0; i < axes.length; i++) {
      const property = element.properties[i]!;
      const axis = axes[i]!;
      const channel = channels[i]!;
      if (channel >= 0) {
        const value = rows.number(property, 'a color') / mostOf(property);
        colors![3 * vertex + channel] = colorByte(value);
      } else if (axis < 0) skipProperty(property, rows);
      else positions[3 * vertex + axis] = rows.number(property, 'a coordinate');
    }
    rows.endRow();
  }
  return { positions, colors };
}

async function readFaces(
  element: PlyElement,
  rows: Rows,
  vertices: number,
  polygons: GrowingPolygons,
  slices: Slices,
): Promise<void> {
  const list = element.properties.find(isIndexList)!;
  for (let face = 0; face < element.count; face++) {
    if ((face & batchMask) === 0 && slices.over) await slices.rest(rows.done());
    for (const property of element.properties) {
      if (property !== list) skipProperty(property, rows);
      else readFace(face, property, rows, vertices, polygons);
    }
    rows.endRow();
  }
}

function readFace(
  face: number,
  list: PlyProperty,
  rows: Rows,
  vertices: number,
  polygons: GrowingPolygons,
): void {
  const size = rows.number(list, 'the number of corners', true);
  if (!(size >= 0 && Number.isInteger(size))) {
    throw badFile(`${rows.place()}: face ${face} cannot have ${size} corners`);
  }
  for (let corner = 0; corner < size; corner++) {
    const vertex = rows.number(list, 'the number of a vertex');
    if (!(vertex >= 0 && vertex < vertices && Number.isInteger(vertex))) {
      throw new KarcherError(
        'badIndex',
        `${rows.place()}: face ${face} uses vertex ${vertex}, but the file has ${counted(vertices)}`,
      );
    }
    if (size >= 3) polygons.corner(vertex);
  }
  polygons.end(size);
}

async function skip(element: PlyElement, rows: Rows, slices: Slices): Promise<void> {
  for (let row = 0; row < element.count; row++) {
    if ((row & batchMask) === 0 && slices.over) await slices.rest(rows.done());
    for (const property of element.properties) skipProperty(property, rows);
    rows.endRow();
  }
}

function skipProperty(property: PlyProperty, rows: Rows): void {
  const what = `a number of '${property.name}'`;
  if (property.length === null) {
    rows.skip(property, what);
    return;
  }
  const size = rows.number(property, what, true);
  if (!(size >= 0 && Number.isInteger(size))) {
    throw badFile(`${rows.place()}: the list '${property.name}' cannot have ${size} entries`);
  }
  for (let i = 0; i < size; i++) rows.skip(property, what);
}
