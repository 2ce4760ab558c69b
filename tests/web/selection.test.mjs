// One selection: the object that looks selected is the one that edits, colors, names and deletions
// change.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun, part } from './part.mjs';

const two = [
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

describe('the selection', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  /** Two curves, of which the second is edited, with the tool that selects. */
  async function drawn() {
    const tab = await Tab.open(browser);
    await tab.click(...two[0]);
    await tab.page.keyboard.press('Enter');
    await tab.click(...two[1]);
    await tab.page.keyboard.press('v');
    await tab.settled();
    return tab;
  }
  const handles = (tab) => tab.page.locator('.handle').count();
  const objectsOf = async (tab) => (await tab.state()).drawing.objects;
  const swatch = (tab, name) => tab.page.getByRole('button', { name, exact: true });
  const length = (tab) => tab.page.locator('#status-length').textContent();
  const placeholder = (tab) => tab.page.locator('#object-name').getAttribute('placeholder');
  test('after the undo of another object’s drag, one object is shown, colored and named', async () => {
    const tab = await drawn();
    const place = await tab.onCurve(0.5, 0);
    await tab.drag(place, { x: place.x + 20, y: place.y + 30 });
    assert.equal((await tab.state()).drawing.active, 1);
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    const { drawing } = await tab.state();
    const name = `B-spline ${drawing.active}`;
    assert.equal(await placeholder(tab), name);
    await swatch(tab, 'Orange').click();
    await tab.settled();
    const colored = (await objectsOf(tab)).filter(({ color }) => color === '#d9480f');
    assert.deepEqual(
      colored.map(({ id }) => id),
      [drawing.active],
    );
    await tab.page.locator('#closed').check();
    await tab.settled();
    const closed = (await objectsOf(tab)).filter(({ figure }) => figure.settings.closed);
    assert.deepEqual(
      closed.map(({ id }) => id),
      [drawing.active],
    );
    await tab.close();
  });

  test('of all leaves hidden objects out, so that Delete does not remove them', async () => {
    const tab = await drawn();
    const { page } = tab;
    await page.getByRole('button', { name: 'Show B-spline 1' }).click();
    await page.locator('#stage').press('Control+a');
    await page.keyboard.press('Delete');
    await tab.settled();
    const left = (await objectsOf(tab)).filter(({ figure }) => figure.points.length > 0);
    assert.deepEqual(
      left.map(({ id, visible }) => [id, visible]),
      [[1, false]],
    );
    await tab.close();
  });

  test('Delete removes the object whose points are shown', async () => {
    const tab = await drawn();
    await tab.page.keyboard.press('Escape');
    const state = await tab.state();
    assert.equal(state.selection, null);
    if (state.none) await swatchRow(tab, 0);
    assert.equal(await handles(tab), 4);
    await tab.page.keyboard.press('Delete');
    await tab.settled();
    const left = (await objectsOf(tab)).filter(({ figure }) => figure.points.length > 0);
    assert.deepEqual(
      left.map(({ id }) => id),
      [1],
    );
    await tab.close();
  });

  const swatchRow = (tab, row) => tab.page.locator('#objects .object').nth(row).click();

  for (const [how, letGo] of [
    ['Escape', (tab) => tab.page.keyboard.press('Escape')],
    [
      'a click on nothing',
      async (tab) => {
        const box = await tab.page.locator('#stage').boundingBox();
        await tab.page.mouse.click(box.x + 80, box.y + box.height - 40);
      },
    ],
  ]) {
    test(`${how} deselects: the selection is empty, and the drawing unchanged`, async () => {
      const tab = await drawn();
      const place = await tab.onCurve(0.5);
      await tab.page.mouse.click(place.x, place.y);
      await tab.settled();
      assert.equal(await handles(tab), 4);
      await letGo(tab);
      await letGo(tab);
      await tab.settled();
      assert.equal(await handles(tab), 0);
      assert.equal(await placeholder(tab), 'Nothing selected');
      assert.equal(await length(tab), '');
      const before = JSON.stringify(await objectsOf(tab));
      assert.equal(await swatch(tab, 'Orange').isDisabled(), true);
      for (const key of ['Delete', 'c', 'Control+d']) await tab.page.keyboard.press(key);
      await tab.settled();
      assert.equal(JSON.stringify(await objectsOf(tab)), before);
      // A click on the curve selects it again.
      await tab.page.mouse.click(place.x, place.y);
      await tab.settled();
      assert.equal(await handles(tab), 4);
      assert.equal(await placeholder(tab), 'B-spline 2');
      await tab.close();
    });
  }

  const pressed = (tab) =>
    tab.page
      .locator('.handle[aria-pressed="true"]')
      .evaluateAll((all) => all.map((handle) => handle.dataset.id));
  const pointsOf = async (tab) =>
    (await tab.state()).figure.points.map(({ face, bary }) => JSON.stringify([face, bary]));
  const shiftClick = async (tab, name) => {
    const { x, y } = await tab.handle(name);
    await tab.page.keyboard.down('Shift');
    await tab.page.mouse.click(x, y);
    await tab.page.keyboard.up('Shift');
    await tab.settled();
  };

  for (const key of ['b', 'p']) {
    test(`takes several points drawn with tool ${key}: they are dragged, deselected and deleted together`, async () => {
      const tab = await Tab.open(browser);
      const name = key === 'p' ? 'Anchor' : 'Control point';
      await tab.page.keyboard.press(key);
      await tab.click([-120, 40], [-40, 0], [40, 40], [120, 0]);
      await tab.page.keyboard.press('v');
      const before = await pointsOf(tab);
      const second = await tab.handle(`${name} 2 of 4`);
      await tab.page.mouse.click(second.x, second.y);
      await shiftClick(tab, `${name} 3 of 4`);
      assert.deepEqual(await pressed(tab), ['point-1', 'point-2']);
      const said = key === 'p' ? '2 anchors' : '2 points';
      assert.equal(await tab.page.locator('#selected').textContent(), said);
      // Both move equally far on the stage, where the surface is nearly flat.
      const third = await tab.handle(`${name} 3 of 4`);
      await tab.dragHandle(`${name} 2 of 4`, 10, 60);
      const moved = await pointsOf(tab);
      assert.deepEqual(
        moved.map((point, i) => point === before[i]),
        [true, false, false, true],
      );
      const there = await tab.handle(`${name} 3 of 4`);
      const off = Math.hypot(there.x - third.x - 10, there.y - third.y - 60);
      assert.ok(off < 8, `${off} pixels`);
      assert.deepEqual(await pressed(tab), ['point-1', 'point-2']);
      await tab.page.keyboard.press('Control+z');
      await tab.settled();
      assert.deepEqual(await pointsOf(tab), before, 'one step of the history');
      // A box surrounds the two on the right, and a click removes one of them.
      await tab.page.keyboard.down('Shift');
      const { x, y } = await tab.middle();
      await tab.drag({ x: x + 10, y: y + 130 }, { x: x + 180, y: y - 60 });
      await tab.page.keyboard.up('Shift');
      assert.deepEqual(await pressed(tab), ['point-2', 'point-3']);
      await shiftClick(tab, `${name} 4 of 4`);
      assert.deepEqual(await pressed(tab), ['point-2']);
      await shiftClick(tab, `${name} 2 of 4`);
      await tab.page.keyboard.press('Delete');
      await tab.settled();
      const left = (await tab.state()).figure.points;
      assert.deepEqual(
        left.map(({ face }) => face),
        [0, 3].map((i) => JSON.parse(before[i])[0]),
      );
      await tab.page.keyboard.press('Control+z');
      await tab.settled();
      assert.deepEqual(await pointsOf(tab), before);
      // A click on one of several selects only that one. The handles return in the next frame.
      await tab.still();
      const back = await tab.handle(`${name} 2 of 4`);
      assert.deepEqual(back, second);
      await tab.page.mouse.click(second.x, second.y);
      await shiftClick(tab, `${name} 3 of 4`);
      await tab.page.mouse.click(second.x, second.y);
      assert.deepEqual(await pressed(tab), ['point-1']);
      await tab.close();
    });
  }

  test('of several objects shows their common settings, and sets them for all', async () => {
    const tab = await drawn();
    await swatch(tab, 'Pink').click();
    await tab.page.keyboard.press('Control+a');
    await tab.settled();
    assert.equal(await placeholder(tab), '2 objects');
    assert.equal(await tab.page.locator('#swatches [aria-pressed="true"]').count(), 0);
    await tab.page.locator('#closed').click();
    await tab.settled();
    await tab.page.locator('#width').fill('7');
    await tab.page.keyboard.press('Enter');
    await swatch(tab, 'Teal').click();
    await tab.settled();
    for (const { color, width, figure } of await objectsOf(tab)) {
      assert.deepEqual([color, width, figure.settings.closed], ['#0e7c9e', 7, true]);
    }
    assert.equal(await tab.page.locator('#swatches [aria-pressed="true"]').count(), 1);
    await tab.close();
  });

  test('of several objects shows different settings as mixed, until one is set', async () => {
    const tab = await drawn();
    const set = async (id, value) => {
      await tab.page.locator(id).fill(value);
      await tab.page.keyboard.press('Enter');
    };
    await tab.page.locator('#degree').selectOption('2');
    await tab.page.locator('#clamped').click();
    await tab.page.locator('#dash').selectOption('dashed');
    await tab.page.locator('#width').fill('9');
    await tab.page.keyboard.press('Enter');
    await tab.page.locator('#levels').selectOption('0');
    await set('#marks', '5');
    await set('#samples', '48');
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('Control+a');
    await tab.settled();
    const words = () =>
      tab.page.evaluate(() =>
        ['degree', 'dash', 'levels', 'width', 'marks', 'samples'].map((id) => {
          const control = document.getElementById(id);
          return control.selectedOptions?.[0].textContent ?? (control.value || control.placeholder);
        }),
      );
    assert.deepEqual(await words(), Array(6).fill('mixed'));
    const clamped = tab.page.locator('#clamped');
    assert.equal(await clamped.evaluate(({ indeterminate }) => indeterminate), true);
    await tab.page.locator('#degree').selectOption('1');
    await tab.page.locator('#dash').selectOption('dotted');
    await tab.page.locator('#levels').selectOption('auto');
    await set('#width', '3');
    await set('#marks', '2');
    await set('#samples', '30');
    await clamped.click();
    await tab.settled();
    const set6 = ['1, linear', 'dotted', 'automatic', '3', '2', '30'];
    assert.deepEqual(await words(), set6);
    for (const { dash, width, figure } of await objectsOf(tab)) {
      const { degree, levels, marks, samples } = figure.settings;
      assert.deepEqual(
        [degree, dash, levels, width, marks, samples],
        [1, 'dotted', 'auto', 3, 2, 30],
      );
    }
    await tab.close();
  });

  const hint = (tab) => tab.page.locator('#hint').textContent();
  const removals = (tab) => tab.page.getByText('too few points and was removed').count();
  const rows = (tab) => tab.page.locator('#objects li').count();
  const pointCounts = async (tab) =>
    (await objectsOf(tab)).map(({ figure }) => figure.points.length);
  const [besideSurface, some] = [
    [-300, -330],
    [
      [-60, 20],
      [20, -30],
    ],
  ];
  const ways = {
    'a click on nothing': (tab) => tab.click(besideSurface),
    Escape: (tab) => tab.page.keyboard.press('Escape'),
  };
  for (const [way, letGo] of part(Object.entries(ways), 1)) {
    test(`an unfinished curve is removed once ${way} deselects it, and undo restores it`, async () => {
      const tab = await Tab.open(browser);
      await tab.page.locator('#tool-curve').click();
      await tab.click(...some);
      assert.equal(await hint(tab), '2 more points make a curve');
      await tab.page.keyboard.press('v');
      await tab.page.keyboard.press('Escape');
      assert.equal(await rows(tab), 1);
      await letGo(tab);
      await tab.settled();
      assert.deepEqual(await pointCounts(tab), [0]);
      assert.equal(await rows(tab), 0);
      assert.equal(await removals(tab), 1);
      assert.equal(await hint(tab), 'Choose a tool to draw');
      await tab.page.keyboard.press('Control+z');
      await tab.settled();
      assert.deepEqual(await pointCounts(tab), [2]);
      assert.equal(await handles(tab), 2);
      await tab.page.keyboard.press('Control+y');
      await tab.settled();
      assert.equal(await rows(tab), 0);
      await tab.close();
    });
  }

  test('an unfinished curve is removed once another one is selected or begun', async () => {
    const tab = await drawn();
    const { page } = tab;
    await page.keyboard.press('b');
    await page.keyboard.press('Enter');
    await tab.click(...some);
    assert.deepEqual(await pointCounts(tab), [4, 4, 2]);
    await page.locator('#objects .object').last().click();
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4, 4]);
    assert.equal(await removals(tab), 1);
    assert.equal((await tab.state()).drawing.active, 1);
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4, 4, 2]);
    await page.keyboard.press('Enter');
    await tab.click([0, 0]);
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4, 4, 1]);
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4, 4]);
    // The selection is empty: a click begins another object.
    assert.equal(await hint(tab), 'Click the surface to place a control point');
    await tab.close();
  });

  inLongRun('an unfinished curve stays where it was copied', async () => {
    const tab = await Tab.open(browser);
    await tab.click([-60, 20], [40, 30]);
    await tab.page.keyboard.press('Control+d');
    await tab.settled();
    const { objects } = (await tab.state()).drawing;
    assert.deepEqual(
      objects.map(({ figure }) => figure.points.length),
      [2, 2],
    );
    await tab.close();
  });

  test('points that undo left can be deselected, and are restored by redo', async () => {
    const tab = await drawn();
    const { page } = tab;
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    assert.deepEqual(await pointCounts(tab), [4, 2]);
    await tab.click(besideSurface);
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4]);
    await page.keyboard.press('Control+y');
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4, 3]);
    await page.keyboard.press('Control+y');
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4, 4]);
    // A curve that has lost points stays, even without a line.
    await tab.page.locator('#points button').first().click();
    await page.keyboard.press('Delete');
    await tab.click(besideSurface);
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [4, 3]);
    await tab.close();
  });

  inLongRun('a single anchor is removed once the next path begins', async () => {
    const tab = await Tab.open(browser);
    await tab.page.keyboard.press('p');
    await tab.click([-60, 20]);
    await tab.settled();
    await tab.click(besideSurface);
    await tab.click([20, -30], [60, 30]);
    await tab.settled();
    assert.deepEqual(await pointCounts(tab), [2]);
    await tab.close();
  });

  inLongRun('shows no length once it is empty, whatever was undone before', async () => {
    const tab = await drawn();
    const { page } = tab;
    const told = () => page.locator('#status-length').textContent();
    assert.match(await told(), /length/);
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    assert.equal((await tab.state()).none, true);
    assert.equal(await told(), '');
    await page.locator('#objects .object').first().click();
    assert.match(await told(), /length/);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+y');
    await tab.settled();
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    assert.equal((await tab.state()).none, true);
    assert.equal(await told(), '');
    await tab.close();
  });
});
