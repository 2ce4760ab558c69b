import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { cutBox, everyFile, gltfParts, stlFile } from './mesh_files.mjs';
import { badFiles, grid, square } from './meshes.mjs';
import {
  failure,
  karcher,
  karcherProcess,
  karcherReading,
  printed,
  temporaryFolder,
} from './run_cli.mjs';

const folder = temporaryFolder();
after(() => folder.remove());
const squareFile = folder.write('square.obj', square);

test('help, of the program and of each command', async () => {
  const general = await karcher('--help');
  assert.equal(general.status, 0);
  assert.equal(general.stderr, '');
  const commands = [...general.stdout.matchAll(/^ {2}(\w+) {2,}\S/gm)].map((match) => match[1]);
  assert.deepEqual(commands, [
    'info',
    'repair',
    'convert',
    'distance',
    'isolines',
    'path',
    'straightest',
    'log',
    'exp',
    'transport',
    'mirror',
    'nearest',
    'mean',
    'centroid',
    'voronoi',
    'weights',
    'trace',
    'edit',
    'circle',
    'ellipse',
    'offset',
    'regions',
    'cut',
    'bench',
    'compare',
  ]);
  assert.equal((await karcher('-h')).stdout, general.stdout);
  for (const command of commands) {
    const { status, stdout, stderr } = await karcher(command, '--help');
    assert.equal((await karcher(command, '-h')).stdout, stdout);
    assert.equal((await karcher('help', command)).stdout, stdout);
    assert.equal(status, 0);
    assert.equal(stderr, '');
    assert.match(stdout, new RegExp(`^karcher ${command} MESH `));
    const options = Array.from(stdout.matchAll(/^ {2}(--\S+)/gm), ([, option]) => option);
    assert.equal(new Set(options).size, options.length, `an option of ${command} is there twice`);
    assert.equal((await karcher(command, 'anything', '--more', '--help')).stdout, stdout);
  }
});

test('help for an unknown command', async () => {
  assert.match(await failure('help', 'fly'), /^karcher has no command 'fly'; it has info, /);
});

test('a dash is standard input, only once', async () => {
  const pathOf = ['--from', 'v:0', '--to', 'v:2'];
  const named = await karcher('path', squareFile, ...pathOf);
  assert.deepEqual(await karcherReading(square, 'path', '-', ...pathOf), named);

  const points = '0 0 0\n1 0.25 0.5\n';
  const weights = ['--weights', '0.5,0.5'];
  const file = folder.write('two_points.txt', points);
  const mean = await karcher('mean', squareFile, '--points', file, ...weights);
  assert.equal(mean.status, 0, mean.stderr);
  assert.deepEqual(
    await karcherReading(points, 'mean', squareFile, '--points', '-', ...weights),
    mean,
  );

  const twice = await karcherReading(square, 'mean', '-', '--points', '-', ...weights);
  assert.equal(twice.status, 1);
  assert.match(twice.stderr, /standard input can be read once, and '-' is given twice/);
});

test('a result goes to the file of --out, or no file is written', async () => {
  const pathOf = ['path', squareFile, '--from', 'v:0', '--to', 'v:2'];
  const { stdout } = await karcher(...pathOf);
  const out = join(folder.path, 'path.json');
  const written = await karcher(...pathOf, '--out', out);
  assert.deepEqual(written, { status: 0, stdout: '', stderr: '' });
  assert.equal(readFileSync(out, 'utf8'), stdout);

  const unwritten = join(folder.path, 'none.json');
  await failure('path', squareFile, '--from', 'v:0', '--to', 'v:99', '--out', unwritten);
  assert.ok(!existsSync(unwritten), 'a command that failed wrote a file');
  const nowhere = join(folder.path, 'no folder', 'path.json');
  assert.match(
    await failure(...pathOf, '--out', nowhere),
    /^cannot write to .*no folder.*: there is no such folder$/,
  );
});

test('a result has the format of its file name, and no other', async () => {
  const isolines = ['isolines', squareFile, '--center', 'v:0', '--radius', '0.3'];
  const out = join(folder.path, 'lines.OBJ');
  assert.equal((await karcher(...isolines, '--out', out)).status, 0);
  assert.match(readFileSync(out, 'utf8'), /^o isolines\nv [\s\S]*\nl /);
  // An explicit format has priority over the name.
  assert.equal((await karcher(...isolines, '--format', 'json', '--out', out)).status, 0);
  assert.ok(JSON.parse(readFileSync(out, 'utf8')).isolines);
  assert.match(
    await failure(...isolines, '--out', 'lines.svg'),
    /^isolines writes JSON, CSV, OBJ, PLY, GLB or STL, not 'lines\.svg'$/,
  );
  const path = ['path', squareFile, '--from', 'v:0', '--to', 'v:2'];
  assert.match(await failure(...path, '--out', 'a.off'), /^path writes JSON, .*, not 'a\.off'$/);
  const info = ['info', squareFile, '--out'];
  assert.match(await failure(...info, 'info.csv'), /^info writes JSON, not 'info\.csv'$/);
  assert.match(await failure(...info, 'info.obj'), /^info writes JSON, not 'info\.obj'$/);
});

