import type { Uniqueness } from 'karcher';
import type { Vector } from '../figures/types';
import type { Scene } from './scene';

/** A center of mass, its uniqueness, and the other minima of the energy. */
export interface KnownCenter {
  uniqueness: Uniqueness;
  position: Vector;
  /** The energy in squared units of the mesh, like the energies of `others`. */
  energy: number;
  /** The other minima in ascending order. */
  others: { position: Vector; energy: number }[];
}

/**
 * Finds our center of mass, and other minima by searches from all points and from places all over
 * the surface.
 */
export function lookForOthers(
  scene: Scene,
  places: readonly Vector[],
  weights: readonly number[],
): KnownCenter {
  const points = places.map((place) => scene.nearest.point(place));
  const center = scene.mesh.centerOfMass(points, weights, { uniqueness: true });
  const { uniqueness, position, energy, otherMinima } = center;
  const others = otherMinima === 'notLooked' ? [] : otherMinima;
  return {
    uniqueness: center.status === 'converged' ? uniqueness : 'notLooked',
    position,
    energy,
    others: others.map((other) => ({ position: other.position, energy: other.energy })),
  };
}

/** The largest number of other minima in the sentence. */
const mostTold = 3;

/** A sentence about the uniqueness of a center. */
export function uniquenessWords({ uniqueness, energy, others }: KnownCenter): string {
  const told = (value: number) => value.toPrecision(4);
  switch (uniqueness) {
    case 'certain':
      return 'Certainly the only center: the points lie in a ball in which the energy is convex.';
    case 'likely':
      return 'Likely the only center: searches from all points and from all over the surface end there.';
    case 'notUnique': {
      const energies = others.slice(0, mostTold).map((other) => told(other.energy));
      const more = others.length > mostTold ? ' and more' : '';
      const are = others.length === 1 ? 'another minimum has' : 'other minima have';
      return `Not the only center: its energy is ${told(energy)}, ${are} ${energies.join(', ')}${more}.`;
    }
    case 'notLooked':
      return 'No center was found.';
  }
}
