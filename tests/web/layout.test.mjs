import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab, touchOf } from './browser.mjs';
import { inLongRun, part } from './part.mjs';

describe('the layout of the page', () => {
  const browser = browserOfSuite({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test('a narrow window needs no sideways scroll and has every tool in reach', async () => {
    const tab = await Tab.open(browser);
    const width = await tab.page.evaluate(() => document.scrollingElement.scrollWidth);
    assert.equal(width, 390);
    for (const tool of await tab.page.locator('.rail .tool, .tools .tool, #sheet-handle').all()) {
      const box = await tool.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 390, `${await tool.getAttribute('id')}`);
      assert.ok(box.y >= 0 && box.y + box.height <= 844, `${await tool.getAttribute('id')}`);
    }
    await tab.page.close();
  });

  test('a narrow window leads to the book and to the Paper page, also with the sheet down', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    const handle = page.locator('#sheet-handle');
    for (const stop of ['half', 'collapsed']) {
      await page.waitForFunction((at) => document.documentElement.dataset.sheet === at, stop);
      await page.evaluate(() =>
        Promise.all(document.getAnimations().map((animation) => animation.finished)),
      );
      const title = await page.locator('#sheet-title').boundingBox();
      for (const name of ['Book', 'Paper']) {
        const box = await page.getByRole('link', { name, exact: true }).boundingBox();
        assert.ok(box.height >= 44 && box.width >= 44, `${name} is for a finger`);
        assert.ok(box.x >= title.x + title.width && box.x + box.width <= 390, `${name} ${stop}`);
        assert.ok(box.y + box.height <= 844, `${name} is in sight, ${stop}`);
      }
      if (stop === 'half') await handle.tap({ position: { x: 40, y: 26 } });
    }
    await page.getByRole('link', { name: 'Paper', exact: true }).tap();
    await page.waitForURL(/paper\.html$/);
    await page.close();
  });

  inLongRun('a narrow window has both legends in one strip, with all of their words', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await tab.click([-80, -40], [-20, 60], [40, -40], [90, 50]);
    await page.locator('#points button').first().click();
    await page.locator('#stage').focus();
    await page.keyboard.press('d');
    await page.keyboard.press('u');
    await page.locator('#distance-legend[aria-busy="false"]').waitFor();
    await page.locator('#comb-note').getByText('Greatest').waitFor();
    const [first, second] = [
      await page.locator('#distance-legend').boundingBox(),
      await page.locator('#comb-legend').boundingBox(),
    ];
    assert.deepEqual([first.x, first.width], [second.x, second.width]);
    assert.equal(first.y + first.height, second.y, 'no gap');
    const stage = await page.locator('#stage').boundingBox();
    assert.ok(first.height + second.height < 0.22 * stage.height, `${first.height}`);
    const cut = await page
      .locator('.legend h2, .legend .remark')
      .evaluateAll((words) =>
        words
          .filter((one) => one.scrollWidth > one.clientWidth || one.scrollHeight > one.clientHeight)
          .map((one) => one.textContent),
      );
    assert.deepEqual(cut, []);
    for (const id of ['distance-off', 'comb-off', 'comb-scale']) {
      const { height } = await page.locator(`#${id}`).boundingBox();
      assert.ok(height >= 44, `${id} is for a finger`);
    }
    await tab.close();
  });

  test('a narrow window has facts, repairs, the points and Clear in its sheet', async () => {
    const tab = await Tab.open(browser);
    // Two squares; the second has its own vertices along the common edge.
    await tab.drop(
      'squares.obj',
      `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0
f 1 2 3 4\nf 5 6 7 8\n`,
    );
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 4);
    await tab.click([-30, 0], [30, 10]);
    await tab.page.locator('#facts-line').tap();
    const lists = tab.page.locator('#facts, #repairs li, #points li, #clear, #method');
    assert.ok((await lists.all()).length >= 6);
    for (const part of await lists.all()) {
      await part.scrollIntoViewIfNeeded();
      const box = await part.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 390);
      assert.ok(box.y >= 0 && box.y + box.height <= 844);
    }
    await tab.page.locator('#clear').tap();
    await tab.settled();
    assert.equal((await tab.state()).figure.points.length, 0);
    await tab.close();
  });

  test('the sheet is drawn up and down, and leaves most of the height to the surface', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    const handle = page.locator('#sheet-handle');
    const heights = async (stop) => {
      await page.locator(`html[data-sheet="${stop}"]`).waitFor();
      await page.waitForFunction(() =>
        document.getAnimations().every(({ playState }) => playState !== 'running'),
      );
      const [stage, panel] = [
        await page.locator('#stage').boundingBox(),
        await page.locator('#panel').boundingBox(),
      ];
      assert.ok(stage.height >= 0.6 * 844, `${stop}: ${stage.height}`);
      return { stage, panel };
    };
    const pull = async (to) => {
      const box = await handle.boundingBox();
      const from = { x: box.x + box.width / 2, y: box.y + 20 };
      await tab.drag(from, { x: from.x, y: to });
    };
    const half = await heights('half');
    assert.ok(half.panel.y >= 0.6 * 844, 'all of the surface is seen at first');
    await pull(800);
    const collapsed = await heights('collapsed');
    assert.ok(collapsed.stage.height >= 0.9 * 844);
    await pull(140);
    const full = await heights('full');
    assert.ok(full.panel.height >= 0.8 * 844);
    await handle.tap();
    await heights('collapsed');
    await handle.tap();
    await heights('half');
    await handle.focus();
    await page.keyboard.press('ArrowUp');
    await heights('full');
    await page.keyboard.press('ArrowDown');
    await heights('half');
    assert.equal((await tab.state()).figure.points.length, 0, 'and nothing is drawn by it');
    await tab.close();
  });

  inLongRun('menus are as wide as the longest of their words', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    await page.setViewportSize({ width: 1280, height: 800 });
    await tab.settled();
    const { x, y } = await tab.middle();
    const openers = {
      'examples-menu': () => page.locator('#examples').click(),
      'save-menu': () => page.locator('#save').click(),
      'context-menu': () => page.mouse.click(x, y, { button: 'right' }),
    };
    for (const [id, open] of Object.entries(openers)) {
      await open();
      await page.locator(`#${id}`).waitFor();
      const [width, words] = await page.locator(`#${id}`).evaluate((menu) => {
        const range = document.createRange();
        const widths = [...menu.querySelectorAll('[role="menuitem"]')].map((item) => {
          range.selectNodeContents(item);
          return range.getBoundingClientRect().width;
        });
        return [menu.offsetWidth, Math.max(...widths)];
      });
      // The menu and its items have 36 pixels of padding; a short menu is as wide as a hand needs.
      assert.ok(width <= Math.max(words + 40, 170), `${id}: ${width} for ${words}`);
      await page.keyboard.press('Escape');
    }
    await tab.close();
  });

  for (const kind of part(['bspline', 'pen', 'ellipse', 'center'], 2)) {
    test(`a finger hits every control, with a ${kind}: each has 44 pixels`, async () => {
      const tab = await Tab.open(browser, `mesh=sphere:1500&kind=${kind}`);
      await tab.click([-40, 0], [20, 30], [60, -20], [0, -50]);
      await tab.page.locator('#points button').first().click();
      const folded = tab.page.locator('details:not([open]) > summary').filter({ visible: true });
      while ((await folded.count()) > 0) await folded.first().click();
      const small = await tab.page.evaluate(() => {
        const boxOf = (element) => {
          const label = element.closest('label');
          const isMarked = ['checkbox', 'radio'].includes(element.type) && label;
          return (isMarked ? label : element).getBoundingClientRect();
        };
        return [...document.querySelectorAll('button, select, input, textarea, summary')]
          .filter((element) => element.checkVisibility() && !element.closest('.stage'))
          .map((element) => [element.id || element.className || element.name, boxOf(element)])
          .filter(([, { width, height }]) => width < 44 || height < 44)
          .map(([name, { width, height }]) => `${name}: ${width} x ${height}`);
      });
      assert.deepEqual(small, []);
      await tab.page.close();
    });
  }

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
        await field.scrollIntoViewIfNeeded();
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
    await tab.page.locator('#remove').tap();
    assert.equal((await tab.state()).figure.points.length, 1);
    await tab.close();
  });

  inLongRun('the selected point has its weight in reach', async () => {
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
    const { touch, together } = await touchOf(tab.page);
    await together(
      ['touchStart', { x: x - 40, y }],
      ...[8, 16, 24].map((step) => ['touchMove', { x: x - 40 + step, y: y - step }]),
    );
    // The page casts rays once a frame.
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
    const two = (apart) => [
      { x: x - apart, y: y + 80 },
      { x: x + apart, y: y + 80 },
    ];
    await together(
      ['touchStart', ...two(30)],
      ...[40, 50, 60].map((apart) => ['touchMove', ...two(apart)]),
      ['touchEnd'],
    );
    await tab.still();
    assert.ok((await apart()) > 1.3 * near, 'nearer');
    assert.equal((await tab.state()).figure.points.length, 2, 'and no point is added');
    await tab.close();
  });

  test('the theme follows the system until it is chosen', async () => {
    const tab = await Tab.open(browser);
    const shows = (theme) => tab.page.locator(`html[data-theme="${theme}"]`).waitFor();
    // Lines without a color of their own have the theme's, also in the fields of colors.
    const color = () => tab.page.locator('#fill-color').inputValue();
    const light = await color();
    await tab.page.emulateMedia({ colorScheme: 'dark' });
    await shows('dark');
    assert.notEqual(await color(), light);
    await tab.page.emulateMedia({ colorScheme: 'light' });
    await shows('light');
    assert.equal(await color(), light);
    await tab.page.locator('#view').click();
    await tab.page.getByRole('menuitemcheckbox', { name: 'Dark theme' }).click();
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
  for (const [name, remove] of part(Object.entries(lacks), 1)) {
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
