// The pen: anchors and handles drawn and edited with a mouse, a finger and keys.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, openPhone, Tab, touchOf } from './browser.mjs';
import { inLongRun } from './part.mjs';

const penOf = async (tab) => (await tab.state()).figure;
const bytesOf = async (tab) => JSON.stringify((await tab.state()).drawing);
const dot = (a, b) => a.reduce((sum, value, axis) => sum + value * b[axis], 0);

describe('the pen', () => {
  const browser = browserOfSuite();

  /** A place of the stage by its offset from the middle. */
  async function placeOf(tab, [dx, dy]) {
    const { x, y } = await tab.middle();
    return { x: x + dx, y: y + dy };
  }

  /** Presses at one place, drags to another, and releases. */
  async function pull(tab, from, to) {
    await tab.drag(await placeOf(tab, from), await placeOf(tab, to));
  }

  /** Draws a corner, a smooth anchor, and a corner. */
  async function drawn(mesh = 'sphere:1500') {
    const tab = await Tab.open(browser, `mesh=${mesh}`);
    await tab.page.keyboard.press('p');
    await tab.click([-100, 40]);
    await pull(tab, [0, -40], [60, -50]);
    await tab.click([100, 50]);
    return tab;
  }

  test('places corners by clicks and smooth anchors by drags, each as one step', async () => {
    const tab = await Tab.open(browser);
    await tab.page.keyboard.press('p');
    assert.match(await tab.page.locator('#hint').textContent(), /^Click to place a corner/);
    const states = [await bytesOf(tab)];
    const eye = await tab.page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    await tab.click([-100, 40]);
    states.push(await bytesOf(tab));
    await pull(tab, [0, -40], [60, -50]);
    states.push(await bytesOf(tab));
    await tab.click([100, 50]);
    states.push(await bytesOf(tab));
    const { kind, points } = await penOf(tab);
    assert.equal(kind, 'pen');
    assert.deepEqual(
      points.map(({ tangents }) => tangents !== undefined),
      [false, true, false],
    );
    assert.deepEqual(points[1].tangents.before, { length: null }, 'opposite, and as long');
    const { curve, tangents, problem } = await tab.view();
    assert.equal(problem, null);
    assert.equal(new Set(Object.values(curve.samples.segment)).size, 2);
    const { before, after } = tangents[1];
    assert.ok(dot(before.direction, after.direction) < -1 + 1e-9);
    assert.ok(Math.abs(before.length - after.length) < 1e-9);
    const now = await tab.page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    assert.deepEqual(now, eye, 'the view has not turned');
    for (const state of states.toReversed().slice(1)) {
      await tab.page.keyboard.press('Control+z');
      assert.equal(await bytesOf(tab), state);
    }
    for (const state of states.slice(1)) {
      await tab.page.keyboard.press('Control+Shift+z');
      assert.equal(await bytesOf(tab), state);
    }
    await tab.close();
  });

  test('drags handles and anchors, Alt breaks them, and the link restores everything', async () => {
    const tab = await drawn();
    const { page } = tab;
    const anchor = await tab.handle('Anchor 2 of 3');
    await page.mouse.click(anchor.x, anchor.y);
    assert.equal(await page.locator('.handle[data-look="tangent"]').count(), 2);
    const first = (await tab.view()).tangents[1];
    await tab.dragHandle('Handle after anchor 2', 15, 35);
    let { before, after } = (await tab.view()).tangents[1];
    assert.ok(dot(after.direction, first.after.direction) < 0.99, 'it is turned');
    assert.ok(dot(before.direction, after.direction) < -1 + 1e-9, 'the other one goes along');
    await page.locator('#joint').selectOption('smooth');
    await tab.dragHandle('Handle before anchor 2', -30, 0);
    const smooth = (await tab.view()).tangents[1];
    assert.ok(dot(smooth.before.direction, smooth.after.direction) < -1 + 1e-9);
    assert.ok(Math.abs(smooth.after.length - after.length) < 1e-9, 'its length is kept');
    await page.keyboard.down('Alt');
    await tab.dragHandle('Handle before anchor 2', 0, -40);
    await page.keyboard.up('Alt');
    ({ before, after } = (await tab.view()).tangents[1]);
    assert.ok(dot(before.direction, after.direction) > -0.999, 'broken');
    assert.ok(dot(after.direction, smooth.after.direction) > 1 - 1e-9, 'the other one stays');
    assert.equal(await page.locator('#joint').inputValue(), 'corner');
    await tab.dragHandle('Anchor 2 of 3', 20, 20);
    const moved = (await tab.view()).tangents[1];
    assert.ok(Math.abs(moved.after.length - after.length) < 1e-9, 'handles go with their anchor');
    assert.ok(dot(moved.after.direction, after.direction) > 0.9);

    const whole = await bytesOf(tab);
    const { polyline } = await tab.view();
    await tab.pastSaving();
    await page.reload();
    await tab.settled();
    assert.equal(await bytesOf(tab), whole);
    assert.deepEqual((await tab.view()).polyline, polyline);
    const fragment = page.url().split('#')[1];
    await page.evaluate(() => sessionStorage.clear());
    const other = await Tab.open(browser, fragment);
    assert.deepEqual((await other.view()).polyline, polyline, 'the link alone tells it');
    assert.deepEqual([...tab.logged, ...other.logged], []);
    await other.page.close();
    await page.close();
  });

  test('takes a typed value before the press that ends the typing', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await page.keyboard.press('p');
    await tab.click([-100, 40], [0, -40]);
    const type = async (text) => {
      await page.locator('#width').fill('');
      await page.locator('#width').pressSequentially(text);
    };
    const widthOf = async () => (await tab.state()).drawing.objects.at(-1).width;
    await type('7');
    await tab.click([100, 50]);
    assert.equal((await penOf(tab)).points.length, 3, 'the click places its anchor');
    assert.equal((await tab.state()).selection, 2);
    assert.equal(await widthOf(), 7);
    await type('9');
    const [, before] = (await penOf(tab)).points;
    await tab.dragHandle('Anchor 2 of 3', 20, 30);
    assert.notDeepEqual((await penOf(tab)).points[1], before, 'the drag moves its anchor');
    assert.equal(await widthOf(), 9);
    await page.locator('#tool-transform').click();
    await page.getByRole('button', { name: 'Turn the selection' }).waitFor();
    await tab.still();
    await type('5');
    const turned = await penOf(tab);
    const { x, y } = await tab.handle('Turn the selection');
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 30, y + 20, { steps: 4 });
    await page.waitForFunction(() => window.karcherPage.state().dragging);
    await page.mouse.up();
    await page.waitForFunction(() => !window.karcherPage.state().dragging);
    assert.notDeepEqual((await penOf(tab)).points, turned.points, 'the drag turns the curve');
    assert.equal(await widthOf(), 5);
    await tab.close();
  });

  test('begins a visible object in place of a hidden empty one, as every other tool does', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    for (const key of ['b', 'p']) {
      await page.keyboard.press(key);
      await tab.click([-100, 40], [0, -40]);
      await page.locator('#objects .eye').first().click();
      await page.locator('#clear').click();
      await tab.click([-60, 20], [40, 30]);
      const { drawing, figure } = await tab.state();
      assert.equal(figure.points.length, 2);
      assert.deepEqual(
        drawing.objects.map(({ visible }) => visible),
        [true],
      );
    }
    await tab.close();
  });

  test('closes at the first anchor, ends with Escape, and a double click on the curve adds an anchor', async () => {
    const tab = await drawn();
    const { page } = tab;
    const first = await tab.handle('Anchor 1 of 3');
    await page.mouse.click(first.x, first.y);
    await tab.settled();
    assert.equal((await penOf(tab)).settings.closed, true);
    const { curve } = await tab.view();
    assert.equal(new Set(Object.values(curve.samples.segment)).size, 3);
    const at = await tab.onCurve(0.15);
    await page.mouse.dblclick(at.x, at.y);
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length === 4);
    assert.equal((await tab.state()).selection, 1);
    const { length } = (await tab.view()).curve;
    assert.ok(Math.abs(length / curve.length - 1) < 0.02, 'the curve stays nearly as it is');
    await page.keyboard.press('Delete');
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length === 3);

    await page.keyboard.press('Escape');
    await tab.click([-120, -110], [-60, -130]);
    assert.equal((await tab.state()).drawing.objects.length, 2, 'a closed one has ended');
    await page.keyboard.press('Escape');
    await tab.click([60, -130]);
    const { drawing, figure } = await tab.state();
    assert.equal(drawing.objects.length, 3, 'Escape ends one');
    assert.equal(figure.kind, 'pen');
    assert.equal(figure.points.length, 1);
    const hint = page.locator('#hint');
    assert.equal(await hint.textContent(), '1 more point makes a curve');
    await page.keyboard.press('Escape');
    assert.match(await hint.textContent(), /^Click to place a corner/, 'no point goes on with it');
    await tab.close();
  });

  test('bends the curve by a drag, and removes an anchor by a double click, each as one step', async () => {
    const tab = await drawn();
    const { page } = tab;
    const whole = await bytesOf(tab);
    const { points } = await penOf(tab);
    const at = await tab.onCurve(0.25);
    await page.mouse.move(at.x, at.y);
    await page.locator('#stage[data-action="bend"]').waitFor();
    assert.match(await page.locator('#hint').textContent(), /^Drag bends the curve/);
    const to = { x: at.x - 15, y: at.y - 30 };
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    await page.waitForFunction(() => window.karcherPage.state().dragging);
    await page.mouse.up();
    await page.waitForFunction(() => !window.karcherPage.state().dragging);
    const { polyline, tangents } = await tab.view();
    const far = await page.evaluate(
      ([line, { x, y }]) => {
        let least = Infinity;
        for (let i = 0; i < line.length; i += 3) {
          const place = window.karcherPage.seen(line.slice(i, i + 3));
          if (place) least = Math.min(least, Math.hypot(place.x - x, place.y - y));
        }
        return least;
      },
      [polyline, to],
    );
    assert.ok(far < 2, `the curve goes through the pointer, but for its samples: ${far} px`);
    const bent = (await penOf(tab)).points;
    for (const [i, { face, bary }] of bent.entries()) {
      assert.deepEqual([face, bary], [points[i].face, points[i].bary], 'anchors stay');
    }
    const { before, after } = tangents[1];
    assert.ok(dot(before.direction, after.direction) < -1 + 1e-9, 'smooth as before');
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);

    const last = await tab.handle('Anchor 3 of 3');
    await page.mouse.click(last.x, last.y);
    await page.waitForFunction(() => window.karcherPage.state().selection === 2);
    const own = await tab.onCurve(0.15);
    await page.mouse.click(own.x, own.y);
    await page.waitForFunction(() => window.karcherPage.state().selection === 0);
    assert.equal(await bytesOf(tab), whole, 'a click selects the nearer anchor');
    const anchor = await tab.handle('Anchor 2 of 3');
    await page.mouse.move(anchor.x, anchor.y);
    await page.locator('#stage[data-action="anchor"]').waitFor();
    await page.mouse.dblclick(anchor.x, anchor.y);
    await page.waitForFunction(() => window.karcherPage.state().figure.points.length === 2);
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(await bytesOf(tab), whole);

    // The handles stay in place from then on.
    await page.waitForFunction(() => !window.karcherPage.view().refining);
    await tab.still();
    await page.keyboard.down('Alt');
    const corner = await tab.handle('Anchor 2 of 3');
    await page.mouse.move(corner.x + 1, corner.y);
    await page.locator('#stage[data-action="convert"]').waitFor();
    await page.mouse.click(corner.x + 1, corner.y);
    await page.keyboard.up('Alt');
    await tab.settled();
    await page.waitForFunction(() => !window.karcherPage.state().figure.points[1].tangents);
    await tab.close();
  });

  inLongRun('keeps handles to 45 degrees with Shift, and draws by keys alone', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await page.keyboard.press('p');
    await pull(tab, [-60, 0], [0, 0]);
    await page.keyboard.down('Shift');
    await tab.dragHandle('Handle after anchor 1', 8, 5);
    await page.keyboard.up('Shift');
    const { after } = (await tab.view()).tangents[0];
    const { after: told } = (await penOf(tab)).points[0].tangents;
    assert.ok(dot(told.direction, after.direction) > 1 - 1e-9);
    const seen = await page.evaluate(
      ([place, direction]) => {
        const at = window.karcherPage.seen(place);
        const on = window.karcherPage.seen(place.map((x, i) => x + 1e-3 * direction[i]));
        return Math.atan2(on.y - at.y, on.x - at.x);
      },
      [Object.values(after.path).slice(0, 3), told.direction],
    );
    // The surface is foreshortened at the side.
    assert.ok(Math.abs(seen) < 0.15, `to the right: ${seen}`);
    await page.keyboard.press('n');
    await page.locator('#stage').focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    await tab.settled();
    const { figure } = await tab.state();
    assert.equal(figure.kind, 'pen');
    assert.equal(figure.points.length, 2);
    assert.ok((await tab.view()).curve);
    await tab.close();
  });

  inLongRun('draws with a finger: taps are corners, and a drag makes a smooth anchor', async () => {
    const phone = await openPhone();
    const tab = await Tab.open(phone);
    const { page } = tab;
    await page.locator('#tool-pen').tap();
    assert.equal((await penOf(tab)).kind, 'pen');
    const { together } = await touchOf(page);
    // The surface is visible above the sheet.
    const middle = await page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    const at = (dx, dy) => ({ x: middle.x + dx, y: middle.y + dy });
    const anchors = async () => {
      await tab.settled();
      return (await penOf(tab)).points.map(({ tangents }) => tangents !== undefined);
    };
    await page.touchscreen.tap(middle.x - 70, middle.y + 20);
    assert.deepEqual(await anchors(), [false]);
    await together(
      ['touchStart', at(0, -20)],
      ...[1, 2, 3, 4].map((step) => ['touchMove', at(10 * step, -20 - 2 * step)]),
      ['touchEnd'],
    );
    assert.deepEqual(await anchors(), [false, true]);
    await page.touchscreen.tap(middle.x + 70, middle.y + 20);
    assert.deepEqual(await anchors(), [false, true, false]);
    const { curve, problem } = await tab.view();
    assert.equal(problem, null);
    assert.equal(new Set(Object.values(curve.samples.segment)).size, 2);
    assert.deepEqual(tab.logged, []);
    await phone.close();
  });
});
