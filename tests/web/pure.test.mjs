// The page's modules that need no browser.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load as loadEngine } from 'karcher';
import { circle, ellipse, figure, load, point, settings } from './figures.mjs';

describe('traced results', () => {
  test('are kept for figures of the drawing and the last 64 others', async () => {
    const { BesideObjects, mostRemembered } = await load('editor/engine/beside.ts');
    const traced = { method: 'karcher', shown: {}, quality: 'draft' };
    const beside = new BesideObjects();
    const figures = Array.from({ length: 200 }, (_, i) => ({ ...figure, points: [point(i)] }));
    const drawing = { objects: [{ id: 1, figure: figures[3] }], active: 1 };
    for (const one of figures) beside.keep(one, traced, drawing);
    const known = figures.map((one) => beside.known(one, 'karcher') !== null);
    assert.equal(known.filter(Boolean).length, mostRemembered + 1);
    assert.ok(known[3], 'what the drawing has');
    assert.ok(known.slice(-mostRemembered).every(Boolean), 'the newest');
  });
});

describe('what points up', () => {
  const ups = ['x', 'y', 'z', '-x', '-y', '-z'];
  const basis = [0, 1, 2].map((axis) => [0, 1, 2].map((i) => Number(i === axis)));

  test('is up in the scene, by a rotation', async () => {
    const { directionFromScene, directionInScene } = await load('viewer/frame.ts');
    for (const up of ups) {
      const [a, b, c] = basis.map((one) => directionInScene(up, one));
      const determinant =
        a[0] * (b[1] * c[2] - b[2] * c[1]) -
        a[1] * (b[0] * c[2] - b[2] * c[0]) +
        a[2] * (b[0] * c[1] - b[1] * c[0]);
      assert.equal(determinant, 1, up);
      const wanted = basis['xyz'.indexOf(up.at(-1))].map((one) => (up[0] === '-' ? -one : one));
      assert.deepEqual(
        directionFromScene(up, basis[1]).map((one) => one + 0),
        wanted.map((one) => one + 0),
        up,
      );
      for (const one of basis) {
        const back = directionFromScene(up, directionInScene(up, one));
        assert.deepEqual(
          back.map((value) => value + 0),
          one,
        );
      }
    }
  });

  test('is in the key of a file, beside its other options', async () => {
    const { readAs, readingOf } = await load('model/meshes.ts');
    for (const up of ups) {
      for (const rest of [
        { parts: null, weld: null },
        { parts: [0, 2], weld: 1e-3 },
      ]) {
        const key = readAs('file:abc-1:a scan~z.ply', { ...rest, up });
        assert.deepEqual(readingOf(key), { ...rest, up }, key);
      }
    }
    assert.equal(readingOf('file:abc-1.0.2*0.001~z:scan.ply').up, 'z', 'as keys were before');
  });
});

describe('the view in a link', () => {
  test('is as near as the view goes, and keeps what is seen to a thousandth of it', async () => {
    const { formatView, parseView } = await load('model/view_place.ts');
    for (const reach of [1e-4, 0.00123, 0.01, 0.5, 10]) {
      const target = [0.123456789, -1.987654321, 1e-9];
      const text = formatView({ azimuth: 12.345, elevation: -6.5, reach, target });
      assert.doesNotMatch(text, /e/, 'no exponent');
      const back = parseView(text);
      assert.equal(back.reach, reach);
      for (const [axis, value] of back.target.entries()) {
        assert.ok(Math.abs(value - target[axis]) <= 1e-3 * reach, `${text}: ${target[axis]}`);
      }
    }
    assert.equal(parseView('0,0,0.00001,0,0,0'), null);
  });
});

