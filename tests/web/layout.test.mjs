import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';
import { part } from './part.mjs';

describe('where the page is shown', () => {
  let browser;
  before(async () => {
    browser = await openBrowser({ viewport: { width: 390, height: 844 }, hasTouch: true });
  });
  after(() => browser.close());

  test('a narrow window has no sideways scroll and every tool in reach', async () => {
    const tab = await Tab.open(browser);
    const width = await tab.page.evaluate(() => document.scrollingElement.scrollWidth);
    assert.equal(width, 390);
    const tools = tab.page.locator('button:visible, select:visible, .segments label:visible');
    for (const tool of await tools.all()) {
      const box = await tool.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 390, `${await tool.textContent()}`);
      assert.ok(box.y >= 0 && box.y + box.height <= 844, `${await tool.textContent()}`);
    }
    await tab.page.close();
  });

  test('a narrow window has facts, repairs, the points and Clear on demand', async () => {
    const tab = await Tab.open(browser);
    // Two squares, the second with vertices of its own along the common edge.
    await tab.drop(
      'squares.obj',
      `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0
f 1 2 3 4\nf 5 6 7 8\n`,
    );
    await tab.page.waitForFunction(() => window.karcherPage.mesh().info.triangles === 4);
    await tab.page.getByText('Method', { exact: true }).waitFor();
    await tab.click([-30, 0], [30, 10]);
    const more = tab.page.getByRole('button', { name: 'Details' });
    const lists = tab.page.locator('#facts, #repairs li, #points li, #clear');
    assert.ok((await lists.all()).length >= 6);
    for (const part of await lists.all()) assert.equal(await part.isVisible(), false);
    await more.tap();
    assert.equal(await more.getAttribute('aria-expanded'), 'true');
    for (const part of await lists.all()) {
      await part.scrollIntoViewIfNeeded();
      const box = await part.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 390);
      assert.ok(box.y >= 0 && box.y + box.height <= 844);
    }
    const stage = await tab.page.locator('#stage').boundingBox();
    assert.ok(stage.height > 0.3 * 844, 'and the surface is still seen');
    await tab.page.locator('#clear').tap();
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 0);
    await more.tap();
    assert.equal(await tab.page.locator('#facts').isVisible(), false);
    assert.deepEqual(tab.logged, []);
    await tab.page.close();
  });

  test('a narrow window shows the whole width of a surface', async () => {
    for (const mesh of part(['genus3:5000', 'sphere:1500', 'openSheet:5000', 'knot:5000'], 2)) {
      const tab = await Tab.open(browser, `mesh=${mesh}`);
      const { positions } = await tab.mesh();
      const seen = await tab.page.evaluate((all) => {
        const places = [];
        for (let i = 0; i < all.length; i += 3) {
          const place = window.karcherPage.seen(all.slice(i, i + 3));
          if (place) places.push(place.x);
        }
        return places;
      }, positions);
      const [least, most] = [Math.min(...seen), Math.max(...seen)];
      assert.ok(least >= 0 && most <= 390, `${mesh}: ${least} to ${most}`);
      assert.ok(most - least > 0.6 * 390, `${mesh} fills ${most - least} pixels`);
      await tab.page.close();
    }
  });

  for (const kind of part(['circle', 'ellipse'], 1)) {
    test(`a narrow window has every setting of the ${kind} in reach`, async () => {
      const tab = await Tab.open(browser, `mesh=sphere:1500&kind=${kind}`);
      await tab.click([0, 0]);
      const fields = tab.page.locator('#circle-settings :is(select, input, .remark):visible');
      assert.equal(await fields.count(), 4);
      for (const field of await fields.all()) {
        const box = await field.boundingBox();
        assert.ok(box.x >= 0 && box.x + box.width <= 390);
        assert.ok(box.y >= 0 && box.y + box.height <= 844);
      }
      const stage = await tab.page.locator('#stage').boundingBox();
      assert.ok(stage.height > 0.5 * 844, 'and the surface has most of the room');
      await tab.page.close();
    });
  }

  test('fingers place and remove points', async () => {
    const tab = await Tab.open(browser);
    const { x, y } = await tab.middle();
    await tab.page.touchscreen.tap(x - 40, y);
    await tab.page.touchscreen.tap(x + 40, y + 10);
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 2);
    await tab.page.getByRole('button', { name: 'Delete' }).tap();
    assert.equal((await tab.state()).figure.points.length, 1);
    assert.deepEqual(tab.logged, []);
    await tab.page.close();
  });

  test('the selected point has its weight in reach', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=center');
    const { x, y } = await tab.middle();
    await tab.page.touchscreen.tap(x - 40, y);
    await tab.page.touchscreen.tap(x + 40, y + 10);
    await tab.settled();
    const slider = tab.page.locator('#notice').getByRole('slider', { name: 'Weight of point 2' });
    await slider.fill('48');
    await tab.settled();
    const { points } = (await tab.state()).figure;
    assert.deepEqual(
      points.map(({ weight = 1 }) => weight),
      [1, 4],
    );
    await tab.page.close();
  });

  test('a finger drags a point, and two zoom', async () => {
    const tab = await Tab.open(browser);
    const { x, y } = await tab.middle();
    await tab.page.touchscreen.tap(x - 40, y);
    await tab.page.touchscreen.tap(x + 40, y + 10);
    await tab.settled();
    const before = (await tab.state()).figure.points;
    const protocol = await tab.page.context().newCDPSession(tab.page);
    const touch = (type, ...places) =>
      protocol.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: places.map(([px, py], id) => ({ x: px, y: py, id })),
      });
    await touch('touchStart', [x - 40, y]);
    for (const step of [8, 16, 24]) await touch('touchMove', [x - 40 + step, y - step]);
    // Rays are cast once a frame.
    await tab.page.waitForFunction(() => window.karcherPage.state().dragging);
    await touch('touchEnd');
    await tab.settled();
    const { points } = (await tab.state()).figure;
    assert.equal(points.length, 2);
    assert.notDeepEqual(points[0], before[0]);
    assert.deepEqual(points[1], before[1]);
    const handle = await tab.handle('Control point 1 of 2');
    assert.ok(Math.hypot(handle.x - (x - 16), handle.y - (y - 24)) < 3, 'it is under the finger');

    const apart = async () => {
      const [a, b] = [
        await tab.handle('Control point 1 of 2'),
        await tab.handle('Control point 2 of 2'),
      ];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    const near = await apart();
    await touch('touchStart', [x - 30, y + 80], [x + 30, y + 80]);
    for (const step of [10, 20, 30]) {
      await touch('touchMove', [x - 30 - step, y + 80], [x + 30 + step, y + 80]);
    }
    await touch('touchEnd');
    await tab.still();
    assert.ok((await apart()) > 1.3 * near, 'nearer');
    assert.equal((await tab.state()).figure.points.length, 2, 'and no point is added');
    assert.deepEqual(tab.logged, []);
    await tab.page.close();
  });

  test('the theme follows the system until it is chosen', async () => {
    const tab = await Tab.open(browser);
    const shows = (theme) => tab.page.locator(`html[data-theme="${theme}"]`).waitFor();
    await tab.page.emulateMedia({ colorScheme: 'dark' });
    await shows('dark');
    await tab.page.emulateMedia({ colorScheme: 'light' });
    await shows('light');
    await tab.page.getByRole('button', { name: 'Dark theme' }).click();
    await tab.page.reload();
    await tab.settled();
    await shows('dark');
    await tab.page.close();
  });

  test('the help opens by its key and closes', async () => {
    const tab = await Tab.open(browser);
    await tab.page.keyboard.press('?');
    const dialog = tab.page.getByRole('dialog', { name: 'Working on a surface' });
    await dialog.waitFor();
    await tab.page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
    await tab.page.close();
  });

  const lacks = {
    WebAssembly: () => {
      delete window.WebAssembly;
    },
    'WebGL 2': () => {
      HTMLCanvasElement.prototype.getContext = () => null;
    },
  };
  for (const [name, remove] of Object.entries(lacks)) {
    test(`a browser without ${name} gets a page that says so`, async () => {
      const page = await browser.context.newPage();
      const errors = [];
      page.on('pageerror', (error) => errors.push(`${error}`));
      await page.addInitScript(remove);
      await page.goto(browser.address);
      const box = page.locator('#unsupported');
      await box.waitFor();
      assert.match(await box.textContent(), new RegExp(`${name}, which`));
      assert.equal(await page.locator('#app').isVisible(), false);
      assert.deepEqual(errors, []);
      await page.close();
    });
  }
});
