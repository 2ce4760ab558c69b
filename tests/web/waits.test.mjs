// Edits made while the page waits for its workers survive the workers' answers.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { everyFile } from '../wasm/mesh_files.mjs';
import { openBrowser, Tab } from './browser.mjs';

/** A cone on z = 0, without a base; its tip is the last vertex. */
const ring = Array.from({ length: 60 }, (_, i) => (Math.PI * i) / 30);
const cone = {
  positions: [...ring.flatMap((t) => [Math.cos(t), Math.sin(t), 0]), 0, 0, 3],
  faces: ring.map((_, i) => [i, (i + 1) % 60, 60]),
};

describe('while the page waits', () => {
  let browser;
  before(async () => {
    browser = await openBrowser();
    // The page holds requests to workers whose script name contains `window.holds`.
    await browser.context.addInitScript(() => {
      window.holds = '';
      window.held = [];
      window.Worker = class extends Worker {
        #name;

        constructor(address, options) {
          super(address, options);
          this.addEventListener('error', () => {
            window.broken = true;
          });
          this.#name = `${address}`;
        }

        postMessage(...message) {
          const send = () => super.postMessage(...message);
          if (window.holds && this.#name.includes(window.holds)) window.held.push(send);
          else send();
        }
      };
    });
  });
  after(() => browser.close());

  const hold = (tab, name) =>
    tab.page.evaluate((holds) => {
      window.holds = holds;
    }, name);
  const held = (tab, count) =>
    tab.page.waitForFunction((wanted) => window.held.length >= wanted, count);
  const release = async (tab) => {
    await hold(tab, '');
    await tab.page.evaluate(() => {
      for (const send of window.held.splice(0)) send();
    });
    await tab.settled();
  };
  const shown = (tab, ending) =>
    tab.page.waitForFunction((end) => window.karcherPage.state().mesh.endsWith(end), ending);

  test('for another upward axis: edits stay, and the last of two choices counts', async () => {
    const tab = await Tab.open(browser);
    await tab.dropBytes('cone.ply', everyFile(cone)['little.ply']);
    await shown(tab, 'cone.ply');
    await tab.click([-20, 60], [30, 0], [0, -60], [10, 90]);
    await hold(tab, 'geometry');
    const up = tab.page.getByRole('combobox', { name: 'What points up' });
    await up.selectOption('Y up');
    await held(tab, 1);
    await tab.click([20, 40]);
    assert.equal((await tab.state()).figure.points.length, 5);
    await up.selectOption('X up');
    await held(tab, 2);
    await tab.page.evaluate(() => window.held[1]());
    await shown(tab, '~x:cone.ply');
    await tab.page.evaluate(() => window.held[0]());
    await hold(tab, '');
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 5);
    // An earlier request has an answer once a later one has.
    await up.selectOption('Z up');
    await shown(tab, '~z:cone.ply');
    assert.equal((await tab.state()).figure.points.length, 5);
    await tab.close();
  });

  test('for two choices of reading a file: both count, and a choice taken back does not', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    const x = [0, 1, 1.00005, 2];
    const corners = x.flatMap((at) => [0, 1].map((y) => `v ${at} ${y} 0`));
    const text = `o left\n${corners.join('\n')}\nf 1 3 4 2\no right\nf 5 7 8 6\n`;
    await tab.drop('gap.obj', text);
    await shown(tab, 'gap.obj');
    await tab.settled();
    const { mesh } = await tab.state();
    const choose = (name, option) => page.getByRole('combobox', { name }).selectOption(option);
    await hold(tab, 'engine');
    await choose('Part of the file', { index: 1 });
    await held(tab, 1);
    await choose('Part of the file', { index: 0 });
    await page.waitForFunction(() => document.getElementById('progress').hidden);
    await release(tab);
    assert.equal((await tab.state()).mesh, mesh);
    await hold(tab, 'engine');
    await choose('Part of the file', { index: 2 });
    await held(tab, 1);
    await choose('What points up', 'X up');
    await hold(tab, '');
    await page.waitForFunction(() => {
      for (const send of window.held.splice(0)) send();
      return window.karcherPage.state().mesh.includes('~x');
    });
    await tab.settled();
    assert.match((await tab.state()).mesh, /\.1~x:gap\.obj$/);
    await tab.close();
  });

  const bytesOf = async (tab) => JSON.stringify((await tab.state()).drawing);
  const dragging = (tab, is) =>
    tab.page.waitForFunction((want) => window.karcherPage.state().dragging === want, is);
  const places = [
    [-110, 40],
    [-40, -10],
    [40, 50],
    [110, -10],
  ];
  /** Pulls a place of the window until the engine shows a step, and lets go before the next one. */
  async function pulled(tab, { x, y }) {
    const { mouse } = tab.page;
    await mouse.move(x, y);
    await mouse.down();
    // A single motion is a single step.
    await mouse.move(x + 20, y - 25);
    await dragging(tab, true);
    await tab.settled();
    const seen = await bytesOf(tab);
    await hold(tab, 'engine');
    await mouse.move(x + 50, y - 40);
    await held(tab, 1);
    await mouse.up();
    return seen;
  }
  const pulls = {
    'a line': async (tab) => {
      await tab.click(...places);
      await tab.page.keyboard.press('v');
      return () => tab.onCurve(0.5);
    },
    'the frame': async (tab) => {
      await tab.click(...places);
      await tab.page.locator('#tool-transform').click();
      return () => tab.handle('Move the selection');
    },
    'a segment of the pen': async (tab) => {
      await tab.page.keyboard.press('p');
      await tab.click(...places);
      await tab.page.keyboard.press('Escape');
      return () => tab.onCurve(0.5);
    },
  };
  for (const [what, begin] of Object.entries(pulls)) {
    test(`for the last step of ${what} that was let go: what is shown is a step, whatever follows`, async () => {
      const tab = await Tab.open(browser);
      const { page } = tab;
      const place = await begin(tab);
      await tab.settled();
      const whole = await bytesOf(tab);
      const seen = await pulled(tab, await place());
      assert.notEqual(seen, whole);
      await page.keyboard.press('Control+z');
      assert.equal(await bytesOf(tab), whole, 'undo');
      await page.keyboard.press('Control+y');
      assert.equal(await bytesOf(tab), seen, 'redo');
      await release(tab);
      assert.equal(await bytesOf(tab), seen, 'a late answer changes nothing');
      await page.keyboard.press('Control+z');
      await tab.settled();
      await tab.still();
      const count = (await tab.state()).drawing.objects.length;
      const again = await pulled(tab, await place());
      await page.keyboard.press('Control+d');
      await release(tab);
      const { objects } = (await tab.state()).drawing;
      assert.equal(objects.length, count + 1);
      assert.deepEqual(objects[0].figure, JSON.parse(again).objects[0].figure, 'a copy');
      await tab.close();
    });
  }

  test('for the last step of a drag: the next drag begins where it is shown', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    await page.keyboard.press('v');
    await tab.settled();
    const whole = await bytesOf(tab);
    const at = await tab.onCurve(0.5);
    const seen = await pulled(tab, at);
    await page.mouse.move(at.x + 20, at.y - 25);
    await page.mouse.down();
    await page.mouse.move(at.x, at.y);
    await page.mouse.up();
    await release(tab);
    await page.waitForFunction((text) => {
      const { dragging, drawing } = window.karcherPage.state();
      return !dragging && JSON.stringify(drawing) !== text;
    }, seen);
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), seen);
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('for the last step of arrow keys that were let go: what is shown is a step', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click(...places);
    await page.keyboard.press('Control+a');
    await page.locator('#stage').focus();
    await tab.settled();
    const whole = await bytesOf(tab);
    await page.keyboard.down('ArrowRight');
    await dragging(tab, true);
    await tab.settled();
    const seen = await bytesOf(tab);
    await hold(tab, 'engine');
    await page.keyboard.down('ArrowRight');
    await held(tab, 1);
    await page.keyboard.up('ArrowRight');
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole, 'undo');
    await page.keyboard.press('Control+y');
    assert.equal(await bytesOf(tab), seen, 'redo');
    await release(tab);
    assert.equal(await bytesOf(tab), seen);
    await tab.close();
  });

  test('for knots: clicks and Enter act in the order of the user, and a click stays with its curve', async () => {
    const at = (faces) => faces.map((face) => `${face},0.3,0.3`).join(';');
    const other = `other=${encodeURIComponent(`kind=points&points=${at([3])}&name=Other`)}`;
    const knots = 'degree=3&clamped=0&knots=0,1,2,3.5,4.5,5.5,6.5,8';
    const tab = await Tab.open(
      browser,
      `mesh=sphere:1500&kind=bspline&${knots}&points=${at([20, 40, 60, 90])}&${other}`,
    );
    const { page } = tab;
    const counts = async () =>
      (await tab.state()).drawing.objects.map(({ figure }) => figure.points.length);
    const counted = (all) =>
      page.waitForFunction((wanted) => {
        const { objects } = window.karcherPage.state().drawing;
        return `${objects.map(({ figure }) => figure.points.length)}` === wanted;
      }, `${all}`);
    const { x, y } = await tab.middle();
    const begun = await counts();
    assert.deepEqual(begun.toSorted(), [1, 4]);
    const own = begun.indexOf(4);
    await hold(tab, 'engine');
    await page.mouse.click(x + 10, y + 20);
    await held(tab, 1);
    await page.keyboard.press('Enter');
    await page.mouse.click(x - 30, y);
    await page.mouse.click(x - 60, y + 30);
    await release(tab);
    await counted([...begun.with(own, 5), 2]);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal((await counts())[own], 5, 'Enter follows the click');
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.deepEqual(await counts(), begun);

    await hold(tab, 'engine');
    await page.mouse.click(x + 10, y + 20);
    await held(tab, 1);
    await page.locator('#objects .object', { hasText: 'Other' }).click();
    await release(tab);
    await counted(begun.with(own, 5));
    const { drawing } = await tab.state();
    assert.equal(drawing.objects.find(({ id }) => id === drawing.active).name, 'Other');
    const { knots: found } = drawing.objects[own].figure.settings;
    assert.equal(found?.length, 9, 'with knots of its own');
    await tab.close();
  });

  test('for a surface: an engine that stops meanwhile is only restarted if the surface does not open', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click([-20, 60], [30, 0], [0, -60], [10, 90]);
    const surface = page.locator('#surface');
    const stopped = page.getByText('The engine stopped');
    /** Begins to open a surface. Before an answer, the engine of the present surface stops. */
    const crash = async (id) => {
      await hold(tab, 'engine');
      await surface.selectOption(id);
      await held(tab, 1);
      await tab.engines()[0].evaluate(() =>
        setTimeout(() => {
          throw new Error('out of memory');
        }),
      );
      await page.waitForFunction(() => window.broken);
      assert.equal(await stopped.count(), 0);
      await hold(tab, '');
      await page.evaluate(() => {
        window.broken = false;
      });
    };
    await crash('openSheet');
    await page.evaluate(() => {
      for (const send of window.held.splice(0)) send();
    });
    await page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('openSheet'));
    await tab.settled();
    assert.equal(await stopped.count(), 0);
    await crash('knot');
    await page.getByRole('button', { name: 'Cancel', exact: true }).click();
    await stopped.waitFor();
    await page.waitForFunction(() => document.getElementById('progress').hidden);
    await tab.settled();
    await tab.click([-20, 60], [30, 0], [0, -60], [10, 90]);
    assert.match((await tab.state()).mesh, /^openSheet/);
    assert.ok((await tab.view()).curve.length > 0);
    await page.close();
  });

  test('for a link’s method: its drawing does not appear on the surface that was opened since', async () => {
    const tab = await Tab.open(browser);
    await hold(tab, 'engine');
    await tab.page.evaluate(() => {
      location.hash =
        'mesh=sphere:1500&kind=points&method=paper-graph&points=1,0.2,0.3;700,0.1,0.5';
    });
    await held(tab, 1);
    await hold(tab, '');
    await tab.page.evaluate(() => {
      const surface = document.getElementById('surface');
      surface.value = 'torus';
      surface.dispatchEvent(new Event('change'));
    });
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('torus'));
    await tab.page.evaluate(() => {
      for (const send of window.held) send();
    });
    await tab.settled();
    const { figure, mesh } = await tab.state();
    assert.deepEqual([mesh.split(':')[0], figure.points.length], ['torus', 0]);
    await tab.page.close();
  });

  test('for a method that takes long to prepare: the method that was chosen since stays', async () => {
    const tab = await Tab.open(browser);
    await tab.click([-20, 60], [30, 0], [0, -60], [10, 90]);
    const method = tab.page.locator('#method');
    await hold(tab, 'engine');
    await method.selectOption('paper-graph');
    await held(tab, 1);
    await hold(tab, '');
    await method.selectOption('paper-exact');
    await tab.page.waitForFunction(() => window.karcherPage.state().method === 'paper-exact');
    await tab.page.evaluate(() => {
      for (const send of window.held) send();
    });
    // The engine answers in order: once a later request has an answer, so has this one.
    await tab.click([60, 40]);
    await tab.page.waitForFunction(() => document.getElementById('progress').hidden);
    assert.equal((await tab.state()).method, 'paper-exact');
    assert.equal(await method.inputValue(), 'paper-exact');
    await tab.close();
  });

  test('for the focus: Escape closes a menu that has just opened, and deselects nothing', async () => {
    const tab = await Tab.open(browser);
    await tab.click([-60, 60], [-20, 0], [20, -60], [60, 20]);
    await tab.page.keyboard.press('v');
    const { x, y } = await tab.onCurve(0.5);
    await tab.page.mouse.click(x, y);
    const before = await tab.state();
    await tab.page.mouse.click(x, y, { button: 'right' });
    const menu = tab.page.locator('#context-menu');
    await menu.waitFor();
    // The focus is elsewhere, as in the moment after the menu opens.
    await tab.page.evaluate(() => document.activeElement.blur());
    await tab.page.keyboard.press('Escape');
    assert.equal(await menu.isVisible(), false);
    const { selection, chosen, none } = await tab.state();
    assert.deepEqual(
      { selection, chosen, none },
      { selection: before.selection, chosen: before.chosen, none: before.none },
    );
    await tab.page.close();
  });

  test('for the outline it says so, and nothing is saved after a cancellation', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click([-60, 0], [60, 0]);
    await hold(tab, 'outline');
    const saveOutline = async () => {
      await page.locator('#save').click();
      await page.getByRole('menuitem', { name: 'with the surface’s outline' }).press('Enter');
    };
    let downloads = 0;
    page.on('download', () => downloads++);
    await saveOutline();
    const progress = page.getByRole('status').filter({ hasText: 'Drawing the outline' });
    await progress.waitFor();
    await progress.getByRole('button', { name: 'Cancel' }).click();
    await progress.waitFor({ state: 'hidden' });

    const coming = page.waitForEvent('download');
    await saveOutline();
    await progress.waitFor();
    await page.evaluate(() => {
      for (const send of window.held) send();
    });
    await coming;
    await progress.waitFor({ state: 'hidden' });
    assert.equal(downloads, 1);
    await tab.close();
  });
});
