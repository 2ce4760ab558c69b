import type { FileCurve } from '../formats/index.js';
import type { Solver } from '../types.js';
import type { Command } from './command.js';
import { drawnOptions } from './options.js';
import { triples } from './output.js';

export const isolines: Command = {
  name: 'isolines',
  call: 'mesh.isolines(center, options), with one radius for each call',
  summary: 'lines of points at given distances from a point',
  output:
    '{isolines: [{radius, lines: [{closed, length, polyline: [[x, y, z], …]}, …]}, …]}, without lines if no point is as far',
  options: [
    {
      name: 'center',
      value: 'POINT',
      help: 'the point from which distances are measured',
      required: true,
    },
    {
      name: 'radius',
      value: 'r1,r2,…',
      help: 'the distances, in units of the mesh',
      required: true,
    },
    {
      name: 'type',
      value: 'exact|linear',
      help: 'lines at exactly this distance, or straight lines in triangles',
      default: 'exact',
    },
    {
      name: 'solver',
      value: 'fast|exact|graph',
      help: 'of --type linear: the solver of distances',
      default: 'exact',
    },
    { name: 'rings', value: 'K', help: 'rings of the graph solver, 1 to 10', default: '6' },
    ...drawnOptions,
  ],
  async run(args) {
    const center = args.point('center');
    const radii = args.numbers('radius');
    const type = args.choice<'exact' | 'linear'>('type');
    if (type === 'exact') args.refuse(['solver', 'rings'], 'with --type exact');
    const solver = args.choice<Solver>('solver');
    const distance = {
      ...(type === 'linear' && { solver }),
      ...args.whereGiven(['rings'], (name) => args.integer(name)),
    };
    const mesh = await args.mesh();
    const curves: FileCurve[] = [];
    const found = radii.map((radius) => {
      const lines = mesh.isolines(center, { radius, type, ...distance });
      return {
        radius,
        lines: lines.map((line) => {
          const polyline = line.polyline({ bits: 64 });
          curves.push({ path: line });
          return { closed: line.closed, length: line.length, polyline: triples(polyline) };
        }),
      };
    });
    return { json: { isolines: found }, mesh, curves: () => curves };
  },
};
