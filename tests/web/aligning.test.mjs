// Objects and points aligned by the context menu, and looks copied by the eyedropper.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';

describe('aligning', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  /** Places of surface points in space. */
  async function positions(tab, points) {
    const mesh = await tab.mesh();
    return points.map(({ face, bary }) =>
      [0, 1, 2].map((axis) =>
        bary.reduce((sum, weight, corner) => {
          const vertex = mesh.triangles[3 * face + corner];
          return sum + weight * mesh.positions[3 * vertex + axis];
        }, 0),
      ),
    );
  }

  const minus = (a, b) => a.map((value, i) => value - b[i]);
  const lengthOf = (v) => Math.hypot(...v);

  /**
   * The distance of a point from the line through two others, and its parameter along that line.
   */
  function onLine(point, from, to) {
    const [way, off] = [minus(to, from), minus(point, from)];
    const part = way.reduce((sum, value, i) => sum + value * off[i], 0) / lengthOf(way) ** 2;
    return { part, off: lengthOf(off.map((value, i) => value - part * way[i])) };
  }

  async function circles(tab, ...places) {
    await tab.page.keyboard.press('o');
    const { x, y } = await tab.middle();
    for (const [dx, dy] of places) {
      await tab.drag({ x: x + dx, y: y + dy }, { x: x + dx + 20, y: y + dy });
      await tab.page.keyboard.press('Enter');
    }
    await tab.page.keyboard.press('v');
    await tab.page.keyboard.press('Control+a');
    await tab.settled();
  }

  async function menu(tab, [dx, dy], name) {
    const { x, y } = await tab.middle();
    await tab.page.mouse.click(x + dx, y + dy, { button: 'right' });
    await tab.page.getByRole('menuitem', { name, exact: true }).click();
  }

  /** Waits until the drawing has changed and the page shows it. */
  async function changed(tab, before) {
    await tab.page.waitForFunction(
      (text) => JSON.stringify(window.karcherPage.state().drawing) !== text,
      JSON.stringify(before),
    );
    await tab.settled();
    return (await tab.state()).drawing;
  }

  const centers = (drawing) => drawing.objects.map(({ figure }) => figure.circle.center);

  test('objects move to the nearest places of the line between the outermost, as one step', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:fair:400');
    await circles(tab, [-180, 100], [-60, -60], [40, 70], [170, -90]);
    const { drawing } = await tab.state();
    const before = await positions(tab, centers(drawing));
    await menu(tab, [20, 70], 'Align on a line');
    const aligned = await changed(tab, drawing);
    const after = await positions(tab, centers(aligned));
    for (const end of [0, 3]) assert.ok(lengthOf(minus(after[end], before[end])) < 1e-9);
    for (const inner of [1, 2]) {
      const [was, is] = [before, after].map((all) => onLine(all[inner], all[0], all[3]));
      assert.ok(was.off > 0.05 && is.off < 1e-5, `${was.off} ${is.off}`);
      assert.ok(Math.abs(is.part - was.part) < 1e-3, `${is.part} beside ${was.part}`);
    }
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    const back = (await tab.state()).drawing;
    assert.deepEqual(centers({ objects: back.objects.slice(0, 4) }), centers(drawing));
    await tab.page.keyboard.press('Control+a');
    await tab.settled();
    const again = (await tab.state()).drawing;
    await menu(tab, [20, 70], 'Space evenly on a line');
    const spaced = await positions(tab, centers(await changed(tab, again)));
    for (const [inner, part] of [
      [1, 1 / 3],
      [2, 2 / 3],
    ]) {
      const is = onLine(spaced[inner], spaced[0], spaced[3]);
      assert.ok(is.off < 1e-5 && Math.abs(is.part - part) < 1e-5, `${is.off} ${is.part}`);
    }
    await tab.close();
  });

  test('two objects cannot be aligned', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:fair:400');
    await circles(tab, [-150, 90], [120, -80]);
    const { x, y } = await tab.middle();
    await tab.page.mouse.click(x + 140, y - 80, { button: 'right' });
    assert.equal(await tab.page.getByRole('menuitem', { name: 'Align on a line' }).count(), 0);
    await tab.page.keyboard.press('Escape');
    await tab.close();
  });

  test('points of a curve are aligned', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:fair:400&kind=polyline');
    await tab.click([-170, 60], [-60, -70], [50, 60], [160, -40]);
    await tab.page.keyboard.press('v');
    // The user has selected the last point already.
    for (const index of [1, 2, 3]) {
      const { x, y } = await tab.handle(`Control point ${index} of 4`);
      await tab.page.keyboard.down('Shift');
      await tab.page.mouse.click(x, y);
      await tab.page.keyboard.up('Shift');
    }
    const { drawing, more } = await tab.state();
    assert.equal(more.length, 3);
    await menu(tab, [-60, -70], 'Align on a line');
    const [object] = (await changed(tab, drawing)).objects;
    const all = await positions(tab, object.figure.points);
    for (const inner of [1, 2]) assert.ok(onLine(all[inner], all[0], all[3]).off < 1e-5);
    assert.equal((await tab.state()).more.length, 3, 'they stay selected');
    await tab.close();
  });

  test('anchors of the pen lie on the line themselves, whatever their handles', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:fair:400&kind=pen');
    const { x, y } = await tab.middle();
    for (const [dx, dy, right, down] of [
      [-170, 60, 40, 30],
      [-60, -70, 50, -20],
      [50, 60, 20, 50],
      [160, -40, 30, -40],
    ]) {
      await tab.drag({ x: x + dx, y: y + dy }, { x: x + dx + right, y: y + dy + down });
    }
    await tab.page.keyboard.press('v');
    for (const index of [1, 2, 3]) {
      const place = await tab.handle(`Anchor ${index} of 4`);
      await tab.page.keyboard.down('Shift');
      await tab.page.mouse.click(place.x, place.y);
      await tab.page.keyboard.up('Shift');
    }
    const { drawing, more } = await tab.state();
    assert.equal(more.length, 3);
    await menu(tab, [-60, -70], 'Align on a line');
    const [object] = (await changed(tab, drawing)).objects;
    const all = await positions(tab, object.figure.points);
    const was = await positions(tab, drawing.objects[0].figure.points);
    for (const end of [0, 3]) assert.ok(lengthOf(minus(all[end], was[end])) < 1e-9);
    for (const inner of [1, 2]) {
      const { off } = onLine(all[inner], all[0], all[3]);
      assert.ok(off < 1e-5, `${off}`);
    }
    await tab.close();
  });

  test('a click with the eyedropper gives all selected objects the look of another one', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:fair:400');
    await circles(tab, [-150, 90], [0, 0], [150, -80]);
    const { x, y } = await tab.middle();
    await tab.page.keyboard.press('Escape');
    await tab.page.mouse.click(x - 130, y + 90);
    await tab.page.locator('#swatches button').nth(2).click();
    await tab.page.locator('#width').fill('9');
    await tab.page.keyboard.press('Enter');
    await tab.page.locator('#dash').selectOption('dashed');
    await tab.page.locator('#opacity').fill('60');
    await tab.page.keyboard.press('Enter');
    await tab.page.locator('#opacity').blur();
    await tab.page.mouse.click(x + 20, y);
    await tab.page.keyboard.down('Shift');
    await tab.page.mouse.click(x + 170, y - 80);
    await tab.page.keyboard.up('Shift');
    await tab.page.locator('#look').click();
    await tab.page.mouse.move(x - 130, y + 89);
    await tab.page.waitForFunction(
      () => document.querySelector('#stage').dataset.action === 'look',
    );
    await tab.page.mouse.click(x - 130, y + 90);
    await tab.settled();
    const { drawing, chosen, tool } = await tab.state();
    for (const { color, width, dash, opacity } of drawing.objects) {
      assert.deepEqual([color, width, dash, opacity], ['#c81e5b', 9, 'dashed', 0.6]);
    }
    assert.deepEqual([chosen.length, tool], [2, 'select'], 'the same ones are selected');
    // The key starts the tool, and Escape ends it.
    await tab.page.keyboard.press('l');
    assert.equal((await tab.state()).tool, 'look');
    await tab.page.keyboard.press('Escape');
    assert.equal((await tab.state()).tool, 'select');
    await tab.close();
  });
});
