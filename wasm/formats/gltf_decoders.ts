import { KarcherError } from '../errors.js';
import type { DracoModule } from './draco_decoder.mjs';
import { isJson, type Json, listOf, objectOf } from './gltf_json.js';
import type { MeshoptDecoder } from './meshopt_decoder.mjs';

/** The decoders for the compressed parts of a file; null for a kind that the file does not use. */
export interface Decoders {
  draco: DracoModule | null;
  meshopt: typeof MeshoptDecoder | null;
}

const meshoptNames = ['KHR_meshopt_compression', 'EXT_meshopt_compression'];

/** The extensions of compression that the reader supports. */
export const compressions: readonly unknown[] = ['KHR_draco_mesh_compression', ...meshoptNames];

/**
 * An object's extension with this name, which describes how meshoptimizer or Draco compressed the
 * object.
 */
const extension = (of: unknown, name: string): Json | undefined => {
  const value = isJson(of) ? objectOf(of, 'extensions')[name] : undefined;
  return isJson(value) ? value : undefined;
};
export const meshoptOf = (view: unknown): Json | undefined =>
  extension(view, meshoptNames[0]!) ?? extension(view, meshoptNames[1]!);
export const dracoOf = (primitive: unknown): Json | undefined =>
  extension(primitive, 'KHR_draco_mesh_compression');

/**
 * Loads the decoders that a file needs. Each file has a new Draco decoder, so that the memory of a
 * large file is freed. Rejects with `KarcherError` notLoaded.
 */
export async function decodersFor(json: Json): Promise<Decoders> {
  const hasDraco = listOf(json, 'meshes').some(
    (mesh) => isJson(mesh) && listOf(mesh, 'primitives').some(dracoOf),
  );
  const hasMeshopt = listOf(json, 'bufferViews').some(meshoptOf);
  return {
    draco: hasDraco
      ? await loaded('Draco', async () => (await import('./draco_decoder.mjs')).default())
      : null,
    meshopt: hasMeshopt
      ? await loaded('meshoptimizer', async () => {
          const { MeshoptDecoder } = await import('./meshopt_decoder.mjs');
          await MeshoptDecoder.ready;
          return MeshoptDecoder;
        })
      : null,
  };
}

async function loaded<Decoder>(name: string, load: () => Promise<Decoder>): Promise<Decoder> {
  try {
    return await load();
  } catch (cause) {
    const why = cause instanceof Error ? cause.message : `${cause}`;
    throw new KarcherError(
      'notLoaded',
      `the glTF file is compressed by ${name}, whose decoder cannot be loaded (${why}): save it uncompressed`,
      { cause },
    );
  }
}
