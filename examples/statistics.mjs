// Statistics on a surface: the mean of a sample, its spread, and intervals of the mean by the bootstrap.
import { load } from 'karcher';

const karcher = await load();
const mesh = karcher.shape('sphere', 5000);
const { point: center } = mesh.nearestPoint([0, 0, 1]);

// A sample about a point: vectors of its tangent plane, mapped to the surface.
let state = 1;
const random = () => {
  state = (state * 16807) % 2147483647;
  return state / 2147483647;
};
const { points } = mesh.expMap(
  center,
  Array.from({ length: 12 }, () => [0.3 * (random() - 0.5), 0.3 * (random() - 0.5), 0]),
);

const equal = points.map(() => 1 / points.length);
const mean = mesh.centerOfMass(points, equal);
console.log(`mean ${mean.position.map((x) => x.toFixed(3))}`);
console.log(`standard deviation ${Math.sqrt(mean.energy).toFixed(4)}`);

// Each row of weights is a bootstrap sample. The engine computes the fields once for all rows.
const rows = Array.from({ length: 2000 }, () => {
  const row = points.map(() => 0);
  for (let i = 0; i < points.length; i++) row[Math.floor(random() * points.length)] += 1;
  return row;
});
const means = mesh.centersOfMass(points, rows, { normalize: true });
const found = Array.from({ length: means.count }, (_, i) => i).filter(
  (i) => means.status[i] === 'converged',
);
const away = found
  .map((i) => {
    const [x, y, z] = means.position.slice(3 * i, 3 * i + 3);
    const [a, b, c] = mean.position;
    return Math.hypot(x - a, y - b, z - c);
  })
  .sort((a, b) => a - b);
console.log(
  `95 % of ${found.length} means lie within ${away[Math.floor(0.95 * away.length)].toFixed(4)}`,
);
