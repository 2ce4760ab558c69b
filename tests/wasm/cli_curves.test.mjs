import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { load } from 'karcher';
import { grid, tube } from './meshes.mjs';
import { failure, karcher, printed, temporaryFolder } from './run_cli.mjs';

const folder = temporaryFolder();
after(() => folder.remove());

const cells = 12;
const meshFile = folder.write('grid.obj', grid(cells));
const mesh = (await load()).meshFromObj(grid(cells));
const places = [
  [2 * (4 + cells * 4), 0, 0],
  [2 * (8 + cells * 5), 0.25, 0.5],
  [2 * (7 + cells * 8) + 1, 0.125, 0.25],
  [2 * (4 + cells * 7), 0, 0],
  [2 * (5 + cells * 4), 0.25, 0.25],
];
const linesOf = (some) => some.map((place) => `${place.join(' ')}\n`).join('');
const pointsFile = folder.write('points.txt', linesOf(places));
const points = places.map(([face, b1, b2]) => ({ face, bary: [1 - b1 - b2, b1, b2] }));
const curveArgs = ['--points', pointsFile];

let files = 0;
const fileOf = (value) => folder.write(`curve${files++}.json`, JSON.stringify(value));
const edited = (...args) => printed('edit', meshFile, ...args);
const traced = (...args) => printed('trace', meshFile, '--samples', '9', ...args);

/** The value as JSON has it, without -0. */
const asJson = (value) => JSON.parse(JSON.stringify(value));

/** Checks that both curves pass through the same places. */
function expectSame({ samples }, curve) {
  assert.equal(samples.length, curve.samples().count);
  samples.forEach(({ position }, i) => {
    position.forEach((value, k) => {
      assert.ok(Math.abs(value - curve.samples().position[3 * i + k]) < 1e-9, `sample ${i}`);
    });
  });
}

test('trace --at, --nearest and --equally-spaced measure the curve', async () => {
  const curve = mesh.curve({ kind: 'bspline', points, samples: 9 });
  const { at, nearest, equallySpaced } = await traced(
    ...curveArgs,
    ...['--at', '0,0.3,1,2', '--nearest', '6,5,1', '--equally-spaced', '4'],
  );
  assert.equal(at.length, 4);
  [0, 0.3, 1, 2].forEach((parameter, i) => {
    const { inFace, inSpace, ...point } = curve.tangentAt(parameter);
    const length = curve.lengthAt(parameter);
    assert.deepEqual(at[i], asJson({ ...point, tangent: { inFace, inSpace }, length }));
  });
  // The lengths are the same, summed in another order.
  assert.ok(Math.abs(at[3].length - curve.length) < 1e-12 * curve.length);
  assert.deepEqual(nearest, asJson(curve.nearest([6, 5, 1])));
  const { parameter, face, bary, position } = curve.equallySpaced(4);
  assert.deepEqual(
    equallySpaced.map((one) => one.parameter),
    Array.from(parameter),
  );
  assert.deepEqual(
    equallySpaced.map(({ point }) => point.face),
    Array.from(face),
  );
  assert.deepEqual(
    equallySpaced.flatMap(({ point }) => point.bary),
    Array.from(bary),
  );
  assert.deepEqual(
    equallySpaced.flatMap((one) => one.position),
    Array.from(position),
  );
  const toVertex = await traced(...curveArgs, '--nearest', 'v:58');
  assert.deepEqual(toVertex.nearest, asJson(curve.nearest(mesh.position({ vertex: 58 }))));
  const other = (await traced(...curveArgs, '--nearest', `${places[1][0]}:0.25,0.5`)).nearest;
  assert.deepEqual(other, asJson(curve.nearest(mesh.position(points[1]))));
  const plain = Object.keys(await traced(...curveArgs));
  assert.deepEqual(plain, ['levels', 'samples', 'bridged', 'polyline', 'length', 'ms']);
});

const edits = [
  [['--insert-on-curve', '0.5'], (curve) => curve.insertOnCurve(0.5)],
  [
    ['--move-point', `1=${places[3][0]}:0.5,0.25`],
    (curve) => curve.movePoint(1, { face: places[3][0], bary: [0.25, 0.5, 0.25] }),
  ],
  [['--insert-point', '2=v:70'], (curve) => curve.insertPoint(2, { vertex: 70 })],
  [['--remove-point', '4'], (curve) => curve.removePoint(4)],
  [['--move-point-in-order', '0=3'], (curve) => curve.movePointInOrder(0, 3)],
  [['--set-weight', '2=3.5'], (curve) => curve.setWeight(2, 3.5)],
  [['--reverse'], (curve) => curve.reverse()],
  [['--set-closed', 'true'], (curve) => curve.setClosed(true)],
  [['--set-kind', 'catmullrom'], (curve) => curve.setKind('catmullrom')],
];

