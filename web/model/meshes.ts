import type { Shape } from 'karcher';
import type { UpAxis as Axis } from 'karcher/formats';
import type { MeshBlobs } from './mesh_blobs';

/** The direction of a file's coordinates that points up: an axis, or the opposite of one. */
export type UpAxis = Axis | `-${Axis}`;

const tessellations = ['fair', 'delaunay', 'grid', 'anisotropic'] as const;

/** The default ratio of length to height for the cells of an anisotropic plane. */
export const usualStretch = 20;

/** The ways to divide a plane into triangles. */
export type Tessellation = (typeof tessellations)[number];

export type SampleSource =
  | { kind: 'bunny'; levels: number }
  | { kind: 'shape'; name: Shape; triangles: number };

/**
 * A generated surface (made_mesh.ts) with about `triangles` triangles; a plane is the unit square
 * in z = 0. The cells of an anisotropic plane are `stretch` times as long as high: 1 to 50 times,
 * 20 by default.
 */
export type MadeSource =
  | SampleSource
  | { kind: 'plane'; tessellation: Tessellation; triangles: number; stretch?: number }
  | { kind: 'simplified'; of: MadeSource; triangles: number };

/** A file, and the indices of the parts to read; null for all. */
export interface FileSource {
  kind: 'file';
  content: Blob;
  name: string;
  parts: readonly number[] | null;
  weld: number | null;
}

/** The source of a surface. */
export type MeshSource = MadeSource | FileSource | { kind: 'arrays'; arrays: MeshBlobs };

export interface Sample {
  id: 'bunny' | Shape;
  label: string;
  /** The levels of detail: Loop subdivisions for the bunny, numbers of triangles for shapes. */
  details: readonly number[];
}

export const detailLabels = ['Coarse', 'Medium', 'Fine', 'Very fine'] as const;

const triangles = [5_000, 20_000, 80_000, 320_000];

export const samples: readonly Sample[] = [
  { id: 'bunny', label: 'Bunny', details: [0, 1, 2, 3] },
  { id: 'torus', label: 'Torus', details: triangles },
  { id: 'sphere', label: 'Sphere', details: triangles },
  { id: 'knot', label: 'Knotted tube', details: triangles },
  { id: 'genus3', label: 'Genus 3', details: triangles },
  { id: 'openSheet', label: 'Open sheet', details: triangles },
];

/**
 * A surface's key: `bunny:levels`, `shape:triangles`, `plane:tessellation:triangles`,
 * `plane:anisotropic*stretch:triangles`, `simplified:triangles:` with the key of the simplified
 * surface, or `file:digest:name`. A file's key has up to three options after the digest: the
 * indices of the parts to read, unless these are all; the tolerance of welding, unless it is the
 * default; and the axis that points up, unless it is the guessed one, with a sign if it points
 * down. An example is `file:digest.0.2*0.001~-z:name`.
 */
export const defaultMesh = 'bunny:1';

/**
 * The largest number of triangles of generated surfaces. The engine, which generates shapes, has
 * the same limit.
 */
const mostTriangles = 1_000_000;

/** Samples have a menu of details; other generated surfaces have none. */
export type ParsedKey =
  | { sample: Sample; detail: number }
  | { made: MadeSource }
  | ({ digest: string; name: string } & Reading);

/**
 * The options for reading a file: its parts (null for all), the tolerance for welding boundaries
 * (null for the default), and the axis that points up (null for a guess).
 */
export interface Reading {
  parts: readonly number[] | null;
  weld: number | null;
  up: UpAxis | null;
}

export function parseKey(key: string): ParsedKey | null {
  const [id, value, ...rest] = key.split(':');
  if (id === 'file' && value) return parseFileKey(value, rest.join(':') || 'file');
  if (id === 'plane') {
    const triangles = countOf(rest.join(':'), mostTriangles);
    const plane = parsePlane(value ?? '');
    return plane && triangles ? { made: { kind: 'plane', ...plane, triangles } } : null;
  }
  if (id === 'simplified') {
    const of = madeSource(rest.join(':'));
    const triangles = countOf(value, mostTriangles);
    return of && of.kind !== 'simplified' && triangles
      ? { made: { kind: 'simplified', of, triangles } }
      : null;
  }
  const sample = samples.find((one) => one.id === id);
  const detail = countOf(value, id === 'bunny' ? 4 : mostTriangles);
  return sample && detail !== null ? { sample, detail } : null;
}

/** A tessellation, with the stretch of an anisotropic one if the text contains it. */
function parsePlane(text: string): { tessellation: Tessellation; stretch?: number } | null {
  const [name, times, ...more] = text.split('*');
  const tessellation = tessellations.find((one) => one === name);
  if (!tessellation || more.length > 0) return null;
  if (times === undefined) return { tessellation };
  const stretch = countOf(times, 50);
  return tessellation === 'anisotropic' && stretch ? { tessellation, stretch } : null;
}

function countOf(text: string | undefined, most: number): number | null {
  const count = Number(text);
  return text && Number.isInteger(count) && count >= 0 && count <= most ? count : null;
}

