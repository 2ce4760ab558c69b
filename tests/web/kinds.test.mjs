// Every kind of curve on the page, and the edits that belong to it.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { browserOfSuite, Tab } from './browser.mjs';
import { farthestFromSurface } from './on_surface.mjs';
import { inLongRun, part } from './part.mjs';
import { far, lengthOf, vertices } from './polylines.mjs';

const places = [
  [-110, 40],
  [-60, -30],
  [10, 40],
  [60, -50],
  [120, 10],
];
const splines = ['bspline', 'bezier', 'catmullrom', 'rational', 'barycentric', 'polyline'];
const through = ['catmullrom', 'barycentric', 'polyline'];
/** The places of surface points. */
function placesOf(points, { positions, triangles }) {
  return points.map(({ face, bary }) =>
    [0, 1, 2].map((axis) =>
      bary.reduce(
        (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
        0,
      ),
    ),
  );
}

/** The distance of a place from a polyline's vertices. */
const distanceTo = (polyline, place) =>
  Math.min(...vertices(polyline).map((vertex) => far(vertex, place)));

const ends = (polyline) => [polyline.slice(0, 3), polyline.slice(-3)];

describe('kinds of curves', () => {
  const browser = browserOfSuite();

  test('lie on the surface, meet their points, and are restored by the link', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0');
    await tab.click(...places);
    const surface = await tab.mesh();
    const { diagonal, meanEdge } = surface.info;
    // A field at vertices gives each center, so that curves meet points to a fraction of an edge.
    const meets = 0.05 * meanEdge;
    for (const kind of splines) {
      await tab.choose(kind);
      const { curve, polyline, problem } = await tab.view();
      assert.equal(problem, null, kind);
      assert.equal(await tab.page.locator('#hint').textContent(), '', kind);
      assert.ok(farthestFromSurface(polyline, surface) <= 2e-6 * diagonal, kind);
      const points = placesOf((await tab.state()).figure.points, surface);
      const [start, end] = ends(polyline);
      if (kind !== 'bspline') {
        assert.ok(far(start, points[0]) <= meets, `${kind} starts at its first point`);
        assert.ok(far(end, points.at(-1)) <= meets, `${kind} ends at its last point`);
      }
      if (through.includes(kind)) {
        // A barycentric curve has a single segment, whose samples need not lie at inner points.
        const near = kind === 'barycentric' ? curve.length / 100 : meets;
        for (const point of points) assert.ok(distanceTo(polyline, point) <= near, kind);
      }
      await tab.page.waitForFunction((name) => location.hash.includes(`kind=${name}&`), kind);
    }
    const { polyline } = await tab.view();
    await tab.page.reload();
    assert.deepEqual((await tab.view()).polyline, polyline);
    await tab.close();
  });

  inLongRun('are closed and opened', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places.slice(0, 3));
    const { diagonal } = (await tab.mesh()).info;
    await tab.page.getByLabel('Closed').check();
    for (const kind of splines) {
      await tab.choose(kind);
      const { polyline, problem } = await tab.view();
      assert.equal(problem, null, kind);
      assert.ok(far(...ends(polyline)) <= 1e-6 * diagonal, `a closed ${kind}`);
    }
    await tab.page.keyboard.press('c');
    assert.ok(far(...ends((await tab.view()).polyline)) > 0.01 * diagonal);
    await tab.page.keyboard.press('Control+z');
    assert.ok(far(...ends((await tab.view()).polyline)) <= 1e-6 * diagonal);
    await tab.close();
  });

  inLongRun('have the degree and the ends that are asked for', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const surface = await tab.mesh();
    for (const degree of [1, 2, 3, 4]) {
      await tab.page.locator('#degree').selectOption(`${degree}`);
      const { curve } = await tab.view();
      assert.equal(new Set(Object.values(curve.samples.segment)).size, 5 - degree);
    }
    await tab.page.locator('#degree').selectOption('5');
    assert.equal((await tab.view()).curve, null);
    assert.equal(await tab.page.locator('#hint').textContent(), '1 more point makes a curve');
    await tab.page.locator('#degree').selectOption('3');
    await tab.page.getByLabel('Clamped ends').check();
    const { polyline } = await tab.view();
    const points = placesOf((await tab.state()).figure.points, surface);
    const meets = 0.05 * surface.info.meanEdge;
    assert.ok(far(ends(polyline)[0], points[0]) <= meets);
    assert.ok(far(ends(polyline)[1], points.at(-1)) <= meets);
    await tab.close();
  });

  const sliders = { bspline: 'Weight', rational: 'Weight', barycentric: 'Beta' };
  for (const [kind, name] of part(Object.entries(sliders), 1)) {
    test(`the ${name.toLowerCase()} slider of a ${kind} curve takes effect at once, as one step`, async () => {
      const tab = await Tab.open(browser);
      await tab.click(...places);
      await tab.choose(kind);
      const before = await tab.view();
      const surface = await tab.mesh();
      const [point] = placesOf([(await tab.state()).figure.points[2]], surface);
      const slider = tab.page.getByRole('slider', { name: `${name} of point 3` });
      for (const value of [36, 42, 48]) {
        await slider.evaluate((input, to) => {
          input.value = `${to}`;
          input.dispatchEvent(new Event('input', { bubbles: true }));
        }, value);
        await tab.page.waitForFunction(
          () => window.karcherPage.state().revision === window.karcherPage.view().revision,
        );
        const { quality, curve } = await tab.page.evaluate(() => window.karcherPage.view());
        assert.ok(curve && quality === 'draft', 'while the slider is held');
      }
      await slider.evaluate((input) => input.dispatchEvent(new Event('change', { bubbles: true })));
      const weighted = await tab.view();
      assert.equal(weighted.quality, 'exact');
      assert.notDeepEqual(weighted.polyline, before.polyline);
      if (kind !== 'barycentric') {
        const [near, was] = [weighted, before].map(({ polyline }) => distanceTo(polyline, point));
        assert.ok(near < 0.6 * was, 'a weight pulls the curve');
      }
      await tab.page.locator('#stage').focus();
      await tab.page.keyboard.press('Control+z');
      assert.deepEqual((await tab.view()).polyline, before.polyline);
      await tab.page.keyboard.press('Control+Shift+z');
      assert.deepEqual((await tab.view()).polyline, weighted.polyline);
      await tab.close();
    });
  }

  for (const kind of part(splines, 2)) {
    test(`a click on a ${kind} curve inserts a point`, async () => {
      const tab = await Tab.open(browser);
      await tab.click(...places);
      await tab.choose(kind);
      const before = await tab.view();
      const { points } = (await tab.state()).figure;
      // A visible sample, away from all handles and from the knot in the middle.
      const at = await tab.onCurve(0.3);
      await tab.page.mouse.move(at.x, at.y);
      await tab.page.locator('.preview[data-on="curve"]').waitFor();
      await tab.page.mouse.click(at.x, at.y);
      await tab.page.waitForFunction(
        (count) => window.karcherPage.state().figure.points.length === count,
        points.length + 1,
      );
      const { selection } = await tab.state();
      assert.ok(selection > 0 && selection < points.length, 'a new point is selected');
      const after = await tab.view();
      const { meanEdge } = (await tab.mesh()).info;
      if (kind === 'catmullrom') {
        assert.ok(
          distanceTo(
            after.polyline,
            placesOf([(await tab.state()).figure.points[selection]], await tab.mesh())[0],
          ) <
            0.05 * meanEdge,
        );
      } else {
        // On a plane the curve would be the same. Here it differs by the curvature: a fifth of it
        // spans the sphere.
        assert.ok(Math.abs(after.curve.length - before.curve.length) < 0.05 * before.curve.length);
      }
      await tab.page.keyboard.press('Control+z');
      assert.deepEqual((await tab.view()).polyline, before.polyline);
      await tab.close();
    });
  }

  inLongRun('a B-spline that took a knot takes every edit after it', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    const knot = await tab.onCurve(0.5);
    await page.mouse.click(knot.x, knot.y);
    await page.getByText('The curve has a knot there already.').waitFor();
    assert.equal((await tab.state()).figure.points.length, 5, 'no second knot beside the first');
    const at = await tab.onCurve(0.3);
    await page.mouse.click(at.x, at.y);
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length === 6);
    const { figure: knotted } = await tab.state();
    assert.equal(knotted.settings.knots.length, 10);
    const { polyline } = await tab.view();
    const edits = {
      removed: () => page.keyboard.press('Delete'),
      added: () => page.mouse.click(at.x, at.y + 130),
      cleared: async () => {
        await page.locator('#clear').click();
        await tab.click(...places);
      },
    };
    for (const [name, edit] of Object.entries(edits)) {
      const { revision } = await tab.state();
      await edit();
      await page.waitForFunction((from) => window.karcherPage.state().revision > from, revision);
      const { problem, curve } = await tab.view();
      assert.equal(problem, null, name);
      assert.ok(curve, name);
      const { settings } = (await tab.state()).figure;
      const count = { removed: 9, added: 11 }[name];
      assert.equal(settings.knots?.length, count, name);
      await page.locator('#stage').focus();
      const isBack = async () => isDeepStrictEqual((await tab.state()).figure, knotted);
      for (let step = 0; step < 6 && !(await isBack()); step++)
        await page.keyboard.press('Control+z');
      assert.deepEqual((await tab.state()).figure, knotted, name);
      assert.deepEqual((await tab.view()).polyline, polyline, name);
    }
    await tab.close();
  });

  test('can be cut at a click, and joined again', async () => {
    const tab = await Tab.open(browser, 'mesh=openSheet:1500');
    await tab.click(...places, [130, 80]);
    for (const kind of part(['bspline', 'catmullrom', 'polyline', 'bezier'], 2)) {
      await tab.choose(kind);
      const before = await tab.view();
      await tab.page.keyboard.press('s');
      assert.equal(
        await tab.page.locator('#hint').textContent(),
        'Click the curve where you want to cut it',
      );
      const at = await tab.onCurve(0.4);
      await tab.page.mouse.click(at.x, at.y);
      await tab.page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
      const cut = await tab.view();
      const [first, second] = [cut.polyline, Object.values(cut.others[0].lines[0])];
      const { meanEdge } = (await tab.mesh()).info;
      assert.ok(far(ends(first)[1], ends(second)[0]) < 0.1 * meanEdge, `${kind}: ends meet`);
      const length = lengthOf(first) + lengthOf(second);
      assert.ok(Math.abs(length - before.curve.length) < 0.05 * length, kind);
      assert.equal(await tab.page.locator('#hint').textContent(), '');

      await tab.page.getByRole('button', { name: 'Join' }).click();
      await tab.page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 1);
      const whole = await tab.view();
      assert.ok(Math.abs(whole.curve.length - before.curve.length) < 0.05 * length, kind);
      await tab.page.keyboard.press('Control+z');
      await tab.page.keyboard.press('Control+z');
      assert.deepEqual((await tab.view()).polyline, before.polyline, kind);
    }
    await tab.page.keyboard.press('s');
    await tab.page.keyboard.press('Escape');
    assert.equal((await tab.state()).tool, 'insert');
    await tab.close();
  });

  test('a B-spline has its knots as a list, and wrong lists lose no work', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    const before = await tab.view();
    const knots = page.getByRole('textbox', { name: 'Knots' });
    assert.equal(await knots.inputValue(), '-3, -2, -1, 0, 1, 2, 3, 4, 5');
    const problem = page.locator('#knots-problem');
    for (const [text, sentence] of [
      ['0 0 0 0 1 2 2 2', /^A B-spline of 5 points and degree 3 takes 9 knots, not 8\.$/],
      ['0 0 0 0 1 0.5 2 2 2', /^Knot 5 is 0\.5, less than knot 4, which is 1\.$/],
      ['0 0 0 0 1 2 2 2 wide', /^'wide' is not a number\.$/],
    ]) {
      await knots.fill(text);
      await knots.press('Enter');
      await page.waitForFunction(
        (source) => new RegExp(source).test(document.getElementById('knots-problem').textContent),
        sentence.source,
      );
      assert.equal(await knots.inputValue(), text, 'it stays to be mended');
      assert.deepEqual((await tab.view()).polyline, before.polyline);
    }
    await knots.press('Escape');
    assert.equal(await problem.isVisible(), false);
    await knots.fill('0; 0; 0; 0; 1,5 2 2, 2, 2'.replace('1,5', '1.5'));
    await knots.press('Enter');
    await page.waitForFunction(() => window.karcherPage.state().figure.settings.knots);
    assert.deepEqual((await tab.state()).figure.settings.knots, [0, 0, 0, 0, 1.5, 2, 2, 2, 2]);
    const { polyline } = await tab.view();
    const points = placesOf((await tab.state()).figure.points, await tab.mesh());
    const { meanEdge } = (await tab.mesh()).info;
    assert.ok(far(ends(polyline)[0], points[0]) <= 0.05 * meanEdge, 'it reaches its ends');
    await knots.fill('');
    await knots.press('Enter');
    assert.deepEqual((await tab.view()).polyline, before.polyline, 'without any they are even');
    await page.locator('#stage').focus();
    await page.keyboard.press('Control+z');
    assert.deepEqual((await tab.view()).polyline, polyline);
    await tab.close();
  });

  inLongRun('as many samples as a tolerance takes, and marks evenly along the curve', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    await page.locator('#sampling').selectOption('tolerance');
    const fine = (await tab.view()).curve;
    assert.notEqual(fine.samples.count, 256);
    const tolerance = page.locator('#tolerance');
    assert.equal(await tolerance.inputValue(), '0.0001');
    await tolerance.fill('1e-2');
    await tolerance.press('Enter');
    const coarse = (await tab.view()).curve;
    assert.ok(coarse.samples.count < fine.samples.count);
    await tab.dragHandle('Control point 2 of 5', 10, -10);
    assert.ok((await tab.view()).curve.samples.count < 256, 'after a drag too');

    await page.locator('#marks').fill('5');
    await page.locator('#marks').press('Enter');
    const { curve } = await tab.view();
    const position = Object.values(curve.marks.position);
    assert.equal(position.length, 15);
    await page.waitForFunction(() => location.hash.includes('tolerance=0.01&marks=5'));
    const { text } = await tab.save('OBJ');
    assert.match(text, /\np( \d+){5}\n$/);
    const content = JSON.parse((await tab.save('JSON')).text);
    assert.deepEqual(
      content.marks.flatMap((mark) => mark.position),
      position,
    );
    assert.equal((await tab.save('SVG')).text.match(/r="4"/g).length, 5);
    await page.reload();
    assert.deepEqual(Object.values((await tab.view()).curve.marks.position).length, 15);
    await tab.close();
  });

  inLongRun('are measured where they are pointed at', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    const { figure: document } = await tab.state();
    await page.keyboard.press('m');
    const hint = page.locator('#hint');
    assert.match(await hint.textContent(), /^Point at the curve/);
    const { curve } = await tab.view();
    const measuredAt = async (part) => {
      const at = await tab.onCurve(part);
      const before = await hint.textContent();
      await page.mouse.move(at.x + 3, at.y + 3);
      await page.waitForFunction(
        (text) => document.getElementById('hint').textContent !== text,
        before,
      );
      const [parameter, length, whole, ...tangent] = (await hint.textContent())
        .replaceAll('−', '-')
        .match(/-?\d+(\.\d+)?/g)
        .map(Number);
      assert.equal(whole, Number(curve.length.toPrecision(4)));
      assert.ok(Math.abs(Math.hypot(...tangent) - 1) < 0.02);
      return { parameter, length };
    };
    const [early, late] = [await measuredAt(0.2), await measuredAt(0.7)];
    assert.ok(early.parameter < late.parameter && late.parameter < 2);
    assert.ok(early.length > 0 && early.length < late.length && late.length < curve.length);
    const at = await tab.onCurve(0.5);
    await page.mouse.click(at.x, at.y);
    await tab.settled();
    assert.deepEqual((await tab.state()).figure, document, 'and stay as they are');
    await page.keyboard.press('Escape');
    assert.equal((await tab.state()).tool, 'insert');
    assert.equal(await hint.textContent(), '');
    await tab.close();
  });

  inLongRun('are run backwards', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    for (const kind of ['bspline', 'catmullrom']) {
      await tab.choose(kind);
      const before = await tab.view();
      await tab.page.getByRole('button', { name: 'Reverse' }).click();
      await tab.page.waitForFunction(
        (revision) => window.karcherPage.state().revision > revision,
        before.revision,
      );
      const { polyline } = await tab.view();
      const { diagonal } = (await tab.mesh()).info;
      assert.ok(far(ends(polyline)[0], ends(before.polyline)[1]) <= 1e-6 * diagonal);
      assert.ok(far(ends(polyline)[1], ends(before.polyline)[0]) <= 1e-6 * diagonal);
    }
    await tab.close();
  });

  inLongRun('lie beside each other, and a click takes up another one', async () => {
    const other = encodeURIComponent('kind=catmullrom&points=30,0.3,0.3;200,0.3,0.3;400,0.3,0.3');
    const tab = await Tab.open(browser, `mesh=openSheet:1500&kind=bspline&points=&other=${other}`);
    await tab.click([-110, 90], [-60, 40], [10, 90], [60, 40]);
    const first = await tab.view();
    assert.ok(first.others[0].lines[0], 'the other curve is drawn');
    const at = await tab.onCurve(0.4, 0);
    await tab.page.mouse.click(at.x, at.y);
    await tab.settled();
    const { figure: document } = await tab.state();
    assert.equal(document.kind, 'catmullrom');
    assert.equal(document.points.length, 3);
    const { objects, active } = (await tab.state()).drawing;
    const others = objects.filter(({ id }) => id !== active);
    assert.deepEqual(
      others.map(({ figure: { kind, points } }) => [kind, points.length]),
      [['bspline', 4]],
    );
    assert.ok((await tab.view()).others[0].lines[0]);
    await tab.page.keyboard.press('Control+z');
    assert.equal((await tab.state()).figure.kind, 'bspline');
    await tab.close();
  });
});
