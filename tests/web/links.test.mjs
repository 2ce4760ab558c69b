// The page refuses or explains links that are too long or invalid, and never breaks.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import fc from 'fast-check';
import { draws } from '../wasm/draws.mjs';
import { browserOfSuite, Tab } from './browser.mjs';
import { load } from './figures.mjs';

const link =
  'mesh=sphere:1500&kind=bspline&method=karcher&points=1,0.2,0.3;40,0.1,0.1,2;90,0.3,0.3;7,0.5,0.25' +
  '&legs=1:5,0.2,0.2&closed=1&degree=2&samples=64&marks=9&levels=2&name=a%20name&color=d9560b&width=6' +
  '&other=kind%3Dcircle%26points%3D%26circle%3D3%2C0.2%2C0.2%3B0.5%2C0%2C0%2C1%26arcs%3D5';

describe('links', () => {
  let model;
  before(async () => {
    const [{ parseLink, formatLink }, { linkProblems }] = [
      await load('model/link.ts'),
      await load('model/link_problems.ts'),
    ];
    model = { parseLink, formatLink, linkProblems };
  });

  test('have wrong parts explained, with the bounds and the replacement', () => {
    const told = (fragment) => model.linkProblems(`mesh=sphere:1500&${fragment}`);
    assert.deepEqual(told('samples=5000000'), [
      "The link's 'samples' must be a whole number from 2 to 5,000, not '5000000'; using 128.",
    ]);
    assert.match(
      told('kind=spiral')[0],
      /'kind' must be one of bspline, .*, not 'spiral'; using bspline/,
    );
    assert.match(told('method=guess')[0], /method 'guess' is not known/);
    for (const wrong of [
      'degree=9',
      'levels=x',
      'marks=1',
      'tolerance=7',
      'arcs=2.5',
      'closed=yes',
      'color=red',
      'knots=1,2,x',
      'legs=0',
      'legs=0:1,0.2',
      `legs=0${':1,0.2,0.2'.repeat(20_001)}`,
      'tangents=x:same',
      'tangents=0:1,2',
    ]) {
      assert.equal(told(wrong).length, 1, wrong);
    }
    assert.equal(told(`other=${encodeURIComponent('kind=bezier&samples=1')}`).length, 1);
    assert.deepEqual(told(`samples=${'9'.repeat(500)}`)[0].length < 200, true);
    assert.equal(told('degree=9&levels=x&marks=1&tolerance=7&arcs=2.5&closed=yes').length, 5);
    assert.deepEqual(model.linkProblems(link), []);
    for (const right of [
      'color=d9560b',
      'knots=0,0.5,-1e-3',
      `legs=0${':1,0.2,0.2'.repeat(64)};3:7,0,1`,
      'tangents=0::same;1:1,0.2,0.3:0.5;2:0.5,0,0,1:',
    ]) {
      assert.deepEqual(told(right), [], right);
    }
    const others = (count) => Array.from({ length: count }, () => 'other=points%3D1').join('&');
    assert.deepEqual(told(others(1999)), []);
    assert.deepEqual(told(others(2000)), ['The link has 2,001 objects; up to 2,000 are read.']);
  });

  test('written by a page have no problem, and are read unchanged', () => {
    const { mesh, method, drawing, problems } = model.parseLink(link);
    assert.deepEqual(problems, []);
    const written = model.formatLink(mesh, method, drawing);
    assert.deepEqual(model.parseLink(written).drawing, drawing);
    assert.equal(model.formatLink(mesh, method, model.parseLink(written).drawing), written);
  });

  test('of random text, or changed at random, are read or refused', () => {
    const piece = fc.oneof(
      fc.constantFrom(
        '&',
        '=',
        ';',
        ',',
        ':',
        '%',
        '%00',
        '#',
        '-1',
        '1e999',
        'NaN',
        '__proto__',
        'other',
      ),
      fc.constantFrom(
        'points',
        'mesh',
        'kind',
        'circle',
        'knots',
        'legs',
        'samples',
        'constructor',
      ),
      fc.string({ maxLength: 8 }),
      fc.double().map(String),
    );
    const change = fc.record({
      at: fc.nat(link.length),
      take: fc.nat(12),
      put: fc.array(piece, { maxLength: 4 }),
    });
    const changed = (changes) =>
      changes.reduce(
        (text, { at, take, put }) => text.slice(0, at) + put.join('') + text.slice(at + take),
        link,
      );
    const text = fc.oneof(
      fc.array(piece, { maxLength: 30 }).map((pieces) => pieces.join('')),
      fc.array(change, { minLength: 1, maxLength: 4 }).map(changed),
    );
    let read = 0;
    fc.assert(
      fc.property(text, (fragment) => {
        const parsed = model.parseLink(fragment);
        if (!parsed) return;
        read++;
        const { mesh, method, drawing, problems } = parsed;
        assert.ok(problems.every((one) => typeof one === 'string' && one.length < 400));
        // The result is a drawing: written and read again it is the same, without a message.
        const written = model.formatLink(mesh, method ?? 'karcher', drawing);
        const again = model.parseLink(written);
        assert.deepEqual(again.problems, []);
        assert.equal(model.formatLink(mesh, method ?? 'karcher', again.drawing), written);
        assert.deepEqual(JSON.parse(JSON.stringify(drawing)), drawing, 'finite, and plain');
      }),
      draws(500),
    );
    assert.ok(read > 100);
  });

  test('saved drawings of random JSON are drawings, or refused with a sentence', async () => {
    const { readDrawing, savedDrawing } = await load('model/saved_drawing.ts');
    const good = () => savedDrawing(model.parseLink(link).drawing);
    const paths = [];
    (function walk(value, path) {
      if (path.length > 0) paths.push(path);
      if (typeof value !== 'object' || value === null) return;
      for (const key of Object.keys(value)) walk(value[key], [...path, key]);
    })(good(), []);
    const value = fc.oneof(
      fc.jsonValue(),
      fc.constantFrom(-1, 1e15, 0.5, '', '0', [], {}, null, [[]], 2 ** 53, true),
    );
    fc.assert(
      fc.property(
        fc.array(fc.tuple(fc.constantFrom(...paths), value), { maxLength: 3 }),
        (changes) => {
          const copy = JSON.parse(JSON.stringify(good()));
          for (const [path, instead] of changes) {
            const owner = path.slice(0, -1).reduce((at, key) => at?.[key], copy);
            if (typeof owner === 'object' && owner !== null) owner[path.at(-1)] = instead;
          }
          let drawing;
          try {
            drawing = readDrawing(copy);
          } catch (error) {
            assert.equal(error.constructor.name, 'Error', error.stack);
            assert.ok(error.message.length > 5 && error.message.length < 400);
            return;
          }
          const written = model.formatLink('sphere:1500', 'karcher', drawing);
          assert.deepEqual(model.linkProblems(written), [], written);
        },
      ),
      draws(400),
    );
  });
});

