import type { DracoAttribute, DracoModule } from './draco_decoder.mjs';
import { badFile } from './failures.js';

/** A column to read: its Draco id, the glTF type of its numbers, and the length of a row. */
export interface DracoColumn {
  id: number;
  type: number;
  size: number;
}

/** A mesh that Draco compressed: triangles, and the requested columns. */
export interface DracoResult {
  points: number;
  /** The corners, as numbers of 4 bytes. */
  corners: Uint8Array;
  columns: Map<number, Uint8Array>;
}

const types = new Map<number, [keyof DracoModule, number]>([
  [5120, ['DT_INT8', 1]],
  [5121, ['DT_UINT8', 1]],
  [5122, ['DT_INT16', 2]],
  [5123, ['DT_UINT16', 2]],
  [5125, ['DT_UINT32', 4]],
  [5126, ['DT_FLOAT32', 4]],
]);

/** Decodes a mesh. Throws `KarcherError` badFile; `what` names the mesh. */
export function decodeDraco(
  draco: DracoModule,
  bytes: Uint8Array,
  columns: readonly DracoColumn[],
  what: string,
): DracoResult {
  try {
    return decoded(draco, bytes, columns);
  } catch (cause) {
    const why = cause instanceof Error ? cause.message : `${cause}`;
    throw badFile(`${what}, which Draco compressed, cannot be read: ${why}`);
  }
}

function decoded(draco: DracoModule, bytes: Uint8Array, columns: readonly DracoColumn[]) {
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  try {
    const signed = new Int8Array(bytes.buffer, bytes.byteOffset, bytes.length);
    if (decoder.GetEncodedGeometryType(signed) !== draco.TRIANGULAR_MESH) {
      throw new Error('it is no mesh of triangles');
    }
    const status = decoder.DecodeArrayToMesh(signed, signed.length, mesh);
    if (!status.ok()) throw new Error(status.error_msg());
    const points = mesh.num_points();
    const corners = filled(draco, 12 * mesh.num_faces(), (length, place) =>
      decoder.GetTrianglesUInt32Array(mesh, length, place),
    );
    const read = columns.map(({ id, type, size }): [number, Uint8Array] => {
      const attribute: DracoAttribute = decoder.GetAttributeByUniqueId(mesh, id);
      if (draco.getPointer(attribute) === 0) throw new Error(`it has no attribute ${id}`);
      if (attribute.num_components() !== size) {
        throw new Error(`attribute ${id} has rows of ${attribute.num_components()}, not ${size}`);
      }
      const [name, width] = types.get(type)!;
      const column = filled(draco, width * size * points, (length, place) =>
        decoder.GetAttributeDataArrayForAllPoints(
          ...([mesh, attribute] as const),
          ...([draco[name] as number, length, place] as const),
        ),
      );
      return [id, column];
    });
    return { points, corners, columns: new Map(read) };
  } finally {
    draco.destroy(mesh);
    draco.destroy(decoder);
  }
}

/** A copy of the data that `write` puts into the decoder's memory. */
function filled(
  draco: DracoModule,
  length: number,
  write: (length: number, place: number) => boolean,
): Uint8Array {
  const place = draco._malloc(Math.max(1, length));
  if (place === 0) throw new Error('there is not enough memory');
  try {
    if (!write(length, place)) throw new Error('its content contradicts its header');
    return draco.HEAPU8.slice(place, place + length);
  } finally {
    draco._free(place);
  }
}
