// The view follows the pointer: it zooms, turns and moves at the place under the pointer.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { part } from './part.mjs';

describe('the view', () => {
  const browser = browserOfSuite({ reducedMotion: 'reduce' });

  const off = [70, -40];

  /**
   * A tab with a point of the surface under a place of the window, in the surface's coordinates.
   */
  async function aimed(mesh = 'sphere:5000') {
    const tab = await Tab.open(browser, `mesh=${mesh}`);
    const { x, y } = await tab.middle();
    const at = { x: x + off[0], y: y + off[1] };
    await tab.click(off);
    const { figure } = await tab.state();
    const { positions, triangles } = await tab.mesh();
    const [{ face, bary }] = figure.points;
    const place = [0, 1, 2].map((axis) =>
      bary.reduce((sum, b, k) => sum + b * positions[3 * triangles[3 * face + k] + axis], 0),
    );
    await tab.page.mouse.move(at.x, at.y);
    return { tab, at, place };
  }
  const seen = async (tab, place) => {
    await tab.still();
    return tab.page.evaluate((position) => window.karcherPage.seen(position), place);
  };
  const near = (one, other, words, within = 3) => {
    assert.ok(one, `${words}: it is not seen`);
    const gap = Math.hypot(one.x - other.x, one.y - other.y);
    assert.ok(gap <= within, `${words}: ${gap} pixels away`);
  };
  const wheel = async (tab, times, by) => {
    for (let i = 0; i < times; i++) {
      await tab.page.mouse.wheel(0, by);
      await tab.still();
    }
  };
  const drag = async (tab, from, [dx, dy], button = 'left') => {
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down({ button });
    await tab.page.mouse.move(from.x + dx, from.y + dy, { steps: 8 });
    await tab.page.mouse.up({ button });
    await tab.still();
  };

  test('zooms to the place under the pointer, never through it, and back', async () => {
    const { tab, at, place } = await aimed();
    const sizeOf = async () => {
      const [a, b] = [place, place.map((value) => value + 0.002)];
      const [one, other] = [await seen(tab, a), await seen(tab, b)];
      return one && other ? Math.hypot(one.x - other.x, one.y - other.y) : 0;
    };
    await wheel(tab, 40, -240);
    near(await seen(tab, place), at, 'after 40 steps');
    await wheel(tab, 40, -240);
    near(await seen(tab, place), at, 'after 80 steps');
    await wheel(tab, 65, 240);
    near(await seen(tab, place), at, 'after 65 steps back');
    assert.ok((await sizeOf()) < 50, 'it is not stuck');
    await tab.close();
  });

  for (const [how, hold, button] of [
    ['the right button', null, 'right'],
    ['Alt', 'Alt', 'left'],
  ]) {
    for (const tool of part(['v', 'p', 'f'], 1)) {
      test(`turns with ${how} about the place under the pointer, with tool ${tool}`, async () => {
        const { tab, at, place } = await aimed();
        await wheel(tab, 6, -240);
        await tab.page.keyboard.press(tool);
        await tab.settled();
        const before = JSON.stringify((await tab.state()).drawing);
        const beside = { x: at.x - 60, y: at.y + 60 };
        const other = await seen(tab, [0, 0, 0]);
        if (hold) await tab.page.keyboard.down(hold);
        // The drag starts beside the point itself, which is a handle.
        await drag(tab, { x: at.x + 14, y: at.y }, [30, 12], button);
        if (hold) await tab.page.keyboard.up(hold);
        near(await seen(tab, place), at, 'turned', 16);
        const view = await tab.page.evaluate(() => location.hash);
        assert.equal(JSON.stringify((await tab.state()).drawing), before, 'nothing is drawn');
        assert.equal(await tab.page.locator('#context-menu').isVisible(), false);
        assert.ok(other !== undefined && beside && view);
        await tab.close();
      });
    }
  }

  test('turns about the middle of the whole where the pointer is beside it, which stays in view', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000');
    const { x, y } = await tab.middle();
    const { width, height } = await tab.page.locator('#stage').boundingBox();
    const unit = Math.min(width, height) / 2;
    const pixel = () =>
      tab.page.evaluate(([h, v]) => window.karcherPage.under(h, v)?.pixel ?? 0, [x, y]);
    const before = await pixel();
    assert.ok(before > 0);
    // Half a turn.
    await drag(tab, { x: x - 0.9 * unit, y: y + 0.5 * unit }, [height / 2, 0], 'right');
    const after = await pixel();
    assert.ok(Math.abs(after / before - 1) < 0.02, `a pixel is ${after}, and was ${before}`);
    await tab.close();
  });

  for (const [how, hold, button] of [
    ['the middle button', null, 'middle'],
    ['the space bar', 'Space', 'left'],
  ]) {
    test(`moves with ${how}, and keeps the place under the pointer there`, async () => {
      const { tab, at, place } = await aimed();
      await wheel(tab, 4, -240);
      await tab.page.keyboard.press('p');
      const before = JSON.stringify((await tab.state()).drawing);
      if (hold) await tab.page.keyboard.down(hold);
      const by = [-90, 60];
      await drag(tab, at, by, button);
      if (hold) await tab.page.keyboard.up(hold);
      near(await seen(tab, place), { x: at.x + by[0], y: at.y + by[1] }, 'moved');
      assert.equal(JSON.stringify((await tab.state()).drawing), before, 'nothing is drawn');
      await tab.close();
    });
  }

  test('Shift 2 zooms to the selection, Shift 1 to all', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000');
    await tab.click([60, 40], [90, 50], [80, 70]);
    await tab.settled();
    const spread = async () => {
      const places = await Promise.all([1, 2, 3].map((i) => tab.handle(`Control point ${i} of 3`)));
      const { x, y } = await tab.middle();
      return Math.max(...places.map((place) => Math.hypot(place.x - x, place.y - y)));
    };
    assert.ok((await spread()) < 120);
    const usual = await tab.handle('Control point 1 of 3');
    await tab.page.keyboard.press('Shift+Digit2');
    await tab.still();
    const box = await tab.page.locator('#stage').boundingBox();
    const wide = await spread();
    assert.ok(wide > box.height / 4 && wide < box.height / 2, `${wide} of ${box.height}`);
    await tab.page.keyboard.press('Shift+Digit1');
    await tab.still();
    near(await tab.handle('Control point 1 of 3'), usual, 'as it was');
    await tab.close();
  });
});
