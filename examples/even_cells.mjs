// Points spread evenly over a surface: each moves to the centroid of its Voronoi cell, again and again (Lloyd).
import { load } from 'karcher';
import { centroid, voronoi } from 'karcher/statistics';

const karcher = await load();
const mesh = karcher.shape('torus', 2000);

// Where the surface is high, a density above 1 draws points together.
const positions = mesh.positions();
const density = Float64Array.from({ length: positions.length / 3 }, (_, v) =>
  Math.exp(2 * positions[3 * v + 2]),
);

let sites = [0, 1, 2, 3, 4, 5, 6, 7].map((vertex) => ({ vertex }));
for (let round = 0; round < 4; round++) {
  const { areas, borders, cell } = await voronoi(mesh, sites, { solver: 'fast' });
  const length = borders.reduce((sum, { path }) => sum + path.length, 0);
  console.log(
    `round ${round}: cells of ${Math.min(...areas).toFixed(4)} to ${Math.max(...areas).toFixed(4)},`,
    `borders ${length.toFixed(3)} long`,
  );
  const next = [];
  for (const [i, site] of sites.entries()) {
    const options = { density, samples: 50, start: site, tolerance: 1e-3 };
    next.push((await centroid(mesh, cell(i), options)).point);
  }
  sites = next;
}
