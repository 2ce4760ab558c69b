import type { Command } from './command.js';
import { UsageError } from './errors.js';
import { drawnOptions, type Option, pointsOption, radiusOption } from './options.js';
import { pathRecord, triples } from './output.js';

/** Log maps, exp maps and parallel transport of vectors and points. */

const fromOption: Option = {
  name: 'from',
  value: 'POINT',
  help: 'the point where the vectors are tangent',
  required: true,
};

const vectorsOption: Option = {
  name: 'vectors',
  value: 'FILE',
  help: "a line 'x y z' for each vector, or JSON as 'karcher log' prints it",
  required: true,
};

/** The vectors as triples [x, y, z]; null for a missing vector. */
function* vectorRecords(flat: Float64Array) {
  for (const vector of triples(flat)) yield vector.some(Number.isNaN) ? null : vector;
}

export const log: Command = {
  name: 'log',
  call: 'mesh.logMap(from, points)',
  summary: 'the log map: vectors to points, or to all vertices, in the tangent plane at a point',
  output:
    "{vectors: [[x, y, z], …]}, or of all vertices in the file's order: null for a vertex without a face or a path, and beyond the radius",
  options: [
    fromOption,
    {
      ...pointsOption,
      required: false,
      default: 'all vertices',
      help: `points: ${pointsOption.help}`,
    },
    radiusOption,
  ],
  async run(args) {
    const from = args.point('from');
    if (args.given('points')) args.refuse(['radius'], 'with --points');
    const points = args.given('points')
      ? await args.points()
      : args.whereGiven(['radius'], (name) => args.number(name));
    const mesh = await args.mesh();
    return { json: { vectors: vectorRecords(mesh.logMap(from, points).vectors) } };
  },
};

export const exp: Command = {
  name: 'exp',
  call: 'mesh.expMap(from, vectors)',
  summary: 'the exp map: the ends of straightest geodesics along vectors of the tangent plane',
  output:
    '{points: [{face, bary}, …], positions: [[x, y, z], …], remaining: [the length left at the boundary, otherwise 0, …]}',
  options: [fromOption, vectorsOption],
  async run(args) {
    const from = args.point('from');
    const vectors = await args.vectors();
    const mesh = await args.mesh();
    const { points, remaining } = mesh.expMap(from, vectors);
    return {
      json: {
        points,
        positions: points.map((point) => mesh.position(point)),
        remaining: Array.from(remaining),
      },
    };
  },
};

export const transport: Command = {
  name: 'transport',
  call: 'mesh.transport(from, to, vectors), mesh.transportAlong(path, vectors)',
  summary:
    'vectors of a tangent plane, carried along the shortest path to another point, or a path',
  output: '{vectors: [[x, y, z], …]}',
  options: [
    { ...fromOption, required: false },
    { name: 'to', value: 'POINT', help: 'the point where they are carried' },
    {
      name: 'along',
      value: 'FILE',
      help: "in place of --from and --to: a path's points, as 'karcher path' and 'karcher straightest' print them",
    },
    vectorsOption,
  ],
  async run(args) {
    const vectors = await args.vectors();
    if (args.given('along')) {
      args.refuse(['from', 'to'], 'with --along');
      const line = await args.points('along');
      const mesh = await args.mesh();
      return { json: { vectors: vectorRecords(mesh.transportAlong(line, vectors)) } };
    }
    for (const name of ['from', 'to']) {
      if (!args.given(name)) throw new UsageError(`transport needs --${name}, or --along FILE`);
    }
    const from = args.point('from');
    const to = args.point('to');
    const mesh = await args.mesh();
    return { json: { vectors: vectorRecords(mesh.transport(from, to, vectors)) } };
  },
};

export const nearest: Command = {
  name: 'nearest',
  call: 'mesh.nearestPoint(place), mesh.frame(point)',
  summary: 'the point of the surface nearest to a place in space, with its frame',
  output:
    '{point: {face, bary}, position, distance, frame: the unit vectors along the first edge, across it and of the normal}',
  options: [{ name: 'place', value: 'X,Y,Z', help: 'the place in space', required: true }],
  async run(args) {
    const place = args.numbers('place');
    if (place.length !== 3) throw new UsageError('--place takes three numbers');
    const mesh = await args.mesh();
    const found = mesh.nearestPoint(place);
    return { json: { ...found, frame: mesh.frame(found.point) } };
  },
};

export const straightest: Command = {
  name: 'straightest',
  call: 'mesh.straightest(from, direction, length)',
  summary: 'the straightest geodesic that leaves a point in a direction',
  output:
    '{length, polyline: [[x, y, z], …], points: [{face, bary}, …], lengths: from the start to each point, end: {face, bary}, stop: complete|boundary|limit, remaining: the length left at the stop}',
  options: [
    { name: 'from', value: 'POINT', help: 'the start', required: true },
    {
      name: 'direction',
      value: 'X,Y,Z',
      help: "the direction in space, projected to the point's face",
      required: true,
    },
    { name: 'length', value: 'L', help: 'the length in units of the mesh', required: true },
    ...drawnOptions,
  ],
  async run(args) {
    const from = args.point('from');
    const direction = args.numbers('direction');
    if (direction.length !== 3) throw new UsageError('--direction takes three numbers');
    const length = args.number('length');
    const mesh = await args.mesh();
    const { path, ...rest } = mesh.straightest(from, direction, length);
    return {
      json: { ...pathRecord(path), ...rest },
      mesh,
      curves: () => [{ path }],
    };
  },
};

export const mirror: Command = {
  name: 'mirror',
  call: 'mesh.mirror(line, points)',
  summary: 'points mirrored in a geodesic',
  output:
    '{points: [{face, bary}, …], positions: [[x, y, z], …], remaining: [the length left at the boundary, otherwise 0, …]}',
  options: [
    {
      name: 'line',
      value: 'FILE',
      help: "the geodesic's points, as 'karcher path' and 'karcher straightest' print them",
      required: true,
    },
    pointsOption,
  ],
  async run(args) {
    const line = await args.points('line');
    const points = await args.points();
    const mesh = await args.mesh();
    const mirrored = mesh.mirror(line, points);
    return {
      json: {
        points: mirrored.points,
        positions: mirrored.points.map((point) => mesh.position(point)),
        remaining: Array.from(mirrored.remaining),
      },
    };
  },
};
