import type { Command } from './command.js';
import { drawnOptions } from './options.js';
import { pathRecord, spacedRecords } from './output.js';

export const path: Command = {
  name: 'path',
  call: 'mesh.shortestPath(from, to)',
  summary: 'the exact shortest path between two points',
  output:
    '{length, polyline: [[x, y, z], …], points: [{face, bary}, …], lengths: from the start to each point, equallySpaced: [{length, point, position}, …] with --equally-spaced}',
  options: [
    { name: 'from', value: 'POINT', help: 'the start of the path', required: true },
    { name: 'to', value: 'POINT', help: 'the end of the path', required: true },
    {
      name: 'equally-spaced',
      value: 'N',
      help: 'N points with the same length of path between them',
    },
    ...drawnOptions,
  ],
  async run(args) {
    const from = args.point('from');
    const to = args.point('to');
    const spaced = args.given('equally-spaced') ? args.integer('equally-spaced') : undefined;
    const mesh = await args.mesh();
    const shortest = mesh.shortestPath(from, to);
    const even = spaced !== undefined && {
      equallySpaced: spacedRecords(mesh.equallySpaced(shortest, spaced)),
    };
    return { json: { ...pathRecord(shortest), ...even }, mesh, curves: () => [{ path: shortest }] };
  },
};