describe('a page with a link', () => {
  const browser = browserOfSuite();

  test('of 5,000 points is refused with the bound', async () => {
    const points = Array.from({ length: 5000 }, (_, i) => `${i % 1400},0.3,0.3`).join(';');
    const tab = await Tab.open(browser, `mesh=sphere:1500&kind=bspline&points=${points}`);
    const alert = tab.page.getByRole('alert');
    assert.match(await alert.textContent(), /The link has 5,000 points; up to 1,000 are opened\./);
    await tab.close();
  });

  test('of more points that was made here opens: from its file, and by a reload with its steps', async () => {
    const tab = await Tab.open(browser);
    const points = Array.from({ length: 1200 }, (_, i) => `${i},0.25,0.5`).join(';');
    const link = `mesh=sphere:1500&kind=points&method=karcher&points=${points}`;
    await tab.drop('many.json', JSON.stringify({ format: 'karcher-curve', version: 1, link }));
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.points.length === 1200);
    await tab.pastSaving();
    await tab.page.reload();
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 1200);
    await tab.page.keyboard.press('Control+z');
    assert.equal((await tab.state()).figure.points.length, 0);
    await tab.close();
  });

  test('for a file that cannot be opened changes nothing, not even the method', async () => {
    const tab = await Tab.open(browser);
    const text = 'v 0 0 0\nf 1 2 3\n';
    const hash = [...text].reduce(
      (sum, letter) => Math.imul(sum ^ letter.charCodeAt(0), 0x01000193),
      0x811c9dc5,
    );
    const key = `file:${(hash >>> 0).toString(36)}-${text.length.toString(36)}:bad.obj`;
    const { method, mesh } = await tab.state();
    assert.notEqual(method, 'paper-ring');
    const link = `mesh=${key}&kind=polyline&method=paper-ring&points=0,0.2,0.3;0,0.5,0.2`;
    await tab.drop('waiting.json', JSON.stringify({ format: 'karcher-curve', version: 1, link }));
    await tab.page.getByText('The curve is on bad.obj').waitFor();
    await tab.drop('bad.obj', text);
    await tab.page.getByText('bad.obj could not be opened').waitFor();
    await tab.settled();
    const after = await tab.state();
    assert.deepEqual([after.mesh, after.method], [mesh, method]);
    await tab.close();
  });

  test('with a hidden object shows nothing of it, even after a refinement would be due', async () => {
    const points = '1,0.2,0.3;400,0.1,0.1;900,0.3,0.3;7,0.5,0.25';
    const own = `mesh=sphere:1500&kind=bspline&method=karcher&points=${points}`;
    const tab = await Tab.open(browser, `${own}&hidden=1`);
    await tab.settled();
    const { curve, quality } = await tab.view();
    assert.deepEqual([curve, quality], [null, null]);
    await tab.page.close();
  });

  test('with wrong settings explains them', async () => {
    const tab = await Tab.open(
      browser,
      'mesh=sphere:1500&kind=spiral&samples=5000000&points=1,0.2,0.3;40,0.1,0.1;90,0.3,0.3;7,0.5,0.25',
    );
    const said = await tab.page.getByRole('alert').textContent();
    assert.match(
      said,
      /'samples' must be a whole number from 2 to 5,000, not '5000000'; using 128/,
    );
    assert.match(said, /'kind' must be one of bspline, .*, not 'spiral'; using bspline/);
    assert.equal((await tab.view()).curve.samples.count, 128);
    await tab.page.close();
  });
});