/** The recipe of the surface with a key; null if the surface comes from a file or the key is unknown. */
export function madeSource(key: string): MadeSource | null {
  const parsed = parseKey(key);
  if (!parsed) return null;
  if ('sample' in parsed) return sampleSource(parsed.sample, parsed.detail);
  return 'made' in parsed ? parsed.made : null;
}

/** The key of a generated surface. */
export function madeKey(source: MadeSource): string {
  switch (source.kind) {
    case 'bunny':
      return `bunny:${source.levels}`;
    case 'shape':
      return `${source.name}:${source.triangles}`;
    case 'plane':
      return source.stretch === undefined
        ? `plane:${source.tessellation}:${source.triangles}`
        : `plane:${source.tessellation}*${source.stretch}:${source.triangles}`;
    case 'simplified':
      return `simplified:${source.triangles}:${madeKey(source.of)}`;
  }
}

/** The surface's name on the page. */
function madeName(source: MadeSource): string {
  switch (source.kind) {
    case 'plane':
      return `Plane, ${source.tessellation}`;
    case 'simplified':
      return `${madeName(source.of)}, simplified`;
    default: {
      const id = source.kind === 'bunny' ? 'bunny' : source.name;
      return samples.find((sample) => sample.id === id)!.label;
    }
  }
}

export function sampleSource(sample: Sample, detail: number): SampleSource {
  return sample.id === 'bunny'
    ? { kind: 'bunny', levels: detail }
    : { kind: 'shape', name: sample.id, triangles: detail };
}

/** Whether two keys name the same sample, possibly with different levels of detail. */
export function sameSurface(a: string, b: string): boolean {
  const [from, to] = [parseKey(a), parseKey(b)];
  return !!from && !!to && 'sample' in from && 'sample' in to && from.sample === to.sample;
}

export function meshLabel(key: string): string {
  const parsed = parseKey(key);
  if (!parsed) return key;
  if ('made' in parsed) return madeName(parsed.made);
  return 'sample' in parsed ? parsed.sample.label : parsed.name;
}

/** The number of bytes in one step of the hash, which takes a few milliseconds. */
const hashedAtOnce = 1 << 21;

/**
 * A digest that identifies a file (FNV-1a); `crypto.subtle` is missing on plain http. A large file
 * takes a while, so the file is read in slices and is never in memory as a whole.
 */
export async function fileKey(file: File): Promise<string> {
  let hash = 0x811c9dc5;
  for (let at = 0; at < file.size; at += hashedAtOnce) {
    const bytes = new Uint8Array(await file.slice(at, at + hashedAtOnce).arrayBuffer());
    for (let i = 0; i < bytes.length; i++) hash = Math.imul(hash ^ bytes[i]!, 0x01000193);
  }
  return `file:${(hash >>> 0).toString(36)}-${file.size.toString(36)}:${file.name}`;
}

function parseFileKey(text: string, name: string): ParsedKey {
  const [, digest, parts, weld, up] =
    /^([^.*~]+)((?:\.\d{1,9})*)(?:\*(\d[\de.-]*))?(?:~(-?[xyz]))?$/.exec(text) ?? [];
  const asUsual = { parts: null, weld: null, up: null };
  if (digest === undefined || !Number.isFinite(Number(weld ?? 0))) {
    return { digest: text, name, ...asUsual };
  }
  return {
    ...{ digest, name },
    parts: parts ? parts.slice(1).split('.').map(Number) : null,
    weld: weld === undefined ? null : Number(weld),
    up: (up as UpAxis | undefined) ?? null,
  };
}

/** The options that a key has for reading its file; null if it names no file. */
export function readingOf(key: string): Reading | null {
  const parsed = parseKey(key);
  if (!parsed || !('digest' in parsed)) return null;
  const { parts, weld, up } = parsed;
  return { parts, weld, up };
}

/** The key of the same file with other options for reading. */
export function readAs(key: string, reading: Partial<Reading>): string {
  const parsed = parseKey(key);
  if (!parsed || !('digest' in parsed)) return key;
  const { digest, name, parts, weld, up } = { ...parsed, ...reading };
  const numbers = (parts ?? []).map((part) => `.${part}`).join('');
  const welded = weld === null ? '' : `*${weld}`;
  return `file:${digest}${numbers}${welded}${up ? `~${up}` : ''}:${name}`;
}

/**
 * The key without the file's name, which the same content has under every name. Any other key is
 * unchanged.
 */
export const contentKey = (key: string) => key.replace(/^(file:[^:]*):.*$/s, '$1');

/** Whether two keys mean the same content that is read in the same way. */
export const sameContent = (a: string, b: string) => contentKey(a) === contentKey(b);

/** The key of a file without its options for reading; any other key is unchanged. */
export const keyOfFile = (key: string) => readAs(key, { parts: null, weld: null, up: null });

/**
 * The key of the drawings on a surface. Their points refer to the file's own triangles, whatever the
 * tolerance of welding is, and whatever points up.
 */
export const drawnKey = (key: string) => contentKey(readAs(key, { weld: null, up: null }));

/** A file with the parts and the welding tolerance of its key. */
export function fileSource(key: string, content: Blob): FileSource {
  const { parts = null, weld = null } = readingOf(key) ?? {};
  return { kind: 'file', content, name: meshLabel(key), parts, weld };
}
