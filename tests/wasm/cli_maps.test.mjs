// Maps, isolines and mesh files on the command line, including pipes of a shell.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { Readable, Writable } from 'node:stream';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load } from 'karcher';
import { meshFromFile } from 'karcher/formats';
import { glbFile } from './mesh_files.mjs';
import { grid } from './meshes.mjs';
import { failure, karcher, karcherReading, printed, temporaryFolder } from './run_cli.mjs';

const { main } = await import(new URL('./cli/main.js', import.meta.resolve('karcher')));
const program = fileURLToPath(new URL('./cli.js', import.meta.resolve('karcher')));
const folder = temporaryFolder();
after(() => folder.remove());

const cells = 8;
const plane = folder.write('plane.obj', grid(cells));
/** Vertex x, y of the grid. */
const at = (x, y) => `v:${x + (cells + 1) * y}`;
const near = (a, b, tolerance = 1e-9) =>
  assert.ok(
    a.length === b.length && a.every((x, i) => Math.abs(x - b[i]) < tolerance),
    `${a} is not ${b}`,
  );

/** Runs a shell command line in which `karcher` is the program. */
function shell(line) {
  const quoted = `karcher() { "${process.execPath}" "${program}" "$@"; }; ${line}`;
  const { status, stdout, stderr } = spawnSync('bash', ['-o', 'pipefail', '-c', quoted], {
    cwd: folder.path,
  });
  return { status, stdout, stderr: stderr.toString() };
}

test('log and exp are inverse to each other through a pipe', async () => {
  const from = ['--from', at(3, 2)];
  const points = folder.write('points.txt', `${at(5, 2)}\n40:0.25,0.5 # short\n7 0.1 0.2\n`);
  const { vectors } = await printed('log', plane, ...from, '--points', points);
  near(vectors[0], [2, 0, 0]);
  const piped = shell(
    `karcher log plane.obj --from ${at(3, 2)} --points points.txt | karcher exp plane.obj --from ${at(3, 2)} --vectors -`,
  );
  assert.equal(piped.status, 0, piped.stderr);
  const back = JSON.parse(piped.stdout);
  near(back.positions[0], [5, 2, 0]);
  near(back.remaining, [0, 0, 0]);
  assert.equal(back.points[1].face, 40);
  near(back.points[1].bary, [0.25, 0.25, 0.5]);
  const all = await printed('log', plane, ...from);
  assert.equal(all.vectors.length, (cells + 1) ** 2);
  near(all.vectors[0], [-3, -2, 0]);
  const lines = folder.write('vectors.txt', '1 0 0\n0, 1, 0 # a comment\n');
  const { positions } = await printed('exp', plane, ...from, '--vectors', lines);
  near(positions.flat(), [4, 2, 0, 3, 3, 0]);
});

test('straightest geodesics, transport and mirror on a plane', async () => {
  const straight = ['straightest', plane, '--from', at(1, 1), '--direction', '3,4,0'];
  const line = await printed(...straight, '--length', '5');
  assert.equal(line.stop, 'complete');
  near(line.polyline.at(-1), [4, 5, 0]);
  assert.ok(Math.abs(line.length - 5) < 1e-9);
  const short = await printed(...straight, '--length', '50');
  assert.equal(short.stop, 'boundary');
  assert.ok(short.remaining > 30);
  const drawn = await karcher(...straight, '--length', '5', '--format', 'obj');
  assert.match(drawn.stdout, /^o straightest\nv 1 1 0\n/);

  const vectors = folder.write('carried.json', '[[1, 2, 0], [0, 1, 0]]');
  const carried = ['transport', plane, '--from', at(1, 1), '--to', at(6, 3), '--vectors', vectors];
  near((await printed(...carried)).vectors.flat(), [1, 2, 0, 0, 1, 0]);

  const mirrored = shell(
    `karcher path plane.obj --from ${at(4, 0)} --to ${at(4, 8)} | karcher mirror plane.obj --line - --points points.txt`,
  );
  assert.equal(mirrored.status, 0, mirrored.stderr);
  near(JSON.parse(mirrored.stdout).positions[0], [3, 2, 0]);
});

