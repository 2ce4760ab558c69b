import { shown } from '../check.js';
import { KarcherError } from '../errors.js';
import { checkMeshFits } from '../room.js';
import { batchMask, Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { badFile, counted } from './failures.js';
import { gltfContent } from './glb.js';
import { type Accessor, Accessors } from './gltf_accessors.js';
import { buffersBeside } from './gltf_buffers.js';
import { compressions, decodersFor, dracoOf } from './gltf_decoders.js';
import { countOf, entryOf, isJson, type Json, listOf, objectOf } from './gltf_json.js';
import { colorByte, encodedLight, materialsOf, partOfEach } from './marks.js';
import type { FilePart, Polygons } from './types.js';

/** A matrix's 16 numbers, column by column. */
type Matrix = readonly number[];

/**
 * The largest number of parts of a file. A small file may have many parts, since instances repeat a
 * mesh.
 */
const mostParts = 250_000;

const identity: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Extensions that do not affect the places of triangles. */
const harmless =
  /^(KHR_(materials|texture|lights|mesh_quantization|xmp)|EXT_(texture|mesh_gpu_instancing)|MSFT_texture)/;

const modes = ['points', 'lines', 'lines', 'lines', 'triangles', 'strip', 'fan'] as const;

/**
 * The names of the files that contain a glTF file's buffers, relative to the glTF file. Throws
 * badFile.
 */
export const gltfBeside = (bytes: Uint8Array) => buffersBeside(gltfContent(bytes).json);

/**
 * Reads the triangles of a glTF 2 file's scene, at the places where its nodes put them. The file is
 * GLB, or text with its buffers beside it. Each primitive of a node's mesh is a part. Skins and
 * morph targets stay at rest. Draco or meshoptimizer may have compressed the data. Rejects with
 * `KarcherError` badFile, badIndex or notLoaded, or the signal's reason.
 */
export async function readGltf(
  bytes: Uint8Array,
  wanted: (part: number) => boolean,
  beside: Readonly<Record<string, Uint8Array>>,
  work: LongWorkOptions,
): Promise<Polygons> {
  const content = gltfContent(bytes);
  const { json } = content;
  if (!isJson(json)) throw badFile("the glTF file's JSON is no object");
  checkVersion(json);
  const accessors = new Accessors(json, content, beside, await decodersFor(json));
  const slices = new Slices(work, 'reading');
  const { parts, materials, chosen, notRead } = await stripsOf(accessors, wanted, slices);
  if (parts.length === 0) throw badFile('the glTF file has no triangles in its scene');
  const scene = new Scene(slices, chosen);
  for (const strip of chosen) await scene.add(strip);
  const partOf = partOfEach(parts, wanted);
  const { colors } = scene;
  const marks = {
    partOf,
    colors,
    ...materialsOf(materialNames(json), materials, partOf, scene.corners.length / 3),
  };
  const info = { format: 'gltf', parts, notRead, ...marks } as const;
  return { positions: scene.positions, corners: scene.corners, sizes: null, info };
}

/** The vertices of those primitives of a mesh that have the same places and the same colors. */
interface Vertices {
  places: Accessor;
  colors: Accessor | null;
}

/** A primitive that has triangles. All nodes that place its mesh share it. */
interface Primitive {
  mode: 'triangles' | 'strip' | 'fan';
  vertices: Vertices;
  /** The vertex numbers that form the triangles; null if they are 0, 1, 2, and so on. */
  indices: Accessor | null;
  triangles: number;
  /** The number of the primitive's material, -1 for none. */
  material: number;
  /**
   * The end of the part's name: a comma and the primitive's number in the mesh, from 1. It is empty
   * if the mesh has only one primitive.
   */
  number: string;
}

/** A primitive with the transform of a node. */
interface Strip {
  name: string;
  node: PlacedMesh;
  primitive: Primitive;
}

/**
 * A mesh's primitives that have triangles, and counts of what is not read: sets of points, sets of
 * lines, and morphs.
 */
interface Primitives {
  triangles: Primitive[];
  points: number;
  lines: number;
  morphed: number;
}

/**
 * All parts of the scene with their materials, the strips of the wanted parts, and sentences about
 * content that is not read.
 */
async function stripsOf(
  accessors: Accessors,
  wanted: (part: number) => boolean,
  slices: Slices,
): Promise<{ parts: FilePart[]; materials: number[]; chosen: Strip[]; notRead: string[] }> {
  const { json } = accessors;
  const nodes = placedMeshes(accessors);
  const meshes = new Map<Json, Primitives>();
  const others = { points: 0, lines: 0, morphed: 0 };
  let count = 0;
  for (const { mesh } of nodes) {
    const known = meshes.get(mesh) ?? (await primitivesOf(mesh, accessors, slices));
    meshes.set(mesh, known);
    count += known.triangles.length;
    others.points += known.points;
    others.lines += known.lines;
    others.morphed += known.morphed;
  }
  if (count > mostParts) {
    throw badFile(
      `the glTF file's nodes place ${counted(count)} parts; up to ${counted(mostParts)} are read`,
    );
  }
  const parts: FilePart[] = [];
  const materials: number[] = [];
  const chosen: Strip[] = [];
  for (const node of nodes) {
    for (const primitive of meshes.get(node.mesh)!.triangles) {
      const name = node.name + primitive.number;
      if (wanted(parts.length)) chosen.push({ name, node, primitive });
      parts.push({ name, triangles: primitive.triangles });
      materials.push(primitive.material);
    }
  }
  const notRead = [
    ...(others.points > 0 ? [`${counted(others.points)} sets of points were left out.`] : []),
    ...(others.lines > 0 ? [`${counted(others.lines)} sets of lines were left out.`] : []),
    ...(others.morphed > 0 ? ['Morph targets are at rest.'] : []),
    ...(listOf(json, 'skins').length > 0 ? ['Skins are at rest.'] : []),
  ];
  return { parts, materials, chosen, notRead };
}

async function primitivesOf(mesh: Json, accessors: Accessors, slices: Slices): Promise<Primitives> {
  const found: Primitives = { triangles: [], points: 0, lines: 0, morphed: 0 };
  const primitives = listOf(mesh, 'primitives');
  const known = new Map<Accessor, Map<Accessor | null, Vertices>>();
  for (const i of primitives.keys()) {
    if (slices.over) await slices.rest(0);
    const primitive = entryOf(mesh, 'primitives', i);
    const kind = modes[countOf(primitive, 'mode', 'a primitive of the glTF file', 4)];
    if (kind === undefined) throw badFile('a primitive of the glTF file has a mode above 6');
    if (kind === 'points' || kind === 'lines') {
      found[kind]++;
      continue;
    }
    // Draco data has only triangles, whatever the mode of the primitive is.
    const mode = dracoOf(primitive) ? 'triangles' : kind;
    if (listOf(primitive, 'targets').length > 0) found.morphed++;
    const { places, indices } = accessors.ofPrimitive(primitive);
    const count = indices?.count ?? places.count;
    const triangles = mode === 'triangles' ? Math.floor(count / 3) : Math.max(0, count - 2);
    if (triangles === 0) continue;
    const number = primitives.length > 1 ? `, ${i + 1}` : '';
    const colors = accessors.colorsOf(primitive);
    const told = typeof primitive.material === 'number' ? primitive.material : -1;
    const material = told in listOf(accessors.json, 'materials') ? told : -1;
    const byColors = known.get(places) ?? new Map<Accessor | null, Vertices>();
    const vertices = byColors.get(colors) ?? { places, colors };
    known.set(places, byColors.set(colors, vertices));
    found.triangles.push({ mode, vertices, indices, triangles, number, material });
  }
  return found;
}

function materialNames(json: Json): string[] {
  return listOf(json, 'materials').map((material, i) => {
    const { name } = isJson(material) ? material : {};
    return typeof name === 'string' && name !== '' ? name : `material ${i}`;
  });
}

function checkVersion(json: Json): void {
  const { version } = objectOf(json, 'asset');
  if (typeof version !== 'string' || !version.startsWith('2.')) {
    const told = typeof version === 'string' ? `version ${version.slice(0, 20)}` : 'no version';
    throw badFile(`the file is glTF of ${told}; version 2 is read`);
  }
  for (const name of listOf(json, 'extensionsRequired')) {
    if (compressions.includes(name)) continue;
    if (typeof name === 'string' && harmless.test(name)) continue;
    if (typeof name !== 'string') {
      throw badFile("the glTF file's 'extensionsRequired' has an entry that is no name");
    }
    throw badFile(`the glTF file needs the extension ${shown(name)}, which is not read`);
  }
}

interface PlacedMesh {
  mesh: Json;
  matrix: Matrix;
  name: string;
}

/** The meshes of the scene's nodes. Throws if the nodes are no tree. */
function placedMeshes(accessors: Accessors): PlacedMesh[] {
  const { json } = accessors;
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
      const told = (name as string | undefined) ?? `mesh ${node.mesh}`;
      // In glTF the joints of a skin place its mesh; the node does not.
      const place = node.skin === undefined ? matrix : identity;
      addInstances({ mesh, matrix: place, name: told }, node, accessors, placed);
    }
    const children = listOf(node, 'children');
    for (let i = children.length - 1; i >= 0; i--) waiting.push({ node: children[i], matrix });
  }
  return placed;
}

