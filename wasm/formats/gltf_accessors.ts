import { decodeDraco } from './draco.js';
import { badFile, counted } from './failures.js';
import type { GltfContent } from './glb.js';
import { Buffers } from './gltf_buffers.js';
import { type Decoders, dracoOf } from './gltf_decoders.js';
import { countOf, entryOf, type Json, objectOf } from './gltf_json.js';

const componentBytes = new Map([
  [5120, 1],
  [5121, 1],
  [5122, 2],
  [5123, 2],
  [5125, 4],
  [5126, 4],
]);
/**
 * The divisors of normalized whole numbers. The quotients are from -1 to 1 for signed types, and
 * from 0 to 1 for unsigned ones.
 */
const most = new Map([
  [5120, 127],
  [5121, 255],
  [5122, 32767],
  [5123, 65535],
]);
/** The types of numbers that indices may have: unsigned integers. */
const counting: readonly unknown[] = [5121, 5123, 5125];

const components = { SCALAR: 1, VEC3: 3, VEC4: 4 } as const;
type RowType = keyof typeof components;

export interface Accessor {
  count: number;
  fill(row: number, values: Float64Array): void;
}

/** Rows of numbers in a buffer. */
interface Rows {
  view: DataView;
  at: number;
  stride: number;
  type: number;
}

/**
 * A reader of the accessors of a glTF file. An accessor is a list of numbers in the file's buffers.
 */
export class Accessors {
  readonly #json: Json;
  readonly #buffers: Buffers;
  readonly #draco: Decoders['draco'];
  readonly #known = new Map<string, Accessor>();

  constructor(
    json: Json,
    content: GltfContent,
    beside: Readonly<Record<string, Uint8Array>>,
    { draco, meshopt }: Decoders,
  ) {
    this.#json = json;
    this.#buffers = new Buffers(json, content, beside, meshopt);
    this.#draco = draco;
  }

  get json(): Json {
    return this.#json;
  }

  /** The places of a primitive's vertices, and its indices if it has any. */
  ofPrimitive(primitive: Json): { places: Accessor; indices: Accessor | null } {
    const { POSITION } = objectOf(primitive, 'attributes');
    const draco = this.#draco && dracoOf(primitive);
    if (draco) return this.#ofDraco(draco, POSITION, primitive.indices);
    return {
      places: this.#accessor(POSITION, 'VEC3'),
      indices: primitive.indices === undefined ? null : this.#accessor(primitive.indices, 'SCALAR'),
    };
  }

