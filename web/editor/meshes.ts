import type { Shape } from 'karcher';

/** Where a surface comes from. */
export type MeshSource =
  | { kind: 'bunny'; levels: number }
  | { kind: 'shape'; name: Shape; triangles: number }
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

/** A surface's key: `bunny:levels`, `shape:triangles` or `file:digest:name`. */
export const defaultMesh = 'bunny:1';

const mostTriangles = 2_000_000;

export function parseKey(
  key: string,
): { sample: Sample; detail: number } | { digest: string; name: string } | null {
  const [id, value, ...rest] = key.split(':');
  if (id === 'file' && value) return { digest: value, name: rest.join(':') || 'file' };
  const sample = samples.find((one) => one.id === id);
  const detail = Number(value);
  if (!sample || !value || !Number.isInteger(detail) || detail < 0) return null;
  const most = sample.id === 'bunny' ? 4 : mostTriangles;
  return detail <= most ? { sample, detail } : null;
}

export function sampleSource(sample: Sample, detail: number): MeshSource {
  return sample.id === 'bunny'
    ? { kind: 'bunny', levels: detail }
    : { kind: 'shape', name: sample.id, triangles: detail };
}

/** Whether two keys show one surface, at perhaps different details. */
export function sameSurface(a: string, b: string): boolean {
  return !a.startsWith('file:') && a.split(':')[0] === b.split(':')[0];
}

export function meshLabel(key: string): string {
  const parsed = parseKey(key);
  if (!parsed) return key;
  return 'sample' in parsed ? parsed.sample.label : parsed.name;
}

/** Tells files apart (FNV-1a); `crypto.subtle` is missing on plain http. */
export function fileKey(name: string, bytes: Uint8Array): string {
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
  return `file:${(hash >>> 0).toString(36)}-${bytes.length.toString(36)}:${name}`;
}