/** Adds a node's mesh once, or once for each of its instances (EXT_mesh_gpu_instancing). */
function addInstances(mesh: PlacedMesh, node: Json, accessors: Accessors, placed: PlacedMesh[]) {
  const extensions = objectOf(node, 'extensions');
  if (extensions.EXT_mesh_gpu_instancing === undefined) {
    placed.push(mesh);
    return;
  }
  const attributes = objectOf(objectOf(extensions, 'EXT_mesh_gpu_instancing'), 'attributes');
  const rows = {
    TRANSLATION: new Float64Array(3),
    ROTATION: new Float64Array(4),
    SCALE: new Float64Array(3),
  };
  const given = (Object.keys(rows) as (keyof typeof rows)[])
    .filter((name) => attributes[name] !== undefined)
    .map((name) => ({
      name: name.toLowerCase(),
      row: rows[name],
      accessor: accessors.vectors(attributes[name], rows[name].length as 3 | 4),
    }));
  const counts = given.map(({ accessor }) => accessor.count);
  const count = counts[0] ?? 0;
  if (counts.some((other) => other !== count)) {
    throw badFile(`the instances of '${mesh.name}' have lists of ${counts.join(' and ')} rows`);
  }
  if (placed.length + count > mostParts) {
    throw badFile(
      `the glTF file's nodes place more than ${counted(mostParts)} parts; so many are read`,
    );
  }
  for (let i = 0; i < count; i++) {
    for (const { accessor, row } of given) accessor.fill(i, row);
    const place = Object.fromEntries(given.map(({ name, row }) => [name, [...row]]));
    const matrix = product(mesh.matrix, matrixOf(place));
    placed.push({ ...mesh, matrix, name: `${mesh.name}, instance ${i + 1}` });
  }
}

