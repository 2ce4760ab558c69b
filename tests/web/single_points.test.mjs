// Objects of single points are visible and can be selected, edited or not.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { figure, load, point } from './figures.mjs';

describe('single points', () => {
  const browser = browserOfSuite();

  test('of the edited object can be clicked when nothing is selected', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=points');
    const { page } = tab;
    await tab.click([-60, 20], [40, -30]);
    const place = await tab.handle('Point 2 of 2');
    await page.keyboard.press('v');
    for (let i = 0; i < 3; i++) await page.keyboard.press('Escape');
    await tab.settled();
    assert.equal((await tab.state()).none, true);
    assert.equal(await page.locator('.handle').count(), 0);
    await page.mouse.click(place.x, place.y);
    await tab.settled();
    const { none, chosen } = await tab.state();
    assert.equal(none, false, 'a click on a dot selects its object');
    assert.equal(chosen.length, 1);
    assert.equal(await page.locator('.handle').count(), 2);
    await tab.close();
  });

  test('do not draw other objects anew while one of them is dragged', async () => {
    const { newObject } = await load('model/drawing.ts');
    const { formatLink } = await load('model/link.ts');
    const kinds = ['points', 'bspline'];
    const others = Array.from({ length: 50 }, (_, i) => {
      const points = [1, 2, 3, 4].map((k) => point((97 * i + k) % 1400));
      return newObject(i + 2, { ...figure, kind: kinds[i % 2], points });
    });
    const uploads = [];
    for (const beside of [[], others]) {
      const own = newObject(1, { ...figure, kind: 'points', points: [] });
      const objects = [...beside, own];
      const link = formatLink('sphere:1500', 'karcher-fast', { objects, active: 1 });
      const tab = await Tab.open(browser, link);
      const { page } = tab;
      await tab.click([-60, 20], [40, -30]);
      const { x, y } = await tab.handle('Point 2 of 2');
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 5, y);
      await tab.settled();
      // The largest upload of a line's places to the graphics during the drag, in floats.
      await page.evaluate(() => {
        window.most = 0;
        const { prototype } = WebGL2RenderingContext;
        for (const name of ['bufferData', 'bufferSubData']) {
          const upload = prototype[name];
          prototype[name] = function (...all) {
            const count = name === 'bufferData' ? all[1].length : (all[4] ?? all[2].length);
            window.most = Math.max(window.most, count);
            return upload.apply(this, all);
          };
        }
      });
      for (let step = 2; step < 10; step++) {
        await page.mouse.move(x + 5 * step, y);
        await tab.settled();
      }
      await page.waitForFunction(() => window.karcherPage.still);
      uploads.push(await page.evaluate(() => window.most));
      await page.mouse.up();
      await tab.close();
    }
    const [alone, withOthers] = uploads;
    assert.ok(alone > 0, `${alone}`);
    assert.equal(withOthers, alone);
  });

  test('of the edited object are in an SVG, selected or not', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=points');
    await tab.click([-60, 20], [40, -30]);
    const circles = async () => (await tab.save('SVG')).text.match(/<circle/g)?.length;
    assert.equal(await circles(), 2);
    await tab.page.keyboard.press('v');
    for (let i = 0; i < 3; i++) await tab.page.keyboard.press('Escape');
    await tab.settled();
    assert.equal((await tab.state()).none, true);
    assert.equal(await circles(), 2);
    await tab.close();
  });
});
