// Two sittings of people who use the page for the first time, each step with the mouse and the keys that
// they would use. `tell` is called after each step with its name.
import assert from 'node:assert/strict';
import bunny from 'bunny';
import { openBrowser, Tab } from './browser.mjs';

/** The sizes of windows that the page is looked at in. */
export const windows = {
  laptop: { width: 1280, height: 800 },
  desk: { width: 1920, height: 1080 },
  phone: { width: 390, height: 844 },
};

/** A scan as a file: the npm package's bunny, which came from a scanner. */
function scanFile() {
  const lines = [
    ...bunny.positions.map((position) => `v ${position.join(' ')}`),
    ...bunny.cells.map((cell) => `f ${cell.map((vertex) => vertex + 1).join(' ')}`),
  ];
  return { name: 'scan.obj', mimeType: 'model/obj', buffer: Buffer.from(lines.join('\n')) };
}

/** A browser of a size, with the page as for a first visit. */
export async function sitDown(viewport, options = {}) {
  const browser = await openBrowser({ viewport, ...options });
  const tab = new Tab(await browser.context.newPage(), browser.address);
  await tab.page.goto(browser.address);
  await tab.settled();
  return { browser, tab };
}

/** Where a part of the stage is in the window: from -1 to 1 both ways, of its smaller side. */
async function placeOn(tab, [x, y]) {
  const box = await tab.page.locator('#stage').boundingBox();
  const unit = Math.min(box.width, box.height) / 2;
  return { x: box.x + box.width / 2 + unit * x, y: box.y + box.height / 2 + unit * y };
}

async function clickAt(tab, ...places) {
  for (const place of places) {
    const { x, y } = await placeOn(tab, place);
    await tab.page.mouse.click(x, y);
    await tab.settled();
  }
}

const dragAt = async (tab, from, to) => tab.drag(await placeOn(tab, from), await placeOn(tab, to));

/** A control of the panel, brought into view as by the wheel. */
async function control(tab, selector) {
  const found = tab.page.locator(selector).filter({ visible: true }).first();
  await found.scrollIntoViewIfNeeded();
  return found;
}

/** Loads a scan, draws on it, compares two methods and takes the curves away as a file. */
export async function scanSitting(tab, tell = async () => {}) {
  const { page } = tab;
  await tell('welcome');
  await page.locator('#tour-skip').click();
  await control(tab, '#open');
  const choosing = page.waitForEvent('filechooser');
  await page.locator('#open').click();
  await (await choosing).setFiles(scanFile());
  await page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('scan.obj'));
  await tab.settled();
  await tell('scan');

  await page.locator('#tool-curve').click();
  await clickAt(tab, [-0.3, -0.05], [-0.12, 0.16], [0.1, 0.02], [0.26, 0.2], [0.4, 0.1]);
  await page.keyboard.press('Enter');
  await page.locator('#tool-circle').click();
  await clickAt(tab, [0.2, 0.42]);
  assert.deepEqual(
    (await tab.state()).drawing.objects.map(({ figure }) => figure.kind),
    ['bspline', 'circle'],
  );
  await tell('drawn');

  // The curve again, and it by the paper's method.
  await page.locator('#tool-select').click();
  await (await control(tab, '#objects .object:last-child, #objects li:last-child .object')).click();
  await tab.settled();
  await (await control(tab, '#compare')).selectOption('paper-exact');
  await page.waitForFunction(
    () =>
      !document.getElementById('comparison').classList.contains('late') &&
      /edges/.test(document.getElementById('compare-largest').textContent),
  );
  const told = await page.locator('#compare-largest').textContent();
  const [, edges, part] = /^([\d.]+) edges · ([\d.]+) %$/.exec(told) ?? [];
  assert.ok(Number(edges) > 0, `another method, another curve: ${told}`);
  assert.ok(Number(part) < 10, `but not another drawing: ${told}`);
  await control(tab, '#comparison');
  await tell('compared');
  await (await control(tab, '#compare-off')).click();
  await page.locator('#comparison').waitFor({ state: 'hidden' });
  const { text } = await tab.save('OBJ');
  assert.equal(text.split('\n').filter((line) => line.startsWith('l ')).length, 2);
}

