// The page's parts that need no browser.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load as loadEngine } from 'karcher';
import { runnerImport } from 'vite';

const load = async (path) => {
  const file = fileURLToPath(new URL(`../../web/${path}`, import.meta.url));
  const { module } = await runnerImport(file, { configFile: false, logLevel: 'error' });
  return module;
};

const point = (face, u = 0.25, v = 0.5) => ({ face, bary: [1 - u - v, u, v] });
const settings = {
  closed: false,
  degree: 3,
  clamped: false,
  knots: null,
  parametrization: 'centripetal',
  samples: 128,
  tolerance: null,
  marks: 0,
  levels: 'auto',
};
const figure = {
  kind: 'bspline',
  settings,
  points: [1, 2, 3, 4].map((face) => point(face)),
  circle: null,
  circleForm: { type: 'arcs', arcs: 7 },
};
const circle = { center: point(5), rim: { radius: 0.5, direction: [0, 0, 1] } };
const ellipse = { ...circle, across: { radius: 0.2 } };

describe('what was traced', () => {
  test('is remembered of what is in the drawing and the last 64 beside that', async () => {
    const { BesideObjects, mostRemembered } = await load('editor/beside.ts');
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

describe('a figure', () => {
  test('has all of its places taken elsewhere, and nothing else', async () => {
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

  test('of the last point lead on to the first of a closed curve only', () => {
    const points = figure.points.with(3, { ...point(4), leg: drawn });
    const closed = { settings: { ...settings, closed: true }, points };
    assert.deepEqual(legs.legsOf(closed), { legs: [null, null, null, drawn] });
    assert.deepEqual(legs.legsOf({ ...closed, settings }), {});
    assert.equal(legOf(legs.withFittingLegs({ ...closed, settings }, closed))[3], undefined);
  });

  test('are named in the order of the points, or not at all', () => {
    assert.deepEqual(legs.legsOf(withOne), { legs: [null, drawn, null] });
    assert.deepEqual(legs.legsOf(figure), {});
  });
});

describe('commands of a figure', () => {
  let module;
  before(async () => {
    module = {
      ...(await load('model/figure.ts')),
      ...(await load('model/figure_commands.ts')),
    };
  });

  test('the inverse takes a command back', () => {
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

  test('that say nothing are refused', () => {
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

  test('have as many triangles at most as a shape that the engine makes', async () => {
    const karcher = await loadEngine();
    assert.throws(() => karcher.shape('sphere', 1_000_001), /to 1000000 can be made/);
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

describe('links', () => {
  let link;
  let drawing;
  before(async () => {
    link = await load('model/link.ts');
    drawing = await load('model/drawing.ts');
  });
  /** The edited figure of a link. */
  const figureOf = (text) => drawing.activeObject(link.parseLink(text).drawing).figure;
  const fitted = (whole, triangles) =>
    drawing.activeObject(link.fitting(drawing.drawingOf(whole), triangles)).figure;

  test('say what they were made of', () => {
    const curve = {
      ...figure,
      settings: { ...settings, degree: 2, clamped: true, knots: [0, 0.5, 2, 2, 4, 7], levels: 2 },
      points: [
        point(1),
        { ...point(2), weight: 4, leg: [point(12), point(13, 0.1, 0.2)] },
        { ...point(3), beta: 0.25 },
      ],
    };
    const round = { ...figure, kind: 'circle', points: [], circle };
    const form = { type: 'linear', arcs: 24 };
    const polyline = {
      ...figure,
      kind: 'polyline',
      settings: { ...settings, closed: true, tolerance: 1e-5 },
      points: figure.points.with(3, { ...point(4), leg: [point(9)] }),
    };
    const through = {
      ...figure,
      kind: 'catmullrom',
      settings: { ...settings, parametrization: 'uniform', samples: 64, marks: 9, levels: 'limit' },
      points: [point(7), { ...point(8), weight: 2, beta: 3 }],
    };
    const pen = {
      ...figure,
      kind: 'pen',
      points: [
        { ...point(1), tangents: { after: { direction: [0, 0.6, -0.8], length: 0.25 } } },
        { ...point(2), tangents: { before: { length: null }, after: point(3, 0.1, 0.2) } },
        point(4),
        {
          ...point(5),
          tangents: { before: { direction: [1, 0, 0], length: 2 }, after: { length: 0.5 } },
        },
      ],
    };
    const whole = {
      objects: [
        drawing.newObject(1, polyline, { name: 'a b&c=#;é', width: 0.5, group: 'Group 1' }),
        drawing.newObject(2, { ...round, circleForm: form }, { color: '#0a0B0c'.toLowerCase() }),
        drawing.newObject(3, curve, { visible: false, group: 'Group 1' }),
        drawing.newObject(4, through, { locked: true, dash: 'dotted' }),
        drawing.newObject(5, pen),
      ],
    };
    for (const mesh of ['bunny:1', 'file:1x-9:a b&c=#.obj']) {
      for (const active of [1, 2, 3, 4, 5]) {
        const made = { ...whole, active };
        const text = link.formatLink(mesh, 'paper-exact', made);
        const read = link.parseLink(`#${text}`);
        const unread = { points: 0, circles: 0 };
        assert.deepEqual(read, {
          mesh,
          method: 'paper-exact',
          drawing: made,
          unread,
          problems: [],
        });
        assert.equal(JSON.stringify(read.drawing), JSON.stringify(made));
      }
    }
  });

  test('of before there were objects keep what was not shown as an object', () => {
    const fields = 'points=1,0.25,0.5;2,0.25,0.5&circle=5,0.25,0.5;0.5,0,0,1';
    const other = encodeURIComponent('kind=polyline&points=3,0.25,0.5;4,0.25,0.5');
    const shownOf = (kind) => {
      const { drawing: read, unread } = link.parseLink(
        `#mesh=torus:9&kind=${kind}&${fields}&other=${other}`,
      );
      assert.deepEqual(unread, { points: 0, circles: 0 });
      assert.equal(read.active, 1);
      return read.objects.map((one) => [
        one.figure.kind,
        one.figure.points.length,
        one.figure.circle !== null,
        one.visible,
      ]);
    };
    const line = ['polyline', 2, false, true];
    assert.deepEqual(shownOf('bezier'), [
      ['bezier', 2, false, true],
      line,
      ['circle', 0, true, false],
    ]);
    assert.deepEqual(shownOf('ellipse'), [
      ['ellipse', 0, true, true],
      line,
      ['bspline', 2, false, false],
    ]);
  });

  test('say every form of a circle and an ellipse', () => {
    const rims = [circle.rim, point(6)];
    const acrosses = [undefined, { radius: 0.2 }, point(7)];
    for (const kind of ['circle', 'ellipse']) {
      for (const rim of rims) {
        for (const across of acrosses) {
          const shape = { center: point(5), rim, ...(across && { across }) };
          const whole = { ...figure, kind, points: [], circle: shape };
          const text = link.formatLink('torus:9', 'karcher', drawing.drawingOf(whole));
          assert.deepEqual(figureOf(text), whole);
        }
      }
    }
  });

  test('leave out what they say wrongly', () => {
    assert.equal(link.parseLink('#'), null);
    const text =
      '#mesh=torus:9&kind=conic&method=magic&points=1,0.2;x;2,0.1,0.2;-1,0,0;3,2,2;4,nan,0';
    const read = link.parseLink(text);
    assert.equal(read.method, null);
    const { points, kind } = figureOf(text);
    assert.equal(kind, 'bspline');
    assert.deepEqual(
      points.map(({ face }) => face),
      [2],
    );
    assert.equal(figureOf('#mesh=torus:9&kind=circle&circle=1,0.2,0.2;-3,1,0,0').circle, null);
    const form = (fields) => figureOf(`#mesh=torus:9&${fields}`).circleForm;
    const knots = (fields) => figureOf(`#mesh=torus:9&${fields}`).settings.knots;
    assert.deepEqual(knots('degree=1&knots=0,1,2,4&points=1,0,0;2,0,0'), [0, 1, 2, 4]);
    assert.equal(knots('degree=1&knots=0,1,2&points=1,0,0;2,0,0'), null, 'one too few');
    for (const fields of ['samples=1', 'samples=2.5', 'tolerance=0', 'tolerance=x', 'marks=1e9']) {
      assert.deepEqual(figureOf(`#mesh=torus:9&${fields}`).settings, settings);
    }
    assert.deepEqual(form('circletype=round&arcs=2'), figure.circleForm);
    assert.deepEqual(form('circletype=exact&arcs=25'), { type: 'exact', arcs: 7 });
    const leg = (fields) => figureOf(`#mesh=torus:9&points=1,0,0;2,0,0&${fields}`);
    for (const fields of [
      'legs=',
      'legs=0',
      'legs=0:',
      'legs=x:3,0,0',
      'legs=0:3,0,2',
      'legs=7:3,0,0',
    ]) {
      assert.ok(
        leg(fields).points.every((point) => !('leg' in point)),
        fields,
      );
    }
    const many = 'legs=0:3,0,0;1:'.concat(Array.from({ length: 65 }, () => '3,0,0').join(':'));
    assert.deepEqual(
      leg(many).points.map((point) => point.leg?.length),
      [1, undefined],
    );
    for (const across of ['', ';', ';-1', ';0', ';wide', ';1,2']) {
      const text = `#mesh=torus:9&kind=circle&circle=5,0.25,0.5;0.5,0,0,1${across}`;
      assert.deepEqual(figureOf(text).circle, circle, across);
    }
  });

  test('count what they say wrongly, and what is beyond the surface', () => {
    const lost = (fields) => {
      const read = link.parseLink(`#mesh=torus:9&${fields}`);
      return link.lostOf(read, link.fitting(read.drawing, 4));
    };
    assert.deepEqual(lost('points='), { points: 0, circles: 0 });
    assert.deepEqual(lost('points=3,0.2,0.2;4,0.2,0.2;x'), { points: 2, circles: 0 });
    assert.deepEqual(lost('kind=center&points=1,0.7,0.7;;1,-0.1,0'), { points: 2, circles: 0 });
    const other = encodeURIComponent('kind=bezier&points=1,0,0;9,0,0;1,nan,0');
    assert.deepEqual(lost(`points=1,0,0&other=${other}`), { points: 2, circles: 0 });
    for (const [circle, isLost] of [
      ['1,0,0;2,0,0', false],
      ['1,0,0;7,0,0', true],
      ['1,0,0;-3,0,0,1', true],
    ]) {
      assert.deepEqual(lost(`circle=${circle}`), { points: 0, circles: isLost ? 1 : 0 });
    }
  });

  test('keep only points of the surface', () => {
    const others = [5, 2].map((face, i) =>
      drawing.newObject(i + 2, { ...figure, kind: 'bezier', points: [point(face)] }),
    );
    const far = {
      ...figure,
      points: [],
      kind: 'circle',
      circle: { center: point(99), rim: point(1) },
    };
    const objects = [drawing.newObject(1, figure), ...others, drawing.newObject(4, far)];
    const fit = link.fitting({ objects, active: 1 }, 4);
    assert.deepEqual(
      fit.objects.map(({ id }) => id),
      [1, 3],
      'what has nothing on the surface is left out',
    );
    assert.deepEqual(fit.objects[0].figure.points, figure.points.slice(0, 3));
    assert.deepEqual(fit.objects[1], others[1]);
    const empty = link.fitting({ objects, active: 4 }, 4).objects.at(-1);
    assert.equal(empty.figure.circle, null, 'the edited one stays');
    const drawn = [
      { ...point(1), leg: [point(3)] },
      { ...point(2), leg: [point(3), point(4)] },
      { ...point(3), leg: [point(1)] },
      point(4),
    ];
    const legsLeft = fitted({ ...figure, points: drawn }, 4).points.map(({ leg }) => leg);
    assert.deepEqual(legsLeft, [[point(3)], undefined, undefined]);
    const knots = [0, 1, 2, 3, 4, 5, 6, 8];
    const knotted = { ...figure, settings: { ...settings, knots } };
    assert.deepEqual(fitted(knotted, 5).settings.knots, knots);
    assert.equal(fitted(knotted, 4).settings.knots, null, 'they are for other points');
    for (const [across, fits] of [
      [point(3), true],
      [point(4), false],
      [{ radius: 5 }, true],
    ]) {
      const shape = { ...circle, center: point(1), across };
      assert.deepEqual(fitted({ ...figure, circle: shape }, 4).circle, fits ? shape : null);
    }
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

  test("keeps an ellipse's radius as a circle, but no point it was taken from", () => {
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

  test('takes positive numbers, with a decimal comma too', async () => {
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
    const { Newest } = await load('editor/newest.ts');
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
  test('are what is bridged, and runs of samples that are not converged', async () => {
    const { lostIntervals, lostSamples } = await load('model/lost.ts');
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
    const { shiftBetween } = await load('editor/shift.ts');
    const to = Float64Array.of(1, 0, 0, 0, 2, 0, 0, 0, 6, 3, 4, 0);
    assert.deepEqual(shiftBetween(new Float64Array(12), to, 2), { median: 1.75, largest: 3 });
    assert.equal(shiftBetween(new Float64Array(9), to, 1), null);
    assert.equal(shiftBetween(new Float64Array(), new Float64Array(), 1), null);
  });
});
