/** The sorting of files that the user dropped or chose together. */

import { formatInteger } from './panels/elements';

/** Files that belong to surfaces and do not open by themselves: materials, buffers and pictures. */
const companions = /\.(mtl|bin|png|jpe?g|webp|ktx2|basis|tga|bmp|gif|tiff?|dds|hdr|exr)$/i;
const openable = /\.(obj|ply|stl|off|glb|gltf|json)$/i;
const drawing = /\.json$/i;

/** Files that the user dropped or chose together. */
export interface SortedFiles {
  /** Files of surfaces. */
  surfaces: File[];
  drawings: File[];
  /** Files that are neither surfaces nor drawings, and belong to no surface. */
  unknown: File[];
}

export function sorted(files: readonly File[]): SortedFiles {
  const known = files.filter(({ name }) => openable.test(name));
  const others = files.filter(({ name }) => !openable.test(name));
  const surfaces = known.filter(({ name }) => !drawing.test(name));
  const drawings = known.filter(({ name }) => drawing.test(name));
  // If no ending is known, the content of the first file may still show its format.
  if (known.length === 0)
    return { surfaces: others.slice(0, 1), drawings, unknown: others.slice(1) };
  return { surfaces, drawings, unknown: others.filter(({ name }) => !companions.test(name)) };
}

/** A sentence about files that the page neither opens nor needs for the opened one. */
export function sentenceOfUnknown([first, second, ...more]: readonly File[]): string {
  if (!second) return `${first!.name} is no surface or drawing, and is left out.`;
  const others = more.length > 0 ? `${formatInteger(1 + more.length)} more` : second.name;
  return `${first!.name} and ${others} are no surfaces or drawings, and are left out.`;
}

const lastPart = (path: string) => path.replace(/^.*[\\/]/, '').toLowerCase();

function asAddress(file: File): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result as string);
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file);
  });
}

/**
 * A textual glTF file with its buffers embedded, so that it is a single file; any other file is
 * unchanged. The reader reports missing buffers and invalid files.
 */
export async function whole(file: File, together: readonly File[]): Promise<File> {
  if (!/\.gltf$/i.test(file.name) || together.length < 2) return file;
  const { namesBeside } = await import('karcher/formats');
  const bytes = new Uint8Array(await file.arrayBuffer());
  let names: string[];
  try {
    names = namesBeside(bytes, file.name);
  } catch {
    return file;
  }
  const found = new Map<string, string>();
  for (const name of names) {
    const buffer = together.find((one) => lastPart(one.name) === lastPart(name));
    if (buffer) found.set(lastPart(name), await asAddress(buffer));
  }
  if (found.size === 0) return file;
  const gltf = JSON.parse(new TextDecoder().decode(bytes));
  for (const buffer of gltf.buffers) {
    const inside = typeof buffer?.uri === 'string' && found.get(lastPart(decoded(buffer.uri)));
    if (inside) buffer.uri = inside;
  }
  return new File([JSON.stringify(gltf)], file.name);
}

function decoded(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}