describe('the pieces of a file', () => {
  test('are parts from the largest; the smallest of very many are one part', async () => {
    const { inPieces } = await load('worker/pieces.ts');
    const karcher = await loadEngine();
    const count = 1205;
    const [positions, triangles] = [[], []];
    // Strips of triangles, far from each other; every hundredth has 7, others 2.
    for (let piece = 0; piece < count; piece++) {
      const faces = piece % 100 === 0 ? 7 : 2;
      const first = positions.length / 3;
      for (let i = 0; i < faces + 2; i++) positions.push(i, 4 * piece + (i % 2), 0);
      for (let i = first; i < first + faces; i++) {
        triangles.push(...((i - first) % 2 === 0 ? [i, i + 1, i + 2] : [i + 1, i, i + 2]));
      }
    }
    const read = async () => ({
      mesh: await karcher.meshFromArrays(Float64Array.from(positions), triangles),
      file: { format: 'stl', parts: [{ name: 'solid', triangles: triangles.length / 3 }] },
    });
    const { mesh, file } = await inPieces(karcher, await read(), null);
    assert.equal(mesh.info.components, count);
    assert.equal(file.parts.length, 1000);
    const sizes = file.parts.map((part) => part.triangles);
    assert.deepEqual([sizes.slice(0, 14), sizes[998]], [[...Array(13).fill(7), 2], 2]);
    assert.deepEqual(file.parts[999], { name: '206 small pieces', triangles: 412 });
    const counted = Array(1000).fill(0);
    for (const part of file.partOf) counted[part]++;
    assert.deepEqual(counted, sizes);
    const one = await inPieces(karcher, await read(), [999]);
    assert.equal(one.mesh.info.triangles, 412);
    assert.equal(one.mesh.info.components, 206);
  });
});

describe('patterns of fills', () => {
  const object = { pattern: 'hatched', spacing: 0.1 };

  test('that fail are messages, leave no fill solid, and are asked for again of another engine', async () => {
    const { Patterns } = await load('editor/engine/patterns.ts');
    const messages = [];
    const patterns = new Patterns(({ message }) => messages.push(message));
    const one = { object, region: {} };
    let asked = 0;
    const failing = {
      closed: false,
      pattern: () => Promise.reject(new Error(`no distance ${++asked}`)),
    };
    assert.equal(await patterns.make(failing, [one]), true);
    assert.equal(patterns.of(one), undefined);
    assert.equal(await patterns.make(failing, [one]), false, 'the same engine is not asked again');
    assert.deepEqual(messages, ['no distance 1']);
    const made = { values: [1] };
    const other = { closed: false, pattern: () => Promise.resolve(made) };
    assert.equal(await patterns.make(other, [one]), true);
    assert.equal(patterns.of(one), made);
    const fine = { object: { ...object, spacing: 1e-9 }, region: one.region };
    await patterns.make({ closed: false, pattern: () => Promise.resolve(null) }, [fine]);
    assert.equal(patterns.of(fine), null, 'what is too fine is solid');
  });

  test('of an engine that was closed in the meantime say nothing', async () => {
    const { Patterns } = await load('editor/engine/patterns.ts');
    const messages = [];
    const patterns = new Patterns((error) => messages.push(error));
    const closed = { closed: true, pattern: () => Promise.reject(new Error('gone')) };
    assert.equal(await patterns.make(closed, [{ object, region: {} }]), false);
    assert.deepEqual(messages, []);
  });
});

describe('lengths and areas', () => {
  test('of ten thousand units and more have no exponent', async () => {
    const { formatArea, formatLength } = await load('model/units.ts');
    assert.equal(formatArea(63043.2, 'mm'), '63040 mm²');
    assert.equal(formatLength(9999.96), '10000');
    assert.equal(formatLength(12.3456, 'mm'), '12.35 mm');
    assert.equal(formatLength(1, 'm'), '1.000 m');
  });
});

describe('a figure', () => {
  test('has all of its places moved, and nothing else', async () => {
    const { withPlaces } = await load('model/figure.ts');
    const whole = {
      ...figure,
      points: [point(1), { ...point(2), weight: 3, leg: [point(9), point(10)] }],
      circle: { center: point(5), rim: point(6), across: point(7) },
    };
    const move = ({ face }) => point(face + 100, 0.125, 0.25);
    const moved = withPlaces(whole, move);
    const leg = [move(point(9)), move(point(10))];
    assert.deepEqual(moved.points, [move(point(1)), { ...move(point(2)), weight: 3, leg }]);
    assert.deepEqual(moved.circle, {
      center: move(point(5)),
      rim: move(point(6)),
      across: move(point(7)),
    });
    const { points: _, circle: __, ...rest } = figure;
    assert.deepEqual({ ...moved, ...rest }, moved);
    const byLengths = withPlaces({ ...figure, circle: ellipse }, move);
    assert.deepEqual(byLengths.circle, { ...ellipse, center: move(ellipse.center) });
    assert.equal('across' in withPlaces({ ...figure, circle }, move).circle, false);
  });

  test('that is a cut keeps its choices of parts on another mesh', async () => {
    const { withObjectPlaces, newObject } = await load('model/drawing.ts');
    const parts = [
      { point: point(3), state: 'deleted' },
      { point: point(4), state: 'hidden' },
    ];
    const cut = { ...figure, kind: 'cut', points: [], derived: { sources: [1, 2], parts } };
    const moved = (move) => withObjectPlaces(newObject(1, cut), move).figure.derived;
    const move = ({ face }) => point(face + 100);
    assert.deepEqual(moved(move), {
      sources: [1, 2],
      parts: [
        { ...parts[0], point: point(103) },
        { ...parts[1], point: point(104) },
      ],
    });
    const onPart = (place) => (place.face === 3 ? move(place) : null);
    assert.deepEqual(moved(onPart).parts, [{ ...parts[0], point: point(103) }]);
  });

  test('does not pass its inside on to the next one', async () => {
    const { cleared } = await load('model/figure.ts');
    assert.equal('inside' in cleared({ ...figure, inside: 'right' }), false);
  });
});