test('control characters of names never reach a terminal', async () => {
  const solids = new TextDecoder().decode(stlFile(cutBox, { text: true }));
  const named = folder.write(
    'named.stl',
    new TextEncoder().encode(solids.replace('part 0', 'a\x1b[31m\x9b\x7f\u202eb')),
  );
  for (const args of [
    ['info', named],
    ['info', folder.write('bad\x1b[2J.obj', 'f 1')],
    ['info', 'none\x1b]0;title\x07.obj'],
    ['a\x1b[31m'],
  ]) {
    const { stdout, stderr } = await karcher(...args);
    assert.ok(stdout.length + stderr.length > 0);
    assert.doesNotMatch(stdout + stderr, /(?![\t\n])[\p{Cc}\p{Bidi_Control}]/u);
  }
});

test("the version is the package's", async () => {
  const { default: own } = await import('karcher/package.json', { with: { type: 'json' } });
  assert.deepEqual((await karcher('--version')).stdout, `${own.version}\n`);
});

test('a result as JSON is written in pieces, whatever its size', async () => {
  const { jsonPieces, triples } = await import(
    new URL('./cli/output.js', import.meta.resolve('karcher'))
  );
  const flat = Float64Array.from({ length: 30_000 }, (_, i) => i / 7);
  const value = (points) => ({
    a: null,
    b: undefined,
    c: [1, 'two', Number.NaN, []],
    lines: [{ points: points() }, { points: points(), closed: true }],
    '"': {},
  });
  const pieces = [...jsonPieces(value(() => triples(flat)))];
  assert.equal(pieces.join(''), JSON.stringify(value(() => [...triples(flat)])));
  assert.ok(pieces.every((piece) => piece.length < 100));
});

test('mistakes in the command line: a sentence and status 1', async () => {
  const wrong = [
    [[], /needs a command/],
    [['paint'], /no command 'paint'/],
    [['info'], /needs a mesh/],
    [['distance', squareFile], /distance needs --from POINT/],
    [['distance', squareFile, '--from'], /--from needs a value: POINT/],
    [['distance', squareFile, '--from', 'v:0', '--from', 'v:1'], /--from is given twice/],
    [
      ['distance', squareFile, '--from', 'v:0', '--solver', 'slow'],
      /--solver must be one of fast, exact, graph/,
    ],
    [
      ['distance', squareFile, '--from', 'v:0', '--rings', 'x'],
      /--rings must be a number, not 'x'/,
    ],
    [['distance', squareFile, '--from', 'v:0', '--rings', '1.5'], /--rings must be a whole number/],
    [
      ['distance', squareFile, '--from', 'v:0', '--solver', 'graph', '--rings', '0'],
      /1 to 10 rings/,
    ],
    [['distance', squareFile, '--from', 'v:0', '--rings', '3'], /'exact' has no rings/],
    [['path', squareFile, '--from', 'v:0', '--to', 'v:1', '--format', 'svg'], /--format must be/],
    [['mean', squareFile, '--points', 'x', '--normalize=yes'], /--normalize takes no value/],
    [['info', squareFile, '--colour'], /no option --colour; it has --/],
    [['info', squareFile, '--colour=red'], /no option --colour/],
    [['info', '-x', squareFile], /no option -x/],
    [['info', `${folder.path}/none.obj`], /cannot read .*none\.obj: there is no such file/],
    [['info', folder.path], /cannot read .*: it is a folder/],
  ];
  for (const [args, message] of wrong) assert.match(await failure(...args), message);
});

test('files that are no mesh: a sentence and status 1', async () => {
  for (const { text, says } of badFiles) {
    assert.match(await failure('info', folder.write('bad.obj', text), '--repair', 'none'), says);
  }
});

test('info describes a mesh', async () => {
  const { meanEdge, diagonal, repairs, checkUp, ...counts } = await printed('info', squareFile);
  assert.deepEqual(counts, {
    vertices: 4,
    triangles: 2,
    components: 1,
    boundaryLoops: 1,
    genus: 0,
    file: {
      format: 'obj',
      parts: [{ name: 'mesh', triangles: 2 }],
      materials: [],
      isColored: false,
      notRead: [],
    },
  });
  assert.ok(Math.abs(meanEdge - (4 + Math.SQRT2) / 5) < 1e-15);
  assert.ok(Math.abs(diagonal - Math.SQRT2) < 1e-15);
  assert.equal(checkUp.boundaryEdges, 4);
  assert.ok(Math.abs(checkUp.smallestAngle - 45) < 1e-12);
  assert.deepEqual(checkUp.needles, { count: 0, faces: [] });
  assert.deepEqual(
    repairs.map(({ kind, count }) => [kind, count]),
    [['triangulated', 1]],
  );
});