test('isolines of several radii', async () => {
  const base = ['isolines', plane, '--center', at(4, 4), '--radius', '1.5,3,30'];
  const { isolines } = await printed(...base);
  assert.deepEqual(
    isolines.map(({ radius, lines }) => [radius, lines.length]),
    [
      [1.5, 1],
      [3, 1],
      [30, 0],
    ],
  );
  for (const { radius, lines } of isolines) {
    for (const { closed, length, polyline } of lines) {
      assert.ok(closed && Math.abs(length - 2 * Math.PI * radius) < 1e-6);
      for (const [x, y] of polyline) assert.ok(Math.abs(Math.hypot(x - 4, y - 4) - radius) < 1e-9);
    }
  }
  const linear = await printed(...base, '--type', 'linear', '--solver', 'graph', '--rings', '3');
  assert.equal(linear.isolines[0].lines.length, 1);
  const drawn = await karcher(...base, '--format', 'obj');
  assert.equal(drawn.stdout.match(/^l /gm).length, 2);
});

test('points are read from the JSON that commands print', async () => {
  const end = await printed(
    'straightest',
    plane,
    '--from',
    at(1, 1),
    '--direction',
    '1,0,0',
    '--length',
    '3.5',
  );
  const point = JSON.stringify(end.end);
  const path = await printed('path', plane, '--from', at(1, 1), '--to', point);
  assert.ok(Math.abs(path.length - 3.5) < 1e-9);
  const whole = await printed(
    'path',
    plane,
    '--from',
    '{"vertex": 10}',
    '--to',
    JSON.stringify(end),
  );
  assert.ok(Math.abs(whole.length - 3.5) < 1e-9);
  const mean = await karcherReading(
    JSON.stringify([{ vertex: 0 }, { vertex: 2 }, end.end]),
    ...['mean', plane, '--points', '-', '--weights', '1,1,2', '--normalize'],
  );
  near(JSON.parse(mean.stdout).position, [(0 + 2 + 9) / 4, 0.5, 0], 1e-6);
  // Samples of a curve, and the points of a path.
  const traced = await karcher(
    'trace',
    plane,
    '--kind',
    'bezier',
    '--points',
    '-',
    '--samples',
    '3',
  );
  assert.equal(traced.status, 1);
  const curve = await karcherReading(
    `${at(1, 1)}\n${at(4, 6)}\n${at(7, 1)}\n`,
    'trace',
    plane,
    ...['--kind', 'bezier', '--points', '-', '--samples', '5', '--levels', '0'],
  );
  const again = await karcherReading(
    curve.stdout,
    'log',
    plane,
    '--from',
    at(1, 1),
    '--points',
    '-',
  );
  const { vectors } = JSON.parse(again.stdout);
  assert.equal(vectors.length, 5);
  near(vectors.at(-1), [6, 0, 0]);
  for (const [text, message] of [
    ['{"face": 3}', /--to must be a point as JSON/],
    ['[1', /--to is no JSON/],
    ['{"point": {"face": "a"}}', /--to must be a point as JSON/],
    ['{"face": 3, "bary": [1, 2]}', /bary|weights/],
  ]) {
    assert.match(await failure('path', plane, '--from', 'v:0', '--to', text), message);
  }
});

/** A drawing as the page saves it. */
function drawing(...figures) {
  const settings = {
    closed: false,
    degree: 2,
    clamped: true,
    knots: null,
    parametrization: 'centripetal',
  };
  const objects = figures.map((figure, id) => ({ id: id + 1, figure: { settings, ...figure } }));
  return JSON.stringify({
    format: 'karcher-curve',
    version: 2,
    drawing: { format: 'karcher-drawing', version: 1, active: 1, objects },
  });
}

