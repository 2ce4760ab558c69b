import { shown } from '../check.js';
import { KarcherError } from '../errors.js';
import { batchMask, Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { badFile, counted } from './failures.js';
import { gltfContent } from './glb.js';
import {
  type Accessor,
  Accessors,
  buffersBeside,
  countOf,
  entryOf,
  listOf,
  objectOf,
} from './gltf_accessors.js';
import { GrowingInts } from './growing.js';
import type { Polygons } from './types.js';

type Json = Readonly<Record<string, unknown>>;
/** A matrix's 16 numbers, column by column. */
type Matrix = readonly number[];

/** Instances may repeat a mesh: so many triangles, and no more, are made of a file. */
const mostTriangles = 50_000_000;

const identity: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Extensions that change nothing of where triangles are. */
const harmless = /^(KHR_(materials|texture|lights|mesh_quantization|xmp)|EXT_texture|MSFT_texture)/;

/** How a compressed file is named to a person. */
const compressions: Readonly<Record<string, string>> = {
  KHR_draco_mesh_compression: 'Draco',
  EXT_meshopt_compression: 'meshoptimizer',
};

const modes = ['points', 'lines', 'lines', 'lines', 'triangles', 'strip', 'fan'] as const;

/** Files that a glTF file's buffers are in, by names relative to its own. Throws badFile. */
export const gltfBeside = (bytes: Uint8Array) => buffersBeside(gltfContent(bytes).json);

/**
 * Reads the triangles of a glTF 2 file's scene, GLB or text with its buffers beside it, where its nodes
 * put them. Each primitive of a node's mesh is a part. Skins and morph targets stay at rest.
 *
 * Rejects with `KarcherError` badFile or badIndex, or the signal's reason.
 */
export async function readGltf(
  bytes: Uint8Array,
  wanted: (part: number) => boolean,
  beside: Readonly<Record<string, Uint8Array>>,
  work: LongWorkOptions,
): Promise<Polygons> {
  const accessors = new Accessors(gltfContent(bytes), beside);
  const { json } = accessors;
  checkVersion(json);
  const { strips, notRead } = primitivesOf(accessors);
  if (strips.length === 0) throw badFile('the glTF file has no triangles in its scene');
  const chosen = strips.filter((_, part) => wanted(part));
  const triangles = chosen.reduce((sum, strip) => sum + strip.triangles, 0);
  const vertices = chosen.reduce((sum, { places }) => sum + places.count, 0);
  if (triangles > mostTriangles || vertices > 3 * mostTriangles) {
    throw badFile(
      `the glTF file makes ${counted(triangles)} triangles of ${counted(vertices)} vertices; up to ${counted(mostTriangles)} are made`,
    );
  }
  const scene = new Scene(new Slices(work, 'reading'), triangles);
  for (const strip of chosen) await scene.add(strip);
  const parts = strips.map((strip) => ({ name: strip.name, triangles: strip.triangles }));
  const info = { format: 'gltf', parts, notRead } as const;
  return { positions: scene.positions, corners: scene.corners, sizes: null, info };
}

/** Triangles of a primitive, where a node puts them. */
interface Strip {
  name: string;
  node: object;
  matrix: Matrix;
  mode: 'triangles' | 'strip' | 'fan';
  position: unknown;
  places: Accessor;
  /** Numbers of its vertices; null where they are taken one after the other. */
  indices: Accessor | null;
  triangles: number;
}

/** What the scene has of triangles, and sentences about what else it has. */
function primitivesOf(accessors: Accessors): { strips: Strip[]; notRead: string[] } {
  const { json } = accessors;
  const strips: Strip[] = [];
  const others = { points: 0, lines: 0, morphed: 0 };
  for (const node of placedMeshes(json)) {
    const primitives = listOf(node.mesh, 'primitives');
    for (const i of primitives.keys()) {
      const primitive = entryOf(node.mesh, 'primitives', i);
      const mode = modes[countOf(primitive, 'mode', 'a primitive of the glTF file', 4)];
      if (mode === undefined) throw badFile('a primitive of the glTF file has a mode above 6');
      if (mode === 'points' || mode === 'lines') {
        others[mode]++;
        continue;
      }
      if (listOf(primitive, 'targets').length > 0) others.morphed++;
      const position = objectOf(primitive, 'attributes').POSITION;
      const places = accessors.accessor(position, 'VEC3');
      const indices =
        primitive.indices === undefined ? null : accessors.accessor(primitive.indices, 'SCALAR');
      const count = indices?.count ?? places.count;
      const triangles = mode === 'triangles' ? Math.floor(count / 3) : Math.max(0, count - 2);
      const name = primitives.length > 1 ? `${node.name}, ${i + 1}` : node.name;
      const { matrix } = node;
      strips.push({ name, node, matrix, mode, position, places, indices, triangles });
    }
  }
  const notRead = [
    ...(others.points > 0 ? [`${counted(others.points)} sets of points were left out.`] : []),
    ...(others.lines > 0 ? [`${counted(others.lines)} sets of lines were left out.`] : []),
    ...(others.morphed > 0 ? ['Morph targets are at rest.'] : []),
    ...(listOf(json, 'skins').length > 0 ? ['Skins are at rest.'] : []),
  ];
  return { strips: strips.filter(({ triangles }) => triangles > 0), notRead };
}

function checkVersion(json: Json): void {
  const { version } = objectOf(json, 'asset');
  if (typeof version !== 'string' || !version.startsWith('2.')) {
    const told = typeof version === 'string' ? `version ${version.slice(0, 20)}` : 'no version';
    throw badFile(`the file is glTF of ${told}; version 2 is read`);
  }
  for (const name of listOf(json, 'extensionsRequired')) {
    if (typeof name === 'string' && harmless.test(name)) continue;
    const compression = typeof name === 'string' ? compressions[name] : undefined;
    throw badFile(
      compression
        ? `the glTF file is compressed by ${compression}, which is not read: save it uncompressed`
        : `the glTF file needs the extension ${shown(name)}, which is not read`,
    );
  }
}

interface PlacedMesh {
  mesh: Json;
  matrix: Matrix;
  name: string;
}

/** The meshes of the scene's nodes. Throws where nodes are no tree. */
function placedMeshes(json: Json): PlacedMesh[] {
  const nodes = listOf(json, 'nodes');
  const scenes = listOf(json, 'scenes');
  const roots =
    scenes.length > 0
      ? listOf(entryOf(json, 'scenes', json.scene ?? 0), 'nodes')
      : rootsOf(json, nodes);
  const placed: PlacedMesh[] = [];
  const seen = new Set<unknown>();
  const waiting = roots.map((node) => ({ node, matrix: identity })).reverse();
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const node = entryOf(json, 'nodes', next.node);
    if (seen.has(next.node)) {
      throw badFile(`node ${next.node} of the glTF file is there twice: nodes must be a tree`);
    }
    seen.add(next.node);
    const matrix = product(next.matrix, matrixOf(node));
    if (node.mesh !== undefined) {
      const mesh = entryOf(json, 'meshes', node.mesh);
      const name = [node.name, mesh.name].find((one) => typeof one === 'string' && one !== '');
      placed.push({ mesh, matrix, name: (name as string | undefined) ?? `mesh ${node.mesh}` });
    }
    const children = listOf(node, 'children').map((child) => ({ node: child, matrix }));
    waiting.push(...children.reverse());
  }
  return placed;
}