/** Draws a closed seam with the pen, styles it, duplicates and moves it, and all of it is kept. */
export async function seamSitting(tab, tell = async () => {}) {
  const { page } = tab;
  await page.locator('#tour-skip').click();
  await (await control(tab, '#surface')).selectOption('sphere');
  await page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('sphere:'));
  await tab.settled();
  await page.locator('#tool-pen').click();
  await clickAt(tab, [-0.28, 0.2]);
  await dragAt(tab, [-0.3, -0.15], [-0.22, -0.28]);
  await clickAt(tab, [0, -0.08]);
  await dragAt(tab, [0.3, -0.15], [0.36, -0.02]);
  await clickAt(tab, [0.28, 0.2]);
  await dragAt(tab, [0, 0.32], [-0.1, 0.33]);
  await tell('seam open');
  await clickAt(tab, [-0.28, 0.2]);
  const { figure } = await tab.state();
  assert.deepEqual([figure.kind, figure.points.length, figure.settings.closed], ['pen', 6, true]);
  await tell('seam');

  await (await control(tab, '.swatch[title="Pink"]')).click();
  await (await control(tab, '#width')).fill('8');
  await page.keyboard.press('Enter');
  await (await control(tab, '#dash')).selectOption('dashed');
  await tab.settled();
  await tell('styled');

  await page.locator('#tool-select').click();
  await (await control(tab, '#duplicate')).click();
  await tab.settled();
  const before = await tab.state();
  assert.equal(before.drawing.objects.length, 2);
  const from = await tab.onCurve(0.4);
  await tab.drag(from, { x: from.x + 30, y: from.y + 24 });
  await page.waitForFunction((revision) => {
    const state = window.karcherPage.state();
    return state.revision > revision && !state.dragging;
  }, before.revision);
  const moved = await tab.state();
  assert.notDeepEqual(moved.figure.points, before.figure.points);
  assert.deepEqual(moved.drawing.objects[0], before.drawing.objects[0], 'the other stays');
  await (await control(tab, '.swatch[title="Teal"]')).click();
  await tab.settled();
  await tell('moved');

  // The same on the other side of a line of two clicks.
  const { drawing: unmirrored } = await tab.state();
  await (await control(tab, '#mirror')).click();
  await (await control(tab, '#mirror-copies')).check();
  await clickAt(tab, [-0.5, -0.14]);
  await page.getByText('second point').waitFor();
  await clickAt(tab, [0.5, -0.14]);
  await page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 3);
  await tab.settled();
  const { drawing: mirrored } = await tab.state();
  assert.deepEqual(mirrored.objects.slice(0, 2), unmirrored.objects);
  const [copied, image] = mirrored.objects.slice(1).map((object) => object.figure);
  assert.deepEqual([image.points.length, image.settings.closed], [6, true]);
  assert.notDeepEqual(image.points, copied.points);
  await tell('mirrored');

  const bytes = async () => JSON.stringify((await tab.state()).drawing);
  const end = await bytes();
  await tab.pastSaving();
  await page.reload();
  await tab.settled();
  assert.equal(await bytes(), end, 'a reload keeps all of it');
  for (let step = 0; step < 3; step++) await page.locator('#undo').click();
  await tab.settled();
  assert.equal(await bytes(), JSON.stringify(before.drawing), 'and what was done');
  for (let step = 0; step < 3; step++) await page.locator('#redo').click();
  await tab.settled();
  assert.equal(await bytes(), end);
  await tell('after a reload');
  const { text } = await tab.save('SVG');
  assert.match(text, /stroke="#c81e5b".*stroke-width="8"/);
  assert.match(text, /stroke="#0e7c9e"/);
}
