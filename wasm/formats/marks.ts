import type { FileMarks, FilePart } from '../types.js';

/** The marks of a file that contains only the surface. */
export const noMarks = { partOf: null, materials: [], materialOf: null, colors: null };

/**
 * The part of each triangle; null if the file has only one part. The triangles of the wanted parts
 * must follow one another, part by part.
 */
export function partOfEach(
  parts: readonly FilePart[],
  wanted: (part: number) => boolean,
): Int32Array | null {
  if (parts.length < 2) return null;
  const counts = parts.map(({ triangles }, part) => (wanted(part) ? triangles : 0));
  const partOf = new Int32Array(counts.reduce((sum, count) => sum + count, 0));
  let end = 0;
  for (const [part, count] of counts.entries()) {
    partOf.fill(part, end, end + count);
    end += count;
  }
  return partOf;
}

/** The material of each triangle's part; -1 for none. */
export function materialsOf(
  names: string[],
  ofParts: readonly number[],
  partOf: Int32Array | null,
  triangles: number,
): Pick<FileMarks, 'materials' | 'materialOf'> {
  if (ofParts.every((material) => material < 0)) return { materials: [], materialOf: null };
  const materialOf =
    partOf?.map((part) => ofParts[part]!) ?? new Int32Array(triangles).fill(ofParts[0]!);
  return { materials: names, materialOf };
}

/** A number from 0 to 1 as a byte; NaN becomes 0. */
export const colorByte = (value: number) => Math.round(255 * Math.min(1, Math.max(0, value || 0)));

/** The sRGB value of a linear value of glTF. Other formats and screens use sRGB. */
export const encodedLight = (light: number) =>
  light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;

/** The inverse of `encodedLight`. */
export const linearLight = (value: number) =>
  value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
