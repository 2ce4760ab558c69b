// A technician's trim line: a scan of a limb, a closed line around it, a cut 2 mm beside the line,
// and a shell for printing. It takes at most 15 clicks and drags besides the line itself.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';

const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

/**
 * An open limb of 40 mm, slightly thicker at one end and uneven everywhere, as a file in
 * millimeters.
 */
function limb(around = 72, along = 60) {
  const place = (i, j) => {
    const [angle, height] = [(2 * Math.PI * i) / around, (j / along - 0.5) * 240];
    const uneven = 0.8 * Math.sin(3 * angle + height / 25) * Math.cos(height / 40);
    const radius = 40 + 8 * (height / 240) + uneven;
    return [radius * Math.sin(angle), height, radius * Math.cos(angle)];
  };
  const lines = [];
  const facet = (...corners) =>
    lines.push(
      'facet normal 0 0 0',
      'outer loop',
      ...corners.map((c) => `vertex ${c.join(' ')}`),
      'endloop',
      'endfacet',
    );
  for (let j = 0; j < along; j++) {
    for (let i = 0; i < around; i++) {
      const next = (i + 1) % around;
      const [a, b, c, d] = [place(i, j), place(next, j), place(next, j + 1), place(i, j + 1)];
      facet(a, b, c);
      facet(a, c, d);
    }
  }
  return ['solid limb', ...lines, 'endsolid'].join('\n');
}

inLongRun(
  'a limb is cut 2 mm beside a line around it, thickened and saved, in at most 15 clicks and drags',
  async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:500');
    const { page } = tab;
    let hands = 0;
    const click = async (locator) => {
      hands++;
      await locator.scrollIntoViewIfNeeded();
      await locator.click();
      await tab.settled();
    };
    const button = (name) => page.getByRole('button', { name, exact: true });
    const choosing = page.waitForEvent('filechooser');
    await click(button('Open file…'));
    await (await choosing).setFiles({
      name: 'limb.stl',
      mimeType: 'model/stl',
      buffer: Buffer.from(limb()),
    });
    await page.waitForFunction(() => window.karcherPage.triangles > 8000);
    await tab.settled();
    // The line: three places in front, three behind.
    await click(page.locator('#tool-curve'));
    const { x, y } = await tab.middle();
    const line = async () => {
      for (const dx of [-60, 0, 60]) {
        await page.mouse.click(x + dx, y + 20);
        await tab.settled();
      }
    };
    await line();
    hands++;
    const from = { x: x - 280, y: y + 250 };
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    // The view turns half around, until the hidden side is in the middle.
    const middle = () => page.evaluate(() => window.karcherPage.seen([0, 10, -43])?.x ?? null);
    for (let at = 0; at < 900; at += 20) {
      await page.mouse.move(from.x + at, from.y);
      await tab.still();
      const there = await middle();
      if (there !== null && Math.abs(there - x) < 25) break;
    }
    await page.mouse.up();
    assert.ok(Math.abs((await middle()) - x) < 25);
    await line();
    hands++;
    await page.locator('#closed').check();
    await tab.settled();
    const { curve } = await tab.view();
    const round = 2 * Math.PI * 40;
    assert.ok(curve.length > round && curve.length < 1.25 * round, `${curve.length}`);
    assert.match(await page.locator('#status-length').textContent(), /^length .* mm/);

    await click(button('Offset'));
    await page.keyboard.type('2');
    await page.keyboard.press('Enter');
    await tab.settled();
    assert.equal((await tab.view()).isolines.lines.length, 1);
    await click(button('Cut'));
    const { parts } = (await tab.view()).cut;
    assert.equal(parts.length, 2);
    await click(button('Delete Part 1'));
    await click(page.locator('#thickness'));
    await page.keyboard.press('Control+a');
    await page.keyboard.type('3');
    await page.keyboard.press('Enter');
    await tab.settled();
    const coming = page.waitForEvent('download');
    await click(button('Save the parts'));
    const bytes = readFileSync(await (await coming).path());
    const { thick, area } = (await tab.view()).cut.parts[1];
    assert.ok(thick.closed);
    assert.equal(thick.most, null);
    assert.equal(bytes.readUInt32LE(80), thick.triangles.length / 3);
    // The volume is 3 mm times the area, and more where the surface is convex.
    assert.ok(thick.volume > 3 * area && thick.volume < 3.2 * area, `${thick.volume} ${area}`);
    assert.ok(hands <= 15, `${hands} clicks and drags`);
    console.log(`${hands} clicks and drags beside the line`);
    await tab.close();
  },
);
