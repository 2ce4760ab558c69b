import type { Shape } from 'karcher';

export const tessellations = ['delaunay', 'grid', 'anisotropic'] as const;

/** How a plane is cut into triangles. */
export type Tessellation = (typeof tessellations)[number];

export type SampleSource =
  | { kind: 'bunny'; levels: number }
  | { kind: 'shape'; name: Shape; triangles: number };

/**
 * A surface that is made where it is asked for (made_mesh.ts). `triangles` is about how many; a plane
 * is the unit square in z = 0.
 */
export type MadeSource =
  | SampleSource
  | { kind: 'plane'; tessellation: Tessellation; triangles: number }
  | { kind: 'simplified'; of: MadeSource; triangles: number };

/** Where a surface comes from. */
export type MeshSource =
  | MadeSource
  | { kind: 'file'; bytes: Uint8Array }
  | { kind: 'arrays'; positions: Float64Array; triangles: Int32Array };

export interface Sample {
  id: 'bunny' | Shape;
  label: string;
  /** What the levels of detail mean: Loop subdivisions of the bunny, triangles of a shape. */
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
 * `simplified:triangles:` and the key of what is simplified, or `file:digest:name`.
 */
export const defaultMesh = 'bunny:1';

/** Of the surfaces that are made; shapes are made by the engine, which has the same limit. */
const mostTriangles = 1_000_000;

/** A sample has a menu of details; other surfaces that are made have none. */
export type ParsedKey =
  | { sample: Sample; detail: number }
  | { made: MadeSource }
  | { digest: string; name: string };

export function parseKey(key: string): ParsedKey | null {
  const [id, value, ...rest] = key.split(':');
  if (id === 'file' && value) return { digest: value, name: rest.join(':') || 'file' };
  if (id === 'plane') {
    const tessellation = tessellations.find((one) => one === value);
    const triangles = countOf(rest.join(':'), mostTriangles);
    return tessellation && triangles ? { made: { kind: 'plane', tessellation, triangles } } : null;
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

function countOf(text: string | undefined, most: number): number | null {
  const count = Number(text);
  return text && Number.isInteger(count) && count >= 0 && count <= most ? count : null;
}

/** How the surface of a key is made; null where it comes from a file, or the key says nothing. */
export function madeSource(key: string): MadeSource | null {
  const parsed = parseKey(key);
  if (!parsed) return null;
  if ('sample' in parsed) return sampleSource(parsed.sample, parsed.detail);
  return 'made' in parsed ? parsed.made : null;
}

/** The key of a surface that is made. */
export function madeKey(source: MadeSource): string {
  switch (source.kind) {
    case 'bunny':
      return `bunny:${source.levels}`;
    case 'shape':
      return `${source.name}:${source.triangles}`;
    case 'plane':
      return `plane:${source.tessellation}:${source.triangles}`;
    case 'simplified':
      return `simplified:${source.triangles}:${madeKey(source.of)}`;
  }
}

/** What a person calls it. */
export function madeName(source: MadeSource): string {
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

/** Whether two keys show one sample, at perhaps different details. */
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

/** Tells files apart (FNV-1a); `crypto.subtle` is missing on plain http. */
export function fileKey(name: string, bytes: Uint8Array): string {
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
  return `file:${(hash >>> 0).toString(36)}-${bytes.length.toString(36)}:${name}`;
}
