import type { Vector } from './types';

/** Places near the built-in surfaces, by their natural coordinates. */

/** The radii of the built-in torus, which lies around the z axis. */
export const torusRadii = { major: 1, minor: 0.4 };

/**
 * A place on the built-in torus by its longitude and its angle around the tube from the outer
 * equator, in degrees.
 */
export function onTorus(longitude: number, around: number): Vector {
  const [u, v] = [longitude, around].map((degrees) => (degrees * Math.PI) / 180) as [
    number,
    number,
  ];
  const { major, minor } = torusRadii;
  const ring = major + minor * Math.cos(v);
  return [ring * Math.cos(u), ring * Math.sin(u), minor * Math.sin(v)];
}

/** A place on the unit sphere by its angles from (0, 0, 1), in degrees: to the right, and up. */
export function onSphere(right: number, up: number): Vector {
  const [a, b] = [right, up].map((degrees) => (degrees * Math.PI) / 180) as [number, number];
  return [Math.cos(b) * Math.sin(a), Math.sin(b), Math.cos(b) * Math.cos(a)];
}

/**
 * A place above the center line of the knotted tube, which is a trefoil: by degrees along the
 * trefoil, and by the distance to its right.
 */
export function onKnot(degrees: number, right: number): Vector {
  const t = (degrees * Math.PI) / 180;
  const x = (Math.sin(t) + 2 * Math.sin(2 * t)) / 3;
  const y = (Math.cos(t) - 2 * Math.cos(2 * t)) / 3;
  const [dx, dy] = [Math.cos(t) + 4 * Math.cos(2 * t), -Math.sin(t) + 4 * Math.sin(2 * t)];
  const speed = Math.hypot(dx, dy);
  const z = -Math.sin(3 * t) / 3 + 0.14;
  return [x + (right * dy) / speed, y - (right * dx) / speed, z];
}
