// A pointer or key that holds something while another action happens releases it, and the next drag
// works normally.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun, part } from './part.mjs';

/** Two rectangles side by side, each 4 wide and 6 high, with a gap between them. */
const rectangle = (x) => `v ${x} 0 0\nv ${x + 4} 0 0\nv ${x + 4} 6 0\nv ${x} 6 0\n`;
const twoParts = `${rectangle(0)}${rectangle(5)}f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n`;

describe('what is held', () => {
  const browser = browserOfSuite();

  const at = async (tab, [dx, dy]) => {
    const { x, y } = await tab.middle();
    return { x: x + dx, y: y + dy };
  };
  const problem = (tab, is) =>
    tab.page.waitForFunction((want) => Boolean(window.karcherPage.view().problem) === want, is);
  const moveTo = async (tab, offsets) => {
    const { x, y } = await at(tab, offsets);
    await tab.page.mouse.move(x, y, { steps: 4 });
  };

  let files = 0;

  /** A corner and a selected smooth anchor on the left part. */
  async function drawn() {
    const tab = await Tab.open(browser);
    // Each test has a file of its own: the browser restores drawings by the files' content.
    await tab.drop('two.obj', `# ${++files}\n${twoParts}`);
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 4);
    await tab.page.keyboard.press('p');
    await tab.click([-60, 90]);
    await tab.drag(await at(tab, [-110, 0]), await at(tab, [-110, -50]));
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 2);
    return tab;
  }

  test('a handle of the pen that no path reaches says so, stays under the pointer, and comes back', async () => {
    const tab = await drawn();
    const { x, y } = await tab.handle('Handle after anchor 2');
    await tab.page.mouse.move(x, y);
    await tab.page.mouse.down();
    await moveTo(tab, [100, -20]);
    await problem(tab, true);
    assert.match((await tab.view()).problem, /^no path leads from anchor 2 to the handle after it/);
    await moveTo(tab, [-100, -60]);
    await problem(tab, false);
    await tab.page.mouse.up();
    await tab.settled();
    const { curve } = await tab.view();
    assert.ok(curve.samples.count > 0);
    const before = JSON.stringify((await tab.state()).drawing);
    await tab.dragHandle('Handle after anchor 2', 20, 30);
    await tab.settled();
    assert.notEqual(JSON.stringify((await tab.state()).drawing), before);
    await tab.close();
  });

  inLongRun(
    'a press of the pen that begins an object, and is taken back, leaves nothing of it',
    async () => {
      const tab = await Tab.open(browser);
      await tab.page.keyboard.press('p');
      await tab.click([-80, 40], [0, -40], [80, 40]);
      await tab.page.keyboard.press('Control+z');
      const whole = await tab.state();
      await tab.page.evaluate(() => document.activeElement.blur());
      for (let step = 0; step < 2; step++) await tab.page.keyboard.press('Escape');
      await tab.page.keyboard.press('p');
      const before = await tab.state();
      assert.equal(before.figure.points.length, 2);
      const { x, y } = await at(tab, [20, 90]);
      await tab.page.mouse.move(x, y);
      await tab.page.mouse.down();
      await tab.page.mouse.move(x + 30, y, { steps: 4 });
      await tab.page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
      await tab.page.keyboard.press('Escape');
      await tab.page.mouse.up();
      const after = await tab.state();
      assert.deepEqual(after.drawing, whole.drawing);
      assert.deepEqual([after.selection, after.chosen], [before.selection, before.chosen]);
      await tab.page.keyboard.press('Control+Shift+z');
      assert.equal(
        (await tab.state()).figure.points.length,
        3,
        'what was undone can be done again',
      );
      // A continued curve and its first anchor are one step.
      for (let step = 0; step < 2; step++) await tab.page.keyboard.press('Escape');
      await tab.page.keyboard.press('p');
      await tab.drag({ x, y }, { x: x + 30, y });
      await tab.settled();
      assert.equal((await tab.state()).drawing.objects.length, 2);
      await tab.page.keyboard.press('Control+z');
      assert.equal((await tab.state()).drawing.objects.length, 1);
      await tab.close();
    },
  );

  inLongRun(
    'a nudge whose key is let go elsewhere takes no later edit back, and later ones move',
    async () => {
      const tab = await Tab.open(browser);
      const { page } = tab;
      await tab.click([-110, 40], [-40, -10], [40, 50], [110, -10]);
      await page.keyboard.press('Control+a');
      const focus = () => page.evaluate(() => document.getElementById('stage').focus());
      const points = async () => JSON.stringify((await tab.state()).figure.points);
      const moves = async (from) => {
        await page.waitForFunction(
          (before) => JSON.stringify(window.karcherPage.state().figure.points) !== before,
          from,
        );
      };
      const still = (is) =>
        page.waitForFunction((want) => window.karcherPage.state().dragging === want, is);
      const start = await points();
      await focus();
      await page.keyboard.down('ArrowRight');
      await moves(start);
      await page.evaluate(() => document.activeElement.blur());
      await still(false);
      await page.keyboard.up('ArrowRight');
      const nudged = await points();
      const undone = async () => {
        await page.keyboard.press('Control+z');
        return points();
      };
      assert.equal(await undone(), start, 'it is one step');
      await page.keyboard.press('Control+Shift+z');
      // The key stays down during another action.
      await focus();
      await page.keyboard.down('ArrowRight');
      await moves(nudged);
      await page.keyboard.press('Control+z');
      await still(false);
      await page.keyboard.press('2');
      assert.equal((await tab.state()).figure.kind, 'bezier');
      await page.keyboard.up('ArrowRight');
      await page.keyboard.press('Control+a');
      const bent = await points();
      await focus();
      await page.keyboard.press('ArrowUp');
      await moves(bent);
      await still(false);
      assert.equal((await tab.state()).figure.kind, 'bezier');
      // The other action deletes the nudged object.
      await focus();
      await page.keyboard.down('ArrowUp');
      await still(true);
      await page.keyboard.press('Delete');
      await page.keyboard.up('ArrowUp');
      await page.keyboard.press('1');
      await tab.click([-110, 40], [-40, -10], [40, 50], [110, -10]);
      await page.keyboard.press('Control+a');
      const drawn = await points();
      await focus();
      await page.keyboard.press('ArrowLeft');
      await moves(drawn);
      await tab.close();
    },
  );

  inLongRun('a handle’s nudge whose key is released elsewhere stays, as one step', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click([-110, 40], [-40, -10], [40, 50], [110, -10]);
    const points = async () => JSON.stringify((await tab.state()).figure.points);
    const start = await points();
    await page.getByRole('button', { name: 'Control point 2 of 4' }).focus();
    await page.keyboard.down('ArrowRight');
    await page.waitForFunction(() => window.karcherPage.state().dragging);
    await page.evaluate(() => document.activeElement.blur());
    await page.waitForFunction(() => !window.karcherPage.state().dragging);
    const nudged = await points();
    assert.notEqual(nudged, start);
    await page.keyboard.up('ArrowRight');
    // The next step does not undo the nudge.
    await page.keyboard.press('c');
    assert.equal(await points(), nudged);
    await page.keyboard.press('Control+z');
    assert.equal(await points(), nudged);
    await page.keyboard.press('Control+z');
    assert.equal(await points(), start);
    await tab.close();
  });

  test('Escape ends the drag of a handle, and Tab leads from an anchor to its handles', async () => {
    const tab = await drawn();
    const before = JSON.stringify((await tab.state()).figure);
    const { x, y } = await tab.handle('Anchor 2 of');
    await tab.page.mouse.move(x, y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(x + 20, y + 30, { steps: 4 });
    await tab.page.waitForFunction(() => window.karcherPage.state().dragging);
    await tab.page.keyboard.press('Escape');
    await tab.page.mouse.move(x + 40, y + 50, { steps: 4 });
    await tab.settled();
    assert.equal((await tab.state()).dragging, false);
    await tab.page.mouse.up();
    assert.equal(JSON.stringify((await tab.state()).figure), before);
    await tab.page.getByRole('button', { name: 'Anchor 1 of 2' }).focus();
    const labels = [];
    for (let step = 0; step < 3; step++) {
      labels.push(await tab.page.evaluate(() => document.activeElement.ariaLabel));
      await tab.page.keyboard.press('Tab');
    }
    assert.deepEqual(labels.slice(0, 2), ['Anchor 1 of 2', 'Anchor 2 of 2']);
    assert.match(labels[2], /^Handle (before|after) anchor 2$/);
    await tab.close();
  });

  test('a typed name is for its object, and its undo belongs to the field', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click([-110, 40], [-40, -10], [40, 50], [110, -10]);
    await page.keyboard.press('Enter');
    // The choice of another object would remove an unfinished curve.
    await tab.click([-80, 90], [-40, 110], [0, 100], [40, 110], [80, 90]);
    const name = page.locator('#object-name');
    await name.focus();
    await page.keyboard.type('Seam');
    await page.keyboard.press('Control+z');
    assert.equal((await tab.state()).figure.points.length, 5, 'the drawing is as it was');
    await name.fill('Seam');
    const named = () => tab.state().then(({ drawing }) => drawing.objects.map((one) => one.name));
    // The press begins another object, before the field loses the focus.
    await page.evaluate(() => {
      const [other] = [...document.querySelectorAll('#objects .object')].slice(-1);
      other.click();
    });
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length === 4);
    await page.evaluate(() => document.activeElement.blur());
    await page.waitForFunction(() =>
      window.karcherPage.state().drawing.objects.some((one) => one.name === 'Seam'),
    );
    assert.deepEqual(await named(), ['', 'Seam']);
    const rows = page.locator('#objects [aria-current]');
    assert.deepEqual(await rows.evaluateAll((all) => all.map((one) => one.ariaCurrent)), ['true']);
    await tab.close();
  });

  inLongRun('a handle is released when its anchor is removed', async () => {
    const tab = await drawn();
    const { x, y } = await tab.handle('Handle after anchor 2');
    await tab.page.mouse.move(x, y);
    await tab.page.mouse.down();
    await moveTo(tab, [-100, -60]);
    await tab.page.keyboard.press('Delete');
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.points.length === 1);
    await moveTo(tab, [-80, -40]);
    await tab.page.mouse.up();
    await tab.settled();
    const { figure, dragging } = await tab.state();
    assert.deepEqual([figure.points.length, dragging], [1, false]);
    await tab.dragHandle('Anchor 1', -20, -30);
    await tab.settled();
    assert.notDeepEqual((await tab.state()).figure.points[0], figure.points[0]);
    await tab.close();
  });

  const places = [
    [-110, 40],
    [-40, -10],
    [40, 50],
    [110, -10],
  ];
  const drawingOf = async (tab) => JSON.stringify((await tab.state()).drawing);

  for (const key of part(['Delete', 'Control+x', 'Control+d', '7', 'n'], 2)) {
    test(`${key} during the drag of a line ends the drag, and undo finds the place before it`, async () => {
      const tab = await Tab.open(browser);
      await tab.click(...places);
      await tab.page.keyboard.press('v');
      const { x, y } = await tab.onCurve(0.4);
      await tab.page.mouse.click(x, y);
      await tab.settled();
      const before = await drawingOf(tab);
      await tab.page.mouse.move(x, y);
      await tab.page.mouse.down();
      await tab.page.mouse.move(x + 30, y + 10, { steps: 4 });
      await tab.page.waitForFunction(() => window.karcherPage.state().dragging);
      await tab.page.keyboard.press(key);
      await tab.page.mouse.move(x + 50, y, { steps: 4 });
      await tab.page.mouse.up();
      await tab.settled();
      const after = await tab.state();
      assert.equal(after.dragging, false);
      const kept = after.drawing.objects.filter(({ figure }) => figure.points.length > 0);
      const gone = key === 'Delete' || key === 'Control+x';
      assert.equal(kept.length, gone ? 0 : key === 'Control+d' ? 2 : 1);
      await tab.page.keyboard.press('Control+z');
      await tab.settled();
      assert.equal(await drawingOf(tab), before);
      await tab.page.keyboard.press('Control+y');
      await tab.settled();
      assert.equal(await drawingOf(tab), JSON.stringify(after.drawing));
      await tab.close();
    });
  }

  test('Delete while a control point is dragged, and right after a drag of a line', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const before = await drawingOf(tab);
    const from = await tab.handle('Control point 2');
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(from.x + 20, from.y + 20, { steps: 3 });
    await tab.page.waitForFunction(() => window.karcherPage.state().dragging);
    await tab.page.keyboard.press('Delete');
    await tab.page.mouse.move(from.x + 40, from.y, { steps: 3 });
    await tab.page.mouse.up();
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 3);
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(await drawingOf(tab), before);
    // After the release, its last step may be under way.
    await tab.page.keyboard.press('v');
    const { x, y } = await tab.onCurve(0.6);
    await tab.page.mouse.click(x, y);
    await tab.page.mouse.move(x, y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(x + 30, y + 10, { steps: 4 });
    await tab.page.mouse.up();
    await tab.page.keyboard.press('Escape');
    await tab.page.keyboard.press('Control+a');
    await tab.page.keyboard.press('Delete');
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 0);
    await tab.close();
  });
});