  /** The colors of a primitive's vertices; null if it has no readable ones. */
  colorsOf(primitive: Json): Accessor | null {
    const { COLOR_0 } = objectOf(primitive, 'attributes');
    if (COLOR_0 === undefined) return null;
    const draco = this.#draco && dracoOf(primitive);
    try {
      const accessor = entryOf(this.#json, 'accessors', COLOR_0);
      const type = accessor.type === 'VEC4' ? 'VEC4' : 'VEC3';
      return draco
        ? this.#colorsOfDraco(draco, accessor, `accessor ${COLOR_0}`, type)
        : this.#accessor(COLOR_0, type);
    } catch {
      // Colors never make the reader reject a surface.
      return null;
    }
  }

  /** An accessor with rows of three or four numbers. */
  vectors(number: unknown, size: 3 | 4): Accessor {
    return this.#accessor(number, size === 3 ? 'VEC3' : 'VEC4');
  }

  /**
   * The places and triangles of a primitive that Draco compressed. Its accessors declare the
   * numbers of vertices and corners, which are checked at once. The data is decoded, and compared
   * with these numbers, only at the first read of a row. Without an accessor of indices, the data
   * is decoded at once, since only the data has the number of triangles.
   */
  #ofDraco(of: Json, places: unknown, indices: unknown): { places: Accessor; indices: Accessor } {
    // This check comes before `what`, since a value that is no number may not convert to text.
    entryOf(this.#json, 'bufferViews', of.bufferView);
    const place = entryOf(this.#json, 'accessors', places);
    const index = indices === undefined ? null : entryOf(this.#json, 'accessors', indices);
    const what = `buffer view ${of.bufferView}`;
    const id = countOf(objectOf(of, 'attributes'), 'POSITION', `${what}, which Draco compressed,`);
    const key = (number: unknown) => `Draco ${of.bufferView} ${id} ${number}`;
    const known = [this.#known.get(key(places)), this.#known.get(key(indices))];
    if (known[0] && known[1]) return { places: known[0], indices: known[1] };
    const type = place.componentType as number;
    checkType(type, `accessor ${places}`);
    const count = countOf(place, 'count', `accessor ${places}`);
    const corners = index && countOf(index, 'count', `accessor ${indices}`);
    let columns: { places: Rows; corners: Rows } | undefined;
    const decoded = () => {
      if (columns) return columns;
      const { bytes } = this.#buffers.view(of.bufferView);
      const mesh = decodeDraco(this.#draco!, bytes, [{ id, type, size: 3 }], what);
      const triangles = mesh.corners.length / 12;
      if (mesh.points !== count || (corners !== null && 3 * triangles !== corners)) {
        throw badFile(
          `${what}, which Draco compressed, has ${counted(triangles)} triangles of ${counted(mesh.points)} vertices, but its accessors declare ${corners === null ? '' : `${counted(corners / 3)} and `}${counted(count)}`,
        );
      }
      columns = {
        places: rowsOf(mesh.columns.get(id)!, type, 3),
        corners: rowsOf(mesh.corners, 5125, 1),
      };
      return columns;
    };
    const corner = { type: 'SCALAR', componentType: 5125 };
    const numbers = index ?? { ...corner, count: decoded().corners.view.byteLength / 4 };
    const made = {
      places: this.#made(place, `accessor ${places}`, 'VEC3', () => decoded().places),
      indices: this.#made(numbers, `accessor ${indices}`, 'SCALAR', () => decoded().corners),
    };
    this.#known.set(key(places), made.places);
    this.#known.set(key(indices), made.indices);
    return made;
  }

  /**
   * The colors of a primitive that Draco compressed. The first read decodes them. They are white if
   * the data cannot be decoded, has no such colors, or has another number of vertices than the
   * accessor declares.
   */
  #colorsOfDraco(of: Json, accessor: Json, what: string, rowType: 'VEC3' | 'VEC4'): Accessor {
    const id = countOf(objectOf(of, 'attributes'), 'COLOR_0', what);
    const type = accessor.componentType as number;
    checkType(type, what);
    const size = components[rowType];
    const white = () => {
      const value = accessor.normalized === true ? (most.get(type) ?? 1) : 1;
      const bytes = new Uint8Array(Float32Array.from({ length: size }, () => value).buffer);
      return { ...rowsOf(bytes, 5126, size), stride: 0 };
    };
    return this.#made(accessor, what, rowType, () => {
      try {
        const { bytes } = this.#buffers.view(of.bufferView);
        const { columns, points } = decodeDraco(this.#draco!, bytes, [{ id, type, size }], what);
        return points === accessor.count ? rowsOf(columns.get(id)!, type, size) : white();
      } catch {
        return white();
      }
    });
  }

  #accessor(number: unknown, type: RowType): Accessor {
    const accessor = entryOf(this.#json, 'accessors', number);
    const key = `${type} ${number}`;
    let known = this.#known.get(key);
    if (!known) {
      known = this.#made(accessor, `accessor ${number}`, type);
      this.#known.set(key, known);
    }
    return known;
  }

  /** An accessor. `decoded` returns the rows if no buffer has them uncompressed. */
  #made(accessor: Json, what: string, type: RowType, decoded?: () => Rows): Accessor {
    if (accessor.type !== type) throw badFile(`${what} has to be of type ${type}`);
    const count = countOf(accessor, 'count', what);
    const componentType = accessor.componentType as number;
    if (type === 'SCALAR') {
      checkCounting(componentType, what);
      if (accessor.normalized === true)
        throw badFile(`${what} is normalized, but must hold indices`);
    }
    const divisor = accessor.normalized === true ? (most.get(componentType) ?? 1) : 1;
    let rows: Rows | null =
      decoded || accessor.bufferView === undefined
        ? null
        : this.#rows(accessor, what, type, componentType, count);
    const sparse = decoded ? null : this.#sparse(accessor, what, type, componentType, count);
    const fillRow = (row: number, values: Float64Array) => {
      if (decoded) rows ??= decoded();
      const instead = sparse ? sparse.find(row) : -1;
      if (instead >= 0) fill(values, sparse!.values, instead);
      else if (rows) fill(values, rows, row);
      else values.fill(0);
      if (divisor === 1) return;
      for (let i = 0; i < values.length; i++) values[i] = Math.max(values[i]! / divisor, -1);
    };
    return { count, fill: fillRow };
  }

  /**
   * The replacement rows of a sparse accessor; null if the accessor is not sparse. `find` returns a
   * row's place among `values`, or -1.
   */
  #sparse(accessor: Json, what: string, type: RowType, componentType: number, rows: number) {
    if (accessor.sparse === undefined) {
      if (accessor.bufferView === undefined && rows > 0) throw badFile(`${what} has no values`);
      return null;
    }
    const sparse = objectOf(accessor, 'sparse');
    const name = `the sparse part of ${what}`;
    const count = countOf(sparse, 'count', name);
    const indices = objectOf(sparse, 'indices');
    checkCounting(indices.componentType, name);
    const at = this.#rows(indices, name, 'SCALAR', indices.componentType as number, count);
    const values = this.#rows(objectOf(sparse, 'values'), name, type, componentType, count);
    const index = new Float64Array(1);
    const indexOf = (row: number) => {
      fill(index, at, row);
      return index[0]!;
    };
    let last = -1;
    for (let row = 0; row < count; row++) {
      const changed = indexOf(row);
      if (!(changed < rows)) throw badFile(`${name} changes row ${changed} of ${rows}`);
      if (changed <= last) throw badFile(`${name} has row ${changed} after row ${last}`);
      last = changed;
    }
    const find = (row: number) => {
      let [low, high] = [0, count];
      while (low < high) {
        const middle = (low + high) >>> 1;
        if (indexOf(middle) < row) low = middle + 1;
        else high = middle;
      }
      return low < count && indexOf(low) === row ? low : -1;
    };
    return { values, find };
  }

  #rows(of: Json, what: string, type: RowType, componentType: number, count: number): Rows {
    const width = checkType(componentType, what);
    const { bytes, stride: told } = this.#buffers.view(of.bufferView);
    const row = width * components[type];
    const stride = told ?? row;
    const start = countOf(of, 'byteOffset', what, 0);
    const end = count === 0 ? start : start + stride * (count - 1) + row;
    if (stride < row || end > bytes.length) {
      throw badFile(
        `${what} declares ${counted(count)} rows, up to byte ${counted(end)} of a buffer view of ${counted(bytes.length)} bytes`,
      );
    }
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    return { view, at: start, stride, type: componentType };
  }
}

