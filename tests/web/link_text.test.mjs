// The text of links and the values read from it: these tests need no browser.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { circle, figure, load, point, settings } from './figures.mjs';

describe('links', () => {
  let link;
  let drawing;
  before(async () => {
    link = { ...(await load('model/link.ts')), ...(await load('model/fitting.ts')) };
    drawing = await load('model/drawing.ts');
  });
  /** The edited figure of a link. */
  const figureOf = (text) => drawing.activeObject(link.parseLink(text).drawing).figure;
  const fitted = (whole, triangles) =>
    drawing.activeObject(link.fitting(drawing.drawingOf(whole), triangles)).figure;

  test('describe what they were made of', () => {
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
        drawing.newObject(3, { ...curve, inside: 'right' }, { visible: false, group: 'Group 1' }),
        drawing.newObject(4, through, {
          locked: true,
          dash: 'dotted',
          opacity: 0.35,
          fill: 0.4,
          fillColor: '#0b8457',
          pattern: 'striped',
          spacing: 0.125,
        }),
        drawing.newObject(5, pen, {
          ...{ width: 0.0275, onSurface: true, fill: 1 },
          ...{ pattern: 'hatched', spacing: 2 },
        }),
      ],
    };
    for (const mesh of ['bunny:1', 'file:1x-9:a b&c=#.obj']) {
      for (const active of [1, 2, 3, 4, 5]) {
        const made = { ...whole, active };
        const turned = { azimuth: -30.5, elevation: 12.25, reach: 0.5, target: [0, 0.125, -1] };
        const view = [null, 'top', turned][active % 3];
        const text = link.formatLink(mesh, 'paper-exact', made, view);
        const read = link.parseLink(`#${text}`);
        const unread = { points: 0, circles: 0 };
        assert.deepEqual(read, {
          mesh,
          method: 'paper-exact',
          drawing: made,
          view,
          unread,
          problems: [],
        });
        assert.equal(JSON.stringify(read.drawing), JSON.stringify(made));
      }
    }
  });

  test('from before there were objects keep the hidden part as an object', () => {
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

  test('describe every form of a circle and an ellipse', () => {
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

  test('lose only their wrong parts', () => {
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
    assert.deepEqual(form('circletype=exact&arcs=25'), { type: 'exact', arcs: 'auto' });
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
    const many = 'legs=0:3,0,0;1:'.concat(Array.from({ length: 20_001 }, () => '3,0,0').join(':'));
    assert.deepEqual(
      leg(many).points.map((point) => point.leg?.length),
      [1, undefined],
    );
    const legsOf = (points, legs) =>
      figureOf(`#mesh=torus:9&closed=1&points=${points}&legs=${legs}`).points.map(({ leg }) => leg);
    assert.deepEqual(
      legsOf('1,0,0;oops;3,0,0;4,0,0', '0:7,0,0;1:7,0,0;2:8,0,0;3:8,0,0'),
      [undefined, [point(8, 0, 0)], [point(8, 0, 0)]],
      'a leg goes with the point that it leads to',
    );
    assert.deepEqual(legsOf('oops;3,0,0;4,0,0', '2:8,0,0'), [undefined, undefined]);
    for (const across of ['', ';', ';-1', ';0', ';wide', ';1,2']) {
      const text = `#mesh=torus:9&kind=circle&circle=5,0.25,0.5;0.5,0,0,1${across}`;
      assert.deepEqual(figureOf(text).circle, circle, across);
    }
  });

  test('keep the sources of objects, even if objects below these are lost', () => {
    const round = (radius) =>
      `other=${encodeURIComponent(`kind=circle&circle=5,0.25,0.5;${radius},0,0,1`)}`;
    const of = (kind, sources) => `other=${encodeURIComponent(`kind=${kind}&of=${sources}`)}`;
    const [bad, small, large] = [round('bad'), round('0.5'), round('0.75')];
    const read = (...fields) => link.parseLink(`mesh=sphere:500&${fields.join('&')}`).drawing;
    const radiusOf = ({ objects }, id) =>
      objects.find((one) => one.id === id).figure.circle.rim.radius;
    // The edited union lies on three circles, of which the link loses the lowest.
    const union = read('kind=union&of=2,3&place=3', bad, small, large);
    assert.equal(union.objects.length, 3);
    const { id, figure: edited } = drawing.activeObject(union);
    assert.deepEqual([id, edited.derived.sources], [3, [1, 2]]);
    assert.deepEqual([radiusOf(union, 1), radiusOf(union, 2)], [0.5, 0.75]);
    // The edited circle lies between others, and the topmost object is derived from it.
    const beside = read(
      'kind=circle&circle=5,0.25,0.5;2,0,0,1&place=2',
      bad,
      small,
      of('union', '3,2'),
    );
    assert.deepEqual(beside.objects[2].figure.derived.sources, [2, 1]);
    assert.deepEqual([beside.active, radiusOf(beside, 2)], [2, 2]);
    // Objects that are derived from the lost one alone are lost with it, to any depth.
    const less = read(
      'kind=circle&circle=5,0.25,0.5;2,0,0,1&place=3',
      bad,
      of('union', 1),
      of('union', '2'),
    );
    assert.equal(less.objects.length, 1);
    assert.equal(less.active, 1);
  });

  test('count their wrong parts, and those beyond the surface', () => {
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
