// Many objects on one surface: drawn, selected, arranged and styled with a mouse and keys.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';
import { inLongRun, randoms, seed } from './part.mjs';

const lines = [
  [
    [-110, 60],
    [-40, 30],
    [20, 60],
    [90, 40],
  ],
  [
    [-100, -60],
    [-30, -90],
    [30, -60],
    [100, -80],
  ],
];

const objectsOf = async (tab) => (await tab.state()).drawing.objects;
const kindsOf = async (tab) => (await objectsOf(tab)).map(({ figure }) => figure.kind);
const bytesOf = async (tab) => JSON.stringify((await tab.state()).drawing);

/** Two curves, drawn one after the other, and a circle. */
async function drawn(browser, mesh = 'sphere:1500') {
  const tab = await Tab.open(browser, `mesh=${mesh}`);
  await tab.click(...lines[0]);
  await tab.page.keyboard.press('Enter');
  await tab.click(...lines[1]);
  await tab.page.keyboard.press('7');
  await tab.click([0, 0]);
  await tab.settled();
  return tab;
}

/** Clicks the middle of a row of the list, from the topmost. */
async function clickRow(tab, row, options = {}) {
  const box = await tab.page.locator('#objects .object').nth(row).boundingBox();
  const place = [box.x + box.width / 2, box.y + box.height / 2];
  if (options.shift) await tab.page.keyboard.down('Shift');
  await tab.page.mouse.click(...place);
  if (options.shift) await tab.page.keyboard.up('Shift');
  await tab.settled();
}

