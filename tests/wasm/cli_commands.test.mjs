import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { load } from 'karcher';
import { grid, square } from './meshes.mjs';
import { failure, karcher, printed, temporaryFolder } from './run_cli.mjs';

const folder = temporaryFolder();
after(() => folder.remove());

const cells = 12;
const gridFile = folder.write('grid.obj', grid(cells));
const places = [
  [2 * (4 + cells * 4), 0, 0],
  [2 * (8 + cells * 5), 0.25, 0.5],
  [2 * (7 + cells * 8) + 1, 0.1, 0.2],
  [2 * (4 + cells * 7), 0, 0],
  [2 * (5 + cells * 4), 0.3, 0.3],
];
const pointsFile = folder.write(
  'points.txt',
  `# face b1 b2\n\n${places.map((place) => place.join(' ')).join('  # a point\r\n')}\n`,
);
const points = places.map(([face, b1, b2]) => ({ face, bary: [1 - b1 - b2, b1, b2] }));
const paper = { method: 'paper', solver: 'exact' };
const weights = '0.1,0.2,0.3,0.4,0';

const mesh = (await load()).meshFromObj(grid(cells));

test('distance prints the numbers of the API', async () => {
  for (const [point, from] of [
    ['v:40', { vertex: 40 }],
    ['57:0.25,0.5', { face: 57, bary: [0.25, 0.25, 0.5] }],
  ]) {
    for (const solver of ['fast', 'exact', 'graph']) {
      const rings = solver === 'graph' ? { rings: 3 } : {};
      const { distance, ...rest } = await printed(
        ...['distance', gridFile, '--from', point, '--solver', solver],
        ...(rings.rings ? ['--rings', '3'] : []),
      );
      assert.deepEqual(rest, {});
      assert.deepEqual(distance, Array.from(mesh.distance(from, { solver, ...rings })));
    }
  }
});

test('distance follows the vertices of the file', async () => {
  // A vertex without a face, then the square, then a separate triangle.
  const text = `v 9 9 9\n${square.replace('f 1 2 3 4', 'f 2 3 4 5')}v 5 0 0\nv 6 0 0\nv 5 1 0\nf 6 7 8\n`;
  const file = folder.write('parts.obj', text);
  const { distance } = await printed('distance', file, '--from', 'v:1', '--solver', 'exact');
  assert.equal(distance[0], null);
  assert.deepEqual(distance.slice(5), [null, null, null]);
  [0, 1, Math.SQRT2, 1].forEach((expected, i) => {
    assert.ok(Math.abs(distance[i + 1] - expected) < 1e-12);
  });
});

test('path, as JSON and as an OBJ file', async () => {
  const args = ['path', gridFile, '--from', '0:0.25,0.25', '--to', 'v:100'];
  const { length, polyline } = await printed(...args);
  const expected = mesh.shortestPath({ face: 0, bary: [0.5, 0.25, 0.25] }, { vertex: 100 });
  assert.equal(length, expected.length);
  assert.deepEqual(polyline.flat(), Array.from(expected.polyline({ bits: 64 })));
  const { status, stdout } = await karcher(...args, '--format', 'obj');
  assert.equal(status, 0);
  const lines = stdout.trimEnd().split('\n');
  assert.deepEqual(lines.slice(0, -1), [
    'o path',
    ...polyline.map((place) => `v ${place.join(' ')}`),
  ]);
  assert.equal(lines.at(-1), `l ${polyline.map((_, i) => i + 1).join(' ')}`);
});

