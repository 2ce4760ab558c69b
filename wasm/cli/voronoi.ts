import type { Solver } from '../types.js';
import type { Command } from './command.js';
import { drawnOptions, pointsOption } from './options.js';
import { regionRecord, triples } from './output.js';

export const voronoi: Command = {
  name: 'voronoi',
  call: "voronoi(mesh, sites, options) of 'karcher/statistics'",
  summary: 'the parts of the surface that are nearest to each of several points',
  output:
    "{nearest: [the nearest point's number for each vertex, null without a path], cells: [{area, perimeter, boundary: [{length, polyline: [[x, y, z], …]}, …]}, …], borders: [{between: [i, j], length, closed, polyline}, …]}",
  options: [
    pointsOption,
    {
      name: 'solver',
      value: 'fast|exact|graph',
      help: 'the solver of distances',
      default: 'exact',
    },
    { name: 'rings', value: 'K', help: 'rings of the graph solver, 1 to 10', default: '6' },
    ...drawnOptions,
  ],
  async run(args) {
    const diagrams = await import('../statistics/index.js');
    const solver = args.choice<Solver>('solver');
    const rings = args.whereGiven(['rings'], (name) => args.integer(name));
    const points = await args.points();
    const mesh = await args.mesh();
    const { nearest, borders, cell } = await diagrams.voronoi(mesh, points, { solver, ...rings });
    const lines = borders.map(({ between, path }) => ({
      between,
      length: path.length,
      closed: path.closed,
      polyline: path.polyline({ bits: 64 }),
    }));
    return {
      json: {
        nearest: Array.from(nearest, (site) => (site < 0 ? null : site)),
        cells: points.map((_, site) => regionRecord(cell(site))),
        borders: lines.map((line) => ({ ...line, polyline: triples(line.polyline) })),
      },
      mesh,
      curves: () => borders.map(({ path }) => ({ path })),
    };
  },
};
