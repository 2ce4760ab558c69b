import type { FileCurve } from '../formats/index.js';
import type { Mesh } from '../mesh.js';
import type { Path } from '../path.js';
import { isolines as isolinesOfValues } from '../statistics/index.js';
import type { Solver } from '../types.js';
import type { Arguments } from './arguments.js';
import type { Command, Result } from './command.js';
import { UsageError } from './errors.js';
import { drawnOptions } from './options.js';
import { triples } from './output.js';
import { parseNumbers } from './syntax.js';

export const isolines: Command = {
  name: 'isolines',
  call: 'mesh.isolines(center, options), with one radius for each call; isolines(mesh, values, levels)',
  summary: 'lines of points at given distances from a point, or of given values',
  output:
    '{isolines: [{radius, lines: [{closed, length, polyline: [[x, y, z], …]}, …]}, …]}, without lines if no point is as far; with --values level in place of radius',
  options: [
    {
      name: 'center',
      value: 'POINT',
      help: 'the point from which distances are measured',
    },
    {
      name: 'radius',
      value: 'r1,r2,…',
      help: 'the distances, in units of the mesh',
    },
    {
      name: 'values',
      value: 'FILE',
      help: "in place of --center and --radius: a number for each vertex, or JSON as 'karcher distance' prints it",
    },
    { name: 'levels', value: 'l1,l2,…', help: 'the levels of --values' },
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
    if (args.given('values')) return ofValues(args);
    args.refuse(['levels'], 'without --values');
    for (const name of ['center', 'radius']) {
      if (!args.given(name)) throw new UsageError(`isolines needs --${name}, or --values FILE`);
    }
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
    return result(
      mesh,
      'radius',
      radii.map((radius) => [radius, mesh.isolines(center, { radius, type, ...distance })]),
    );
  },
};

async function ofValues(args: Arguments): Promise<Result> {
  args.refuse(['center', 'radius', 'type', 'solver', 'rings'], 'with --values');
  if (!args.given('levels')) throw new UsageError('isolines needs --levels with --values');
  const values = parseNumbers(await args.file('values'), args.text('values'));
  const levels = args.numbers('levels');
  const mesh = await args.mesh();
  const lines = await isolinesOfValues(mesh, values, levels);
  return result(
    mesh,
    'level',
    levels.map((level, i) => [level, lines[i]!]),
  );
}

/** The lines of each radius or level. */
function result(
  mesh: Mesh,
  name: 'radius' | 'level',
  found: readonly [number, readonly Path[]][],
): Result {
  const curves: FileCurve[] = [];
  const isolines = found.map(([value, lines]) => ({
    [name]: value,
    lines: lines.map((path) => {
      curves.push({ path });
      const { closed, length } = path;
      return { closed, length, polyline: triples(path.polyline({ bits: 64 })) };
    }),
  }));
  return { json: { isolines }, mesh, curves: () => curves };
}
