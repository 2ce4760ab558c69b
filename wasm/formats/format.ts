import { badFile } from './failures.js';
import { isGlb } from './glb.js';
import { isOff } from './off.js';
import { isBinaryStl, isTextStl } from './stl.js';
import { startOf } from './text.js';
import type { MeshFormat } from './types.js';

/**
 * Beginnings of files that are not meshes of a supported format, each with the name of its kind of
 * file.
 */
const others: readonly (readonly [RegExp | string, string])[] = [
  [/^Kaydara FBX Binary/, 'an FBX file'],
  [/^; FBX/, 'an FBX file'],
  [/^BLENDER/, 'a Blender file'],
  [/^# vtk DataFile/, 'a VTK file'],
  [/^<VTKFile/, 'a VTK file'],
  [/^PXR-USDC|^#usda/, 'a USD file'],
  [/^DRACO/, 'a Draco file'],
  [/^#(VRML|X3D)/, 'a VRML file'],
  [/^ISO-10303-21/, 'a STEP file'],
  [/^MeshVersionFormatted/, 'a MEDIT file'],
  [/^\$MeshFormat/, 'a Gmsh file'],
  [/^<\?xml[\s\S]{0,400}<COLLADA/, 'a COLLADA file'],
  [/^<\?xml[\s\S]{0,400}<X3D/, 'an X3D file'],
  [/^<\?xml[\s\S]{0,400}<amf/, 'an AMF file'],
  [/^(<!doctype html|<html)/i, 'a web page'],
  [/^<svg|^<\?xml[\s\S]{0,400}<svg/, 'an SVG drawing'],
  [/^<\?xml/, 'an XML file'],
  ['PK\x03\x04', 'a ZIP archive (as 3MF, USDZ and KMZ files are)'],
  ['\x1f\x8b', 'compressed by gzip'],
  ['7z\xbc\xaf', 'a 7z archive'],
  ['\x89PNG', 'a PNG picture'],
  ['\xff\xd8\xff', 'a JPEG picture'],
  [/^GIF8/, 'a GIF picture'],
  [/^%PDF/, 'a PDF document'],
];

const endings = new Map<string, MeshFormat>([
  ['obj', 'obj'],
  ['ply', 'ply'],
  ['stl', 'stl'],
  ['off', 'off'],
  ['glb', 'gltf'],
  ['gltf', 'gltf'],
]);

/** The endings of the names of files that can be read. */
export const fileEndings: readonly string[] = [...endings.keys()].map((ending) => `.${ending}`);

/**
 * A file's bytes without the byte order mark that some editors write before UTF-8 text. Throws
 * `KarcherError` badFile for bytes that are no mesh, whatever the ending: a Git LFS pointer, text
 * in UTF-16.
 */
export function withoutMark(bytes: Uint8Array): Uint8Array {
  // A binary STL file begins with 80 arbitrary bytes. Its length identifies it.
  if (isBinaryStl(bytes)) return bytes;
  const [first, second, third] = bytes;
  if ((first === 0xff && second === 0xfe) || (first === 0xfe && second === 0xff)) {
    throw badFile('the file is UTF-16 text: save it as UTF-8');
  }
  const isMarked = first === 0xef && second === 0xbb && third === 0xbf;
  const text = isMarked ? bytes.subarray(3) : bytes;
  if (startOf(text).startsWith('version https://git-lfs.')) {
    throw badFile(
      'the file is a Git LFS pointer, not the file itself: fetch it with `git lfs pull`',
    );
  }
  return text;
}

/**
 * The format of a file, by the beginning of its bytes, or else by the ending of its name. Throws
 * `KarcherError` badFile if the file is no mesh of a supported format; the message names the file's
 * kind.
 */
export function formatOf(bytes: Uint8Array, name = ''): MeshFormat {
  const start = startOf(withoutMark(bytes));
  if (/^ply[\r\n]/.test(start)) return 'ply';
  if (isGlb(bytes)) return 'gltf';
  const ending = endings.get(/\.([^.]+)$/.exec(name)?.[1]?.toLowerCase() ?? '');
  const other = others.find(([begin]) =>
    typeof begin === 'string' ? start.startsWith(begin) : begin.test(start),
  )?.[1];
  // A binary STL file begins with 80 arbitrary bytes.
  if (isBinaryStl(bytes) && (ending === 'stl' || !isTextStl(start))) return 'stl';
  if (other) {
    throw badFile(`the file is ${other}, which is not read; ${fileEndings.join(', ')} files are`);
  }
  if (isTextStl(start)) return 'stl';
  if (isOff(start)) return 'off';
  if (/^\s*\{/.test(start)) return 'gltf';
  if (bytes.length === 0 && ending !== 'obj') throw badFile('the file is empty');
  return ending ?? 'obj';
}
