import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { test } from 'node:test';
import { load } from 'karcher';
import { loadInWorker } from 'karcher/worker';

const karcher = await load();
const mesh = karcher.shape('sphere', 500);
const points = [0, 50, 100, 150].map((vertex) => ({ vertex }));
const quarters = [0.25, 0.25, 0.25, 0.25];
const center = points[0];

// Values that no argument and no option accepts.
const wrong = {
  symbol: Symbol('s'),
  bigint: 10n,
  text: 'x',
  NaN: Number.NaN,
  'a date': new Date(0),
  'no prototype': Object.create(null),
  'a negative length': { length: -1 },
  'a huge length': { length: 2 ** 40 },
  holes: new Array(3),
  'texts in an array': ['a', 'b', 'c'],
  'a vertex that is a text': { vertex: '1' },
  'weights that are a text': { face: 0, bary: 'abc' },
  'a face that is a text': { face: '0', bary: [1, 0, 0] },
};

const withOptions = (make, options, names) =>
  Object.fromEntries(
    names.map((name) => [`${make.name} ${name}`, (value) => make({ ...options, [name]: value })]),
  );
const field = ['method', 'solver', 'rings'];
const radii = [0.3, 0.2];
const direction = [0, 1, 0.3];

const calls = {
  meshFromObj: (value) => karcher.meshFromObj(value),
  positions: (value) => karcher.meshFromArrays(value, [0, 1, 2]),
  triangles: (value) => karcher.meshFromArrays([0, 0, 0, 1, 0, 0, 0, 1, 0], value),
  'shape name': (value) => karcher.shape(value),
  'shape triangles': (value) => karcher.shape('sphere', value),
  subdivide: (value) => mesh.subdivide(value),
  'surfacePoint face': (value) => mesh.surfacePoint(value, [1, 0, 0]),
  'surfacePoint bary': (value) => mesh.surfacePoint(0, value),
  position: (value) => mesh.position(value),
  points: (value) => mesh.centerOfMass(value, quarters),
  weights: (value) => mesh.centerOfMass(points, value),
  'distances, all': (value) => mesh.centerOfMassOfDistances(value, [1]),
  'distances, one': (value) => mesh.centerOfMassOfDistances([value], [1]),
  'distance from': (value) => mesh.distance(value),
  'shortestPath to': (value) => mesh.shortestPath(center, value),
  'straightest direction': (value) => mesh.straightest(center, value, 1),
  'straightest length': (value) => mesh.straightest(center, [1, 2, 3], value),
  ...withOptions(
    function start(options) {
      return mesh.centerOfMass(points, quarters, options);
    },
    {},
    [...field, 'start', 'normalize'],
  ),
  'circle center': (value) => mesh.circle(value, { radius: 0.3 }),
  'ellipse center': (value) => mesh.ellipse(value, { radii, direction }),
  'isolines center': (value) => mesh.isolines(value, { radius: 0.3 }),
  ...withOptions(mesh.circle.bind(mesh, center), { radius: 0.3 }, [
    ...['radius', 'arcs', 'samples'],
    ...field,
  ]),
  ...withOptions(mesh.ellipse.bind(mesh, center), { radii, direction }, [
    ...['radii', 'direction', 'arcs', 'samples'],
    ...field,
  ]),
  ...withOptions(mesh.isolines.bind(mesh, center), { radius: 0.3 }, [
    ...['radius', 'type', 'solver', 'rings'],
  ]),
  ...withOptions(mesh.curve.bind(mesh), { kind: 'bspline', points, samples: 4 }, [
    ...['kind', 'points', 'samples', 'tolerance', 'geometry', 'closed', 'degree', 'knots'],
    ...['weights', 'betas', 'parametrization', 'basis'],
    ...field,
  ]),
  ...withOptions(
    function polyline(options) {
      return mesh.shortestPath(center, points[0]).polyline(options);
    },
    {},
    ['bits'],
  ),
  'a custom basis': (basis) => mesh.curve({ kind: 'custom', points, basis }),
};
const edits = [
  ...['addPoint', 'removePoint', 'setKind', 'setClosed', 'pointAt', 'tangentAt', 'nearest'],
  ...['lengthAt', 'pointAtLength', 'equallySpaced', 'insertOnCurve', 'split', 'join'],
  ...['movePoint', 'insertPoint', 'movePointInOrder', 'setWeight', 'setBeta'],
  ...['setPoints', 'setWeights', 'setBetas'],
];

test('a value of a wrong type is refused with a sentence, wherever it is passed', () => {
  const curve = mesh.curve({ kind: 'bspline', points, samples: 4 });
  for (const name of edits) {
    calls[`curve.${name}`] = (value) => curve[name](value, 0);
    if (curve[name].length > 1) calls[`curve.${name}, second`] = (value) => curve[name](0, value);
  }
  const before = JSON.stringify([curve.points(), curve.samples()]);
  for (const [what, call] of Object.entries(calls)) {
    for (const [kind, value] of Object.entries(wrong)) {
      assert.throws(() => call(value), { name: 'KarcherError' }, `${what}: ${kind}`);
    }
  }
  assert.equal(JSON.stringify([curve.points(), curve.samples()]), before);
});

