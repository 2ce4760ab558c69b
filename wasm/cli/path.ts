import type { Command } from './command.js';
import { drawnOptions } from './options.js';
import { pathRecord } from './output.js';

export const path: Command = {
  name: 'path',
  call: 'mesh.shortestPath(from, to)',
  summary: 'the exact shortest path between two points',
  output:
    '{length, polyline: [[x, y, z], …], points: [{face, bary}, …], lengths: from the start to each point}',
  options: [
    { name: 'from', value: 'POINT', help: 'the start of the path', required: true },
    { name: 'to', value: 'POINT', help: 'the end of the path', required: true },
    ...drawnOptions,
  ],
  async run(args) {
    const from = args.point('from');
    const to = args.point('to');
    const mesh = await args.mesh();
    const shortest = mesh.shortestPath(from, to);
    return { json: pathRecord(shortest), mesh, curves: () => [{ path: shortest }] };
  },
};