/** The nodes that are not children of others. */
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

/** Whether a matrix turns shapes inside out. */
function mirrors([a, b, c, , d, e, f, , g, h, i]: Matrix): boolean {
  return a! * (e! * i! - f! * h!) - d! * (b! * i! - c! * h!) + g! * (b! * f! - c! * e!) < 0;
}

/** Vertices and triangles at the places of nodes. */
class Scene {
  readonly #slices: Slices;
  readonly positions: Float64Array;
  readonly corners: Int32Array;
  /**
   * Three bytes for each vertex, white for primitives without colors; null if no primitive has
   * colors.
   */
  readonly colors: Uint8Array | null;
  #vertices = 0;
  #corner = 0;
  /**
   * The number of the first vertex in the scene, for all vertices of the last node. The node's
   * primitives share them.
   */
  #starts = new Map<Vertices, number>();
  #node: PlacedMesh | null = null;

  /** Reserves memory for all strips. Throws `KarcherError` outOfMemory if they do not fit. */
  constructor(slices: Slices, strips: readonly Strip[]) {
    this.#slices = slices;
    let [triangles, vertices] = [0, 0];
    const seen = new Set<Vertices>();
    for (const [i, { node, primitive }] of strips.entries()) {
      triangles += primitive.triangles;
      if (node !== strips[i - 1]?.node) seen.clear();
      if (!seen.has(primitive.vertices)) vertices += primitive.vertices.places.count;
      seen.add(primitive.vertices);
    }
    checkMeshFits(vertices, triangles, 'the glTF file makes');
    this.positions = new Float64Array(3 * vertices);
    this.corners = new Int32Array(3 * triangles);
    const isColored = strips.some(({ primitive }) => primitive.vertices.colors);
    this.colors = isColored ? new Uint8Array(3 * vertices).fill(255) : null;
  }