test('mean prints the center of mass', async () => {
  const args = ['mean', gridFile, '--points', pointsFile];
  const mean = await printed(...args, '--weights', weights);
  const masses = [0.1, 0.2, 0.3, 0.4, 0];
  assert.deepEqual(mean, mesh.centerOfMass(points, masses));
  const papers = await printed(...args, '--weights', weights, '--method', 'paper');
  assert.deepEqual(papers, mesh.centerOfMass(points, masses, paper));
  const ring = await printed(...args, '--weights', weights, '--method', 'paper', '--star', 'ring');
  assert.deepEqual(ring, mesh.centerOfMass(points, masses, { ...paper, star: 'ring' }));
  const scaled = await printed(...args, '--weights', '1,2,3,4,0', '--normalize');
  assert.ok(Math.abs(scaled.position[0] - mean.position[0]) < 1e-12);
  // A list that begins with a negative weight.
  const negative = await printed(...args, '--weights', '-0.1,0.3,0.4,0.4,0');
  assert.equal(negative.status, 'converged');
  const graph = await printed(...args, '--weights', weights, '--solver', 'graph', '--rings', '2');
  assert.deepEqual(graph, mesh.centerOfMass(points, masses, { solver: 'graph', rings: 2 }));
  const certified = await printed(...args, '--weights', weights, '--certificate');
  assert.deepEqual(certified, mesh.centerOfMass(points, masses, { certificate: true }));
});

test('mean of many rows of weights, from a start, and with equal weights', async () => {
  const args = ['mean', gridFile, '--points', pointsFile];
  const rows = [
    [0.1, 0.2, 0.3, 0.4, 0],
    [0.5, 0, 0, 0, 0.5],
  ];
  const lines = rows.map((row) => row.join(' ')).join('\n');
  const file = folder.write('rows.txt', `# two means\n${lines}\n`);
  const { means } = await printed(...args, '--rows', file, '--check');
  assert.equal(means.length, 2);
  for (const [i, row] of rows.entries()) {
    const alone = mesh.centerOfMass(points, row);
    for (const name of ['point', 'position', 'status', 'energy']) {
      assert.deepEqual(means[i][name], alone[name]);
    }
  }
  const start = { vertex: 84 };
  const equal = [0.2, 0.2, 0.2, 0.2, 0.2];
  const from = await printed(...args, '--start', 'v:84');
  assert.deepEqual(from, mesh.centerOfMass(points, equal, { start }));
  for (const [more, message] of [
    [['--rows', file, '--weights', '1'], /--rows has no use with --weights/],
    [['--check'], /--check has no use without --rows/],
    [['--rows', file, '--paths'], /--paths has no use with --rows/],
    [['--rows', pointsFile], /3 weights|rows? /],
  ]) {
    assert.match(await failure(...args, ...more), message);
  }
});

test('distance from the nearest of several points', async () => {
  const { distance } = await printed('distance', gridFile, '--from', 'v:3 0:0.2,0.3');
  const sources = [{ vertex: 3 }, { face: 0, bary: [0.5, 0.2, 0.3] }];
  assert.deepEqual(distance, Array.from(mesh.distance(sources)));
});

test('weights prints weights that make a point the center of mass', async () => {
  const [{ face, bary }] = points;
  const at = `${face}:${bary[1]},${bary[2]}`;
  const args = ['weights', gridFile, '--points', pointsFile, '--point', at];
  const plain = mesh.weightsOf(points[0], points);
  assert.deepEqual(await printed(...args), { ...plain, weights: Array.from(plain.weights) });
  const given = await printed(...args, '--weights', weights, '--non-negative', '--solver', 'exact');
  const options = { weights: weights.split(',').map(Number), nonNegative: true, solver: 'exact' };
  assert.deepEqual(given.weights, Array.from(mesh.weightsOf(points[0], points, options).weights));
  assert.match(
    await failure('weights', gridFile, '--points', pointsFile, '--point', '1 2'),
    /--point/,
  );
});

test('mean with the shortest paths to the points', async () => {
  const args = ['mean', gridFile, '--points', pointsFile, '--weights', weights];
  const { paths, ...mean } = await printed(...args, '--paths');
  assert.deepEqual(mean, await printed(...args));
  assert.equal(paths.length, points.length);
  paths.forEach(({ length, polyline }, i) => {
    const expected = mesh.shortestPath(mean.point, points[i]);
    assert.equal(length, expected.length);
    assert.deepEqual(polyline.flat(), Array.from(expected.polyline({ bits: 64 })));
  });
});