test('every format is read, with the requested parts', async () => {
  for (const [name, bytes] of Object.entries(everyFile(cutBox))) {
    const { file, triangles, genus } = await printed('info', folder.write(name, bytes));
    assert.deepEqual([triangles, genus], [12, 0], name);
    assert.equal(file.format, name.split('.')[1].replace('glb', 'gltf'));
  }
  const halves = folder.write('halves.stl', stlFile(cutBox, { text: true, solids: 2 }));
  assert.equal((await printed('info', halves, '--parts', '1')).triangles, 6);
  assert.match(await failure('info', halves, '--parts', '2'), /no part 2: the file has 2/);
  assert.match(await failure('info', folder.write('x.ply', 'ply\n')), /header does not end/);
  // A text file with its buffer beside it.
  const { json, buffer } = gltfParts(cutBox);
  json.buffers[0].uri = 'body.bin';
  const scene = folder.write('scene.gltf', JSON.stringify(json));
  assert.match(await failure('info', scene), /cannot read .*body\.bin: there is no such file/);
  folder.write('body.bin', buffer);
  assert.equal((await printed('distance', scene, '--from', 'v:0')).distance.length, 8);
});

test('two parts, Windows line ends, a handle', async () => {
  const moved = square.replaceAll('v 0', 'v 5').replaceAll('v 1', 'v 6');
  const both = `${square}${moved.replace('f 1 2 3 4', 'f 5 6 7 8')}`.replaceAll('\n', '\r\n');
  const counts = await printed('info', folder.write('both.obj', both));
  assert.equal(counts.components, 2);
  assert.equal(counts.boundaryLoops, 2);
  // Three by three squares with opposite sides identified: a torus.
  const torus = [];
  const corner = (i, j) => (i % 3) + 3 * (j % 3) + 1;
  for (let k = 0; k < 9; k++) {
    const [u, v] = [k % 3, Math.floor(k / 3)].map((i) => (2 * Math.PI * i) / 3);
    torus.push(
      `v ${(2 + Math.cos(v)) * Math.cos(u)} ${(2 + Math.cos(v)) * Math.sin(u)} ${Math.sin(v)}`,
    );
  }
  for (let k = 0; k < 9; k++) {
    const [i, j] = [k % 3, Math.floor(k / 3)];
    const corners = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
    torus.push(`f ${corners.join(' ')}`);
  }
  const closed = await printed('info', folder.write('torus.obj', torus.join('\n')));
  assert.deepEqual(
    [closed.vertices, closed.triangles, closed.boundaryLoops, closed.genus],
    [9, 18, 0, 1],
  );
});

test('in a process of its own, a command ends with the same output', async () => {
  for (const args of [
    ['--help'],
    ['distance', squareFile, '--from', 'v:0'],
    ['path', squareFile, '--from', 'v:0', '--to', 'v:2', '--format', 'obj'],
    ['distance', squareFile, '--from', 'v:999'],
    ['paint'],
  ]) {
    const { signal, ...rest } = await karcherProcess(args);
    assert.equal(signal, null);
    assert.deepEqual(rest, await karcher(...args), args.join(' '));
  }
});

test('a long result passes completely through a pipe that is read late', async () => {
  const long = folder.write('long.obj', grid(200));
  const args = ['distance', long, '--from', 'v:0'];
  const { status, stdout, stderr } = await karcherProcess(args, (child) => {
    child.stdout.pause();
    child.once('spawn', () => setTimeout(() => child.stdout.resume(), 300));
  });
  assert.deepEqual([status, stderr], [0, '']);
  assert.ok(stdout.length > 1 << 17, `${stdout.length} characters`);
  assert.equal(JSON.parse(stdout).distance.length, 201 ** 2);
});

test('a signal ends a command', async () => {
  const gridFile = folder.write('plain.obj', grid(4));
  const points = folder.write('points.txt', '0 0 0\n3 0 0\n9 0 0\n20 0 0\n');
  const { status, signal } = await karcherProcess(
    ['bench', gridFile, '--points', points],
    (child) => child.kill('SIGTERM'),
  );
  assert.deepEqual([status, signal], [null, 'SIGTERM']);
});

test('a reader that closes early is reported', async () => {
  const gridFile = folder.write('grid.obj', grid(4));
  const { status, stderr } = await karcherProcess(['info', gridFile], (child) =>
    child.stdout.destroy(),
  );
  assert.equal(status, 1);
  assert.match(stderr, /^karcher: cannot write to standard output: it was closed [^\n]*\n$/);
});
