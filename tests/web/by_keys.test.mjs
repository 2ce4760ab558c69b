// Keys alone do what a mouse does on the stage: each gesture has its keys, or another way to the
// same end.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun, part } from './part.mjs';

describe('without a mouse', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  /** Opens the page with the focus on the stage. */
  async function open(fragment = 'mesh=sphere:500') {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    const keys = async (...names) => {
      for (const name of names) await page.keyboard.press(name);
      await tab.settled();
    };
    const onStage = () => page.locator('#stage').focus();
    await onStage();
    const objects = async () => (await tab.state()).drawing.objects;
    const figure = async () => (await tab.state()).figure;
    return { tab, page, keys, onStage, objects, figure };
  }
  /** Presses Tab until an element has the focus, and fails after 200 times. */
  async function tabTo(page, selector) {
    for (let count = 0; count < 200; count++) {
      const isThere = await page.evaluate((one) => document.activeElement?.matches(one), selector);
      if (isThere) return;
      await page.keyboard.press('Tab');
    }
    assert.fail(`no way to ${selector} by Tab`);
  }

  const drawing = {
    b: { kind: 'bspline', points: 4 },
    p: { kind: 'pen', points: 4 },
    w: { kind: 'center', points: 4 },
  };
  for (const [tool, { kind, points }] of part(Object.entries(drawing), 2)) {
    test(`tool ${tool} places points, which keys move, delete and restore`, async () => {
      const { tab, page, keys, figure } = await open();
      await keys(tool);
      for (let count = 0; count < points; count++) {
        await keys('Enter', 'Control+ArrowRight', 'Control+ArrowUp');
      }
      assert.equal((await figure()).kind, kind);
      assert.equal((await figure()).points.length, points);
      const before = JSON.stringify((await figure()).points[0]);
      await tabTo(page, '#handles .handle');
      for (const key of ['ArrowLeft', 'ArrowUp']) {
        const { revision } = await tab.state();
        await keys(key);
        await page.waitForFunction((seen) => window.karcherPage.state().revision > seen, revision);
        await page.waitForFunction(() => !window.karcherPage.state().dragging);
      }
      assert.notEqual(JSON.stringify((await figure()).points[0]), before);
      // The focus selects again after a move by keys.
      await keys('Tab');
      assert.equal((await tab.state()).selection, 1);
      await keys('Shift+Tab');
      assert.equal((await tab.state()).selection, 0);
      await keys('Delete');
      assert.equal((await figure()).points.length, points - 1);
      // Each arrow key was a step, and so was the deletion.
      await keys('Control+z', 'Control+z', 'Control+z');
      assert.equal(JSON.stringify((await figure()).points[0]), before);
      await tab.close();
    });
  }

  inLongRun('a circle is placed and enlarged', async () => {
    const { tab, page, keys, figure } = await open();
    await keys('o', 'Enter');
    const { rim } = (await figure()).circle;
    await tabTo(page, '#handles .handle[data-id*="rim"]');
    await keys('ArrowRight', 'ArrowRight');
    assert.notDeepEqual((await figure()).circle.rim, rim);
    await tab.close();
  });

  test('the view turns, moves and zooms, whatever the selection is', async () => {
    const { tab, keys, onStage, objects } = await open();
    const place = () => tab.page.evaluate(() => location.hash);
    await keys('b', 'Enter', 'Control+ArrowRight', 'Enter', 'Control+ArrowUp', 'Enter');
    await keys('Control+ArrowUp', 'Enter', 'Control+a');
    await onStage();
    assert.equal((await tab.state()).chosen.length, 1);
    const before = JSON.stringify(await objects());
    const seen = new Set();
    for (const key of ['Control+ArrowLeft', 'Control+Shift+ArrowDown', '+', '-', '+']) {
      await keys(key);
      await tab.still();
      await tab.pastSaving();
      seen.add(await place());
    }
    assert.ok(seen.size >= 4, [...seen].join('\n'));
    assert.equal(JSON.stringify(await objects()), before);
    // Arrow keys alone move the selection.
    await keys('ArrowLeft');
    await tab.page.waitForFunction(
      (were) => JSON.stringify(window.karcherPage.state().drawing.objects) !== were,
      before,
    );
    await tab.close();
  });

  inLongRun('several points are selected in their list, moved together and deleted', async () => {
    const { tab, page, keys, figure } = await open();
    await keys('b');
    for (let count = 0; count < 6; count++) {
      await keys('Enter', 'Control+ArrowRight', 'Control+ArrowUp');
    }
    const rows = page.locator('#points li > button:first-child');
    await rows.nth(1).focus();
    await keys('Enter');
    await rows.nth(3).focus();
    await keys('Shift+Enter');
    const state = await tab.state();
    assert.deepEqual([state.more, state.selection], [[1], 3]);
    const before = (await figure()).points.map((point) => JSON.stringify(point));
    await page.locator('#handles .handle[aria-pressed="true"]').last().focus();
    await keys('ArrowDown', 'ArrowDown');
    const isMoved = ([i, was]) =>
      JSON.stringify(window.karcherPage.state().figure.points[i]) !== was;
    for (const i of [1, 3]) await page.waitForFunction(isMoved, [i, before[i]]);
    const after = (await figure()).points.map((point) => JSON.stringify(point));
    assert.deepEqual(
      [...after.keys()].filter((i) => after[i] !== before[i]),
      [1, 3],
    );
    await keys('Delete');
    assert.equal((await figure()).points.length, 4);
    await tab.close();
  });

  test('keys reach the ruler, the split, the list of objects and the menu', async () => {
    const { tab, page, keys, onStage, objects } = await open();
    await keys('m', 'Enter', 'Control+ArrowRight', 'Control+ArrowRight', 'Enter');
    await page.waitForFunction(() =>
      /along the surface/.test(document.getElementById('hint').textContent),
    );
    await keys('Escape', 'b', 'Enter', 'Control+ArrowRight', 'Enter', 'Control+ArrowUp', 'Enter');
    await keys('Control+ArrowUp', 'Enter', 'n', 'o', 'Enter');
    assert.equal((await objects()).length, 2);
    await tabTo(page, '#objects .object');
    await keys('Enter');
    await page.locator('#objects .object').nth(1).focus();
    await keys('Shift+Enter');
    assert.equal((await tab.state()).chosen.length, 2);
    await keys('Control+g');
    await onStage();
    await keys('Shift+F10');
    await page.locator('#context-menu').getByRole('menuitem', { name: 'Ungroup' }).press('Enter');
    await tab.settled();
    assert.ok((await objects()).every(({ group }) => group === null));
    await tab.close();
  });

  test('every control has a name, and Tab or arrows reach it', async () => {
    const { tab, page } = await open();
    await tab.click([-60, 10], [-20, -50], [30, 10], [70, -50]);
    await page.evaluate(() => document.activeElement.blur());
    const reached = new Set();
    for (let count = 0; count < 250; count++) {
      await page.keyboard.press('Tab');
      const at = await page.evaluate(() => {
        const element = document.activeElement;
        element.dataset.reached = 'yes';
        return element === document.body ? 'body' : element.outerHTML.slice(0, 60);
      });
      if (at === 'body' && reached.size > 20) break;
      reached.add(at);
    }
    const missed = await page.evaluate(() =>
      [...document.querySelectorAll('button, select, input, textarea, summary, a[href]')]
        .filter((one) => one.checkVisibility({ visibilityProperty: true }) && !one.disabled)
        // Tab reaches only one radio button of a group, and the test of handles covers handles.
        .filter((one) => one.dataset.reached !== 'yes' && one.type !== 'radio')
        .filter((one) => !one.closest('[inert]'))
        .map((one) => one.id || one.className || one.outerHTML.slice(0, 80)),
    );
    assert.deepEqual(missed, []);
    await tab.close();
  });
});