test('trace prints the samples of a curve', async () => {
  for (const [kind, segments] of [
    ['bspline', 2],
    ['bezier', 1],
  ]) {
    const { samples, polyline, length, ms } = await printed(
      ...['trace', gridFile, '--points', pointsFile, '--kind', kind, '--samples', '9'],
      ...['--method', 'paper', '--solver', 'exact'],
    );
    const curve = mesh.curve({ kind, points, samples: 9, ...paper });
    assert.equal(samples.length, 9 * segments);
    samples.forEach((sample, i) => {
      assert.deepEqual(Object.keys(sample), [
        'segment',
        't',
        'face',
        'bary',
        'position',
        'converged',
        'status',
      ]);
      assert.equal(sample.segment, Math.floor(i / 9));
      assert.equal(sample.t, (i % 9) / 8);
      assert.equal(sample.converged, true);
      assert.equal(sample.status, 'converged');
      assert.equal(sample.face, curve.samples().face[i]);
    });
    assert.deepEqual(
      samples.flatMap(({ bary }) => bary),
      Array.from(curve.samples().bary),
    );
    assert.deepEqual(
      samples.flatMap(({ position }) => position),
      Array.from(curve.samples().position),
    );
    assert.deepEqual(polyline.flat(), Array.from(curve.polyline({ bits: 64 })));
    assert.equal(length, curve.length);
    for (const key of ['prepare', 'fields', 'trace']) assert.ok(ms[key] >= 0);
  }
});

test('trace knows every kind of curve', async () => {
  const curves = [
    [['--closed', '--degree', '2'], { kind: 'bspline', closed: true, degree: 2 }],
    [['--knots', 'clamped'], { kind: 'bspline', knots: 'clamped' }],
    [
      ['--degree', '2', '--knots', '0,0,0,1,3,4,4,4', '--weights', '1,2,1,1,1'],
      { kind: 'bspline', degree: 2, knots: [0, 0, 0, 1, 3, 4, 4, 4], weights: [1, 2, 1, 1, 1] },
    ],
    [
      ['--kind', 'rational', '--weights', '1,2,3,2,1'],
      { kind: 'rational', weights: [1, 2, 3, 2, 1] },
    ],
    [
      ['--kind', 'barycentric', '--betas', '1,4,6,4,1'],
      { kind: 'barycentric', betas: [1, 4, 6, 4, 1] },
    ],
    [['--kind', 'catmullrom'], { kind: 'catmullrom' }],
    [
      ['--kind', 'catmullrom', '--parametrization', 'uniform', '--closed'],
      { kind: 'catmullrom', parametrization: 'uniform', closed: true },
    ],
    [['--kind', 'polyline'], { kind: 'polyline' }],
  ];
  for (const [args, options] of curves) {
    const { length, samples } = await printed('trace', gridFile, '--points', pointsFile, ...args);
    const curve = mesh.curve({ points, ...options });
    assert.equal(length, curve.length);
    assert.equal(samples.length, curve.samples().count);
  }
  const adaptive = await printed('trace', gridFile, '--points', pointsFile, '--tolerance', '1e-3');
  const curve = mesh.curve({ kind: 'bspline', points, samples: 'adaptive', tolerance: 1e-3 });
  assert.equal(adaptive.samples.length, curve.samples().count);
  const byDefault = await printed(
    'trace',
    gridFile,
    '--points',
    pointsFile,
    '--samples',
    'adaptive',
  );
  assert.ok(byDefault.samples.length > adaptive.samples.length);
});

test('points printed by trace are read back at the same place', async () => {
  const { samples } = await printed('trace', gridFile, '--points', pointsFile, '--samples', '5');
  const text = samples.map(({ face, bary }) => `${face} ${bary[1]} ${bary[2]}\n`).join('');
  const file = folder.write('again.txt', text);
  for (const [i, sample] of samples.entries()) {
    const oneHot = samples.map((_, j) => (i === j ? 1 : 0)).join(',');
    const mean = await printed('mean', gridFile, '--points', file, '--weights', oneHot);
    mean.position.forEach((value, k) => {
      assert.ok(Math.abs(value - sample.position[k]) < 1e-9);
    });
  }
});

