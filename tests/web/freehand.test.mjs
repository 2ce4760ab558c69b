// Freehand strokes with a mouse and a finger.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, openPhone, Tab, touchOf } from './browser.mjs';
import { inLongRun } from './part.mjs';

const bytesOf = async (tab) => JSON.stringify((await tab.state()).drawing);
const strokeAt = ({ x, y }) =>
  Array.from({ length: 41 }, (_, i) => ({
    x: x - 120 + 6 * i,
    y: y + 35 * Math.sin(i / 6),
  }));

/** The largest distance between the places of a stroke and the curve, in CSS pixels. */
const worstOff = (tab, stroke) =>
  tab.page.evaluate((places) => {
    const { polyline } = window.karcherPage.view().curve;
    const line = [];
    for (let i = 0; i < polyline.length; i += 3) {
      const place = window.karcherPage.seen(polyline.subarray(i, i + 3));
      if (place) line.push(place);
    }
    const from = ({ x, y }) =>
      Math.min(...line.map((place) => Math.hypot(place.x - x, place.y - y)));
    return Math.max(...places.map(from));
  }, stroke);

describe('freehand', () => {
  const browser = browserOfSuite();

  /** Moves along a stroke with the button down. */
  async function draw(page, [first, ...rest]) {
    await page.mouse.move(first.x, first.y);
    await page.mouse.down();
    for (const { x, y } of rest) await page.mouse.move(x, y);
  }

  /** Holds the engine's answers until the returned function is called. */
  async function held(tab) {
    const [engine] = tab.engines();
    await engine.evaluate(() => {
      const post = globalThis.postMessage;
      const answers = [];
      globalThis.postMessage = (...answer) => answers.push(answer);
      globalThis.release = () => {
        globalThis.postMessage = post;
        for (const answer of answers) post.apply(globalThis, answer);
      };
    });
    return () => engine.evaluate(() => globalThis.release());
  }

  test('that ends during another press leaves a drawing that a file contains', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000');
    const { page } = tab;
    const middle = await tab.middle();
    const release = await held(tab);
    await page.keyboard.press('f');
    await draw(page, strokeAt(middle));
    await page.mouse.up();
    await page.keyboard.press('o');
    await page.mouse.move(middle.x + 30, middle.y - 60);
    await page.mouse.down();
    await page.mouse.move(middle.x + 60, middle.y - 60, { steps: 4 });
    await release();
    await page.waitForFunction(() =>
      window.karcherPage.state().drawing.objects.some(({ figure }) => figure.kind === 'pen'),
    );
    await page.mouse.up();
    await tab.settled();
    const { drawing } = await tab.state();
    for (const { id, figure } of drawing.objects) {
      const isEmpty = figure.points.length === 0 && !figure.circle;
      assert.ok(!isEmpty || id === drawing.active, `object ${id} is empty`);
      assert.ok(figure.kind !== 'pen' || !figure.circle, `the curve ${id} has a circle`);
    }
    for (let undone = 0; undone < 4; undone++) await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal((await tab.state()).drawing.objects.length, 1);
    await tab.close();
  });

  test('makes a curve of few anchors near the stroke, as one step; Escape cancels the stroke', async (t) => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000');
    const { page } = tab;
    const empty = await bytesOf(tab);
    const middle = await tab.middle();
    await page.keyboard.press('f');
    assert.equal(await page.locator('#tool-freehand').getAttribute('aria-pressed'), 'true');
    const eye = await page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    const stroke = strokeAt(middle);
    await draw(page, stroke);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    assert.equal(await bytesOf(tab), empty);
    assert.equal((await tab.state()).tool, 'freehand');

    await draw(page, stroke);
    await page.mouse.up();
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length > 0);
    await tab.settled();
    const { figure } = await tab.state();
    assert.equal(figure.kind, 'pen');
    assert.ok(figure.points.length <= 8, `${figure.points.length} anchors`);
    const off = await worstOff(tab, stroke);
    t.diagnostic(`${figure.points.length} anchors, ${off.toFixed(2)} px off`);
    // The samples of the curve are up to 2 pixels apart.
    assert.ok(off < 4, `${off} px`);
    assert.deepEqual(await page.evaluate(() => window.karcherPage.seen([0, 0, 1])), eye);

    await page.locator('#freehand-tolerance').fill('12');
    const loop = Array.from({ length: 50 }, (_, i) => ({
      x: middle.x + 70 * Math.cos((2 * Math.PI * i) / 48),
      y: middle.y + 120 + 40 * Math.sin((2 * Math.PI * i) / 48),
    }));
    const before = await bytesOf(tab);
    await draw(page, loop);
    await page.mouse.up();
    await page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
    await tab.settled();
    const closed = (await tab.state()).figure;
    assert.equal(closed.settings.closed, true);
    assert.ok(closed.points.length <= 5, `${closed.points.length} anchors`);
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), before, 'one step');
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), empty);

    await page.reload();
    await tab.settled();
    assert.equal(await page.locator('#freehand-tolerance').inputValue(), '12', 'kept');
    await tab.close();
  });

  inLongRun('draws with one finger, and two turn to the view', async () => {
    const phone = await openPhone();
    const tab = await Tab.open(phone);
    const { page } = tab;
    const empty = await bytesOf(tab);
    const box = await page.locator('#tool-freehand').boundingBox();
    assert.ok(box.width >= 44 && box.height >= 44);
    await page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
    assert.equal((await tab.state()).tool, 'freehand');
    // The surface is visible above the sheet.
    const center = await page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    const { touch, together } = await touchOf(page);
    const from = center ?? (await tab.middle());
    const at = (i) => ({ x: from.x - 60 + 8 * i, y: from.y + 20 * Math.sin(i / 3) });
    const moves = (place, count) =>
      Array.from({ length: count }, (_, i) => ['touchMove', place(i + 1)]);
    await together(['touchStart', at(0)], ...moves(at, 7), [
      'touchStart',
      at(7),
      { x: from.x, y: from.y + 60 },
    ]);
    await touch('touchMove', { x: at(7).x - 10, y: at(7).y }, { x: from.x, y: from.y + 90 });
    await touch('touchEnd');
    await tab.still();
    assert.equal(await bytesOf(tab), empty, 'a second finger drops the stroke');

    const again = await page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    const there = (i) => ({ x: again.x - 60 + 8 * i, y: again.y + 20 * Math.sin(i / 3) });
    await together(['touchStart', there(0)], ...moves(there, 15), ['touchEnd']);
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length > 0);
    await tab.settled();
    assert.ok((await tab.view()).curve);
    assert.deepEqual(tab.logged, []);
    await phone.close();
  });
});