describe('a drawing of many objects', () => {
  let browser;
  before(async () => {
    browser = await openBrowser({ viewport: { width: 1280, height: 900 } });
    const permissions = ['clipboard-read', 'clipboard-write'];
    await browser.context.grantPermissions(permissions, { origin: browser.address });
  });
  after(() => browser.close());

  test('Enter ends a curve and begins another, and no tool hides an object', async () => {
    const tab = await drawn(browser);
    assert.deepEqual(await kindsOf(tab), ['bspline', 'bspline', 'circle']);
    const { others, circle } = await tab.view();
    assert.ok(circle);
    assert.deepEqual(
      others.map((one) => one.lines.length),
      [1, 1],
      'both curves are drawn beside the circle',
    );
    const names = await tab.page.locator('#objects .object span').allTextContents();
    assert.deepEqual(names, ['Circle 3', 'B-spline 2', 'B-spline 1'], 'the topmost first');
    await tab.page.locator('#new-object').click();
    await tab.page.keyboard.press('0');
    await tab.click([-60, 0], [60, 0]);
    assert.deepEqual(await kindsOf(tab), ['bspline', 'bspline', 'circle', 'points']);
    assert.equal((await tab.view()).others.length, 3);
    await tab.close();
  });

  test('is selected by clicks on curves, with Shift, in a box and in the list', async () => {
    const tab = await drawn(browser);
    const { page } = tab;
    const at = await tab.onCurve(0.5, 0);
    await page.mouse.click(at.x, at.y);
    await tab.settled();
    let state = await tab.state();
    assert.equal(state.drawing.active, 1, 'a click on a curve edits it');
    assert.deepEqual(state.chosen, [1]);
    assert.equal(await page.locator('.handle').count(), 4, 'its points have handles');

    const other = await tab.onCurve(0.5, 0);
    await page.keyboard.down('Shift');
    await page.mouse.click(other.x, other.y);
    await page.keyboard.up('Shift');
    state = await tab.state();
    assert.deepEqual(state.chosen, [1, 2], 'Shift adds one');

    await clickRow(tab, 0);
    assert.deepEqual((await tab.state()).chosen, [3]);
    await clickRow(tab, 2, { shift: true });
    assert.deepEqual((await tab.state()).chosen.toSorted(), [1, 3]);
    await clickRow(tab, 2, { shift: true });
    assert.deepEqual((await tab.state()).chosen, [3], 'and takes it out again');

    const { x, y } = await tab.middle();
    await page.keyboard.down('Shift');
    await tab.drag({ x: x - 140, y: y - 150 }, { x: x + 140, y: y + 120 });
    await page.keyboard.up('Shift');
    assert.deepEqual((await tab.state()).chosen.toSorted(), [1, 2, 3], 'all in a box');
    const before = await page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    await page.keyboard.press('Escape');
    assert.deepEqual((await tab.state()).chosen, []);
    await page.keyboard.press('Control+a');
    assert.deepEqual((await tab.state()).chosen.toSorted(), [1, 2, 3]);
    const after = await page.evaluate(() => window.karcherPage.seen([0, 0, 1]));
    assert.deepEqual(after, before, 'the view has not turned');
    await tab.close();
  });

  test('is duplicated, grouped, ordered, named, styled, hidden, locked and deleted, and all back', async () => {
    const tab = await drawn(browser);
    const { page } = tab;
    const states = [await bytesOf(tab)];
    const step = async (act, check) => {
      await act();
      await tab.settled();
      const objects = await objectsOf(tab);
      assert.ok(check(objects, await tab.state()), `${act}: ${JSON.stringify(objects)}`);
      states.push(await bytesOf(tab));
    };
    const byId = (objects, id) => objects.find((one) => one.id === id);
    await step(
      () => page.locator('#duplicate').click(),
      (objects) => objects.length === 4 && objects[3].figure.kind === 'circle',
    );
    await step(
      () => page.getByRole('button', { name: 'Orange' }).click(),
      (objects) => objects[3].color === '#d9480f' && objects[2].color === null,
    );
    await step(
      async () => {
        await page.locator('#width').fill('7.5');
        await page.locator('#width').press('Enter');
      },
      (objects) => objects[3].width === 7.5,
    );
    await step(
      () => page.locator('#dash').selectOption('dotted'),
      (objects) => objects[3].dash === 'dotted',
    );
    await step(
      async () => {
        await page.locator('#object-name').fill('Seam');
        await page.locator('#object-name').press('Enter');
      },
      (objects) => objects[3].name === 'Seam',
    );
    await step(
      () => page.locator('#lower').click(),
      (objects) => objects[2].name === 'Seam',
    );
    // A selection is no step of the history: it belongs to the next one.
    await clickRow(tab, 3);
    await clickRow(tab, 2, { shift: true });
    await step(
      () => page.locator('#group').click(),
      (objects) => objects.filter(({ group }) => group === 'Group 1').length === 2,
    );
    await step(
      () => page.getByRole('button', { name: 'Show B-spline 1' }).click(),
      (objects) => !byId(objects, 1).visible && byId(objects, 2).visible,
    );
    assert.ok(
      (await tab.view()).others.every(({ id }) => id !== 1),
      'it is not drawn',
    );
    await step(
      () => page.getByRole('button', { name: 'Lock B-spline 2' }).click(),
      (objects) => byId(objects, 2).locked,
    );
    assert.equal(await page.locator('.handle').count(), 0, 'what is locked has no handles');
    await step(
      async () => {
        await clickRow(tab, 0);
        await page.keyboard.press('Delete');
      },
      (objects) => !byId(objects, 3) && objects.length === 4,
    );
    for (const state of states.toReversed().slice(1)) {
      await page.locator('#undo').click();
      assert.equal(await bytesOf(tab), state);
    }
    for (const state of states.slice(1)) {
      await page.locator('#redo').click();
      assert.equal(await bytesOf(tab), state);
    }
    await tab.close();
  });

  test('is restored by a reload with its history', async () => {
    const tab = await drawn(browser);
    const { page } = tab;
    await page.getByRole('button', { name: 'Violet' }).click();
    await page.keyboard.press('Control+z');
    const whole = await bytesOf(tab);
    await tab.pastSaving();
    await page.reload();
    await tab.settled();
    assert.equal(await bytesOf(tab), whole);
    await page.locator('#redo').click();
    assert.equal((await objectsOf(tab))[2].color, '#8a3ffc');
    let steps = 0;
    while (await page.locator('#undo').isEnabled()) {
      await page.locator('#undo').click();
      steps++;
    }
    assert.equal(steps, 12, 'nine points, two beginnings and a style');
    const [first, ...rest] = await objectsOf(tab);
    assert.deepEqual(rest, []);
    assert.deepEqual(first.figure.points, []);
    await tab.close();
  });

  inLongRun('is copied to another tab, and cut and pasted', async () => {
    const tab = await drawn(browser);
    const { page } = tab;
    await clickRow(tab, 2);
    await clickRow(tab, 1, { shift: true });
    await page.keyboard.press('Control+c');
    const other = await Tab.open(browser, 'mesh=sphere:1500');
    await other.page.bringToFront();
    await other.page.locator('#stage').focus();
    await other.page.keyboard.press('Control+v');
    await other.settled();
    const [copied, pasted] = [await objectsOf(tab), await objectsOf(other)];
    assert.deepEqual(
      pasted.map(({ figure }) => figure),
      copied.slice(0, 2).map(({ figure }) => figure),
    );
    await other.page.keyboard.press('Control+x');
    assert.ok((await objectsOf(other)).every(({ figure }) => figure.points.length === 0));
    await other.page.keyboard.press('Control+v');
    assert.equal((await objectsOf(other)).length, 2);
    await other.page.locator('#surface').selectOption('torus');
    await other.page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('torus:'));
    await other.page.locator('#stage').focus();
    await other.page.keyboard.press('Control+v');
    await other.page.getByText('Nothing was pasted').waitFor();
    assert.deepEqual([...tab.logged, ...other.logged], []);
    await other.page.close();
    await page.close();
  });

  test('is saved as a file, and opens again unchanged', async () => {
    const tab = await drawn(browser);
    const { page } = tab;
    await page.getByRole('button', { name: 'Green' }).click();
    const whole = await bytesOf(tab);
    const { name, text } = await tab.save('JSON');
    assert.equal(JSON.parse(text).drawing.objects.length, 3);
    const obj = (await tab.save('OBJ')).text;
    assert.equal(obj.match(/^l /gm).length, 3, 'a line each');
    const svg = (await tab.save('SVG')).text;
    assert.match(svg, /stroke="#0b8457"/);
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Delete');
    await tab.settled();
    assert.ok((await objectsOf(tab)).every(({ figure }) => figure.points.length === 0));
    await tab.drop(name, text);
    await page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 3);
    assert.equal(await bytesOf(tab), whole);
    const broken = JSON.parse(text);
    broken.drawing.objects[1].width = 'wide';
    await tab.drop('broken.json', JSON.stringify(broken));
    const alert = page.getByRole('alert').filter({ hasText: 'broken.json' });
    assert.match(await alert.locator('p').textContent(), /The width of object 2 is "wide"\.$/);
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('that exceeds a link is restored all the same', async () => {
    const numbers = randoms(seed);
    const random = () => numbers.next().value / 2;
    const points = Array.from({ length: 500 }, (_, i) => `${i},${random()},${random()}`).join(';');
    const other = encodeURIComponent(`kind=points&points=${points}`);
    const tab = await Tab.open(browser, `mesh=sphere:1500&kind=bspline&points=&other=${other}`);
    const { page } = tab;
    await tab.click(...lines[0]);
    const whole = await bytesOf(tab);
    await page.waitForFunction(() => /&kept=1$/.test(location.hash));
    await page.reload();
    await tab.settled();
    assert.equal(await bytesOf(tab), whole);
    await page.getByRole('button', { name: 'Copy link' }).click();
    await page.getByText('too large for a link').waitFor();
    await tab.close();
  });
});