describe('legs', () => {
  let legs;
  before(async () => {
    legs = await load('model/legs.ts');
  });
  const drawn = [point(7), point(8)];
  const withOne = { settings, points: figure.points.with(1, { ...point(2), leg: drawn }) };
  const legOf = ({ points }) => points.map(({ leg }) => leg);
  const fitting = (points, changed = settings) =>
    legOf(legs.withFittingLegs({ settings: changed, points }, withOne));

  test('stay while they join the same two places', () => {
    const { points } = withOne;
    assert.deepEqual(fitting(points.with(1, { ...points[1], weight: 2 }))[1], drawn);
    assert.deepEqual(fitting(points.with(3, point(9)))[1], drawn);
    assert.deepEqual(fitting([point(9), ...points])[2], drawn);
    assert.deepEqual(fitting(points.toSpliced(0, 1))[0], drawn);
    for (const moved of [
      points.with(1, { ...point(9), leg: drawn }),
      points.with(2, point(9)),
      points.toSpliced(2, 0, point(9)),
      points.toSpliced(2, 1),
      [points[0], points[2], points[1], points[3]],
    ]) {
      assert.ok(fitting(moved).every((leg) => leg === undefined));
    }
  });

  test('of the last point lead on to the first only in a closed curve', () => {
    const points = figure.points.with(3, { ...point(4), leg: drawn });
    const closed = { settings: { ...settings, closed: true }, points };
    assert.deepEqual(legs.legsOf(closed), { legs: [null, null, null, drawn] });
    assert.deepEqual(legs.legsOf({ ...closed, settings }), {});
    assert.equal(legOf(legs.withFittingLegs({ ...closed, settings }, closed))[3], undefined);
  });

  test('are in the order of the points, or absent', () => {
    assert.deepEqual(legs.legsOf(withOne), { legs: [null, drawn, null] });
    assert.deepEqual(legs.legsOf(figure), {});
  });
});

describe('commands of a figure', () => {
  let module;
  before(async () => {
    module = {
      ...(await load('model/figure.ts')),
      ...(await load('model/commands.ts')),
    };
  });

  test('are undone by their inverse', () => {
    const [from, to] = [figure.points[1], point(9)];
    const commands = [
      { type: 'insert', index: 2, point: point(7) },
      { type: 'remove', index: 1, point: from },
      { type: 'reorder', from: 0, to: 2 },
      { type: 'reorder', from: 3, to: 1 },
      { type: 'change', index: 1, from, to },
      { type: 'change', index: 1, from, to: { ...from, weight: 3 } },
      { type: 'kind', from: 'bspline', to: 'circle' },
      { type: 'settings', from: settings, to: { ...settings, closed: true } },
      { type: 'circle', from: null, to: circle },
      { type: 'circleForm', from: figure.circleForm, to: { type: 'exact', arcs: 5 } },
      { type: 'replace', from: figure, to: module.emptyFigure },
    ];
    for (const command of commands) {
      const done = module.applyToFigure(figure, command);
      assert.notDeepEqual(done, figure, command.type);
      assert.deepEqual(
        module.applyToFigure(done, module.invertFigureCommand(command)),
        figure,
        command.type,
      );
      assert.deepEqual(
        module.invertFigureCommand(module.invertFigureCommand(command)),
        command,
        command.type,
      );
    }
  });
});