test('trace draws a curve as an OBJ file', async () => {
  const { status, stdout } = await karcher(
    ...['trace', gridFile, '--points', pointsFile, '--samples', '5', '--format', 'obj'],
  );
  assert.equal(status, 0);
  const vertices = stdout.match(/^v /gm).length;
  const numbers = [...stdout.matchAll(/^l (.*)$/gm)].flatMap((match) => match[1].split(' '));
  assert.deepEqual(
    numbers.map(Number),
    Array.from({ length: vertices }, (_, i) => i + 1),
  );
});

test('circle prints samples at its radius', async () => {
  const { polyline, samples, length, notShortest } = await printed(
    ...['circle', gridFile, '--center', 'v:84', '--radius', '3', '--arcs', '5'],
  );
  assert.equal(samples.length, 5 * 32);
  for (const { position } of samples) {
    assert.ok(Math.abs(Math.hypot(position[0] - 6, position[1] - 6) - 3) < 1e-9);
  }
  assert.ok(polyline.length >= samples.length - 5);
  assert.ok(Math.abs(length / (6 * Math.PI) - 1) < 1e-3);
  assert.deepEqual(notShortest, []);
});

test('isolines of both types, and ellipse', async () => {
  const about = ['--center', 'v:84'];
  for (const type of ['linear', 'exact']) {
    const { isolines } = await printed(
      ...['isolines', gridFile, ...about, '--radius', '3', '--type', type],
    );
    const [{ lines }] = isolines;
    const expected = mesh.isolines({ vertex: 84 }, { radius: 3, type });
    assert.equal(lines.length, 1);
    assert.equal(lines[0].closed, true);
    assert.equal(lines[0].length, expected[0].length);
    assert.deepEqual(lines[0].polyline.flat(), Array.from(expected[0].polyline({ bits: 64 })));
  }
  const { samples } = await printed(
    ...['ellipse', gridFile, ...about, '--radii', '3,2', '--direction', '0,1,0'],
  );
  for (const { position } of samples) {
    assert.ok(Math.abs(Math.hypot((position[0] - 6) / 2, (position[1] - 6) / 3) - 1) < 1e-9);
  }
});

test('bench prints every timing', async () => {
  const report = await printed('bench', gridFile, '--points', pointsFile, '--samples', '16');
  assert.deepEqual(report.mesh, { vertices: 169, triangles: 288 });
  assert.equal(report.paper.samples, 32);
  assert.equal(report.paper.lost, 0);
  for (const key of [
    'graphMs',
    'fieldGraphMs',
    'fieldExactMs',
    'gradientMs',
    'sampleUs',
    'dragMs',
  ]) {
    assert.ok(report.paper[key] >= 0 && Number.isFinite(report.paper[key]), key);
  }
  assert.equal(report.karcher.samples, 32);
  assert.equal(report.karcher.lost, 0);
  for (const key of [
    'fieldMs',
    'fieldVertices',
    'fieldNsPerVertex',
    'sampleNs',
    'dragMs',
    'weightMs',
  ]) {
    assert.ok(report.karcher[key] > 0 && Number.isFinite(report.karcher[key]), key);
  }
  for (const key of ['fieldMs', 'fieldVertices', 'fieldNsPerVertex']) {
    assert.ok(report.exact[key] > 0 && Number.isFinite(report.exact[key]), key);
  }
  for (const key of ['prepareMs', 'calibrationNs', 'peakMemoryMB']) {
    assert.ok(report[key] > 0 && Number.isFinite(report[key]), key);
  }
});

