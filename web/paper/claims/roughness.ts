import type { Karcher, Mesh } from 'karcher';
import { randomFrom } from '../../model/random';

/** A copy of a mesh whose vertices are moved at random, evenly within a ball of `noise` mean edges. */
export function roughened(karcher: Karcher, mesh: Mesh, noise: number, seed: number): Mesh {
  const random = randomFrom(seed);
  const positions = mesh.positions();
  const radius = noise * mesh.info.meanEdge;
  for (let v = 0; v < positions.length; v += 3) {
    const [x, y, z] = inBall(random);
    positions[v]! += radius * x;
    positions[v + 1]! += radius * y;
    positions[v + 2]! += radius * z;
  }
  return karcher.meshFromArrays(positions, mesh.triangles());
}

function inBall(random: () => number): [number, number, number] {
  for (;;) {
    const [x, y, z] = [2 * random() - 1, 2 * random() - 1, 2 * random() - 1];
    if (x * x + y * y + z * z <= 1) return [x, y, z];
  }
}