/** Nodes that are no other's children. */
function rootsOf(json: Json, nodes: readonly unknown[]): number[] {
  const children = new Set(nodes.flatMap((_, i) => listOf(entryOf(json, 'nodes', i), 'children')));
  return nodes.map((_, i) => i).filter((i) => !children.has(i));
}

function numbersOf(json: Json, name: string, otherwise: readonly number[]): readonly number[] {
  const list = json[name] ?? otherwise;
  const good = Array.isArray(list) && list.length === otherwise.length;
  if (good && list.every((one) => typeof one === 'number' && Number.isFinite(one))) return list;
  throw badFile(`a node's ${name} in the glTF file must be ${otherwise.length} numbers`);
}

const placing = ['matrix', 'translation', 'rotation', 'scale'];

function matrixOf(node: Json): Matrix {
  if (placing.every((name) => node[name] === undefined)) return identity;
  if (node.matrix !== undefined) return numbersOf(node, 'matrix', identity);
  const [tx, ty, tz] = numbersOf(node, 'translation', [0, 0, 0]) as [number, number, number];
  const [x, y, z, w] = numbersOf(node, 'rotation', [0, 0, 0, 1]) as [
    number,
    number,
    number,
    number,
  ];
  const [sx, sy, sz] = numbersOf(node, 'scale', [1, 1, 1]) as [number, number, number];
  return [
    ...[(1 - 2 * (y * y + z * z)) * sx, 2 * (x * y + z * w) * sx, 2 * (x * z - y * w) * sx, 0],
    ...[2 * (x * y - z * w) * sy, (1 - 2 * (x * x + z * z)) * sy, 2 * (y * z + x * w) * sy, 0],
    ...[2 * (x * z + y * w) * sz, 2 * (y * z - x * w) * sz, (1 - 2 * (x * x + y * y)) * sz, 0],
    ...[tx, ty, tz, 1],
  ];
}

