// Sessions of people who use the page for the first time, each step with the mouse and the keys
// that they would use. A session calls `tell` after each step with the step's name.
import assert from 'node:assert/strict';
import bunny from 'bunny';
import { openBrowser, Tab } from './browser.mjs';

/** The sizes of the page's windows. */
export const windows = {
  laptop: { width: 1280, height: 800 },
  desk: { width: 1920, height: 1080 },
  phone: { width: 390, height: 844 },
};

/** A scan as a file: the npm package's bunny, which was scanned. */
function scanFile() {
  const lines = [
    ...bunny.positions.map((position) => `v ${position.join(' ')}`),
    ...bunny.cells.map((cell) => `f ${cell.map((vertex) => vertex + 1).join(' ')}`),
  ];
  return { name: 'scan.obj', mimeType: 'model/obj', buffer: Buffer.from(lines.join('\n')) };
}

/** A browser of a size, with the page as on a first visit. */
export async function sitDown(viewport, options = {}) {
  const browser = await openBrowser({ viewport, ...options });
  const tab = new Tab(await browser.context.newPage(), browser.address);
  await tab.page.goto(browser.address);
  await tab.settled();
  return { browser, tab };
}

/**
 * A place of the stage in the window: from -1 to 1 in both directions, relative to its smaller
 * side.
 */
export async function placeOn(tab, [x, y]) {
  const box = await tab.page.locator('#stage').boundingBox();
  const unit = Math.min(box.width, box.height) / 2;
  return { x: box.x + box.width / 2 + unit * x, y: box.y + box.height / 2 + unit * y };
}

export async function clickAt(tab, ...places) {
  for (const place of places) {
    const { x, y } = await placeOn(tab, place);
    await tab.page.mouse.click(x, y);
    await tab.settled();
  }
}

export const dragAt = async (tab, from, to) =>
  tab.drag(await placeOn(tab, from), await placeOn(tab, to));

/** A control of the panel, scrolled into view as by the wheel. */
export async function control(tab, selector) {
  const found = tab.page.locator(selector).filter({ visible: true }).first();
  await found.scrollIntoViewIfNeeded();
  return found;
}

/** Loads a scan, draws on it, compares two methods and saves the curves as a file. */
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

  // The user selects the curve again, and compares it with that of the paper's method.
  await page.locator('#tool-select').click();
  await (await control(tab, '#objects .object:last-child, #objects li:last-child .object')).click();
  await tab.settled();
  await (await control(tab, '#compare')).selectOption('paper-exact');
  await page.waitForFunction(
    () =>
      !document.getElementById('comparison').classList.contains('late') &&
      /\d/.test(document.getElementById('compare-largest').textContent),
  );
  const [edges, part] = await page
    .locator('#compare-largest, #compare-largest-part')
    .allTextContents();
  const told = `${edges} edges, ${part} %`;
  assert.ok(Number(edges) > 0, `another method, another curve: ${told}`);
  assert.ok(Number(part) < 10, `but not another drawing: ${told}`);
  await control(tab, '#comparison');
  await tell('compared');
  await (await control(tab, '#compare-off')).click();
  await page.locator('#comparison').waitFor({ state: 'hidden' });
  const { text } = await tab.save('OBJ');
  assert.equal(text.split('\n').filter((line) => line.startsWith('l ')).length, 2);
}

/** Reads figure 4 on the Paper page, and continues with its curve in the editor, by two methods. */
export async function figureSitting(tab, tell = async () => {}) {
  const { page } = tab;
  await page.locator('#tour-skip').click();
  await page.getByRole('link', { name: 'Paper', exact: true }).filter({ visible: true }).click();
  await page
    .locator('#contents')
    .getByRole('link', { name: /coarse and on a fine/ })
    .click();
  const figure = page.locator('#resolution');
  await figure.locator('tbody td').filter({ hasText: /\d/ }).first().waitFor();
  await tell('figure');
  const coarse = figure.locator('a[href*="mesh="]').first();
  await coarse.scrollIntoViewIfNeeded();
  await coarse.click();
  await tab.settled();
  const { figure: curve, mesh } = await tab.state();
  assert.match(mesh, /simplified/);
  assert.equal(curve.kind, 'bspline');
  assert.ok(curve.points.length >= 4, `${curve.points.length} points`);
  await tell('its curve');

  await (await control(tab, '#compare')).selectOption('paper-exact');
  const numbers = () => page.locator('#compare-mean, #compare-largest').allTextContents();
  const answered = () =>
    page.waitForFunction(
      () =>
        !document.getElementById('comparison').classList.contains('late') &&
        /\d/.test(document.getElementById('compare-largest').textContent),
    );
  await answered();
  const [mean, largest] = (await numbers()).map(Number);
  assert.ok(0 < mean && mean <= largest, `${mean} ${largest}`);
  await tell('compared');

  const { x, y } = await tab.handle('Control point 3 of');
  await tab.drag({ x, y }, { x: x + 20, y: y - 15 });
  await tab.settled();
  await answered();
  const revised = (await numbers()).map(Number);
  assert.notDeepEqual(revised, [mean, largest]);
  assert.ok(revised[0] <= revised[1]);
  await tell('changed');
  await (await control(tab, '#compare-off')).click();
  await page.locator('#comparison').waitFor({ state: 'hidden' });
}

/**
 * Draws a closed seam with the pen, styles, duplicates and moves it, and checks that the page keeps
 * all of it.
 */
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

  // The user mirrors a copy in a line of two clicks.
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

