// axe finds no fault with the page for users of a keyboard or a screen reader, in all its panels
// and states.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';
import { inLongRun, long } from './part.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const sizes = { desk: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } };

/** The violated rules, each with the elements that violate it. */
async function violations(page) {
  if (await page.evaluate(() => window.axe === undefined)) await page.evaluate(axe);
  // Half faded elements have the colors of neither state.
  await page.waitForFunction(() =>
    document
      .getAnimations()
      .every(({ playState, effect }) =>
        playState === 'running' ? effect.getComputedTiming().iterations === Infinity : true,
      ),
  );
  // Searching the selectors of elements takes long, and only violations need them.
  const found = (selectors) =>
    page.evaluate(
      (options) => window.axe.run(document, { resultTypes: ['violations'], ...options }),
      { selectors },
    );
  const { passes, violations: wrong } = await found(false);
  assert.ok(passes.length > 10, 'axe has looked');
  if (wrong.length === 0) return [];
  return (await found(true)).violations.map(({ id, nodes }) => [
    ...[id, ...nodes.map(({ target }) => `${target}`)],
  ]);
}

/** States that are similar in all sizes: a group, messages, and derived objects. */
async function lookFurther(browser, tab, look) {
  const { page } = tab;
  const { x, y } = await tab.middle();
  await page.keyboard.press('Escape');
  await tab.drag({ x: x - 60, y: y - 60 }, { x: x - 30, y: y - 60 });
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Control+g');
  await look('a group', tab);
  await page.locator('#objects .fold').first().click();
  await look('a folded group', tab);
  await page.keyboard.press('m');
  await tab.click([-60, 0], [40, 20]);
  await look('the ruler', tab);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await look('nothing selected', tab);
  await tab.drop('bad.obj', 'nothing');
  await page.getByRole('alert').waitFor();
  await page.locator('#progress').waitFor({ state: 'hidden' });
  await look('a message', tab);
  await page.getByRole('alert').getByRole('button', { name: 'Dismiss' }).click();
  const two = ['one.obj', 'two.obj'].map((file) => [file, new TextEncoder().encode('none')]);
  await tab.dropFiles(two);
  await page.locator('#which-dialog').waitFor();
  await look('several files', tab);

  const made = await Tab.open(
    browser,
    [
      'mesh=sphere:1500&kind=circle&circle=100,0.3,0.3;0.5,1,0,0',
      `other=${encodeURIComponent('kind=circle&circle=110,0.3,0.3;0.5,1,0,0')}`,
    ].join('&'),
  );
  for (const maker of ['Union', 'Offset', 'Cut']) {
    await made.page.locator('#stage').press('Control+a');
    await made.page.locator('#makers').getByRole('button', { name: maker }).click();
    await made.settled();
    await look(maker, made);
    if (maker === 'Union') {
      await made.page.locator('#pattern').selectOption('hatched');
      await made.settled();
      await look('a pattern', made);
      await made.page.locator('#stage').press('Control+z');
    }
    if (maker === 'Offset') {
      await made.page.locator('#offset-end').fill('0.3');
      await made.page.keyboard.press('Enter');
      await made.settled();
      await look('an offset with two distances', made);
      await made.page.locator('#stage').press('Control+z');
    }
    if (maker === 'Cut') {
      await made.page.getByRole('button', { name: 'Delete Part 1' }).click();
      await made.settled();
      await look('a deleted part', made);
      await made.page.locator('#stage').press('Control+z');
    }
    await made.page.locator('#stage').press('Control+z');
  }
  await made.page.locator('#view').click();
  await made.page.locator('#ground-shadow').click();
  await made.page.locator('#view-menu').waitFor();
  await look('a shadow on the ground', made);
  await made.page.close();
}

for (const [name, viewport] of Object.entries(sizes)) {
  for (const colorScheme of ['light', 'dark']) {
    // Every run has both sizes and both schemes.
    const isAlways = (name === 'phone') === (colorScheme === 'dark');
    const check = isAlways ? test : inLongRun;
    const looksFurther = long || name === 'desk';
    check(`axe finds nothing, ${colorScheme}, ${viewport.width} pixels wide`, async () => {
      const browser = await openBrowser({ viewport, colorScheme, hasTouch: name === 'phone' });
      try {
        const wrong = {};
        const look = async (state, { page }) => {
          const found = await violations(page);
          if (found.length > 0) wrong[state] = found;
        };
        const first = new Tab(await browser.context.newPage(), browser.address);
        await first.page.goto(browser.address);
        await first.settled();
        await look('the first visit', first);
        await first.page.close();

        const tab = await Tab.open(browser);
        const { page } = tab;
        await look('empty', tab);
        await tab.click([-60, 10], [-20, -50], [30, 10], [70, -50]);
        await look('drawing', tab);
        for (const menu of ['view', 'examples', 'save']) {
          await page.locator(`#${menu}`).click();
          await page.locator(`#${menu}-menu`).waitFor();
          await look(`${menu} menu`, tab);
          await page.keyboard.press('Escape');
        }
        await page.keyboard.press('?');
        await look('help', tab);
        await page.keyboard.press('Escape');
        if (name === 'phone') {
          const handle = page.locator('#sheet-handle');
          await handle.click();
          await look('the sheet down', tab);
          await handle.press('ArrowUp');
          await handle.press('ArrowUp');
          await look('the sheet up', tab);
          await handle.press('ArrowDown');
        }
        await page.locator('#facts-line').click();
        await page.locator('#checkup > summary').click();
        await page.locator('#checkup-found > *').first().waitFor();
        await look('check-up', tab);
        await page.locator('#compare').selectOption('paper-exact');
        await page.locator('#comparison').waitFor();
        await look('comparison', tab);
        await look('samples, marks and knots', tab);
        await page.keyboard.press('k');
        await look('the frame', tab);
        await page.keyboard.press('Escape');
        await page.keyboard.press('i');
        await look('the mirror', tab);
        await page.keyboard.press('Escape');
        for (const [key, tool] of Object.entries({
          p: 'pen',
          f: 'freehand',
          o: 'circle',
          e: 'ellipse',
          w: 'center',
        })) {
          await page.keyboard.press(key);
          await tab.click([-90, 60], [-50, 80]);
          await look(tool, tab);
        }
        const { x, y } = await tab.middle();
        await page.mouse.click(x, y, { button: 'right' });
        await page.locator('#context-menu').waitFor();
        await look('context menu', tab);
        if (looksFurther) await lookFurther(browser, tab, look);
        await page.close();

        const paper = await browser.context.newPage();
        await paper.goto(`${browser.address}paper.html`);
        await paper.locator('h1').waitFor();
        await look('the Paper page', { page: paper });
        assert.deepEqual(wrong, {});
      } finally {
        await browser.close();
      }
    });
  }
}
