/** A vector in space, or a place. */
export type Vector = [number, number, number];

/** The sum of two vectors. */
export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/** The first vector minus the second. */
export const subtract = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** A vector times a number. */
export const scaled = (a: Vector, s: number): Vector => [s * a[0], s * a[1], s * a[2]];
/** The scalar product of two vectors. */
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** The length of a vector. */
export const length = (a: Vector): number => Math.sqrt(dot(a, a));
/** The vector product, which is normal to both. */
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
/** Entry i of an array x, y, z, x, y, z, … */
export const at = (flat: ArrayLike<number>, i: number): Vector => [
  flat[3 * i]!,
  flat[3 * i + 1]!,
  flat[3 * i + 2]!,
];
/** The distance between two places. */
export const distance = (a: Vector, b: Vector): number => length(subtract(a, b));
