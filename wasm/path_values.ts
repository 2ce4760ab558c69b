/** Paths and regions as values that survive JSON. */

/** A path as a value that survives JSON. `Path.from` returns the path. */
export interface PathValue {
  /** Whether the path ends where it starts. */
  closed: boolean;
  /** The length on the surface. */
  length: number;
  /** The face of each point. */
  face: readonly number[];
  /** Three barycentric weights for each point. */
  bary: readonly number[];
  /** The coordinates x, y, z of each point. */
  position: readonly number[];
  /** The length from the start to each point. */
  lengths: readonly number[];
}

/** A region as a value that survives JSON. `Region.from` returns the region. */
export interface RegionValue {
  /** The area, in squared units of the mesh. */
  area: number;
  /** The length of the region's boundary. */
  perimeter: number;
  /** The closed paths that bound the region. */
  boundary: readonly PathValue[];
  /** A number for each triangle: 0 outside the region, 1 inside, 2 if it is partly inside. */
  share: readonly number[];
  /** The triangle of each entry of `sides`, in ascending order. */
  triangles: readonly number[];
  /**
   * The sides of the region within partial triangles, four numbers for each: the second and third
   * weight of one end, and then of the other end.
   */
  sides: readonly number[];
  /** Whether the region lies left of its first outline, for a region of one shape. */
  isLeft?: boolean | undefined;
}