test('drawings of the page are read as curves and points', async () => {
  const points = [
    { face: 0, bary: [0.2, 0.3, 0.5] },
    { face: 60, bary: [0.2, 0.3, 0.5], weight: 3 },
    { face: 100, bary: [0.2, 0.3, 0.5] },
  ];
  const file = folder.write(
    'drawing.json',
    drawing({ kind: 'bspline', points }, { kind: 'circle', points: [] }),
  );
  const lines = points.map(({ face, bary }) => `${face} ${bary[1]} ${bary[2]}\n`).join('');
  const plain = folder.write('plain.txt', lines);
  const same = ['--points', plain, '--degree', '2', '--knots', 'clamped', '--weights', '1,3,1'];
  const { polyline } = await printed('trace', plane, ...same);
  const traced = await printed('trace', plane, '--curve', file);
  near(traced.polyline.flat(), polyline.flat());
  const weights = ['--weights', '1,1,1', '--normalize'];
  const [drawn, listed] = [file, plain].map((name) =>
    printed('mean', plane, '--points', name, ...weights),
  );
  near((await drawn).position, (await listed).position);
  const round = folder.write('round.json', drawing({ kind: 'circle', points: [] }));
  assert.match(await failure('trace', plane, '--curve', round), /has no spline: circle only/);
  assert.match(
    await failure('mean', plane, '--points', round, ...weights),
    /must have one object with points: it has 0/,
  );
});

/** A bow tie, an edge of three faces, an unwelded seam, a repeated face and a loose vertex. */
const broken = `${[
  ...['0 0 0', '1 0 0', '1 1 0', '-1 0 0', '-1 -1 0', '5 0 0', '6 0 0', '5 1 0', '6 0 0'],
  ...['6 1 0', '5 1 0', '9 9 9', '5 -1 0', '5 0 1'],
]
  .map((place) => `v ${place}\n`)
  .join('')}f 1 2 3\nf 1 4 5\nf 6 7 8\nf 9 10 11\nf 6 7 13\nf 6 7 14\nf 1 2 3\n`;

test('repair writes the repaired surface, and reports the repairs', async () => {
  const mesh = folder.write('broken.obj', broken);
  const file = join(folder.path, 'mended.ply');
  const told = await printed('repair', mesh, '--out', file);
  const { repairs } = await printed('info', mesh);
  assert.deepEqual(told.repairs, repairs);
  assert.deepEqual([told.vertices, told.triangles], [16, 6]);
  const engine = await load();
  const again = await meshFromFile(engine, readFileSync(file), { name: file });
  assert.equal(again.mesh.info.triangles, 6);
  // Points keep the file's order and their places.
  const before = engine.meshFromObj(broken);
  const places = (of) => {
    const [positions, corners] = [of.positions(), of.triangles()];
    return Array.from(corners, (v) => Array.from(positions.slice(3 * v, 3 * v + 3)).join(' '));
  };
  assert.deepEqual(places(again.mesh), places(before).slice(0, 18));
  assert.match(await failure('repair', mesh, '--out', 'mended.txt'), /must end in \.stl, /);
  assert.match(await failure('repair', mesh), /repair needs --out FILE/);
  assert.match(await failure('repair', mesh, '--repair', 'none', '--out', file), /no use/);
});

test('convert writes every format to a file and to a pipe', async () => {
  const { triangles, meanEdge } = await printed('info', plane);
  for (const format of ['obj', 'ply', 'stl', 'glb']) {
    const file = join(folder.path, `out.${format}`);
    assert.equal((await printed('convert', plane, '--out', file)).triangles, triangles);
    const piped = shell(
      `cat plane.obj | karcher convert - --out - --to ${format} | tee piped | karcher info -`,
    );
    assert.equal(piped.status, 0, piped.stderr);
    assert.ok(readFileSync(join(folder.path, 'piped')).equals(readFileSync(file)), format);
    const seen = JSON.parse(piped.stdout);
    assert.equal(seen.triangles, triangles);
    assert.ok(Math.abs(seen.meanEdge - meanEdge) < 1e-6);
  }
  const same = shell(`karcher path plane.obj --from v:0 --to v:9 --out -`);
  assert.deepEqual(
    JSON.parse(same.stdout),
    await printed('path', plane, '--from', 'v:0', '--to', 'v:9'),
  );
});

