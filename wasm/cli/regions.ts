import type { BooleanOperation, FillRule } from '../types.js';
import type { Command } from './command.js';
import { drawnOptions } from './options.js';
import { outlineOptions, readOutlines } from './outlines.js';
import { regionRecord } from './output.js';

export const regions: Command = {
  name: 'regions',
  call: 'mesh.regions(shapes, options)',
  summary: 'the regions that closed curves, or curves from boundary to boundary, enclose',
  output:
    '{regions: [{area, perimeter, boundary: [{length, polyline: [[x, y, z], …]}, …]}, …]}: one for each curve, or one in all with --combine or --inside; the boundary has closed lines with the region to their left: its outline and those of its holes',
  options: [
    ...outlineOptions,
    {
      name: 'inside',
      value: 'POINT',
      help: 'a point inside the region that all curves enclose together; by default the smaller side of each is inside',
    },
    {
      name: 'side',
      value: 'left|right',
      help: 'the side of each curve, seen along it, that is inside',
      default: 'the smaller one',
    },
    {
      name: 'rule',
      value: 'evenOdd|nonZero',
      help: 'the rule for the inside of a curve that crosses itself',
      default: 'evenOdd',
    },
    {
      name: 'combine',
      value: 'none|union|intersection|difference|exclusion',
      help: 'one region from the regions of all curves; a difference is the first without all others',
      default: 'none',
    },
    ...drawnOptions,
  ],
  async run(args) {
    const rule = args.choice<FillRule>('rule');
    const combine = args.choice<BooleanOperation | 'none'>('combine');
    const { inside } = args.whereGiven(['inside'], (name) => args.point(name));
    if (inside) {
      args.refuse(['combine', 'side'], 'with --inside, which makes one region of all curves');
    }
    const side = args.given('side') ? args.choice<'left' | 'right'>('side') : undefined;
    const { mesh, outlines } = await readOutlines(args);
    const shapes = side
      ? outlines.map((outline) => ({ outlines: [outline], inside: side }))
      : outlines;
    const found = mesh.regions(inside ? [{ outlines, inside }] : shapes, {
      rule,
      ...(combine !== 'none' && { combine }),
    });
    return {
      json: {
        regions: found.map(regionRecord),
      },
      mesh,
      curves: () => found.flatMap((region) => region.boundary().map((path) => ({ path }))),
    };
  },
};
