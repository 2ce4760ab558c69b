/**
 * The used part of the package `draco3d`: the decoder. The build writes the decoder, with its
 * WebAssembly module inside, beside the reader.
 */
export interface DracoModule {
  readonly HEAPU8: Uint8Array;
  readonly TRIANGULAR_MESH: number;
  readonly DT_INT8: number;
  readonly DT_UINT8: number;
  readonly DT_INT16: number;
  readonly DT_UINT16: number;
  readonly DT_UINT32: number;
  readonly DT_FLOAT32: number;
  readonly Decoder: new () => DracoDecoder;
  readonly Mesh: new () => DracoMesh;
  getPointer(thing: object): number;
  destroy(thing: object): void;
  _malloc(bytes: number): number;
  _free(place: number): void;
}

export interface DracoMesh {
  num_faces(): number;
  num_points(): number;
}

export interface DracoAttribute {
  num_components(): number;
}

export interface DracoDecoder {
  GetEncodedGeometryType(bytes: Int8Array): number;
  DecodeArrayToMesh(
    bytes: Int8Array,
    length: number,
    mesh: DracoMesh,
  ): { ok(): boolean; error_msg(): string };
  GetTrianglesUInt32Array(mesh: DracoMesh, bytes: number, place: number): boolean;
  GetAttributeByUniqueId(mesh: DracoMesh, id: number): DracoAttribute;
  GetAttributeDataArrayForAllPoints(
    mesh: DracoMesh,
    attribute: DracoAttribute,
    type: number,
    bytes: number,
    place: number,
  ): boolean;
}

export default function createDecoder(): Promise<DracoModule>;