test('each of several meshes has a line, and a failing one does not stop the others', async () => {
  const other = folder.write('other.glb', '');
  const { writeFileSync } = await import('node:fs');
  const square = {
    positions: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
    faces: [
      [0, 1, 2],
      [0, 2, 3],
    ],
  };
  writeFileSync(other, glbFile(square));
  const { status, stdout, stderr } = await karcher('info', plane, 'missing.obj', other);
  assert.equal(status, 1);
  assert.match(stderr, /^karcher: cannot read missing\.obj: there is no such file\n$/);
  const lines = stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  assert.deepEqual(
    lines.map(({ mesh, triangles }) => [basename(mesh), triangles]),
    [
      ['plane.obj', 2 * cells ** 2],
      ['other.glb', 2],
    ],
  );
  const star = join(folder.path, 'copy_*.stl');
  assert.equal((await karcher('convert', plane, other, '--out', star)).status, 0);
  const written = readdirSync(folder.path).filter((name) => name.startsWith('copy_'));
  assert.deepEqual(written.sort(), ['copy_other.stl', 'copy_plane.stl']);
  // A dollar sign in a mesh's name stays one.
  const named = ['a$.glb', 'a$$.glb', "$'.glb"].map((name) => folder.write(name, ''));
  for (const name of named) writeFileSync(name, glbFile(square));
  const dollar = join(folder.path, 'dollar_*_.ply');
  assert.equal((await karcher('convert', ...named, '--out', dollar)).status, 0);
  assert.deepEqual(
    readdirSync(folder.path)
      .filter((name) => name.startsWith('dollar_'))
      .sort(),
    ['dollar_a$_.ply', 'dollar_a$$_.ply', "dollar_$'_.ply"].sort(),
  );
  assert.match(await failure('convert', plane, other, '--out', 'a.stl'), /needs a '\*'/);
  assert.match(
    await failure('convert', plane, other, 'a/plane.ply', '--out', star),
    /--out .*'.*plane\.obj' and 'a\/plane\.ply' are both named 'plane'/,
  );
  const drawn = ['--from', 'v:0', '--to', 'v:2', '--format', 'obj'];
  assert.match(await failure('path', plane, other, ...drawn), /takes one mesh with --format obj/);
  // One read of standard input serves all meshes.
  const points = await karcherReading(
    'v:0\n',
    'log',
    plane,
    other,
    '--from',
    'v:1',
    '--points',
    '-',
  );
  assert.equal(points.stdout.trim().split('\n').length, 2);
});

test('on a terminal a line shows the progress of reading, and disappears', async () => {
  const run = async (isTTY) => {
    const pieces = [];
    const stderr = Object.assign(
      new Writable({
        write: (piece, _, done) => {
          pieces.push(piece.toString());
          done();
        },
      }),
      { isTTY },
    );
    const stdout = new Writable({ write: (_piece, _, done) => done() });
    const file = folder.write('large.obj', grid(150));
    const status = await main(['path', file, '--from', 'v:0', '--to', 'v:9'], {
      stdin: Readable.from([]),
      stdout,
      stderr,
    });
    assert.equal(status, 0);
    return pieces.join('');
  };
  assert.equal(await run(false), '');
  const shown = await run(true);
  assert.match(shown, /\d+ %/);
  assert.ok(shown.endsWith('\r\u001b[K'));
});

test('medians and Huber’s means', async () => {
  const three = folder.write('three.txt', `${at(1, 2)}\n${at(4, 3)}\n${at(8, 2)}\n`);
  const base = ['mean', plane, '--points', three, '--weights', '1,1,1'];
  const { position, converged } = await printed(...base, '--median');
  near(position, [4, 3, 0]);
  assert.equal(converged, true);
  // The value is a mean of distances with --normalize, else their sum.
  const sum = Math.hypot(3, 1) + Math.hypot(4, 1);
  near([(await printed(...base, '--median')).value], [sum]);
  near([(await printed(...base, '--median', '--normalize')).value], [sum / 3]);
  near((await printed(...base, '--huber-mean', '100')).position, [13 / 3, 7 / 3, 0], 1e-6);
  assert.match(await failure(...base, '--median', '--paths'), /--paths has no use with --median/);
  assert.match(await failure(...base, '--huber-mean', '-1'), /threshold must be positive/);
});

