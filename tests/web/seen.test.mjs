// That what is drawn is seen: the pixels of the stage.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';

describe('the picture on the stage', () => {
  let browser;
  before(async () => {
    browser = await openBrowser({ pixelRatio: 1 });
  });
  after(() => browser.close());

  /** How much bluer than red the window is, at most, within a few pixels of a place: 0 to 255. */
  async function bluest(page, { x, y }) {
    const reach = 3;
    const clip = { x: x - reach, y: y - reach, width: 2 * reach + 1, height: 2 * reach + 1 };
    const png = [...(await page.screenshot({ clip }))];
    return page.evaluate(async (bytes) => {
      const image = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      let most = 0;
      for (let i = 0; i < data.length; i += 4) most = Math.max(most, data[i + 2] - data[i]);
      return most;
    }, png);
  }

  test('has the whole curve in its color, and nothing of it beside', async () => {
    const tab = await Tab.open(browser, 'mesh=torus:2000');
    await tab.choose('bspline');
    await tab.click([-200, 60], [-100, 160], [50, 170], [200, 40]);
    await tab.still();
    for (const part of [0.1, 0.3, 0.5, 0.7, 0.9]) {
      const place = await tab.onCurve(part);
      const [on, beside] = [
        await bluest(tab.page, place),
        await bluest(tab.page, { x: place.x, y: place.y - 60 }),
      ];
      assert.ok(on > 60, `${on} at ${part} of the curve`);
      assert.ok(beside < 40, `${beside} beside it`);
    }
    await tab.page.close();
  });
});