test('bad points, weights and radii: a sentence and status 1', async () => {
  let files = 0;
  const file = (text) => folder.write(`wrong${files++}.txt`, text);
  const from = (point) => ['distance', gridFile, '--from', point];
  const mean = (text, list) => ['mean', gridFile, '--points', file(text), '--weights', list];
  const trace = (text, ...more) => ['trace', gridFile, '--points', file(text), ...more];
  const circle = (radius) => ['circle', gridFile, '--center', 'v:84', '--radius', radius];
  const isolines = (radius) => ['isolines', gridFile, '--center', 'v:84', '--radius', radius];
  const three = '0 0 0\n1 0 0\n2 0 0\n';
  const wrong = [
    [from('v:999'), /no vertex 999/],
    [from('v:-1'), /must be a point/],
    [from('v:1.5'), /must be a point/],
    [from('vertex'), /must be a point/],
    [from('3'), /must be a point/],
    [from('3:0.5'), /must be a point/],
    [from('3:0.5,0.2,0.3'), /must be a point/],
    [from('3:0.5,x'), /b2 of --from must be a number, not 'x'/],
    [from('3:0.5,NaN'), /must be a number/],
    [from('3:0.5,1e999'), /must be a number/],
    [from('3:0.7,0.7'), /in face 3 lies outside/],
    [from('288:0,0'), /no face 288: the mesh has 288/],
    [mean(three, '0.3,0.3'), /3 points but 2 weights/],
    [mean(three, '0.3,0.3,0.3'), /sum to 0\.9/],
    [mean(three, '0.3,,0.7'), /number 2 of --weights must be a number, not ''/],
    [mean(three, 'a,b,c'), /number 1 of --weights/],
    [mean('', '1'), /at least one point/],
    [
      mean('0 0 0\n\n0 0.5\n', '1'),
      /line 3 of .*wrong\d+\.txt must be 'face b1 b2', .* or 'v:vertex', not '0 0\.5'/,
    ],
    [mean('0 0 0 # fine\n0 0 zero\n', '1'), /b2 of line 2 of .*wrong\d+\.txt must be a number/],
    [mean('-1 0 0\n', '1'), /line 1 of .* must be 'face b1 b2'/],
    [mean('0 0.9 0.9\n', '1'), /in face 0 lies outside/],
    [['mean', gridFile, '--points', `${folder.path}/none`, '--weights', '1'], /no such file/],
    [trace(three), /at least 4 control points, not 3/],
    [trace(three, '--kind', 'line'), /--kind must be one of bspline, bezier, .*, not 'line'/],
    [trace(three, '--kind', 'bezier', '--samples', '1'), /2 to 100000 samples/],
    [trace(three, '--samples', 'many'), /--samples must be a number/],
    [trace(three, '--levels', 'foo'), /--levels must be a whole number, auto or limit, not 'foo'/],
    [trace(three, '--levels', '1.5'), /--levels must be a whole number, auto or limit, not '1.5'/],
    [trace(three, '--samples', '9', '--tolerance', '1e-3'), /--samples or --tolerance, not both/],
    [trace(three, '--tolerance', '0'), /tolerance must be positive/],
    [trace(three, '--degree', '2', '--knots', '0,1,2'), /takes 6 knots, not 3/],
    [trace(three, '--degree', '9'), /degree 1 to 5, not 9/],
    [trace(three, '--kind', 'rational', '--weights', '1,2'), /3 control points but 2 weights/],
    [trace(three, '--kind', 'bezier', '--weights', '1,2,1'), /has no weights/],
    [trace(three, '--kind', 'bezier', '--degree', '2'), /'bezier' takes no degree/],
    [trace(three, '--knots', 'clampd'), /--knots must be uniform, clamped or numbers/],
    [trace(three, '--kind', 'bezier', '--knots', 'clamped'), /'bezier' takes no knots/],
    [trace(three, '--parametrization', 'uniform'), /'bspline' takes no parametrization/],
    [trace(three, '--rings', '3'), /'fast' has no rings/],
    [trace(three, '--kind', 'barycentric', '--betas', '1,x,1'), /number 2 of --betas/],
    [trace(three, '--closed', '--knots', 'clamped', '--degree', '2'), /no ends to clamp/],
    [trace(three, '--method', 'other'), /--method must be one of/],
    [circle('100'), /goes beyond the farthest vertex/],
    [circle('5.99'), /meets the boundary/],
    [circle('0'), /the radius must be a positive number, not 0/],
    [circle('wide'), /--radius must be a number, not 'wide'/],
    [[...circle('2'), '--arcs', '2'], /a circle has 3 to 64 arcs, not 2/],
    [[...circle('2'), '--arcs', '5', '--tolerance', '.1'], /--tolerance has no use with --arcs/],
    [[...circle('2'), '--tolerance', '0'], /tolerance must be a positive number, not 0/],
    [[...isolines('2'), '--solver', 'fast'], /--solver has no use/],
    [[...isolines('2'), '--type', 'linear', '--rings', '3'], /'exact' has no rings/],
    [[...isolines('0'), '--type', 'linear'], /distance must be a positive number/],
  ];
  for (const [args, message] of wrong) assert.match(await failure(...args), message);
});

