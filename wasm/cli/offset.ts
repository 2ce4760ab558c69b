import type { Command } from './command.js';
import { drawnOptions } from './options.js';
import { outlineOptions, readOutlines } from './outlines.js';
import { linesResult } from './output.js';

export const offset: Command = {
  name: 'offset',
  call: 'mesh.offset(paths, options)',
  summary: 'lines at a distance from curves, on one side or on both',
  output:
    '{lines: [{closed, length, polyline: [[x, y, z], …]}, …]}: the points at exactly this distance from the nearest curve, without the parts that are nearer to another',
  options: [
    ...outlineOptions,
    {
      name: 'distance',
      value: 'D',
      help: 'the distance in units of the mesh; several, with commas, are at equal parts of the length of each curve',
      required: true,
    },
    {
      name: 'side',
      value: 'both|left|right',
      help: 'the side of the curves, seen along them; both goes around the ends of open ones too',
      default: 'both',
    },
    {
      name: 'corners',
      value: 'round|miter|bevel',
      help: 'the shape of corners on their outer side',
      default: 'round',
    },
    {
      name: 'miter-limit',
      value: 'L',
      help: 'the largest distance of a mitre from its corner, in distances; longer ones become bevels',
      default: '4',
    },
    ...drawnOptions,
  ],
  async run(args) {
    const distance = args.numbers('distance');
    const side = args.choice<'both' | 'left' | 'right'>('side');
    const corners = args.choice<'round' | 'miter' | 'bevel'>('corners');
    const miterLimit = args.number('miter-limit');
    const { mesh, outlines } = await readOutlines(args);
    return linesResult(mesh, mesh.offset(outlines, { distance, side, corners, miterLimit }));
  },
};
