// Writers of compressed GLB files of triangles {positions, faces}, by the encoders of the packages.
import draco3d from 'draco3d';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { glbOf, gltfParts } from './mesh_files.mjs';

/** The parts of a glTF file with other bytes, whose accessors have no view. */
function compressedParts(mesh, name, buffer) {
  const parts = gltfParts(mesh, {
    extensionsUsed: [name],
    extensionsRequired: [name],
    buffers: [{ byteLength: buffer.length }],
  });
  return { json: parts.json, buffer };
}

/**
 * A file by Draco: a coordinate has `bits` bits, or all of them. The order of triangles may change.
 * `colors` are four bytes a vertex.
 */
export async function dracoParts(mesh, { bits = 0, colors } = {}) {
  const encoderModule = await draco3d.createEncoderModule();
  const encoder = new encoderModule.Encoder();
  const builder = new encoderModule.MeshBuilder();
  const made = new encoderModule.Mesh();
  const bytes = new encoderModule.DracoInt8Array();
  const corners = mesh.faces.flat();
  const vertices = mesh.positions.length / 3;
  builder.AddFacesToMesh(made, mesh.faces.length, Uint32Array.from(corners));
  const id = builder.AddFloatAttributeToMesh(
    ...[made, encoderModule.POSITION, vertices, 3, Float32Array.from(mesh.positions)],
  );
  const colorId =
    colors &&
    builder.AddUInt8Attribute(made, encoderModule.COLOR, vertices, 4, Uint8Array.from(colors));
  if (bits > 0) encoder.SetAttributeQuantization(encoderModule.POSITION, bits);
  // Sequential encoding keeps the order of vertices.
  else encoder.SetEncodingMethod(encoderModule.MESH_SEQUENTIAL_ENCODING);
  const length = encoder.EncodeMeshToDracoBuffer(made, bytes);
  const buffer = Uint8Array.from({ length }, (_, i) => bytes.GetValue(i));
  const name = 'KHR_draco_mesh_compression';
  const { json } = compressedParts(mesh, name, buffer);
  json.bufferViews = [{ buffer: 0, byteLength: length }];
  for (const accessor of json.accessors) delete accessor.bufferView;
  json.meshes[0].primitives[0].extensions = {
    [name]: { bufferView: 0, attributes: { POSITION: id, COLOR_0: colorId } },
  };
  if (colors) {
    json.meshes[0].primitives[0].attributes.COLOR_0 = json.accessors.length;
    const type = { componentType: 5121, type: 'VEC4', normalized: true };
    json.accessors.push({ ...type, count: vertices });
  }
  return { json, buffer };
}

export const dracoFile = async (mesh, options) => glbOf(await dracoParts(mesh, options));

/** A file by meshoptimizer, under either name of the extension. */
export async function meshoptParts(mesh, { name = 'EXT_meshopt_compression' } = {}) {
  await MeshoptEncoder.ready;
  const corners = Uint32Array.from(mesh.faces.flat());
  const places = new Uint8Array(Float32Array.from(mesh.positions).buffer);
  const vertices = mesh.positions.length / 3;
  const streams = [
    {
      ...{ mode: 'ATTRIBUTES', count: vertices, byteStride: 12 },
      bytes: MeshoptEncoder.encodeVertexBuffer(places, vertices, 12),
    },
    {
      ...{ mode: 'TRIANGLES', count: corners.length, byteStride: 4 },
      bytes: MeshoptEncoder.encodeIndexBuffer(
        new Uint8Array(corners.buffer),
        ...[corners.length, 4],
      ),
    },
  ];
  const buffer = new Uint8Array(streams.reduce((sum, { bytes }) => sum + bytes.length, 0));
  const { json } = compressedParts(mesh, name, buffer);
  let at = 0;
  json.bufferViews = streams.map(({ bytes, ...stream }) => {
    buffer.set(bytes, at);
    const compressed = { buffer: 0, byteOffset: at, byteLength: bytes.length, ...stream };
    at += bytes.length;
    return {
      ...{ buffer: 1, byteLength: stream.count * stream.byteStride },
      extensions: { [name]: compressed },
    };
  });
  json.buffers.push({ byteLength: 1, extensions: { [name]: { fallback: true } } });
  return { json, buffer };
}

export const meshoptFile = async (mesh, options) => glbOf(await meshoptParts(mesh, options));