/** The number of bytes of a number of this type. Throws if the type is unknown. */
function checkType(componentType: number, what: string): number {
  const bytes = componentBytes.get(componentType);
  if (bytes === undefined) throw badFile(`${what} has numbers of no type that is known`);
  return bytes;
}

/** Rows of numbers, one after the other. */
function rowsOf(bytes: Uint8Array, type: number, size: number): Rows {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  return { view, at: 0, stride: size * componentBytes.get(type)!, type };
}

function checkCounting(componentType: unknown, what: string): void {
  if (counting.includes(componentType)) return;
  throw badFile(`${what} has numbers that are no indices: these must be whole and at least 0`);
}

function fill(values: Float64Array, { view, at, stride, type }: Rows, row: number): void {
  let place = at + stride * row;
  const bytes = componentBytes.get(type)!;
  for (let i = 0; i < values.length; i++, place += bytes) {
    switch (type) {
      case 5126:
        values[i] = view.getFloat32(place, true);
        break;
      case 5125:
        values[i] = view.getUint32(place, true);
        break;
      case 5123:
        values[i] = view.getUint16(place, true);
        break;
      case 5122:
        values[i] = view.getInt16(place, true);
        break;
      case 5121:
        values[i] = view.getUint8(place);
        break;
      case 5120:
        values[i] = view.getInt8(place);
        break;
    }
  }
}
