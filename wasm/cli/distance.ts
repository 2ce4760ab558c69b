import type { Solver } from '../types.js';
import type { Command } from './command.js';
import { radiusOption } from './options.js';

export const distance: Command = {
  name: 'distance',
  call: 'mesh.distance(from, options)',
  summary: 'geodesic distances from a point, or from the nearest of several, to all vertices',
  output:
    "{distance: […]}, in the file's vertex order: null for a vertex without a face or a path, and beyond the radius",
  options: [
    {
      name: 'from',
      value: 'POINTS',
      help: 'the source, or several with spaces between them',
      required: true,
    },
    {
      name: 'solver',
      value: 'fast|exact|graph',
      help: 'how distances are found',
      default: 'exact',
    },
    { name: 'rings', value: 'K', help: 'rings of the graph solver, 1 to 10', default: '6' },
    radiusOption,
  ],
  async run(args) {
    const from = args.pointList('from');
    const solver = args.choice<Solver>('solver');
    const rings = args.whereGiven(['rings'], (name) => args.integer(name));
    const radius = args.whereGiven(['radius'], (name) => args.number(name));
    const mesh = await args.mesh();
    const distances = mesh.distance(from, { solver, ...rings, ...radius });
    return {
      json: { distance: Array.from(distances, (value) => (Number.isNaN(value) ? null : value)) },
    };
  },
};
