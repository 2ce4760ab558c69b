import type { Command } from './command.js';
import { formatOption } from './options.js';
import { outlineOptions, readOutlines } from './outlines.js';
import { linesResult } from './output.js';

export const offset: Command = {
  name: 'offset',
  call: 'mesh.offset(paths, options)',
  summary: 'lines at a distance from curves, on one side or on both',
  output:
    '{lines: [{closed, length, polyline: [[x, y, z], …]}, …]}: the points whose exact distance from the nearest curve it is; corners are round, and what runs into itself is trimmed',
  options: [
    ...outlineOptions,
    { name: 'distance', value: 'D', help: 'in units of the mesh', required: true },
    {
      name: 'side',
      value: 'both|left|right',
      help: 'seen along the curves; both goes round the ends of open ones too',
      default: 'both',
    },
    formatOption,
  ],
  async run(args) {
    const distance = args.number('distance');
    const side = args.choice<'both' | 'left' | 'right'>('side');
    const { mesh, outlines } = await readOutlines(args);
    return linesResult(mesh.offset(outlines, { distance, side }));
  },
};