describe('keys of surfaces', () => {
  let meshes;
  before(async () => {
    meshes = await load('model/meshes.ts');
  });

  test('say how a surface is made', () => {
    const torus = { kind: 'shape', name: 'torus', triangles: 50_000 };
    const named = [
      ['bunny:2', { kind: 'bunny', levels: 2 }, 'Bunny'],
      ['torus:50000', torus, 'Torus'],
      ['plane:grid:8000', { kind: 'plane', tessellation: 'grid', triangles: 8000 }, 'Plane, grid'],
      [
        'simplified:500:torus:50000',
        { kind: 'simplified', of: torus, triangles: 500 },
        'Torus, simplified',
      ],
    ];
    for (const [key, source, name] of named) {
      assert.equal(meshes.madeKey(source), key);
      assert.deepEqual(meshes.madeSource(key), source);
      assert.equal(meshes.meshLabel(key), name);
    }
  });

  test('without meaning are refused', () => {
    const wrong = ['torus', 'torus:-1', 'torus:1e9', 'bunny:9', 'plane:8000', 'plane:round:8000'];
    const ofWhat = [
      'simplified:500',
      'simplified:x:torus:900',
      'simplified:9:simplified:9:torus:9',
    ];
    for (const key of [...wrong, ...ofWhat, 'simplified:500:file:abc:a.obj']) {
      assert.equal(meshes.parseKey(key), null, key);
    }
  });

  test('have at most as many triangles as a shape of the engine', async () => {
    const karcher = await loadEngine();
    assert.throws(() => karcher.shape('sphere', 1_000_001), /500 to 1000000 triangles/);
    assert.ok(meshes.parseKey('sphere:1000000'));
    assert.equal(meshes.parseKey('sphere:1000001'), null);
  });

  test('name the same sample at different details, and no other surface', () => {
    assert.ok(meshes.sameSurface('torus:500', 'torus:900'));
    assert.ok(!meshes.sameSurface('torus:500', 'sphere:500'));
    assert.ok(!meshes.sameSurface('simplified:500:torus:900', 'simplified:500:sphere:900'));
    assert.ok(!meshes.sameSurface('file:a:x.obj', 'file:b:x.obj'));
  });
});

describe('the shape of a circle and an ellipse', () => {
  let module;
  before(async () => {
    module = await load('model/circle.ts');
  });
  const drawn = { radius: 0.7, direction: [0, 1, 0], across: null };
  const rim = { radius: 0.7, direction: [0, 1, 0] };

  test('keeps its radii when its center is moved, and across when it is turned', () => {
    const { byRadii, withHandle } = module;
    const loose = { center: point(5), rim: point(6), across: point(7) };
    const grabbed = byRadii(loose, { ...drawn, across: { radius: 0.3 } });
    assert.deepEqual(grabbed, { center: point(5), rim, across: { radius: 0.3 } });
    const to = point(8);
    assert.deepEqual(withHandle(loose, grabbed, 'center', to), { ...grabbed, center: to });
    assert.deepEqual(withHandle(loose, grabbed, 'rim', to), { ...grabbed, rim: to });
    assert.deepEqual(withHandle(loose, grabbed, 'across', to), { ...loose, across: to });
  });

  test('keeps an ellipse’s radius as a circle, but not the point that it came from', () => {
    const { byRadii } = module;
    assert.deepEqual(byRadii(ellipse, drawn), { ...ellipse, rim });
    assert.deepEqual(byRadii({ ...ellipse, across: point(7) }, drawn), { ...circle, rim });
    assert.deepEqual(byRadii(circle, drawn), { ...circle, rim });
    assert.deepEqual(byRadii(ellipse, null), ellipse);
    assert.deepEqual(byRadii(circle, null), circle);
  });

  test('takes a radius in the direction of its handle', () => {
    const { withRadius } = module;
    const wide = { radius: 2, direction: [0, 1, 0] };
    assert.deepEqual(withRadius(circle, drawn, 'rim', 2), { ...circle, rim: wide });
    assert.deepEqual(withRadius(ellipse, drawn, 'rim', 2), { ...ellipse, rim: wide });
    assert.deepEqual(withRadius(circle, drawn, 'across', 2), { ...circle, across: { radius: 2 } });
  });

  test('has its radius across in the plane of the face, to the left', () => {
    const { acrossDirection, reachAlong } = module;
    const corners = [
      [1, 1, 3],
      [5, 1, 3],
      [2, 4, 3],
    ];
    assert.deepEqual(acrossDirection([1, 0, 0], corners), [0, 1, 0]);
    const [x, y, z] = acrossDirection([0.6, 0.8, 0.3], corners);
    assert.ok(Math.hypot(x + 0.8, y - 0.6, z) < 1e-15, 'of the part in the face');
    assert.equal(reachAlong(5, [0.6, 0.8, 0], [0, 1, 0]), 4);
    assert.equal(reachAlong(5, [0.6, -0.8, 0], [0, 1, 0]), -4);
  });

  test('takes positive numbers, even with a decimal comma', async () => {
    const { positiveNumber } = await load('panels/number_field.ts');
    for (const [text, value] of Object.entries({ 2: 2, ' 0.5 ': 0.5, '0,5': 0.5, '1e-3': 1e-3 })) {
      assert.equal(positiveNumber(text), value);
    }
    for (const text of ['', ' ', '0', '-1', 'wide', '1 2', 'Infinity', 'NaN', '1,2,3']) {
      assert.equal(positiveNumber(text), null, text);
    }
  });
});

