import type { Command } from './command.js';
import { formatOption } from './options.js';
import { outlineOptions, readOutlines } from './outlines.js';
import { linesResult } from './output.js';

export const offset: Command = {
  name: 'offset',
  call: 'mesh.offset(paths, options)',
  summary: 'lines at a distance from curves, on one side or on both',
  output:
    '{lines: [{closed, length, polyline: [[x, y, z], …]}, …]}: the points whose exact distance from the nearest curve it is; what runs into itself is trimmed',
  options: [
    ...outlineOptions,
    {
      name: 'distance',
      value: 'D',
      help: 'in units of the mesh; several, with commas, are at equal parts of the length of each curve',
      required: true,
    },
    {
      name: 'side',
      value: 'both|left|right',
      help: 'seen along the curves; both goes round the ends of open ones too',
      default: 'both',
    },
    {
      name: 'corners',
      value: 'round|miter|bevel',
      help: 'what becomes of corners on their outer side',
      default: 'round',
    },
    {
      name: 'miter-limit',
      value: 'L',
      help: 'how far a mitre may reach from its corner, in distances; beyond it is a bevel',
      default: '4',
    },
    formatOption,
  ],
  async run(args) {
    const distance = args.numbers('distance');
    const side = args.choice<'both' | 'left' | 'right'>('side');
    const corners = args.choice<'round' | 'miter' | 'bevel'>('corners');
    const miterLimit = args.number('miter-limit');
    const { mesh, outlines } = await readOutlines(args);
    return linesResult(mesh.offset(outlines, { distance, side, corners, miterLimit }));
  },
};
