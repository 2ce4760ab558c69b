// The Paper page as a reader meets it: its visible parts, and its state before computing.
import assert from 'node:assert/strict';
import { after, afterEach, before, describe, test } from 'node:test';
import { openBrowser } from './browser.mjs';

const ids = [
  ...['means', 'transport', 'paths', 'resolution', 'gallery', 'graph', 'averages', 'rational'],
  ...['circles', 'far', 'plane', 'carried', 'plots', 'table'],
];

describe('the Paper page for readers', () => {
  let browser;
  let page;
  before(async () => {
    browser = await openBrowser({ viewport: { width: 1280, height: 800 }, asUsers: true });
  });
  after(() => browser.close());
  afterEach(() => page.close());

  /**
   * Opens the page. With `held` its workers start only when the returned function is called, so
   * that the waiting state is visible.
   */
  async function open({ query = '?antialias=off', held = false, hash = '' } = {}) {
    page = await browser.context.newPage();
    let release = () => {};
    if (held) {
      const released = new Promise((resolve) => {
        release = resolve;
      });
      await page.route(/worker/, async (route) => {
        await released;
        await route.continue().catch(() => {});
      });
    }
    await page.goto(`${browser.address}paper.html${query}${hash}`);
    await page.waitForFunction(() => window.karcherPaper);
    return release;
  }
  const goTo = (id) =>
    page.evaluate((wanted) => {
      document.getElementById(wanted).scrollIntoView({ behavior: 'instant' });
    }, id);
  /** The visible height of an element in pixels. */
  const inSight = (locator) =>
    locator.evaluate((element) => {
      const { top, bottom } = element.getBoundingClientRect();
      const head = document.querySelector('.site-head').getBoundingClientRect().bottom;
      return Math.min(innerHeight, bottom) - Math.max(head, top);
    });

  for (const [width, height] of [
    [1280, 800],
    [390, 844],
  ]) {
    test(`a figure is visible with its title, before its caption unfolds, at ${width} px`, async () => {
      const release = await open({ held: true });
      await page.setViewportSize({ width, height });
      for (const id of ids) {
        await goTo(id);
        const card = page.locator(`#${id} :is(.panel-card, .panel-stage)`).last();
        const first = page.locator(`#${id} .panel-card`).first();
        assert.ok((await card.count()) === 1);
        const seen = await inSight(first);
        assert.ok(seen > height / 3, `${id}: ${seen} px`);
      }
      const caption = page.locator('#gallery > .caption');
      const rest = caption.getByText('The models and control points are ours');
      assert.equal(await rest.isVisible(), false);
      await caption.locator('summary').press('Enter');
      assert.equal(await rest.isVisible(), true);
      release();
    });
  }

  test('saved numbers stand in tables until they are computed, and panels name what they wait for', async () => {
    const release = await open({ held: true });
    await goTo('circles');
    const circle = page.locator('#circles .panel-card').first();
    const row = circle.locator('tr[data-line="circleArcs"]');
    assert.match(await row.locator('td').nth(2).textContent(), /^0\.\d+/);
    assert.equal(await row.getAttribute('data-state'), 'saved');
    assert.match(await circle.locator('.saved-note').textContent(), /^Grey: Measured on \d{4}-/);
    assert.match(
      await circle.locator('.making').textContent(),
      /^(Waits for its turn|Makes the mesh): Sphere, about 500 triangles/,
    );
    release();
    await page.waitForFunction(() => {
      const { panels } = window.karcherPaper.sections.find(
        ({ element }) => element.id === 'circles',
      );
      return panels[0].settled;
    });
    assert.equal(await row.getAttribute('data-state'), 'done');
    assert.equal(await circle.locator('.making').isVisible(), false);
    assert.equal(await circle.locator('.saved-note').isVisible(), false);
  });

  test('the last saved Table 1 is shown until the table is run', async () => {
    const release = await open({ held: true });
    await goTo('table');
    const cell = page.locator('#table tr[data-row="bunny-4k"] td[data-method="karcher"]').first();
    const status = page.locator('#table [role=status]');
    assert.match(await cell.textContent(), /\d/);
    assert.match(
      await status.textContent(),
      /^Measured on \d{4}-.* by version .*“Run” measures it/,
    );
    // The page names the machine with the numbers.
    assert.doesNotMatch(await page.evaluate(() => window.karcherPaper.table.csv()), /Mozilla/);
    await page.getByRole('button', { name: 'Run', exact: true }).click();
    assert.equal(await cell.textContent(), '');
    assert.match(await status.textContent(), /Starting|making the mesh/);
    release();
  });

  test('visible figures are computed first, even if others were requested before', async () => {
    const release = await open({ query: '?antialias=off&detail=0.02', held: true });
    for (const id of ids.slice(0, 10)) {
      await goTo(id);
      // Waits until the page has noticed that the figure is near.
      await page.waitForFunction(
        (wanted) =>
          ['transport', 'carried'].includes(wanted) ||
          document.querySelector(`#${wanted} .making`).textContent !== '',
        id,
      );
    }
    await goTo('averages');
    release();
    const others = await page
      .waitForFunction(() => {
        const { sections } = window.karcherPaper;
        const settled = sections.filter((section) => section.settled);
        return settled.some(({ element }) => element.id === 'averages')
          ? settled.map(({ element }) => element.id)
          : null;
      })
      .then((handle) => handle.jsonValue());
    assert.ok(others.length <= 2, `${others}`);
  });

  /**
   * Opens the page at Figure 6. From the first measurement by exact paths of its first panel on,
   * the worker sends nothing until the page cancels this work, or the returned function is called.
   */
  async function openHeldAtMeasurement() {
    page = await browser.context.newPage();
    const hold = () => {
      let work = null;
      const held = [];
      const send = globalThis.postMessage.bind(globalThis);
      const flush = () => {
        for (const message of held.splice(0)) send(...message);
      };
      addEventListener('message', ({ data }) => {
        if (data.call === 'trace' && data.args[0].panel.id === 'equal') work = data.id;
        if (data.cancel !== work) return;
        work = null;
        flush();
      });
      globalThis.postMessage = (...message) => {
        const [{ id, args }] = message;
        const isMeasurement = id === work && args?.[1]?.measured !== undefined;
        if (isMeasurement || held.length > 0) held.push(message);
        else send(...message);
      };
      globalThis.release = () => {
        globalThis.postMessage = send;
        flush();
      };
    };
    await page.route(/worker/, async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `(${hold})();${await response.text()}` });
    });
    await page.goto(`${browser.address}paper.html?antialias=off&detail=0.02`);
    await page.waitForFunction(() => window.karcherPaper);
    await goTo('rational');
    await page
      .locator('#rational .panel-card')
      .first()
      .getByText('Measures by exact paths…', { exact: true })
      .waitFor();
    return () =>
      Promise.all(page.workers().map((worker) => worker.evaluate(() => globalThis.release?.())));
  }
  /** The lines of that panel, and whether they have measurements, once all is done. */
  async function measured() {
    const lines = await page.waitForFunction(() => {
      const { sections } = window.karcherPaper;
      const { panels } = sections.find(({ element }) => element.id === 'rational');
      return panels[0].settled && JSON.parse(panels[0].json()).lines;
    });
    const all = await lines.jsonValue();
    return all.map((line) => [line.id, Boolean(line.ruler)]);
  }

  test('all lines are measured by exact paths, even if another one is switched on meanwhile', async () => {
    const release = await openHeldAtMeasurement();
    await page.locator('#rational tr[data-line="bSurf"] input').first().check();
    await release();
    assert.deepEqual(await measured(), [
      ['bSurf', true],
      ['paper', true],
      ['karcher', true],
      ['leveled', true],
    ]);
  });

  test('all lines are measured by exact paths, even if a visible figure interrupts them', async () => {
    const release = await openHeldAtMeasurement();
    await goTo('plane');
    await page.waitForFunction(() => {
      const { sections } = window.karcherPaper;
      const { panels } = sections.find(({ element }) => element.id === 'plane');
      return panels.some(({ settled }) => settled);
    });
    await release();
    await goTo('rational');
    assert.deepEqual(await measured(), [
      ['paper', true],
      ['karcher', true],
      ['leveled', true],
    ]);
  });

  test('a loupe enlarges curves, follows the mouse, moves by keys and can be closed', async () => {
    await open({ query: '?antialias=off&detail=0.02' });
    await goTo('paths');
    const panel = page.locator('#paths .panel-card').first();
    await page.waitForFunction(
      () => window.karcherPaper.sections.find(({ element }) => element.id === 'paths').settled,
    );
    const loupe = panel.locator('.loupe');
    const button = panel.getByRole('button', { name: 'Loupe' });
    assert.equal(await loupe.isVisible(), false);
    await button.click();
    assert.equal(await loupe.isVisible(), true);
    const picture = () => loupe.locator('canvas').evaluate((canvas) => canvas.toDataURL());
    const drawn = async (before) => {
      await page.waitForFunction(
        ([canvas, old]) => canvas.toDataURL() !== old,
        [await loupe.locator('canvas').elementHandle(), before],
      );
      return picture();
    };
    // A canvas has this width until the page draws it.
    await page.waitForFunction(
      (canvas) => canvas.width !== 300,
      await loupe.locator('canvas').elementHandle(),
    );
    let last = await picture();
    await loupe.focus();
    await page.keyboard.press('ArrowRight');
    last = await drawn(last);
    const stage = await panel.locator('.panel-stage').boundingBox();
    await page.mouse.move(stage.x + 0.4 * stage.width, stage.y + 0.6 * stage.height);
    const target = await panel.locator('.loupe-target').boundingBox();
    assert.ok(Math.abs(target.x + target.width / 2 - stage.x - 0.4 * stage.width) < 2);
    await drawn(last);
    await page.mouse.move(2, 2);
    await page.keyboard.press('Escape');
    assert.equal(await loupe.isVisible(), false);
    assert.ok(await button.evaluate((element) => element === document.activeElement));
  });
});
