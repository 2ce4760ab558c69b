import type { Command } from './command.js';
import { outlineOptions, readOutlines } from './outlines.js';
import { parseNumbers } from './syntax.js';

export const centroid: Command = {
  name: 'centroid',
  call: "centroid(mesh, region, options) of 'karcher/statistics'",
  summary: 'the center of mass of the regions of curves, of a density, or of the whole surface',
  output:
    '{centroids: [{point: {face, bary}, position: [x, y, z], samples, steps, converged}, …]}: one for each curve, or one of the surface without curves',
  options: [
    ...outlineOptions,
    {
      name: 'density',
      value: 'FILE',
      help: 'the mass by area: a number for each vertex in the order of the mesh file, or JSON',
      default: '1 everywhere',
    },
    {
      name: 'region-samples',
      value: 'N',
      help: 'the largest number of points that represent a region',
      default: '1000',
    },
  ],
  async run(args) {
    const statistics = await import('../statistics/index.js');
    const density = args.given('density')
      ? parseNumbers(await args.file('density'), args.text('density'))
      : undefined;
    const samples = args.given('region-samples') ? args.integer('region-samples') : undefined;
    const options = { samples, density };
    const centroids = [];
    if (args.given('points') || args.given('curve')) {
      const { mesh, outlines } = await readOutlines(args);
      for (const region of mesh.regions(outlines)) {
        centroids.push(await statistics.centroid(mesh, region, options));
      }
    } else {
      centroids.push(await statistics.centroid(await args.mesh(), 'all', options));
    }
    return { json: { centroids } };
  },
};