function product(a: Matrix, b: Matrix): Matrix {
  if (b === identity) return a;
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, 4 * Math.floor(i / 4)];
    return [0, 1, 2, 3].reduce((sum, k) => sum + a[row + 4 * k]! * b[column + k]!, 0);
  });
}

/** Whether a matrix turns what it maps inside out. */
function mirrors([a, b, c, , d, e, f, , g, h, i]: Matrix): boolean {
  return a! * (e! * i! - f! * h!) - d! * (b! * i! - c! * h!) + g! * (b! * f! - c! * e!) < 0;
}

/** Vertices and triangles as nodes put them. */
class Scene {
  readonly #slices: Slices;
  readonly #whole: number;
  readonly #corners = new GrowingInts();
  readonly #chunks: Float64Array[] = [];
  /** Where the vertices of accessors begin, of the last node: its primitives share them. */
  #starts = new Map<unknown, number>();
  #node: object | null = null;
  #vertices = 0;

  constructor(slices: Slices, triangles: number) {
    this.#slices = slices;
    this.#whole = 3 * triangles;
  }

  get positions(): Float64Array {
    const positions = new Float64Array(3 * this.#vertices);
    let at = 0;
    for (const chunk of this.#chunks) {
      positions.set(chunk, at);
      at += chunk.length;
    }
    return positions;
  }

  get corners(): Int32Array {
    return this.#corners.values;
  }

  async add(strip: Strip): Promise<void> {
    const { name, mode, places, indices, triangles } = strip;
    const vertices = places.count;
    const start = await this.#start(strip);
    const turned = mirrors(strip.matrix);
    const index = new Float64Array(1);
    let [first, second] = [0, 0];
    const rows = mode === 'triangles' ? 3 * triangles : triangles + 2;
    for (let row = 0; row < rows; row++) {
      if ((row & batchMask) === 0 && this.#slices.over) await this.#rest();
      indices?.fill(row, index);
      const vertex = indices ? index[0]! : row;
      if (!(vertex < vertices)) {
        throw new KarcherError(
          'badIndex',
          `'${name}', corner ${row}: a triangle uses vertex ${vertex}, but there are ${counted(vertices)}`,
        );
      }
      const corner = mode === 'triangles' ? row % 3 : Math.min(row, 2);
      if (corner === 0) first = vertex;
      else if (corner === 1) second = vertex;
      else {
        // In a strip every other triangle is turned over.
        const over = (mode === 'strip' && row % 2 === 1) !== turned;
        const [b, c] = over ? [vertex, second] : [second, vertex];
        this.#corners.push(start + first);
        this.#corners.push(start + b);
        this.#corners.push(start + c);
        if (mode === 'strip') first = second;
        if (mode !== 'triangles') second = vertex;
      }
    }
  }

  async #start({ node, position, places, matrix }: Strip): Promise<number> {
    if (node !== this.#node) this.#starts = new Map();
    this.#node = node;
    const known = this.#starts.get(position);
    if (known !== undefined) return known;
    const start = this.#vertices;
    const { count } = places;
    const chunk = new Float64Array(3 * count);
    const place = new Float64Array(3);
    for (let row = 0; row < count; row++) {
      if ((row & batchMask) === 0 && this.#slices.over) await this.#rest();
      places.fill(row, place);
      const [x, y, z] = [place[0]!, place[1]!, place[2]!];
      for (let axis = 0; axis < 3; axis++) {
        chunk[3 * row + axis] =
          matrix[axis]! * x + matrix[4 + axis]! * y + matrix[8 + axis]! * z + matrix[12 + axis]!;
      }
    }
    this.#chunks.push(chunk);
    this.#vertices += count;
    this.#starts.set(position, start);
    return start;
  }

  #rest(): Promise<void> {
    return this.#slices.rest(this.#corners.length / this.#whole);
  }
}
