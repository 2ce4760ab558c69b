// Objects moved as a whole with a mouse: exactly on a plane, and back to the start in one drag.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { flatGrid } from './circle_views.mjs';
import { inLongRun } from './part.mjs';

const places = [
  [-110, 40],
  [-40, -10],
  [40, 50],
  [110, -10],
];

/** The places of surface points. */
const placesOf = (points, { positions, triangles }) =>
  points.map(({ face, bary }) =>
    [0, 1, 2].map((axis) =>
      bary.reduce(
        (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
        0,
      ),
    ),
  );

const bytesOf = async (tab) => JSON.stringify((await tab.state()).drawing);
const far = (p, q) => Math.hypot(...p.map((value, axis) => value - q[axis]));

describe('objects that are moved', () => {
  const browser = browserOfSuite();

  const dragging = (tab, is) =>
    tab.page.waitForFunction((want) => window.karcherPage.state().dragging === want, is);

  test('on a plane keep their shape, as one step', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('flat.obj', flatGrid(16));
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 512);
    await tab.click([-60, 20], [-20, -20], [20, 30], [50, -10]);
    await tab.page.keyboard.press('Escape');
    const whole = await bytesOf(tab);
    const before = placesOf((await tab.state()).figure.points, await tab.mesh());
    const at = await tab.onCurve(0.5);
    await tab.page.mouse.move(at.x, at.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(at.x + 20, at.y - 25, { steps: 4 });
    await dragging(tab, true);
    await tab.page.mouse.up();
    await dragging(tab, false);
    await tab.settled();
    const { figure } = await tab.state();
    const moved = placesOf(figure.points, await tab.mesh());
    const step = moved[0].map((value, axis) => value - before[0][axis]);
    assert.ok(Math.hypot(...step) > 0.3, `${step}`);
    for (const [i, place] of moved.entries()) {
      const expected = before[i].map((value, axis) => value + step[axis]);
      assert.ok(far(place, expected) < 1e-9, `point ${i + 1} is ${far(place, expected)} off`);
    }
    await tab.page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('are unchanged after a drag there and back, and a click moves nothing', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    await page.keyboard.press('7');
    await tab.click([0, 110]);
    await page.keyboard.press('Control+a');
    const whole = await bytesOf(tab);
    const at = await tab.onCurve(0.3);
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + 30, at.y - 20, { steps: 4 });
    await dragging(tab, true);
    await tab.settled();
    const objects = JSON.parse(whole).objects;
    const held = (await tab.state()).drawing.objects;
    for (const [i, { figure }] of held.entries()) {
      assert.notDeepEqual(figure, objects[i].figure, 'all that is selected goes along');
    }
    await page.mouse.move(at.x, at.y, { steps: 4 });
    await page.mouse.up();
    await dragging(tab, false);
    assert.equal(await bytesOf(tab), whole);
    await page.keyboard.press('Control+z');
    assert.equal((await tab.state()).figure.circle, null, 'and it is no step');
    await page.keyboard.press('Control+Shift+z');

    await page.keyboard.press('Escape');
    const other = await tab.onCurve(0.5, 0);
    await page.mouse.click(other.x, other.y);
    await tab.settled();
    assert.equal((await tab.state()).figure.kind, 'bspline', 'a click edits it');
    const own = await tab.onCurve(0.4);
    await page.mouse.click(own.x, own.y);
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length === 5);
    await tab.close();
  });

  inLongRun('stop before one would leave the surface, and say so', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('flat.obj', flatGrid(16));
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 512);
    const { x, y } = await tab.middle();
    await tab.click([-60, 20], [-20, -20], [20, 30], [50, -10]);
    const at = await tab.onCurve(0.5);
    const edge = await tab.page.evaluate(() => window.karcherPage.seen([15.9, 8, 0]));
    assert.ok(edge.x > x && Math.abs(edge.y - y) < 200);
    await tab.drag(at, edge);
    await tab.page.getByText('The move stops where').waitFor();
    await dragging(tab, false);
    const { positions } = await tab.mesh();
    assert.ok(Math.max(...positions) === 16);
    const places = placesOf((await tab.state()).figure.points, await tab.mesh());
    assert.ok(places.every((place) => place[0] <= 16 && place[0] >= 0));
    await tab.close();
  });

  test('move by arrow keys, ten times as far with Shift, each key one step', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    await page.keyboard.press('Enter');
    await tab.settled();
    // The selection belongs to the next step.
    const whole = await bytesOf(tab);
    await page.locator('#objects .object').last().click();
    await tab.settled();
    const first = await tab.handle('Control point 2 of 4');
    await page.locator('#stage').focus();
    const steps = [
      ['ArrowRight', 4, 0],
      ['Shift+ArrowUp', 0, -40],
      ['ArrowLeft', -4, 0],
    ];
    let from = first;
    for (const [key, dx, dy] of steps) {
      const { revision } = await tab.state();
      await page.keyboard.press(key);
      await page.waitForFunction((before) => {
        const state = window.karcherPage.state();
        return state.revision > before && !state.dragging;
      }, revision);
      await tab.settled();
      await tab.still();
      const to = await tab.handle('Control point 2 of 4');
      // The surface is curved: objects elsewhere move nearly as far.
      assert.ok(Math.abs(to.x - from.x - dx) < 4 + 0.2 * Math.abs(dy), `${key}: ${to.x - from.x}`);
      assert.ok(Math.abs(to.y - from.y - dy) < 4 + 0.2 * Math.abs(dy), `${key}: ${to.y - from.y}`);
      from = to;
    }
    assert.ok(Math.abs(from.y - first.y + 40) < 12);
    for (const _ of steps) await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('with Alt held a drag leaves a copy, as one step, and elsewhere turns the view', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click([-60, 10], [-20, -50], [30, 10], [70, -50]);
    await page.keyboard.press('v');
    await tab.settled();
    const before = await tab.state();
    const place = await tab.onCurve(0.5);
    await page.keyboard.down('Alt');
    await page.mouse.move(place.x, place.y, { steps: 2 });
    await page.locator('.stage[data-action="copy"]').waitFor();
    await tab.drag(place, { x: place.x - 20, y: place.y + 60 });
    const { drawing } = await tab.state();
    const [copy, moved] = drawing.objects;
    assert.equal(drawing.objects.length, 2);
    assert.deepEqual(copy.figure, before.figure, 'the copy stays where it was');
    assert.equal(moved.id, before.drawing.active);
    assert.equal(drawing.active, moved.id);
    assert.notDeepEqual(moved.figure, before.figure);
    const middle = await tab.middle();
    const seen = await tab.onCurve(0.5, 0);
    await tab.drag({ x: middle.x, y: middle.y + 190 }, { x: middle.x + 40, y: middle.y + 190 });
    await tab.still();
    const turned = await tab.onCurve(0.5, 0);
    assert.ok(Math.hypot(turned.x - seen.x, turned.y - seen.y) > 5, 'the view has turned');
    assert.equal((await tab.state()).drawing.objects.length, 2);
    await page.keyboard.up('Alt');
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.deepEqual((await tab.state()).drawing, before.drawing);
    await tab.close();
  });
});