/** A vase, a surface of revolution without a bottom: foot, belly, neck and lip, 240 mm high. */
function vaseFile(around = 96, along = 70) {
  const radius = (t) =>
    45 + 42 * Math.sin(Math.PI * t) ** 2 * (1 - 0.35 * t) - 16 * t ** 3 + 22 * t ** 12;
  const lines = [];
  for (let j = 0; j <= along; j++) {
    for (let i = 0; i < around; i++) {
      const [t, angle] = [j / along, (2 * Math.PI * i) / around];
      lines.push(`v ${radius(t) * Math.sin(angle)} ${240 * t} ${radius(t) * Math.cos(angle)}`);
    }
  }
  const at = (i, j) => 1 + (i % around) + around * j;
  for (let j = 0; j < along; j++) {
    for (let i = 0; i < around; i++) {
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
    }
  }
  return { name: 'vase.obj', mimeType: 'model/obj', buffer: Buffer.from(lines.join('\n')) };
}

const placeOf = ({ face, bary }, { positions, triangles }) =>
  [0, 1, 2].map((axis) =>
    bary.reduce(
      (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
      0,
    ),
  );

/**
 * A poster: a colored heart in a ring of dots, evenly spaced around a vase, saved as SVG and PNG.
 */
export async function posterSitting(tab, tell = async () => {}) {
  const { page } = tab;
  await page.locator('#tour-skip').click();
  const choosing = page.waitForEvent('filechooser');
  await (await control(tab, '#open')).click();
  await (await choosing).setFiles(vaseFile());
  await page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('vase.obj'));
  await tab.settled();
  await tab.still();
  await tell('vase');

  // The user draws half of a heart; the other half is its mirror image in the vase's symmetry.
  await page.locator('#tool-pen').click();
  await clickAt(tab, [0, 0.34]);
  await dragAt(tab, [0.22, 0.06], [0.24, -0.06]);
  await dragAt(tab, [0.1, -0.1], [0.02, -0.1]);
  await clickAt(tab, [0, 0]);
  await page.keyboard.press('Enter');
  await tab.settled();
  await page.locator('#tool-select').click();
  await clickAt(tab, [0.22, 0.06]);
  await tell('half');
  await (await control(tab, '#mirror')).click();
  await (await control(tab, '#mirror-in')).selectOption('symmetry');
  await (await control(tab, '#mirror-copies')).check();
  await page.locator('#mirror-now').waitFor();
  await tell('symmetry');
  await (await control(tab, '#mirror-now')).click();
  await page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
  await tab.settled();
  // The half ends in the middle of the view: the other one begins there.
  const mesh = await tab.mesh();
  const [left, right] = (await tab.state()).drawing.objects.map(({ figure }) =>
    [0, -1].map((end) => placeOf(figure.points.at(end), mesh)),
  );
  for (const end of [0, 1]) {
    const gap = Math.hypot(...left[end].map((value, axis) => value - right[end][axis]));
    assert.ok(gap < 1, `the halves are ${gap} mm apart`);
  }
  await page.locator('#tool-select').click();
  await page.locator('#stage').focus();
  await page.keyboard.press('Control+a');
  await (await control(tab, '.swatch[title="Pink"]')).click();
  await (await control(tab, '#width')).fill('7');
  await page.keyboard.press('Enter');
  await tab.settled();
  await tell('heart');

  // The dots form a row below the lip, evenly spaced.
  await page.locator('#stage').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await page.locator('#tool-circle').click();
  for (const [x, y] of [
    [-0.3, -0.4],
    [-0.16, -0.46],
    [0.04, -0.42],
    [0.12, -0.44],
    [0.3, -0.42],
  ]) {
    await dragAt(tab, [x, y], [x + 0.035, y]);
    await page.keyboard.press('Enter');
  }
  await tab.settled();
  await tell('dots');
  await page.locator('#tool-select').click();
  const box = async (from, to) => {
    await page.keyboard.down('Shift');
    await dragAt(tab, from, to);
    await page.keyboard.up('Shift');
  };
  await page.keyboard.press('Escape');
  await box([-0.95, -0.6], [0.95, -0.3]);
  const { chosen } = await tab.state();
  await tell('chosen');
  assert.equal(chosen.length, 5, 'all dots are selected');
  const before = JSON.stringify((await tab.state()).drawing);
  const { x, y } = await placeOn(tab, [0.12, -0.44]);
  await page.mouse.click(x + 4, y, { button: 'right' });
  await page.getByRole('menuitem', { name: 'Space evenly on a line', exact: true }).click();
  await page.waitForFunction(
    (text) => JSON.stringify(window.karcherPage.state().drawing) !== text,
    before,
  );
  await tab.settled();
  await (await control(tab, '.swatch[title="Teal"]')).click();
  await (await control(tab, '#fill')).fill('100');
  await page.keyboard.press('Enter');
  await tab.settled();
  await tell('even');
  await page.locator('#stage').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await tab.settled();
  await tab.still();
  await tell('poster');

  const { name, text } = await tab.save('SVG');
  assert.match(name, /\.svg$/);
  assert.equal((text.match(/stroke="#c81e5b"/g) ?? []).length, 2);
  assert.equal((text.match(/stroke="#0e7c9e"/g) ?? []).length, 5);
  const coming = page.waitForEvent('download');
  await page.locator('#save').click();
  await page.getByRole('menuitem', { name: 'PNG' }).first().click();
  const picture = await coming;
  assert.match(picture.suggestedFilename(), /\.png$/);
}
