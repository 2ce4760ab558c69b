/** The decoder of the package `meshoptimizer`. The build copies it beside the reader. */
export const MeshoptDecoder: {
  readonly supported: boolean;
  readonly ready: Promise<void>;
  decodeGltfBuffer(
    target: Uint8Array,
    count: number,
    size: number,
    source: Uint8Array,
    mode: string,
    filter?: string,
  ): void;
};