test('edit prints a curve that trace reads', async () => {
  for (const [args, change] of edits) {
    const curve = mesh.curve({ kind: 'bspline', points, samples: 9 });
    const point = change(curve);
    const result = await edited(...curveArgs, ...args);
    assert.equal(result.curves.length, 1);
    assert.equal(result.point, point);
    assert.equal(result.curves[0].kind, curve.kind);
    expectSame(await traced('--curve', fileOf(result)), curve);
    // A single curve of the output is valid, too.
    expectSame(await traced('--curve', fileOf(result.curves[0])), curve);
  }
});

test('legs are read with a curve, and printed with it', async () => {
  const [a, b, c, ...rest] = points;
  const through = mesh.curve({ kind: 'polyline', points: [a, b, c], samples: 9 });
  // On a plane every path straightens to the same line, so that the file has no leg.
  const file = fileOf({ kind: 'polyline', points: [a, b, c], legs: [[rest[0]], null] });
  expectSame(await traced('--curve', file), through);
  assert.equal((await edited('--curve', file, '--reverse')).curves[0].legs, undefined);
  const cylinder = folder.write('tube.obj', tube(24, 6));
  const ends = [0, 2 * 4].map((face) => ({ face, bary: [0.2, 0.3, 0.5] }));
  const around = {
    kind: 'polyline',
    points: ends,
    legs: [[{ face: 2 * 14, bary: [0.2, 0.3, 0.5] }]],
  };
  const long = await printed('trace', cylinder, '--curve', fileOf(around));
  const short = await printed('trace', cylinder, '--curve', fileOf({ ...around, legs: [null] }));
  assert.ok(long.length > 4 * short.length, `${long.length}, ${short.length}`);
  const [again] = (await printed('edit', cylinder, '--curve', fileOf(around), '--reverse')).curves;
  assert.equal(again.legs.length, 1);
  const { stdout: help } = await karcher('edit', '--help');
  for (const name of Object.keys(again)) assert.match(help, new RegExp(`\\b${name}\\b`));
  const back = await printed('trace', cylinder, '--curve', fileOf(again));
  assert.ok(Math.abs(back.length - long.length) < 1e-9);
});

test('every kind is restored with all of its properties', async () => {
  const kinds = [
    [{ kind: 'bezier' }, []],
    [{ kind: 'rational', weights: [1, 2, 3, 2, 1] }, ['--weights', '1,2,3,2,1']],
    [{ kind: 'barycentric', betas: [1, 4, 6, 4, 1] }, ['--betas', '1,4,6,4,1']],
    [{ kind: 'catmullrom', parametrization: 'uniform' }, ['--parametrization', 'uniform']],
    [{ kind: 'polyline', closed: true }, ['--closed']],
    [{ kind: 'bspline', degree: 2, knots: 'clamped' }, ['--degree', '2', '--knots', 'clamped']],
  ];
  for (const [options, args] of kinds) {
    const curve = mesh.curve({ points, samples: 9, ...options });
    curve.insertOnCurve(0.5);
    const all = [...curveArgs, '--kind', options.kind, ...args, '--insert-on-curve', '0.5'];
    expectSame(await traced('--curve', fileOf(await edited(...all))), curve);
  }
  const opened = await edited(
    ...curveArgs,
    '--kind',
    'polyline',
    '--closed',
    '--set-closed',
    'false',
  );
  assert.equal(opened.curves[0].closed, false);
  const beta = await edited(...curveArgs, '--kind', 'barycentric', '--set-beta', '1=4');
  assert.deepEqual(beta.curves[0].betas, [1, 4, 1, 1, 1]);
});

test('curves are split and joined again', async () => {
  const curve = mesh.curve({ kind: 'bspline', points, samples: 9 });
  const parts = await edited(...curveArgs, '--split', '1.5');
  assert.equal(parts.curves.length, 2);
  const file = fileOf(parts);
  for (const [i, part] of curve.split(1.5).entries()) {
    expectSame(await traced('--curve', file, '--number', `${i}`), part);
  }
  const joined = await edited('--curve', file, '--number', '0', '--join', fileOf(parts.curves[1]));
  const [first, second] = curve.split(1.5);
  expectSame(await traced('--curve', fileOf(joined)), first.join(second));

  // A file of points, as lines or as other commands print them, describes a curve of the same kind.
  const clamped = { kind: 'bspline', degree: 2, knots: 'clamped', samples: 9 };
  const back = points.toReversed();
  const expected = mesh
    .curve({ ...clamped, points })
    .join(mesh.curve({ ...clamped, points: back }));
  for (const more of [
    folder.write('more.txt', linesOf(places.toReversed())),
    fileOf(back),
    fileOf({ points: back, positions: [], remaining: [] }),
    fileOf({ levels: 0, samples: back }),
  ]) {
    const both = await edited(...curveArgs, '--degree', '2', '--knots', 'clamped', '--join', more);
    expectSame(await traced('--curve', fileOf(both)), expected);
  }
});

