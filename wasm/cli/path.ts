import { type Command, formatOption } from './command.js';
import { triples } from './output.js';

export const path: Command = {
  name: 'path',
  summary: 'the exact shortest path between two points',
  output: '{length, polyline: [[x, y, z], …]}',
  options: [
    { name: 'from', value: 'POINT', help: 'where the path starts', required: true },
    { name: 'to', value: 'POINT', help: 'where it ends', required: true },
    formatOption,
  ],
  async run(args) {
    const from = args.point('from');
    const to = args.point('to');
    const mesh = await args.mesh();
    const { length, polyline } = mesh.shortestPath(from, to);
    return { json: { length, polyline: triples(polyline) }, polylines: [polyline] };
  },
};
