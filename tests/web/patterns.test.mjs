// Fills hatched or striped by distances: on the page, in files, links and the history.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';

describe('patterns of fills', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const square = [
    [-90, -90],
    [90, -90],
    [90, 90],
    [-90, 90],
  ];
  async function drawn(mesh) {
    const tab = await Tab.open(browser, `mesh=${mesh}&kind=polyline`);
    await tab.click(...square);
    await tab.page.locator('#closed').check();
    await tab.settled();
    return tab;
  }
  async function choose(tab, pattern, spacing) {
    await tab.page.locator('#pattern').selectOption(pattern);
    if (spacing !== undefined) {
      await tab.page.locator('#pattern-spacing').fill(`${spacing}`);
      await tab.page.keyboard.press('Enter');
    }
    await tab.page.locator('#pattern').blur();
    await tab.settled();
  }
  /** The area of the painted triangles in an SVG, in pixels. */
  async function paintedArea(tab) {
    const { text } = await tab.save('SVG');
    const [, path] = /<path fill="[^"]+" fill-opacity="[^"]+" d="([^"]*)"/.exec(text);
    return path
      .split('Z')
      .slice(0, -1)
      .reduce((sum, triangle) => {
        const [ax, ay, bx, by, cx, cy] = triangle.match(/-?[\d.]+/g).map(Number);
        return sum + ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
      }, 0);
  }

  test('cover the right part of the area, on a plane', async () => {
    const tab = await drawn('plane:grid:200');
    await tab.page.locator('#fill').fill('50');
    await tab.page.keyboard.press('Enter');
    await tab.settled();
    const whole = await paintedArea(tab);
    const { region } = (await tab.view()).fill;
    const side = Math.sqrt(region.area);
    await choose(tab, 'hatched', side / 16);
    const hatched = (await paintedArea(tab)) / whole;
    assert.ok(Math.abs(hatched - 1 / 4) < 0.02, `${hatched}`);
    // The first and the third of four bands along the border of a square.
    await choose(tab, 'striped', side / 8);
    const striped = (await paintedArea(tab)) / whole;
    assert.ok(Math.abs(striped - (1 - 9 / 16 + 4 / 16 - 1 / 16)) < 0.02, `${striped}`);
    await tab.close();
  });

  test('and units of widths that several objects take leave each its own numbers', async () => {
    const styled = (width, spacing, points) =>
      `kind=polyline&closed=1&points=${points}&width=${width}&fill=0.5&hatched=${spacing}`;
    const [first, second] = [
      '10,0.3,0.3;60,0.3,0.3;65,0.3,0.3',
      '110,0.3,0.3;160,0.3,0.3;165,0.3,0.3',
    ];
    const others = [styled(2, 0.01, first), 'kind=union&of=1,2&width=4&fill=0.5&hatched=0.02'];
    const tab = await Tab.open(
      browser,
      [`mesh=plane:grid:200&${styled(8, 0.03, second)}`, ...others.map(encodeURIComponent)].join(
        '&other=',
      ),
    );
    const { page } = tab;
    const objects = async () => (await tab.state()).drawing.objects;
    const before = await objects();
    assert.equal(before.length, 3);
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await page.locator('#width-unit').selectOption('surface');
    await tab.settled();
    const inUnit = await objects();
    assert.ok(inUnit.every(({ onSurface }) => onSurface));
    const reaches = inUnit.map(({ width }, i) => width / before[i].width);
    assert.ok(Math.max(...reaches) < 1.1 * Math.min(...reaches), `${reaches}`);
    await choose(tab, 'striped');
    assert.deepEqual(
      (await objects()).map(({ pattern, spacing }) => [pattern, spacing]),
      before.map(({ spacing }) => ['striped', spacing]),
    );
    for (let step = 0; step < 2; step++) await page.keyboard.press('Control+z');
    assert.deepEqual(await objects(), before);
    await tab.close();
  });

  test('are undone, follow a drag, and are restored by a reload and by a link', async () => {
    const tab = await drawn('sphere:1500');
    const before = JSON.stringify((await tab.state()).drawing);
    await choose(tab, 'hatched');
    const [{ fill, pattern, spacing }] = (await tab.state()).drawing.objects;
    assert.deepEqual([fill, pattern], [0.5, 'hatched']);
    assert.ok(spacing > 0);
    const from = await tab.handle('Control point 1 of 4');
    await tab.drag(from, { x: from.x - 30, y: from.y - 20 });
    const shown = await paintedArea(tab);
    await tab.pastSaving();
    await tab.page.reload();
    await tab.settled();
    assert.equal((await tab.state()).drawing.objects[0].pattern, 'hatched');
    assert.ok(Math.abs((await paintedArea(tab)) / shown - 1) < 1e-6);
    for (let step = 0; step < 2; step++) await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), before);
    await tab.close();
  });

  inLongRun('stay solid if they would have too many lines', async () => {
    const tab = await drawn('plane:grid:200');
    await choose(tab, 'solid');
    await tab.page.locator('#fill').fill('50');
    await tab.page.keyboard.press('Enter');
    await tab.settled();
    const whole = await paintedArea(tab);
    await choose(tab, 'striped', 1e-9);
    assert.ok(Math.abs((await paintedArea(tab)) / whole - 1) < 1e-6);
    const hint = () => tab.page.locator('#hint').textContent();
    assert.match(await hint(), /stays solid.*more than 1,000 lines/);
    await choose(tab, 'striped', 0.000125);
    const spacing = tab.page.locator('#pattern-spacing');
    assert.equal(await spacing.inputValue(), '0.000125');
    assert.ok(await spacing.evaluate((input) => input.scrollWidth <= input.clientWidth));
    await choose(tab, 'striped', 0.1);
    assert.doesNotMatch(await hint(), /solid/);
    await tab.close();
  });
});
