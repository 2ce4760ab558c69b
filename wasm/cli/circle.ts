import type { Mesh } from '../mesh.js';
import type { Circle, Ellipse } from '../path_types.js';
import type { Command, Result } from './command.js';
import { UsageError } from './errors.js';
import { drawnOptions, fieldOptions, levelsOption, type Option } from './options.js';
import { sampleRecords, triples } from './output.js';

const arcOptions = (byDefault: string): readonly Option[] => [
  { name: 'arcs', value: 'N', help: `the number of arcs, 3 to 64; by default ${byDefault}` },
  {
    name: 'samples',
    value: 'N',
    help: 'the number of samples for each arc, both ends included',
    default: '32',
  },
  levelsOption,
];

const circleOutput =
  '{levels, polyline: [[x, y, z], …], samples: [{segment, t, face, bary, position, converged, status}, …], bridged: [{segment, t0, t1, reason}, …], length, notShortest: [arc, …], deviation}';

function resultOf(mesh: Mesh, circle: Ellipse & Partial<Circle>): Result {
  return {
    json: {
      levels: circle.levels,
      polyline: triples(circle.path.polyline({ bits: 64 })),
      samples: sampleRecords(circle.samples),
      bridged: circle.bridged,
      length: circle.path.length,
      notShortest: circle.notShortest,
      deviation: circle.deviation,
    },
    mesh,
    curves: () => [{ path: circle.path }],
  };
}

export const circle: Command = {
  name: 'circle',
  call: 'mesh.circle(center, options)',
  summary: 'a geodesic circle of rational quadratic arcs',
  output: circleOutput,
  options: [
    { name: 'center', value: 'POINT', help: 'the center', required: true },
    { name: 'radius', value: 'R', help: 'the radius, in units of the mesh', required: true },
    ...arcOptions('as many as the tolerance takes'),
    {
      name: 'tolerance',
      value: 'PART',
      help: 'without --arcs, the largest error of the radius, as a part of it',
      default: '0.001',
    },
    ...fieldOptions,
    ...drawnOptions,
  ],
  async run(args) {
    const center = args.point('center');
    const radius = args.number('radius');
    const options = {
      ...args.whereGiven(['arcs'], (name) => args.integer(name)),
      samples: args.integer('samples'),
      levels: args.levels(),
      tolerance: args.number('tolerance'),
    };
    const field = args.field();
    if (args.given('arcs')) args.refuse(['tolerance'], 'with --arcs');
    const mesh = await args.mesh();
    return resultOf(mesh, mesh.circle(center, { radius, ...options, ...field }));
  },
};

export const ellipse: Command = {
  name: 'ellipse',
  call: 'mesh.ellipse(center, options)',
  summary: 'an ellipse of rational quadratic arcs about a point',
  output: circleOutput,
  options: [
    { name: 'center', value: 'POINT', help: 'the center', required: true },
    {
      name: 'radii',
      value: 'A,B',
      help: 'the radii along and across the direction',
      required: true,
    },
    {
      name: 'direction',
      value: 'X,Y,Z',
      help: "the direction of the first radius in space, projected to the center's face",
      required: true,
    },
    ...arcOptions('7'),
    ...fieldOptions,
    ...drawnOptions,
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
    return resultOf(
      mesh,
      mesh.ellipse(center, { radii, direction, ...arcs, samples, levels, ...field }),
    );
  },
};
