// The camera's place in links.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { runnerImport } from 'vite';
import { draws } from '../wasm/draws.mjs';
import { openBrowser, Tab, until } from './browser.mjs';
import { inLongRun } from './part.mjs';

const load = async (path) => {
  const file = fileURLToPath(new URL(`../../web/${path}`, import.meta.url));
  const { module } = await runnerImport(file, { configFile: false, logLevel: 'error' });
  return module;
};

describe('a view in a link', () => {
  let model;
  before(async () => {
    const [view, link, problems] = [
      await load('model/view_place.ts'),
      await load('model/link.ts'),
      await load('model/link_problems.ts'),
    ];
    model = { ...view, ...link, ...problems };
  });

  test('is read as it was written, to a pixel', () => {
    const number = (least, most) => fc.double({ min: least, max: most, noNaN: true });
    const orbit = fc.record({
      azimuth: number(-180, 180),
      elevation: number(-90, 90),
      reach: number(0.02, 9),
      target: fc.tuple(number(-9, 9), number(-9, 9), number(-9, 9)),
    });
    fc.assert(
      fc.property(orbit, (view) => {
        const text = model.formatView(view);
        const read = model.parseView(text);
        assert.equal(model.formatView(read), text);
        assert.ok(Math.abs(read.azimuth - view.azimuth) <= 0.00501);
        assert.ok(Math.abs(read.elevation - view.elevation) <= 0.00501);
        assert.ok(Math.abs(read.reach - view.reach) <= 1e-4 * view.reach);
        assert.ok(read.target.every((at, i) => Math.abs(at - view.target[i]) <= 5.01e-6));
      }),
      draws(200),
    );
    for (const name of model.viewNames) assert.equal(model.parseView(name), name);
  });

  test('has no other meaning: numbers out of range are reported', () => {
    const fine = [10, 20, 1, 0, 0, 0];
    const wrong = [
      ...[[181], [NaN], ['']].map((one) => [...one, ...fine.slice(1)]),
      ...[91, -91, 'x'].map((one) => [10, one, 1, 0, 0, 0]),
      ...[0, -1, 11, Infinity].map((one) => [10, 20, one, 0, 0, 0]),
      ...[3, 4, 5].map((at) => fine.with(at, 21)),
      fine.slice(1),
      [...fine, 0],
      ['upwards'],
    ].map((numbers) => numbers.join(','));
    for (const text of [...wrong, '']) {
      assert.equal(model.parseView(text), null, text);
      const [told, ...more] = model.linkProblems(`mesh=sphere:1500&view=${text}`);
      assert.match(told, /^The link's 'view' must be a side, as front, or six numbers: /, text);
      assert.deepEqual(more, []);
      assert.equal(model.parseLink(`mesh=sphere:1500&view=${text}`).view, null);
    }
    assert.deepEqual(model.linkProblems(`mesh=sphere:1500&view=${fine}`), []);
    assert.equal(
      model.formatView({ azimuth: 0, elevation: 0, reach: 1, target: [99, 0, 0] }),
      null,
    );
    assert.equal(model.parseLink('mesh=sphere:1500').view, null);
  });
});

describe('links of the page', () => {
  let browser;
  before(async () => {
    browser = await openBrowser({ viewport: { width: 1280, height: 800 } });
    const permissions = ['clipboard-read', 'clipboard-write'];
    await browser.context.grantPermissions(permissions, { origin: browser.address });
  });
  after(() => browser.close());

  const link = 'mesh=torus:5000&kind=bspline&method=karcher-fast&points=10,0.3,0.3;900,0.2,0.3';
  /** The places of some vertices in the window; null for hidden ones. */
  const seen = async (tab) => {
    await tab.still();
    return tab.page.evaluate(async () => {
      const { positions } = await window.karcherPage.mesh();
      const count = positions.length / 3;
      return Array.from({ length: 300 }, (_, i) => {
        const at = 3 * Math.floor((i * count) / 300);
        return window.karcherPage.seen(positions.subarray(at, at + 3));
      });
    });
  };
  const farthest = (a, b) => {
    let most = 0;
    let both = 0;
    for (const [i, place] of a.entries()) {
      if (!place || !b[i]) continue;
      both++;
      most = Math.max(most, Math.hypot(place.x - b[i].x, place.y - b[i].y));
    }
    assert.ok(both > 15);
    return most;
  };
  const copied = async (tab) => {
    await tab.page.locator('#share').click();
    await tab.page.getByText('Link copied.').first().waitFor();
    return tab.page.evaluate(() => navigator.clipboard.readText());
  };

  test('open with the view with which they were copied', async () => {
    const tab = await Tab.open(browser, link);
    const { page } = tab;
    const usual = await seen(tab);
    assert.ok(!(await copied(tab)).includes('view='), 'the usual view goes without saying');
    const { x, y } = await tab.middle();
    await tab.drag({ x: x + 200, y: y + 250 }, { x: x + 290, y: y + 190 });
    await page.mouse.move(x - 80, y - 60);
    await page.mouse.wheel(0, -240);
    const turned = await seen(tab);
    assert.ok(farthest(usual, turned) > 40);
    const address = await copied(tab);
    assert.match(address, /&view=[-\d.,]+/);
    await page.waitForFunction((text) => location.href === text, address);
    const second = await Tab.open(browser, address.split('#')[1]);
    assert.ok(farthest(turned, await seen(second)) < 1);
    assert.equal(await copied(second), address, 'a link of a link is the same');
    await second.page.reload();
    await second.settled();
    assert.ok(farthest(turned, await seen(second)) < 1, 'also after a reload');
    // A link to the visible surface shows the same drawing from elsewhere.
    await second.page.evaluate((text) => {
      location.hash = text;
    }, `${link}&view=top`);
    const was = JSON.stringify(turned);
    await until(async () => JSON.stringify(await seen(second)) !== was, 'the view is another one');
    await page.locator('#view').click();
    await page.getByRole('menuitem', { name: 'Top' }).click();
    assert.ok(farthest(await seen(tab), await seen(second)) < 1);
    assert.match(await copied(tab), /&view=top$/);
    await page.keyboard.press('r');
    await tab.still();
    assert.ok(!(await copied(tab)).includes('view='));
    assert.deepEqual([...tab.logged, ...second.logged], []);
    await second.page.close();
    await page.close();
  });

  test('and files of drawings open with the view with which they were saved', async () => {
    const tab = await Tab.open(browser, link);
    const { page } = tab;
    const usual = await seen(tab);
    assert.ok(!JSON.parse((await tab.save('JSON')).text).link.includes('view='));
    const { x, y } = await tab.middle();
    await tab.drag({ x: x + 200, y: y + 250 }, { x: x + 290, y: y + 190 });
    const turned = await seen(tab);
    assert.ok(farthest(usual, turned) > 40);
    const { name, text } = await tab.save('JSON');
    assert.match(JSON.parse(text).link, /&view=[-\d.,]+(&|$)/);

    const elsewhere = await Tab.open(browser);
    await elsewhere.drop(name, text);
    await elsewhere.page.waitForFunction(() => window.karcherPage.state().mesh === 'torus:5000');
    await elsewhere.settled();
    assert.ok(farthest(turned, await seen(elsewhere)) < 1, 'on another surface');
    await page.keyboard.press('r');
    await until(async () => farthest(usual, await seen(tab)) < 1, 'the view is the usual one');
    await tab.drop(name, text);
    await until(async () => farthest(turned, await seen(tab)) < 1, 'the view is that of the file');
    assert.deepEqual([...tab.logged, ...elsewhere.logged], []);
    await elsewhere.page.close();
    await page.close();
  });

  inLongRun(
    'of older versions have the default view, and an impossible view is reported',
    async () => {
      const tab = await Tab.open(browser, link);
      const usual = await seen(tab);
      await tab.page.close();
      const wrong = await Tab.open(browser, `${link}&view=10,20,99,0,0,0`);
      const alert = wrong.page.getByRole('alert');
      assert.match(await alert.innerText(), /'view' must be .*not '10,20,99,0,0,0'/s);
      assert.ok(farthest(usual, await seen(wrong)) < 1);
      assert.equal((await wrong.state()).figure.points.length, 2, 'the drawing is there');
      await wrong.close();
    },
  );

  inLongRun('show the same in a narrow window and in a wide one', async () => {
    const wide = await Tab.open(browser, `${link}&view=30,40,0.9,0.05,0,0`);
    const inWide = (await seen(wide)).filter((place) => place !== null);
    await wide.page.close();
    const narrow = await Tab.open(browser, 'mesh=sphere:1500');
    await narrow.page.setViewportSize({ width: 390, height: 844 });
    await narrow.page.evaluate((text) => {
      location.hash = text;
    }, `${link}&view=30,40,0.9,0.05,0,0`);
    await narrow.page.waitForFunction(() => window.karcherPage.state().mesh === 'torus:5000');
    await narrow.settled();
    const places = (await seen(narrow)).filter((place) => place !== null);
    const box = await narrow.page.locator('#stage').boundingBox();
    assert.ok(Math.abs(places.length - inWide.length) <= 25);
    assert.ok(places.every(({ x, y }) => x >= 0 && x <= 390 && y >= box.y && y <= box.height));
    await narrow.close();
  });
});
