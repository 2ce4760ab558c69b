import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { farthestFromSurface, middles } from './on_surface.mjs';
import { inLongRun, part } from './part.mjs';

/** Four places that lie on every surface used here, as offsets from the stage's middle. */
const places = [
  [-110, 40],
  [-40, -10],
  [40, 50],
  [110, -10],
];
/** The tolerance for places as floats, on a surface of about unit size. */
const onSurface = 2e-6;

describe('editing a curve', () => {
  const browser = browserOfSuite();

  for (const mesh of part(['sphere:1500', 'bunny:0'], 1)) {
    test(`clicks make a curve on ${mesh}, and a drag changes it there`, async () => {
      const tab = await Tab.open(browser, `mesh=${mesh}`);
      const hint = tab.page.locator('#hint');
      assert.equal(await hint.textContent(), 'Click the surface to place a control point');

      await tab.click(...places.slice(0, 3));
      const polygon = await tab.view();
      assert.equal(polygon.curve, null);
      assert.equal(polygon.polygonOnly, true);
      assert.equal(polygon.legs.length, 2, 'two geodesics join three points');
      assert.equal(await hint.textContent(), '1 more point makes a curve');

      await tab.click(places[3]);
      const first = await tab.view();
      assert.equal(first.curve.samples.count, 128, 'one segment');
      assert.equal(first.legs.length, 3);
      assert.equal(await hint.isVisible(), false);

      await tab.dragHandle('Control point 2 of 4', 25, -20);
      const moved = await tab.view();
      assert.notDeepEqual(moved.polyline, first.polyline);
      assert.equal((await tab.state()).figure.points.length, 4, 'a drag adds no point');

      const surface = await tab.mesh();
      const tolerance = onSurface * surface.info.diagonal;
      for (const { polyline, legs } of [polygon, first, moved]) {
        for (const line of [polyline ?? [], ...legs]) {
          assert.ok(farthestFromSurface(line, surface) <= tolerance);
          assert.ok(farthestFromSurface(middles(line), surface) <= tolerance);
        }
      }
      assert.match(await tab.page.locator('#status').textContent(), /triangles.*128 samples.*ms/s);
      await tab.close();
    });
  }

  test('every edit can be undone and redone', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    await tab.dragHandle('Control point 4 of 4', 10, 30);
    await tab.choose('bezier');
    await tab.page.getByRole('button', { name: 'Control point 1 of 4' }).focus();
    await tab.page.keyboard.press('Delete');
    await tab.settled();
    const end = (await tab.state()).figure;
    assert.equal(end.points.length, 3);
    assert.equal(end.kind, 'bezier');

    const documents = [end];
    while (await tab.page.locator('#undo').isEnabled()) {
      await tab.page.keyboard.press('Control+z');
      documents.push((await tab.state()).figure);
    }
    const counts = documents.map(({ points }) => points.length);
    assert.deepEqual(counts, [3, 4, 4, 4, 3, 2, 1, 0], 'delete, kind, drag, four clicks');
    assert.deepEqual(documents[3].points.slice(0, 3), documents[1].points.slice(0, 3));
    assert.notDeepEqual(documents[3].points[3], documents[1].points[3]);

    for (const document of documents.slice(0, -1).reverse()) {
      await tab.page.keyboard.press('Control+Shift+z');
      assert.deepEqual((await tab.state()).figure, document);
    }
    const again = await tab.view();
    assert.equal(again.curve.samples.count, 128);
    await tab.close();
  });

  test('a curve after edits equals a new curve of its points', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places, [60, 90]);
    await tab.dragHandle('Control point 3 of 5', -15, 20);
    await tab.page.keyboard.press('Delete');
    await tab.click([20, 100]);
    const edited = await tab.view();
    await tab.page.reload();
    const anew = await tab.view();
    assert.equal(anew.polyline.length, edited.polyline.length);
    const farthest = Math.max(...anew.polyline.map((x, i) => Math.abs(x - edited.polyline[i])));
    assert.ok(farthest <= 1e-6 * (await tab.mesh()).info.diagonal, `${farthest}`);
    await tab.close();
  });

  inLongRun('buttons and keys move points in their order, and back', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=rational');
    const { page } = tab;
    await tab.click(...places);
    const { points } = (await tab.state()).figure;
    const before = await tab.view();
    await page.getByRole('button', { name: 'Move point 1 down in order' }).click();
    const faces = async () => (await tab.state()).figure.points.map(({ face }) => face);
    const [a, b, c, d] = points.map(({ face }) => face);
    assert.deepEqual(await faces(), [b, a, c, d]);
    assert.equal((await tab.state()).selection, 1);
    await page.keyboard.press('Enter');
    assert.deepEqual(await faces(), [b, c, a, d], 'the keys stay with the point');
    await page.keyboard.press('Alt+ArrowDown');
    await page.keyboard.press('Alt+ArrowDown');
    assert.deepEqual(await faces(), [b, c, d, a], 'the last one stays the last');
    assert.notDeepEqual((await tab.view()).polyline, before.polyline);
    await page.getByRole('button', { name: 'Control point 4 of 4' }).focus();
    await page.keyboard.press('Alt+ArrowUp');
    assert.deepEqual(await faces(), [b, c, a, d], 'and from a handle');
    for (let step = 0; step < 4; step++) await page.keyboard.press('Control+z');
    assert.deepEqual((await tab.state()).figure.points, points);
    assert.deepEqual((await tab.view()).polyline, before.polyline);
    await tab.close();
  });

  test('a drag of empty space or of the surface turns the view and edits nothing', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { figure: document } = await tab.state();
    const handle = await tab.handle('Control point 1 of 4');
    const { x, y } = await tab.middle();
    await tab.drag({ x, y: y + 60 }, { x: x + 50, y: y + 60 });
    await tab.drag({ x: x - 300, y: y - 250 }, { x: x - 300, y: y - 200 });
    assert.deepEqual((await tab.state()).figure, document);
    const turned = await tab.handle('Control point 1 of 4');
    assert.ok(Math.hypot(turned.x - handle.x, turned.y - handle.y) > 5);

    await tab.page.keyboard.press('r');
    await tab.still();
    const reset = await tab.handle('Control point 1 of 4');
    assert.ok(Math.hypot(reset.x - handle.x, reset.y - handle.y) < 0.5);
    await tab.page.close();
  });

  test('hovering shows where a click places a point', async () => {
    const tab = await Tab.open(browser);
    const { x, y } = await tab.middle();
    await tab.page.mouse.move(x + 30, y - 20);
    const mark = tab.page.locator('.preview');
    await mark.waitFor();
    const box = await mark.boundingBox();
    assert.ok(Math.hypot(box.x + 7 - x - 30, box.y + 7 - y + 20) < 1);
    await tab.page.mouse.move(x - 300, y - 300);
    await mark.waitFor({ state: 'hidden' });
    assert.equal((await tab.state()).figure.points.length, 0);
    await tab.page.close();
  });

  inLongRun('keys alone place, move and remove points', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await page.locator('#stage').focus();
    for (const key of ['Enter', 'ArrowLeft', 'ArrowLeft', 'Enter']) await page.keyboard.press(key);
    await page.keyboard.press('Tab');
    assert.equal((await tab.state()).selection, 0);
    const before = (await tab.state()).figure.points;
    assert.equal(before.length, 2);
    await page.keyboard.press('Shift+ArrowDown');
    const moved = (await tab.state()).figure.points;
    assert.notDeepEqual(moved[0], before[0]);
    assert.deepEqual(moved[1], before[1]);
    await page.keyboard.press('Backspace');
    assert.equal((await tab.state()).figure.points.length, 1);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    assert.deepEqual((await tab.state()).figure.points, before);
    await tab.close();
  });

  inLongRun('another method prepares, can be cancelled, and traces another curve', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0');
    await tab.click(...places);
    const usual = await tab.view();
    const method = tab.page.locator('#method');
    await tab.page.evaluate(() => {
      const menu = document.getElementById('method');
      menu.value = 'paper-graph';
      menu.dispatchEvent(new Event('change'));
      document.getElementById('cancel').click();
    });
    await tab.page.waitForFunction(() => document.getElementById('method').value === 'karcher');
    assert.equal((await tab.state()).method, 'karcher');

    await method.selectOption('paper-graph');
    await tab.page.waitForFunction(() => window.karcherPage.state().method === 'paper-graph');
    const graph = await tab.view();
    assert.equal(graph.curve.samples.count, 128);
    assert.notDeepEqual(graph.polyline, usual.polyline);
    await method.selectOption('karcher');
    await tab.page.waitForFunction(() => window.karcherPage.state().method === 'karcher');
    assert.deepEqual((await tab.view()).polyline, usual.polyline);
    await tab.close();
  });

  test("a circle's radius and center are dragged on the surface", async () => {
    const tab = await Tab.open(browser);
    await tab.page.keyboard.press('7');
    assert.equal(
      await tab.page.locator('#hint').textContent(),
      'Click the surface to place the center',
    );
    await tab.click([0, 0]);
    const first = await tab.view();
    assert.ok(first.curve, 'one click makes a circle');
    const surface = await tab.mesh();
    const tolerance = onSurface * surface.info.diagonal;
    assert.ok(farthestFromSurface(first.polyline, surface) <= tolerance);

    await tab.dragHandle('Radius of the circle', 40, 0);
    const wider = await tab.view();
    assert.ok(wider.circle.radius > 1.2 * first.circle.radius);
    assert.ok(wider.curve.length > 1.2 * first.curve.length);

    await tab.dragHandle('Center of the circle', -30, -20);
    const moved = await tab.view();
    const { radius } = wider.circle;
    assert.ok(Math.abs(moved.circle.radius - radius) <= 1e-9 * radius, 'the radius goes along');
    assert.notDeepEqual(moved.polyline, wider.polyline);
    assert.ok(farthestFromSurface(moved.polyline, surface) <= tolerance);

    await tab.page.keyboard.press('Delete');
    assert.equal((await tab.view()).curve, null);
    await tab.page.keyboard.press('Control+z');
    assert.deepEqual((await tab.view()).polyline, moved.polyline);
    await tab.close();
  });

  inLongRun('a circle wider than the surface gives a sentence, and can be undone', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=circle&circle=0,0.3,0.3;9,1,0,0');
    const { problem, curve, legs } = await tab.view();
    assert.equal(curve, null);
    assert.deepEqual(legs, [], 'its radius may go around any number of times');
    assert.ok(problem);
    const hint = await tab.page.locator('#hint').textContent();
    assert.match(hint, /^[A-Z].*\.$/);
    await tab.page.getByRole('button', { name: 'Radius of the circle' }).waitFor();
    await tab.page.keyboard.press('1');
    await tab.click(...places);
    assert.ok((await tab.view()).curve, 'other curves are not in the way of it');
    await tab.close();
  });

  test('a failure names points without numbers, since the engine counts them differently', async () => {
    const tab = await Tab.open(browser);
    const corners = [0, 5].map((x) => `v ${x} 0 0\nv ${x + 1} 0 0\nv ${x} 1 0\nv ${x} 0 1\n`);
    const faces = [0, 4].map((k) =>
      [`132`, `124`, `234`, `143`].map(
        (face) => `f ${[...face].map((corner) => Number(corner) + k).join(' ')}\n`,
      ),
    );
    await tab.drop('two.obj', [...corners, ...faces.flat()].join(''));
    await tab.page.waitForFunction(() => window.karcherPage.info().components === 2);
    const { mesh } = await tab.state();
    const hint = tab.page.locator('#hint');
    const hintOf = async (fragment, text) => {
      await tab.page.evaluate((hash) => {
        location.hash = hash;
      }, fragment);
      await tab.page.getByText(text).first().waitFor();
      await tab.settled();
      assert.doesNotMatch(await hint.textContent(), /\d/);
    };
    const places = 'points=0,0.3,0.3;1,0.3,0.3;4,0.3,0.3';
    for (const kind of ['polyline', 'center']) {
      await hintOf(`mesh=${mesh}&kind=${kind}&${places}`, 'on different components of the surface');
      assert.match(await hint.textContent(), /^The points lie on different components/);
    }
    await hintOf(
      'mesh=openSheet:5000&kind=circle&circle=0,0.3,0.3;0.5,1,0,0',
      'meets the surface’s boundary',
    );
    await tab.close();
  });
});
