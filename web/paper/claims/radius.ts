import type { Mesh, SurfacePoint } from 'karcher';
import { type Peers, vectors } from 'karcher/peers';
import { randomFrom } from '../../model/random';
import { torusRadii } from '../figures/surfaces';
import { roughened } from './roughness';
import { studySeed } from './seed';

const { at, cross, dot, length, subtract } = vectors;

/**
 * Statistics of sets of four random points in a geodesic ball, on a surface with bumps of `noise`
 * mean edges. The paper's method searches for the center of mass from each of the four points.
 * `found` counts the sets for which a search converges, and `same` those for which all four
 * searches converge to the same center.
 */
export interface RadiusPoint {
  surface: 'sphere' | 'torus';
  noise: number;
  /** The radius up to which Karcher's condition holds on this surface. */
  condition: number;
  radius: number;
  cases: number;
  found: number;
  same: number;
}

const triangles = 5_000;
const noises = [0, 0.2, 0.4];
/**
 * The radii, in units of the radius up to which Karcher's condition holds on the smooth surface.
 */
const radii = [0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.5];
const casesARadius = 12;

/** The largest curvature and the radius of injectivity of each smooth surface. */
const smooth = {
  sphere: { curvature: 1, injectivity: Math.PI },
  torus: {
    curvature: 1 / (torusRadii.minor * (torusRadii.major + torusRadii.minor)),
    injectivity: Math.PI * torusRadii.minor,
  },
};

/**
 * The radius below which a ball has one center of mass by H. Karcher's theorem: half of the radius
 * of injectivity or half of pi / (2 sqrt(K)), whichever is smaller. K is the largest curvature.
 */
export const conditionOf = (curvature: number, injectivity: number): number =>
  Math.min(injectivity, Math.PI / (2 * Math.sqrt(curvature))) / 2;

/** The largest curvature of a vertex: its angle defect over a third of the area around it. */
export function largestCurvature(mesh: Mesh): number {
  const positions = mesh.positions();
  const faces = mesh.triangles();
  const angles = new Float64Array(positions.length / 3);
  const areas = new Float64Array(positions.length / 3);
  for (let f = 0; f < faces.length; f += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b, c] = [0, 1, 2].map((i) => faces[f + ((k + i) % 3)]!) as [number, number, number];
      const corner = at(positions, a);
      const [left, right] = [b, c].map((v) => subtract(at(positions, v), corner)) as [
        vectors.Vector,
        vectors.Vector,
      ];
      const twice = length(cross(left, right));
      angles[a]! += Math.atan2(twice, dot(left, right));
      areas[a]! += twice / 6;
    }
  }
  return angles.reduce((most, angle, v) => Math.max(most, (2 * Math.PI - angle) / areas[v]!), 0);
}

export function radius(peers: Peers, cases = casesARadius): RadiusPoint[] {
  return (['sphere', 'torus'] as const).flatMap((surface) => {
    const { curvature, injectivity } = smooth[surface];
    const smoothly = conditionOf(curvature, injectivity);
    return noises.flatMap((noise) => {
      const shape = peers.karcher.shape(surface, triangles);
      const mesh = noise > 0 ? roughened(peers.karcher, shape, noise, studySeed) : shape;
      const condition = noise > 0 ? conditionOf(largestCurvature(mesh), injectivity) : smoothly;
      const random = randomFrom(studySeed);
      const result = radii.map((part) => {
        const counted = count(mesh, part * smoothly, cases, random);
        return { surface, noise, condition, radius: part * smoothly, cases, ...counted };
      });
      if (mesh !== shape) mesh.dispose();
      shape.dispose();
      return result;
    });
  });
}

function count(mesh: Mesh, radius: number, cases: number, random: () => number) {
  let [found, same] = [0, 0];
  for (let k = 0; k < cases; k++) {
    const points = ball(mesh, radius, random);
    const raw = points.map(() => 0.05 + random());
    const total = raw.reduce((a, b) => a + b);
    const weights = raw.map((weight) => weight / total);
    const ends = points.map((start) =>
      mesh.centerOfMass(points, weights, { method: 'paper', solver: 'exact', start }),
    );
    const converged = ends.filter(({ status }) => status === 'converged');
    if (converged.length > 0) found++;
    const isApart = converged.some(
      ({ position }) =>
        Math.hypot(...position.map((x, c) => x - converged[0]!.position[c]!)) >
        0.1 * mesh.info.meanEdge,
    );
    if (converged.length === 4 && !isApart) same++;
  }
  return { found, same };
}

/**
 * Four points in the geodesic ball around a random point, in random directions. Their distances
 * from the random point have the same distribution as for uniform points in a disk.
 */
function ball(mesh: Mesh, radius: number, random: () => number): SurfacePoint[] {
  const [a, b] = [Math.sqrt(random()), random()];
  const center: SurfacePoint = {
    face: Math.floor(mesh.info.triangles * random()),
    bary: [1 - a, a * (1 - b), a * b],
  };
  return Array.from({ length: 4 }, () => {
    const direction = [0, 1, 2].map(() => 2 * random() - 1) as [number, number, number];
    return mesh.straightest(center, direction, radius * Math.sqrt(random())).end;
  });
}
