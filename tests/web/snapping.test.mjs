// Snapping to points, curves, vertices and edges with a real mouse.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { flatGrid } from './circle_views.mjs';

describe('snapping', () => {
  const browser = browserOfSuite();

  const isOn = (tab) => tab.page.locator('#snap').getAttribute('aria-pressed');
  const mark = (tab) => tab.page.locator('.preview[data-on="snap"]:not([hidden])');
  const seen = (tab, place) => tab.page.evaluate((at) => window.karcherPage.seen(at), place);

  test('moves points to vertices and edges of large triangles, unless Ctrl is held, and is kept', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.drop('flat.obj', flatGrid(4));
    await page.waitForFunction(() => window.karcherPage.triangles === 32);
    await tab.still();
    await page.keyboard.press('p');
    const vertex = await seen(tab, [2, 2, 0]);
    const place = async (x, y) => {
      const { length } = (await tab.state()).figure.points;
      await page.mouse.move(x, y);
      await page.mouse.click(x, y);
      await page.waitForFunction(
        (count) => window.karcherPage.state().figure.points.length > count,
        length,
      );
      return (await tab.state()).figure.points.at(-1);
    };
    const free = await place(vertex.x + 4, vertex.y + 3);
    assert.ok(Math.max(...free.bary) < 0.999, 'the magnet is off at first');
    assert.equal(await isOn(tab), 'false');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('g');
    assert.equal(await isOn(tab), 'true');
    await page.mouse.move(vertex.x + 5, vertex.y + 3);
    await mark(tab).waitFor();
    assert.equal(await mark(tab).getAttribute('data-tag'), 'vertex');
    const shown = await mark(tab).boundingBox();
    const off = [shown.x + shown.width / 2 - vertex.x, shown.y + shown.height / 2 - vertex.y];
    assert.ok(Math.hypot(...off) < 1, `the mark is ${off} from what it marks`);
    const on = await place(vertex.x + 4, vertex.y + 3);
    assert.deepEqual(on.bary.toSorted(), [0, 0, 1]);
    const { positions, triangles } = await tab.mesh();
    const corner = triangles[3 * on.face + on.bary.indexOf(1)];
    assert.deepEqual(positions.slice(3 * corner, 3 * corner + 3), [2, 2, 0]);

    const [from, to] = [await seen(tab, [1, 1, 0]), await seen(tab, [1, 2, 0])];
    const middle = { x: (from.x + to.x) / 2 + 2, y: (from.y + to.y) / 2 + 1 };
    await page.mouse.move(middle.x, middle.y);
    await page.locator('.preview[data-tag="edge"]').waitFor();
    const edge = await place(middle.x, middle.y);
    assert.equal(edge.bary.filter((weight) => weight === 0).length, 1);

    await page.keyboard.down('Control');
    const third = await seen(tab, [3, 2, 0]);
    const freed = await place(third.x + 4, third.y + 3);
    await page.keyboard.up('Control');
    assert.ok(freed.bary.every((weight) => weight > 0 && weight < 1));

    await page.reload();
    await tab.settled();
    assert.equal(await isOn(tab), 'true', 'kept');
    await page.locator('#snap').click();
    assert.equal(await isOn(tab), 'false');
    await tab.close();
  });

  test('moves placed and dragged points to anchors and curves of other objects', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:20000');
    const { page } = tab;
    await page.keyboard.press('p');
    await tab.click([-120, 40], [-30, -80]);
    await page.keyboard.press('Enter');
    const [first] = (await tab.state()).drawing.objects[0].figure.points;
    await tab.click([60, 60]);
    const { x, y } = await tab.middle();
    // The pointer is over the other curve's end, and without the magnet would select it.
    await page.keyboard.press('g');
    await page.mouse.move(x - 118, y + 41);
    await page.locator('.preview[data-tag="anchor"]').waitFor();
    await page.mouse.click(x - 118, y + 41);
    await tab.settled();
    const { figure, drawing } = await tab.state();
    assert.equal(drawing.objects.length, 2);
    assert.equal(figure.points.length, 2);
    assert.deepEqual([figure.points[1].face, figure.points[1].bary], [first.face, first.bary]);

    const handle = await tab.handle('Anchor 1 of 2');
    const on = await tab.onCurve(0.5, 0);
    await page.mouse.move(handle.x, handle.y);
    await page.mouse.down();
    await page.mouse.move(on.x + 3, on.y + 3, { steps: 4 });
    await page.locator('.preview[data-tag="curve"]').waitFor();
    await page.mouse.up();
    await tab.settled();
    const far = await page.evaluate(async () => {
      const { drawing } = window.karcherPage.state();
      const { positions, triangles } = await window.karcherPage.mesh();
      const { face, bary } = drawing.objects[1].figure.points[0];
      const place = [0, 1, 2].map((axis) =>
        bary.reduce(
          (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
          0,
        ),
      );
      const line = window.karcherPage.view().others[0].lines[0];
      let least = Infinity;
      for (let i = 3; i < line.length; i += 3) {
        const [a, b] = [line.slice(i - 3, i), line.slice(i, i + 3)];
        const step = [0, 1, 2].map((axis) => b[axis] - a[axis]);
        const whole = step.reduce((sum, value) => sum + value * value, 0) || 1;
        const along = step.reduce((sum, value, axis) => sum + value * (place[axis] - a[axis]), 0);
        const part = Math.min(1, Math.max(0, along / whole));
        const off = step.map((value, axis) => a[axis] + part * value - place[axis]);
        least = Math.min(least, Math.hypot(...off));
      }
      return least;
    });
    // Lines are drawn in single precision.
    assert.ok(far < 1e-6, `${far} from the curve of a sphere of radius 1`);
    await tab.close();
  });
});