test('a Voronoi diagram and centroids', async () => {
  const sites = folder.write('sites.txt', [at(2, 4), at(6, 4), at(6, 4)].join('\n'));
  const { nearest, cells: parts, borders } = await printed('voronoi', plane, '--points', sites);
  near(
    parts.map(({ area }) => area),
    [32, 32, 0],
  );
  near([parts[0].perimeter, parts[0].boundary[0].length], [24, 24]);
  assert.deepEqual([nearest[0], nearest[cells]], [0, 1]);
  assert.equal(borders.length, 1);
  assert.deepEqual([borders[0].between, borders[0].closed], [[0, 1], false]);
  near(borders[0].polyline[0].slice(0, 1), [4]);
  const obj = await karcher('voronoi', plane, '--points', sites, '--format', 'obj');
  assert.match(obj.stdout, /^v 4 0 0$/m);

  const [whole] = (await printed('centroid', plane)).centroids;
  near(whole.position, [4, 4, 0], 1e-6);
  const rows = Array.from({ length: cells + 1 }, (_, y) =>
    Array(cells + 1)
      .fill(y)
      .join(' '),
  );
  const densities = rows.join(' ').split(' ').map(Number);
  for (const text of [
    rows.join('\n'),
    JSON.stringify(densities),
    JSON.stringify({ values: densities }),
  ]) {
    const density = folder.write('density.txt', text);
    const [heavy] = (await printed('centroid', plane, '--density', density)).centroids;
    near(heavy.position, [4, (2 / 3) * cells, 0], 1e-6);
  }
  const corners = folder.write('corners.txt', [at(1, 1), at(4, 1), at(1, 4)].join('\n'));
  const triangle = ['--points', corners, '--kind', 'polyline', '--closed', '--samples', '900'];
  const [inside] = (await printed('centroid', plane, ...triangle)).centroids;
  near(inside.position, [2, 2, 0], 1e-6);
  // The samples of the outline are independent of the points that represent its region.
  const few = [...triangle, '--region-samples', '3'];
  assert.ok((await printed('centroid', plane, ...few)).centroids[0].samples <= 3);
  assert.ok(inside.samples > 3);
});

test('even points of a path, transport along it, radii and the nearest point', async () => {
  const ends = ['--from', at(1, 1), '--to', at(5, 4)];
  const even = await printed('path', plane, ...ends, '--equally-spaced', '6');
  even.equallySpaced.forEach(({ length, position }, i) => {
    near([length], [i]);
    near(position, [1 + 0.8 * i, 1 + 0.6 * i, 0]);
  });
  const line = folder.write('line.json', JSON.stringify(even));
  const vectors = ['--vectors', folder.write('way.txt', '1 2 0\n')];
  const { vectors: carried } = await printed('transport', plane, '--along', line, ...vectors);
  near(carried[0], [1, 2, 0]);
  await failure('transport', plane, '--along', line, ...ends, ...vectors);
  await failure('transport', plane, ...vectors);
  const radius = ['--from', at(4, 4), '--radius', '1'];
  const { distance } = await printed('distance', plane, ...radius);
  assert.equal(distance.filter((far) => far !== null).length, 5);
  const log = await printed('log', plane, ...radius);
  assert.equal(log.vectors.filter((vector) => vector !== null).length, 5);
  await failure('log', plane, ...radius, '--points', line);
  const { point, frame, ...found } = await printed('nearest', plane, '--place', '2.5,3.25,7');
  near(found.position, [2.5, 3.25, 0]);
  near([found.distance], [7]);
  near(frame[2], [0, 0, 1]);
  assert.ok(Number.isInteger(point.face));
  await failure('nearest', plane, '--place', '1,2');
});
