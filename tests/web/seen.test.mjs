// The drawing is visible: the pixels of the stage show it.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';

describe('the picture on the stage', () => {
  const browser = browserOfSuite({ asUsers: true });

  /** The largest excess of blue over red within a few pixels of a place of the window: 0 to 255. */
  async function bluest(tab, { x, y }) {
    const reach = 3;
    const side = 2 * reach + 1;
    const colors = await tab.pixels({ x: x - reach, y: y - reach, width: side, height: side });
    return Math.max(0, ...colors.map(([red, , blue]) => blue - red));
  }

  test('has the whole curve in its color, and nowhere else', async () => {
    const tab = await Tab.open(browser, 'mesh=torus:2000');
    await tab.choose('bspline');
    await tab.click([-200, 60], [-100, 160], [50, 170], [200, 40]);
    await tab.still();
    for (const part of [0.1, 0.3, 0.5, 0.7, 0.9]) {
      const place = await tab.onCurve(part);
      const [on, beside] = [
        await bluest(tab, place),
        await bluest(tab, { x: place.x, y: place.y - 60 }),
      ];
      assert.ok(on > 60, `${on} at ${part} of the curve`);
      assert.ok(beside < 40, `${beside} beside it`);
    }
    await tab.page.close();
  });
});