test('compare prints each method with its measures or its reason', async () => {
  const args = ['compare', gridFile, '--points', pointsFile, '--samples', '5', '--landmarks', '40'];
  const { mesh: printedMesh, methods } = await printed(...args);
  assert.deepEqual(printedMesh, { vertices: 169, triangles: 288, meanEdge: mesh.info.meanEdge });
  assert.deepEqual(Object.keys(methods), [
    ...['vectorHeat', 'affineHeat', 'weightedAverages', 'descent', 'bSurf', 'paper', 'karcher'],
    'leveled',
  ]);
  const keys = [
    ...['solver', 'ok', 'reason', 'prepareMs', 'traceMs', 'fieldsMs', 'dragMs', 'dragFieldMs'],
    ...['memory', 'samples', 'lost', 'lostByOwnRule', 'logMaps', 'deviation', 'turningNoise'],
    ...['breaks', 'sharpestTurn', 'ruler', 'drag'],
  ];
  for (const [name, method] of Object.entries(methods)) {
    assert.deepEqual(Object.keys(method), keys, name);
    assert.equal(method.ok, name !== 'descent', `${name}: ${method.reason}`);
    assert.equal(method.samples, method.ok ? 10 : null, name);
    assert.equal(method.reason === null, method.ok, name);
  }
  // On the plane, log vectors of both solvers are exact.
  assert.ok(methods.karcher.deviation.max < 1e-8);
  assert.match(methods.descent.reason, /two points/);
  const two = folder.write('two.txt', '3 0 0\n200 0.1 0.2\n');
  const pair = await printed(
    'compare',
    gridFile,
    '--points',
    two,
    '--samples',
    '9',
    '--landmarks',
    '40',
  );
  assert.equal(pair.methods.descent.ok, true);
  // The deviation is from the exact path, which is straight here; our path lies on it.
  assert.ok(pair.methods.karcher.deviation.max < 1e-8);
  assert.ok(pair.methods.descent.deviation.max > 0);
  const delaunay = (await printed(...args, '--delaunay', '--budget', '60')).methods;
  assert.equal(delaunay.vectorHeat.ok, true);
  assert.match(await failure(...args, '--budget', '-1'), /--budget must be at least 0/);
  const asPrinted = ['--solver', 'exact', '--star', 'ring', '--seeds', 'heaviest', '--drag', '0'];
  const { paper, karcher } = (await printed(...args, ...asPrinted)).methods;
  assert.equal(
    paper.solver,
    'exact distances; gradients of the faces around a vertex; seeds at the heaviest points',
  );
  assert.equal(paper.drag, null);
  assert.equal(karcher.solver, methods.karcher.solver);
  assert.notDeepEqual(paper.deviation, methods.paper.deviation);
  const twoRings = (await printed(...args, '--rings', '2', '--drag', '0')).methods.paper;
  assert.match(twoRings.solver, /^graph distances, k = 2; .* and beyond; authors’ seeds$/);
  assert.match(await failure(...args, '--solver', 'fast'), /--solver must be one of exact, graph/);
  assert.match(await failure(...args, '--solver', 'exact', '--rings', '2'), /--rings/);
  assert.match(
    await failure('compare', gridFile, '--points', folder.write('one.txt', '3 0 0\n')),
    /2 points/,
  );
});