test('invalid options, progress functions and signals are refused', async () => {
  const badArgument = { name: 'KarcherError', code: 'badArgument' };
  for (const options of [null, 5, 'x', [], () => 0]) {
    assert.throws(() => mesh.curve(options), badArgument);
    assert.throws(() => mesh.circle(center, options), badArgument);
    assert.throws(() => mesh.distance(center, options), badArgument);
    await assert.rejects(mesh.prepare(options), badArgument);
    await assert.rejects(mesh.prepare({}, options), badArgument);
    const progress = typeof options === 'function' ? null : options;
    await assert.rejects(mesh.prepare({}, { progress }), badArgument);
    await assert.rejects(mesh.prepare({}, { signal: options }), badArgument);
  }
  assert.throws(() => mesh.distance(center, { method: 'paper' }), badArgument);
  const distances = [mesh.distance(center)];
  for (const option of [{ solver: 'exact' }, { method: 'paper' }]) {
    assert.throws(() => mesh.centerOfMassOfDistances(distances, [1], option), badArgument);
  }
});

test('isolines at distance zero, of either type', () => {
  for (const type of ['linear', 'exact']) {
    for (const radius of [0, -1]) {
      assert.throws(() => mesh.isolines(center, { radius, type }), {
        code: 'badArgument',
        message: /distance must be a positive number/,
      });
    }
  }
  const three = { direction, radii: [...radii, 0.1] };
  assert.throws(() => mesh.ellipse(center, three), { message: /two radii/ });
});

/** An array after the transfer of its buffer: it looks empty. */
function gone() {
  const array = new Float64Array(9);
  structuredClone(array, { transfer: [array.buffer] });
  return array;
}

test('transferred, excessive and cyclic values are no arguments', async () => {
  const long = new Array(2 ** 32 - 1);
  const local = [
    () => karcher.meshFromArrays(gone(), [0, 1, 2]),
    () => karcher.meshFromArrays([0, 0, 0, 1, 0, 0, 0, 1, 0], gone()),
    () => mesh.curve({ kind: 'custom', points, basis: gone }),
    () => mesh.centerOfMass(long, [1]),
    () => mesh.centerOfMassOfDistances(long, [1]),
  ];
  for (const call of local) assert.throws(call, { name: 'KarcherError', code: 'badArgument' });
  const worker = await loadInWorker();
  const sphere = await worker.shape('sphere', 500);
  const cyclic = [];
  cyclic.push(cyclic);
  const remote = [
    () => sphere.centerOfMass(cyclic, [1]),
    () => worker.meshFromArrays(gone(), [0, 1, 2]),
    () => sphere.position(() => 'a secret of the worker'),
    () => worker.client.call('__defineGetter__', ['shape', () => {}]),
    () => worker.client.call('constructor', []),
  ];
  for (const call of remote) {
    await assert.rejects(call, (error) => {
      assert.equal(error.name, 'KarcherError');
      assert.equal(error.code, 'badArgument');
      assert.doesNotMatch(error.message, /=>/);
      return true;
    });
  }
  assert.equal((await worker.shape('sphere', 500)).info.triangles, sphere.info.triangles);
  worker.dispose();
});

test('numbers whose squares overflow are refused with the limit, or have a result', () => {
  const sphere = karcher.shape('sphere', 500);
  const vertices = sphere.info.vertices;
  const refused = (limit) => (error) => {
    assert.equal(error.name, 'KarcherError');
    assert.equal(error.code, 'badArgument');
    assert.match(error.message, limit);
    return true;
  };
  for (const size of [1e155, 1e200, 1e308]) {
    for (const place of [
      [size, size, size],
      [-size, 0, 0],
    ]) {
      assert.throws(() => sphere.nearestPoint(place), refused(/1e\+30 is allowed/));
    }
    const distances = [new Float64Array(vertices).fill(size), new Float64Array(vertices)];
    assert.throws(
      () => sphere.centerOfMassOfDistances(distances, [0.5, 0.5]),
      refused(/1e\+60 is allowed/),
    );
    // A geodesic ends at a boundary, or after the largest number of crossings.
    for (const point of [{ vertex: 3 }, { face: 3, bary: [0.2, 0.3, 0.5] }]) {
      const { remaining } = sphere.expMap(point, [size / 4, size / 8, 0]);
      assert.ok(remaining[0] > 0 && remaining[0] < size, `${size}: ${remaining[0]}`);
    }
  }
  assert.ok(sphere.nearestPoint([1e30, 0, 0]).distance > 9e29);
  sphere.dispose();
});

test('a wrong worker or signal is refused, and no worker keeps running', async () => {
  const { code, stdout } = await new Promise((resolve) => {
    const program = `
      import { loadInWorker } from 'karcher/worker';
      for (const options of [{ worker: {} }, { worker: () => null }, { signal: 'x' }, { signal: {} }]) {
        await loadInWorker(options).catch(({ name, code }) => console.log(name, code));
      }`;
    const args = ['--input-type=module', '-e', program];
    execFile(process.execPath, args, { timeout: 600_000 }, (error, out) =>
      resolve({ code: error ? (error.code ?? 'it did not end') : 0, stdout: out }),
    );
  });
  assert.equal(code, 0);
  assert.equal(stdout, 'KarcherError badArgument\n'.repeat(4));
});
