import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';

/** A point on the upper side of the torus, around its axis. */
const onRing = (angle) => [Math.cos(angle), Math.sin(angle), 0.4];

describe('legs of the control polygon', () => {
  const browser = browserOfSuite();

  const seen = (tab, angle) =>
    tab.page.evaluate((place) => window.karcherPage.seen(place), onRing(angle));

  /** A polyline of two points after a drag of the second one nearly all around the ring. */
  async function drawnAround() {
    const tab = await Tab.open(browser, 'mesh=torus:2000&kind=polyline');
    for (const angle of [0.2, 0.8]) {
      const { x, y } = await seen(tab, angle);
      await tab.page.mouse.click(x, y);
    }
    await tab.settled();
    const handle = await tab.handle('Control point 2 of 2');
    await tab.page.mouse.move(handle.x, handle.y);
    await tab.page.mouse.down();
    for (let angle = 0.9; angle < 5.6; angle += 0.1) {
      const place = await seen(tab, angle);
      assert.ok(place, `the ring is seen at ${angle}`);
      await tab.page.mouse.move(place.x, place.y);
      await tab.settled();
    }
    await tab.page.mouse.up();
    await tab.settled();
    return tab;
  }

  test('stay as drawn; a shorter path is shown, and a click takes it', async () => {
    const tab = await drawnAround();
    const drawn = await tab.view();
    const { figure: document } = await tab.state();
    assert.ok(document.points[0].leg.length >= 1);
    assert.ok(drawn.curve.length > 3, `${drawn.curve.length} long`);
    assert.equal(drawn.shorter.length, 1);
    assert.match(await tab.page.locator('#hint').textContent(), /point 1 is [\d,]+ % longer/);

    await tab.pastSaving();
    await tab.page.reload();
    await tab.settled();
    const again = await tab.view();
    assert.deepEqual((await tab.state()).figure, document);
    assert.deepEqual(again.polyline, drawn.polyline);
    assert.equal(again.shorter.length, 1);

    await tab.page.getByRole('button', { name: 'Shorten' }).click();
    const short = await tab.view();
    assert.ok(short.curve.length < 2, `${short.curve.length} long`);
    assert.deepEqual(short.shorter, []);
    assert.equal(await tab.page.getByRole('button', { name: 'Shorten' }).isVisible(), false);

    await tab.page.keyboard.press('Control+z');
    assert.deepEqual((await tab.view()).polyline, drawn.polyline);
    assert.deepEqual((await tab.state()).figure, document);

    // A click on the shorter path itself.
    const place = await tab.page.evaluate(() => {
      const [{ polyline }] = window.karcherPage.view().shorter;
      const middle = 3 * Math.floor(polyline.length / 6);
      return window.karcherPage.seen(polyline.subarray(middle, middle + 3));
    });
    await tab.page.mouse.click(place.x, place.y);
    assert.deepEqual((await tab.view()).polyline, short.polyline);
    await tab.close();
  });

  test('of a drag are one step of the history with it', async () => {
    const tab = await drawnAround();
    const { figure: document } = await tab.state();
    await tab.page.keyboard.press('Control+z');
    const before = (await tab.state()).figure;
    assert.equal(before.points.length, 2);
    assert.ok(before.points.every(({ leg }) => leg === undefined));
    await tab.page.keyboard.press('Control+Shift+z');
    assert.deepEqual((await tab.state()).figure, document);
    // When Escape moves a point back, it has its leg again.
    const handle = await tab.handle('Control point 2 of 2');
    await tab.page.mouse.move(handle.x, handle.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(handle.x + 12, handle.y + 12, { steps: 3 });
    await tab.page.waitForFunction(
      () => window.karcherPage.state().figure.points[0].leg === undefined,
    );
    await tab.page.keyboard.press('Escape');
    await tab.page.mouse.up();
    await tab.settled();
    assert.deepEqual((await tab.state()).figure, document);
    await tab.page.close();
  });
});
