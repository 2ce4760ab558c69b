import { badFile, counted } from './failures.js';

/** The contents of a glTF file: its JSON, and the buffer in the same file, if any. */
export interface GltfContent {
  json: unknown;
  buffer: Uint8Array | null;
}

export const [glbMagic, jsonChunk, binaryChunk] = [0x46546c67, 0x4e4f534a, 0x004e4942] as const;

export const isGlb = (bytes: Uint8Array) =>
  bytes.length >= 4 && new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true) === glbMagic;

/** Splits a GLB file, or a glTF file of text, into its contents. Throws `KarcherError` badFile. */
export function gltfContent(bytes: Uint8Array): GltfContent {
  if (!isGlb(bytes)) return { json: parsed(bytes), buffer: null };
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20) throw badFile(`the GLB file ends at byte ${bytes.length}, in its header`);
  const version = view.getUint32(4, true);
  if (version !== 2) throw badFile(`the GLB file has version ${version}; version 2 is read`);
  const length = view.getUint32(8, true);
  if (length > bytes.length) {
    throw badFile(
      `the GLB file declares ${counted(length)} bytes, but it has ${counted(bytes.length)}`,
    );
  }
  let json: Uint8Array | null = null;
  let buffer: Uint8Array | null = null;
  for (let at = 12; at + 8 <= length; ) {
    const size = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const start = at + 8;
    if (start + size > length) {
      throw badFile(
        `byte ${at}: a chunk of the GLB file declares ${counted(size)} bytes, but ${counted(length - start)} follow`,
      );
    }
    const chunk = bytes.subarray(start, start + size);
    if (type === jsonChunk) json ??= chunk;
    else if (type === binaryChunk) buffer ??= chunk;
    at = start + size;
  }
  if (!json) throw badFile('the GLB file has no chunk of JSON');
  return { json: parsed(json), buffer };
}

function parsed(bytes: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (cause) {
    const why = cause instanceof Error ? cause.message : `${cause}`;
    throw badFile(`the glTF file's JSON cannot be read: ${why}`);
  }
}