describe('the newest request', () => {
  test('waits for the running one, and older ones are dropped', async () => {
    const { Newest } = await load('editor/engine/newest.ts');
    const ran = [];
    let idle = 2;
    let release;
    const newest = new Newest(
      (job) => {
        ran.push(job);
        return new Promise((resolve) => {
          release = resolve;
        });
      },
      async () => {
        ran.push('idle');
        return --idle > 0;
      },
    );
    for (const job of [1, 2, 3]) newest.push(job);
    assert.deepEqual(ran, [1]);
    assert.equal(newest.busy, true);
    release();
    await new Promise(setImmediate);
    assert.deepEqual(ran, [1, 3]);
    release();
    await new Promise(setImmediate);
    assert.deepEqual(ran, [1, 3, 'idle', 'idle']);
    assert.equal(newest.busy, false);
  });
});

describe('parts of a curve without a center', () => {
  test('are bridges, and runs of samples that did not converge', async () => {
    const { lostSamples } = await load('model/lost.ts');
    const { lostIntervals } = await load('worker/traced.ts');
    const [c, b, i, n] = ['converged', 'bridged', 'indefinite', 'noProgress'];
    const status = [c, b, b, c, i, i, n, c, c];
    const segment = [0, 0, 0, 0, 1, 1, 1, 1, 1];
    const t = [0, 0.3, 0.6, 1, 0, 0.25, 0.5, 0.75, 1];
    const position = Float64Array.from({ length: 27 }, (_, at) => at);
    const bridged = [
      { segment: 1, t0: 0.8, t1: 0.85, reason: 'jump' },
      { segment: 0, t0: 0.1, t1: 0.7, reason: i },
    ];
    const lost = lostIntervals({ segment, t, status, position }, bridged);
    const at = (sample) => [3 * sample, 3 * sample + 1, 3 * sample + 2];
    assert.deepEqual(lost, [
      { segment: 0, from: 0.1, to: 0.7, reason: i, samples: 2, position: at(1) },
      { segment: 1, from: 0, to: 0.25, reason: i, samples: 2, position: at(4) },
      { segment: 1, from: 0.5, to: 0.5, reason: n, samples: 1, position: at(6) },
      { segment: 1, from: 0.8, to: 0.85, reason: 'jump', samples: 0, position: at(7) },
    ]);
    assert.equal(lostSamples(lost), 5);
    assert.deepEqual(lostIntervals({ segment: [], t: [], status: [], position: [] }, []), []);
  });
});

describe('the shift between two curves', () => {
  test('has a median and a largest value in the unit given', async () => {
    const { shiftBetween } = await load('editor/engine/compute.ts');
    const to = Float64Array.of(1, 0, 0, 0, 2, 0, 0, 0, 6, 3, 4, 0);
    assert.deepEqual(shiftBetween(new Float64Array(12), to, 2), { median: 1.75, largest: 3 });
    assert.equal(shiftBetween(new Float64Array(9), to, 1), null);
    assert.equal(shiftBetween(new Float64Array(), new Float64Array(), 1), null);
  });
});