  async add({ name, node, primitive }: Strip): Promise<void> {
    const { mode, vertices, indices, triangles } = primitive;
    const { count } = vertices.places;
    const start = await this.#start(node, vertices);
    const turned = mirrors(node.matrix);
    const index = new Float64Array(1);
    const { corners } = this;
    let [first, second] = [0, 0];
    const rows = mode === 'triangles' ? 3 * triangles : triangles + 2;
    for (let row = 0; row < rows; row++) {
      if ((row & batchMask) === 0 && this.#slices.over) await this.#rest();
      indices?.fill(row, index);
      const vertex = indices ? index[0]! : row;
      if (!(vertex < count)) {
        throw new KarcherError(
          'badIndex',
          `'${name}', corner ${row}: a triangle uses vertex ${vertex}, but there are ${counted(count)}`,
        );
      }
      const corner = mode === 'triangles' ? row % 3 : Math.min(row, 2);
      if (corner === 0) first = vertex;
      else if (corner === 1) second = vertex;
      else {
        // In a strip every second triangle has the opposite orientation.
        const over = (mode === 'strip' && row % 2 === 1) !== turned;
        const [b, c] = over ? [vertex, second] : [second, vertex];
        corners[this.#corner++] = start + first;
        corners[this.#corner++] = start + b;
        corners[this.#corner++] = start + c;
        if (mode === 'strip') first = second;
        if (mode !== 'triangles') second = vertex;
      }
    }
  }

  /**
   * Adds the vertices of a node's primitive to the scene, unless an earlier primitive of the node
   * has added them. Returns the number of the first of these vertices.
   */
  async #start(node: PlacedMesh, vertices: Vertices): Promise<number> {
    if (node !== this.#node) this.#starts = new Map();
    this.#node = node;
    const known = this.#starts.get(vertices);
    if (known !== undefined) return known;
    const { places, colors } = vertices;
    const start = this.#vertices;
    const { matrix } = node;
    const { positions } = this;
    const place = new Float64Array(3);
    for (let row = 0; row < places.count; row++) {
      if ((row & batchMask) === 0 && this.#slices.over) await this.#rest();
      places.fill(row, place);
      const [x, y, z] = [place[0]!, place[1]!, place[2]!];
      for (let axis = 0; axis < 3; axis++) {
        positions[3 * (start + row) + axis] =
          matrix[axis]! * x + matrix[4 + axis]! * y + matrix[8 + axis]! * z + matrix[12 + axis]!;
      }
    }
    const light = new Float64Array(3);
    for (let row = 0; colors && row < Math.min(colors.count, places.count); row++) {
      colors.fill(row, light);
      for (let k = 0; k < 3; k++) {
        this.colors![3 * (start + row) + k] = colorByte(encodedLight(light[k]!));
      }
    }
    this.#vertices += places.count;
    this.#starts.set(vertices, start);
    return start;
  }

  #rest(): Promise<void> {
    return this.#slices.rest(this.#corner / this.corners.length);
  }
}