test('invalid curves and edits: a sentence and status 1', async () => {
  const edit = (...args) => ['edit', meshFile, ...curveArgs, ...args];
  const trace = (...args) => ['trace', meshFile, ...args];
  const two = fileOf(await edited(...curveArgs, '--split', '1'));
  const { curves } = await edited(...curveArgs, '--reverse');
  const wrong = [
    [edit(), /edit takes one of --insert-on-curve, --split, .*--set-kind$/],
    [edit('--reverse', '--set-closed', 'true'), /edit takes one of .*, not two/],
    [['edit', meshFile, '--reverse'], /edit needs --points FILE or --curve FILE/],
    [trace(), /trace needs --points FILE or --curve FILE/],
    [edit('--insert-on-curve', 'x'), /--insert-on-curve must be a number, not 'x'/],
    [edit('--insert-on-curve', '9'), /no parameter 9/],
    [edit('--split', '0'), /cannot be split at 0, its end/],
    [edit('--move-point', '1'), /--move-point must be a point's number and a value, 'I=…'/],
    [edit('--move-point', '1=2=3'), /--move-point must be a point's number and a value/],
    [edit('--move-point', 'x=v:1'), /the number in --move-point must be a number, not 'x'/],
    [
      edit('--move-point', '1.5=v:1'),
      /the number in --move-point must be a whole number, not '1\.5'/,
    ],
    [edit('--move-point', '1=here'), /the point of --move-point must be a point/],
    [edit('--move-point', '9=v:1'), /no control point 9/],
    [edit('--remove-point', '0.5'), /--remove-point must be a whole number/],
    [
      edit('--move-point-in-order', '0=x'),
      /the new number in --move-point-in-order must be a number/,
    ],
    [edit('--set-weight', '0=-1'), /weight of point 0 must be from 1e-12 to 1e12, not -1/],
    [edit('--set-beta', '0=1'), /has no betas/],
    [edit('--set-kind', 'circle'), /--set-kind must be one of/],
    [edit('--join', `${folder.path}/none`), /no such file/],
    [edit('--join', two), /holds 2 curves: --join takes a file of one/],
    [edit('--closed', '--join', pointsFile), /closed curve has no end to join/],
    [edit('--format', 'obj', '--reverse'), /no option --format/],
    [edit('--number', '1', '--reverse'), /--number has no use without --curve/],
    [trace('--curve', two), /holds 2 curves: --number chooses one, from 0/],
    [trace('--curve', two, '--number', '2'), /holds no curve 2: it holds 2, from 0/],
    [trace('--curve', two, '--number', '0', '--closed'), /--closed has no use with --curve/],
    [trace('--curve', two, ...curveArgs), /--points has no use with --curve/],
    [trace('--curve', pointsFile), /must hold a curve as JSON/],
    [trace('--curve', fileOf(null)), /must hold a curve as JSON/],
    [trace('--curve', fileOf({ curves: 5 })), /must hold a curve as JSON/],
    [trace('--curve', fileOf({ curves: [] })), /holds no curve 0: it holds 0/],
    [trace('--curve', fileOf({ curves: ['x'] })), /holds no curve 0/],
    [trace('--curve', fileOf({ ...curves[0], colour: 1 })), /'colour' in .* is no part of a curve/],
    [trace('--curve', fileOf({ ...curves[0], points: 5 })), /points must be an array/],
    [trace('--curve', fileOf({ ...curves[0], kind: 'spiral' })), /must be one of bspline/],
    [trace(...curveArgs, '--at', '0,x'), /number 2 of --at must be a number/],
    [trace(...curveArgs, '--at', '9'), /no parameter 9/],
    [trace(...curveArgs, '--nearest', '1,2'), /must be a point or a place 'x,y,z'/],
    [trace(...curveArgs, '--nearest', 'v:x'), /--nearest must be a point/],
    [trace(...curveArgs, '--equally-spaced', '1'), /2 to 1000000/],
    [trace(...curveArgs, '--equally-spaced', '0'), /2 to 1000000/],
    [trace(...curveArgs, '--at', '1', '--format', 'obj'), /--at has no use with --format obj/],
  ];
  for (const [args, message] of wrong) assert.match(await failure(...args), message);
});
