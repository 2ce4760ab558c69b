import type { Circle, Ellipse } from '../path_types.js';
import type { Command, Result } from './command.js';
import { UsageError } from './errors.js';
import { fieldOptions, formatOption, levelsOption, type Option } from './options.js';
import { linesResult, sampleRecords, triples } from './output.js';

const arcOptions = (byDefault: string): readonly Option[] => [
  { name: 'arcs', value: 'N', help: `the number of arcs, 3 to 64; without it ${byDefault}` },
  { name: 'samples', value: 'N', help: 'samples an arc, both ends included', default: '32' },
  levelsOption,
];

const circleOutput =
  '{levels, polyline: [[x, y, z], …], samples: [{segment, t, face, bary, position, converged, status}, …], bridged: [{segment, t0, t1, reason}, …], length, notShortest: [arc, …], deviation}';

function resultOf(circle: Ellipse & Partial<Circle>): Result {
  const polyline = circle.path.polyline({ bits: 64 });
  return {
    json: {
      levels: circle.levels,
      polyline: triples(polyline),
      samples: sampleRecords(circle.samples),
      bridged: circle.bridged,
      length: circle.path.length,
      notShortest: circle.notShortest,
      deviation: circle.deviation,
    },
    polylines: [polyline],
  };
}

export const circle: Command = {
  name: 'circle',
  summary: 'a geodesic circle of rational quadratic arcs, or lines of points at one distance',
  output: `${circleOutput}; with --type linear or exact {lines: [{closed, length, polyline}, …]}`,
  options: [
    { name: 'center', value: 'POINT', help: 'the center', required: true },
    { name: 'radius', value: 'R', help: 'the radius, in units of the mesh', required: true },
    {
      name: 'type',
      value: 'arcs|linear|exact',
      help: 'rational arcs, or the isoline of the distance: linear in triangles (by default of --solver exact), or exact',
      default: 'arcs',
    },
    ...arcOptions('as many as the tolerance takes'),
    {
      name: 'tolerance',
      value: 'PART',
      help: 'how far points may be from the radius, as a part of it, where arcs are not counted',
      default: '0.001',
    },
    ...fieldOptions,
    formatOption,
  ],
  async run(args) {
    const center = args.point('center');
    const radius = args.number('radius');
    const type = args.choice<'arcs' | 'linear' | 'exact'>('type');
    const options = {
      ...args.whereGiven(['arcs'], (name) => args.integer(name)),
      samples: args.integer('samples'),
      levels: args.levels(),
      tolerance: args.number('tolerance'),
    };
    const { method, ...distance } = args.field();
    if (type !== 'arcs')
      args.refuse(['arcs', 'samples', 'levels', 'method', 'tolerance'], `with --type ${type}`);
    if (args.given('arcs')) args.refuse(['tolerance'], 'with --arcs');
    if (type === 'exact') args.refuse(['solver', 'rings'], 'with --type exact');
    const mesh = await args.mesh();
    if (type === 'arcs') {
      return resultOf(mesh.circle(center, { radius, ...options, method, ...distance }));
    }
    return linesResult(mesh.isolines(center, { radius, type, ...distance }));
  },
};

export const ellipse: Command = {
  name: 'ellipse',
  summary: 'an ellipse of rational quadratic arcs about a point',
  output: circleOutput,
  options: [
    { name: 'center', value: 'POINT', help: 'the center', required: true },
    { name: 'radii', value: 'A,B', help: 'along and across the direction', required: true },
    {
      name: 'direction',
      value: 'X,Y,Z',
      help: "of the first radius, in space: its part in the center's face counts",
      required: true,
    },
    ...arcOptions('7'),
    ...fieldOptions,
    formatOption,
  ],
  async run(args) {
    const center = args.point('center');
    const [along, across, ...more] = args.numbers('radii');
    if (along === undefined || across === undefined || more.length > 0) {
      throw new UsageError('--radii takes two numbers');
    }
    const direction = args.numbers('direction');
    const arcs = args.whereGiven(['arcs'], (name) => args.integer(name));
    const samples = args.integer('samples');
    const levels = args.levels();
    const field = args.field();
    const mesh = await args.mesh();
    const radii = [along, across] as const;
    return resultOf(mesh.ellipse(center, { radii, direction, ...arcs, samples, levels, ...field }));
  },
};
