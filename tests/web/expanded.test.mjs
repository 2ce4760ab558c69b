// Expanded booleans remember the objects that their pieces come from.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { fitsFile } from './schema.mjs';

describe('expanded booleans', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });
  const drawingOf = async (tab) => (await tab.state()).drawing;
  const bytesOf = async (tab) => JSON.stringify(await drawingOf(tab));
  const maker = (tab, name) =>
    tab.page.locator('#makers').getByRole('button', { name, exact: true });
  const inSteps = async (tab, count, key) => {
    for (let step = 0; step < count; step++) await tab.page.keyboard.press(key);
    await tab.settled();
  };

  /** Two circles on a sphere and their union with a fill. */
  async function withUnion() {
    const tab = await Tab.open(browser, 'mesh=sphere:3000&kind=circle');
    const { page } = tab;
    const { x, y } = await tab.middle();
    await tab.drag({ x: x - 60, y: y - 20 }, { x: x, y: y - 20 });
    await page.keyboard.press('Enter');
    await page.keyboard.press('o');
    await tab.drag({ x: x + 20, y: y + 30 }, { x: x + 80, y: y + 30 });
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await page.locator('#fill').fill('40');
    await page.keyboard.press('Enter');
    await maker(tab, 'Union').click();
    await tab.settled();
    await page.keyboard.press('Escape');
    await page.locator('#stage').focus();
    return tab;
  }

  test('an expanded boolean remembers its operands, through undo, copies, a file and a reload', async () => {
    const tab = await withUnion();
    const { page } = tab;
    await page.keyboard.press('v');
    for (const [row, name] of [
      [2, 'Heart'],
      [1, 'Ring'],
    ]) {
      await page.locator('#objects .object').nth(row).click();
      await page.locator('#object-name').fill(name);
      await page.keyboard.press('Enter');
    }
    await page.locator('#objects .object').nth(0).click();
    await tab.settled();
    const before = JSON.stringify((await drawingOf(tab)).objects);
    await page.locator('#expand').click();
    await tab.settled();
    const { objects, active } = await drawingOf(tab);
    const { figure } = objects.find(({ id }) => id === active);
    assert.equal(figure.kind, 'pen');
    const origins = figure.points.map(({ origin }) => origin);
    assert.deepEqual(new Set(origins.map(({ of }) => of)), new Set(['Heart', 'Ring']));
    // Each circle gives one run of pieces, which follow each other on its line.
    const changes = origins.filter(({ of }, i) => of !== origins.at(i - 1).of);
    assert.equal(changes.length, 2);
    origins.forEach(({ of, from, to }, i) => {
      assert.ok(from !== to && from >= 0 && to <= 1);
      const next = origins[(i + 1) % origins.length];
      const gap = Math.abs(next.from - to);
      if (next.of === of) assert.ok(Math.min(gap, Math.abs(1 - gap)) < 1e-5, `${to} ${next.from}`);
    });
    assert.equal(
      await page.locator('#origins').textContent(),
      `From ${origins[0].of}, from ${origins.find(({ of }) => of !== origins[0].of).of}`,
    );
    const svg = await tab.save('SVG');
    assert.match(svg.text, /<desc>from (Heart, from Ring|Ring, from Heart)<\/desc>/);
    const saved = await tab.save(/^JSON the whole/);
    assert.ok(fitsFile(JSON.parse(saved.text)), JSON.stringify(fitsFile.errors));
    assert.ok(saved.text.includes('"origin"'));
    await page.locator('#stage').focus();
    await page.keyboard.press('Control+d');
    await tab.settled();
    const copy = (await drawingOf(tab)).objects.at(-1);
    assert.deepEqual(
      copy.figure.points.map(({ origin }) => origin),
      origins,
    );
    await inSteps(tab, 2, 'Control+z');
    // A step back also takes back the selection before the step.
    const objectsNow = async () => JSON.stringify((await drawingOf(tab)).objects);
    assert.equal(await objectsNow(), before);
    await inSteps(tab, 1, 'Control+Shift+z');
    await tab.pastSaving();
    const made = await bytesOf(tab);
    await page.reload();
    await tab.settled();
    assert.equal(await bytesOf(tab), made);
    await page.locator('#stage').focus();
    await inSteps(tab, 1, 'Control+z');
    assert.equal(await objectsNow(), before);
    await tab.close();
  });
});
