import { load } from '../load.js';
import type { Command } from './command.js';

export const info: Command = {
  name: 'info',
  summary: 'what a mesh consists of, and what was mended while it was read',
  output:
    '{vertices, triangles, components, boundaryLoops, genus, meanEdge, diagonal, fastSolver, repairs: [{kind, count, message}, …], file: {format, parts: [{name, triangles}, …], notRead: [sentence, …]}}',
  options: [],
  async run(args) {
    const read = await args.meshFile();
    const { mesh, file } = await read(await load());
    return { json: { ...mesh.info, file } };
  },
};
