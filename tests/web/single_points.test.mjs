// Objects of single points are visible and can be selected, edited or not.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';

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
