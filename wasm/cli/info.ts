import type { Command } from './command.js';

export const info: Command = {
  name: 'info',
  summary: 'what a mesh consists of, and what was mended while it was read',
  output:
    '{vertices, triangles, components, boundaryLoops, genus, meanEdge, diagonal, fastSolver, repairs: [{kind, count, message}, …]}',
  options: [],
  async run(args) {
    const mesh = await args.mesh();
    return { json: mesh.info };
  },
};
