// The order of objects by drags and keys, and the menu for a place of the surface.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, openBrowser, Tab, touchOf } from './browser.mjs';
import { inLongRun } from './part.mjs';

const at = (faces) => faces.map((face) => `${face},0.3,0.3`).join(';');
const other = (faces, name) =>
  `other=${encodeURIComponent(`kind=polyline&points=${at(faces)}&name=${name}`)}`;
/** Three lines, from the lowest to the topmost; the topmost is edited. */
const fragment = [
  `mesh=sphere:1500&kind=polyline&points=${at([20, 40])}&name=Third&place=2`,
  other([60, 90], 'First'),
  other([10, 500], 'Second'),
].join('&');

const namesOf = async (tab) => (await tab.state()).drawing.objects.map(({ name }) => name);

describe('the order of objects, and the menu at a place', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  test('rows move by drags and by keys, each time as one step', async () => {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    assert.deepEqual(await namesOf(tab), ['First', 'Second', 'Third']);
    const rows = page.locator('#objects .object');
    const middle = async (row) => {
      const box = await rows.nth(row).boundingBox();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    };
    await tab.drag(await middle(0), await middle(2));
    assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second'], 'the topmost to the foot');
    assert.equal((await tab.state()).drawing.active, 3, 'and a drag is no click');
    await page.keyboard.press('Control+z');
    assert.deepEqual(await namesOf(tab), ['First', 'Second', 'Third']);
    await rows.nth(2).focus();
    await page.keyboard.press('Alt+ArrowUp');
    assert.deepEqual(await namesOf(tab), ['Second', 'First', 'Third']);
    await page.keyboard.press('Alt+ArrowUp');
    assert.deepEqual(await namesOf(tab), ['Second', 'Third', 'First'], 'the keys stay with it');
    await page.keyboard.press('Alt+ArrowDown');
    assert.deepEqual(await namesOf(tab), ['Second', 'First', 'Third']);
    await tab.close();
  });

  test('a drag of a row ends without a move when the drawing changes meanwhile', async () => {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    const rows = page.locator('#objects .object');
    const middle = async (row) => {
      const box = await rows.nth(row).boundingBox();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    };
    // Undo takes back the order, or a row.
    for (const prepare of ['Alt+ArrowUp', 'Control+d']) {
      const before = await namesOf(tab);
      await rows.nth(2).focus();
      await page.keyboard.press(prepare);
      const [from, to] = [await middle(0), await middle(2)];
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await page.mouse.move(to.x, to.y, { steps: 4 });
      await page.locator('#objects .dragged').waitFor();
      await page.keyboard.press('Control+z');
      assert.deepEqual(await namesOf(tab), before);
      assert.equal(await page.locator('#objects .dragged').count(), 0);
      await page.mouse.move(to.x, to.y + 2);
      await page.mouse.up();
      assert.deepEqual(await namesOf(tab), before, prepare);
    }
    await tab.drag(await middle(0), await middle(2));
    assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second'], 'the next drag moves a row');
    await tab.close();
  });

  test('a row pressed at the edge of the list is let go outside, and dragged if it is moved', async () => {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    const list = await page.locator('#objects').boundingBox();
    const row = await page.locator('#objects > li').first().boundingBox();
    const edge = { x: list.x + list.width / 2, y: row.y + 2 };
    const press = async () => {
      await page.mouse.move(edge.x, edge.y);
      await page.mouse.down();
      await page.mouse.move(edge.x, list.y - 3);
    };
    await press();
    await page.mouse.up();
    await page.mouse.move(edge.x, row.y + 2.2 * row.height, { steps: 4 });
    assert.equal(await page.locator('#objects .dragged').count(), 0);
    assert.deepEqual(await namesOf(tab), ['First', 'Second', 'Third']);
    await press();
    await page.mouse.move(edge.x, row.y - row.height);
    assert.equal(await page.locator('#objects .dragged').count(), 1);
    await page.mouse.move(edge.x, row.y + 2.2 * row.height, { steps: 4 });
    await page.mouse.up();
    assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second']);
    await tab.close();
  });

  test('a copied group is one group, even with hidden or locked members', async () => {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    const rows = page.locator('#objects > li');
    const names = page.locator('#objects .object');
    const groupRows = page.locator('#objects .group-row .group-name');
    const drawing = async () => (await tab.state()).drawing;
    const groups = async () => (await drawing()).objects.map(({ group }) => group);
    const leaveCopy = async () => {
      await page.locator('#tool-select').click();
      const { x, y } = await tab.onCurve(0.5);
      await page.keyboard.down('Alt');
      await tab.drag({ x, y }, { x: x + 25, y: y + 15 });
      await page.keyboard.up('Alt');
      await tab.settled();
    };
    await names.nth(0).click();
    await names.nth(1).click({ modifiers: ['Shift'] });
    await names.nth(2).click({ modifiers: ['Shift'] });
    await page.keyboard.press('Control+g');
    await groupRows.first().click();
    const grouped = await drawing();
    await leaveCopy();
    const [first, second] = ['Group 1', 'Group 2'].map((group) => Array(3).fill(group));
    assert.deepEqual(await groups(), [...second, ...first]);
    assert.equal(await groupRows.count(), 2);
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.deepEqual((await drawing()).objects, grouped.objects);

    // The second object is hidden, and moves with the others. The first one is locked: it stays in
    // place, without a copy.
    await rows.nth(2).locator('button').nth(1).click();
    await rows.nth(3).locator('button').nth(2).click();
    await names.nth(0).click();
    const mixed = await drawing();
    const told = (objects) => objects.map(({ visible, locked }) => [visible, locked]);
    assert.deepEqual(told(mixed.objects), [
      [true, true],
      [false, false],
      [true, false],
    ]);
    const takeBack = async () => {
      await page.keyboard.press('Control+z');
      await tab.settled();
      assert.deepEqual((await drawing()).objects, mixed.objects);
      await groupRows.first().click();
    };
    await leaveCopy();
    assert.deepEqual(await groups(), [...second.slice(1), ...first]);
    const { objects: apart } = await drawing();
    assert.deepEqual(told(apart), [...told(mixed.objects).slice(1), ...told(mixed.objects)]);
    const isMoved = (object) =>
      JSON.stringify(object.figure) !==
      JSON.stringify(mixed.objects.find(({ id }) => id === object.id).figure);
    assert.deepEqual(apart.slice(2).map(isMoved), [false, true, true]);
    await takeBack();
    await page.keyboard.press('Control+d');
    await tab.settled();
    assert.deepEqual(await groups(), [...first, ...second]);
    assert.deepEqual(told((await drawing()).objects).slice(3), told(mixed.objects));
    await takeBack();
    await page.keyboard.press('Delete');
    await page.getByText('What is locked is not deleted.').first().waitFor();
    assert.deepEqual(
      (await drawing()).objects.filter(({ name }) => name).map(({ name }) => name),
      ['First'],
    );
    await takeBack();
    await page.locator('#ungroup').click();
    assert.deepEqual(await groups(), [null, null, null]);
    await takeBack();
    await tab.close();
  });

  inLongRun(
    'a group whose members are not neighbors has a row above each run, and is one group',
    async () => {
      const grouped = (faces, name) => `${other(faces, name)}${encodeURIComponent('&group=A')}`;
      const lines = `mesh=sphere:1500&kind=polyline&points=${at([20, 40])}&name=Third&group=A&place=2`;
      const tab = await Tab.open(
        browser,
        [lines, grouped([60, 90], 'First'), other([10, 500], 'Second')].join('&'),
      );
      const { page } = tab;
      const objects = async () => (await tab.state()).drawing.objects;
      const told = async () => (await objects()).map(({ name, group }) => `${name} ${group}`);
      const groupRows = page.locator('#objects .group-row');
      const before = await objects();
      assert.deepEqual(await told(), ['First A', 'Second null', 'Third A']);
      assert.equal(await groupRows.count(), 2);
      for (const row of [0, 1]) {
        await groupRows.nth(row).locator('.group-name').click();
        assert.deepEqual((await tab.state()).chosen, [1, 3]);
      }
      for (const copy of ['Control+d', 'Control+c']) {
        await page.keyboard.press(copy);
        if (copy === 'Control+c') await page.keyboard.press('Control+v');
        await page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 5);
        await tab.settled();
        assert.deepEqual((await told()).slice(0, 3), ['First A', 'Second null', 'Third A']);
        assert.equal(new Set((await objects()).slice(3).map(({ group }) => group)).size, 1);
        assert.equal(await groupRows.count(), 3);
        await page.keyboard.press('Control+z');
        assert.deepEqual(await objects(), before);
        await groupRows.first().locator('.group-name').click();
      }
      await page.keyboard.press('Delete');
      assert.deepEqual(await told(), ['Second null', ' null']);
      await page.keyboard.press('Control+z');
      assert.deepEqual(await objects(), before);
      await groupRows.nth(1).locator('.group-name').click();
      await page.keyboard.press('Control+g');
      assert.deepEqual(await told(), ['Second null', 'First Group 1', 'Third Group 1']);
      assert.equal(await groupRows.count(), 1);
      await tab.close();
    },
  );

  test('a group has a row, which selects, folds, renames, hides, locks and moves its members', async () => {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    const row = page.locator('#objects .group-row');
    const names = page.locator('#objects .object');
    const objects = async () => (await tab.state()).drawing.objects;
    const groups = async () => (await objects()).map(({ group }) => group);
    const middle = async (locator) => {
      const box = await locator.boundingBox();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    };
    await names.nth(1).click();
    await names.nth(2).click({ modifiers: ['Shift'] });
    await page.keyboard.press('Control+g');
    assert.deepEqual(await groups(), ['Group 1', 'Group 1', null]);
    assert.equal(await row.count(), 1);
    assert.equal(await row.locator('.group-name').textContent(), 'Group 12');
    await names.first().click();
    assert.deepEqual((await tab.state()).chosen, [3]);
    await row.locator('.group-name').click();
    assert.deepEqual((await tab.state()).chosen.toSorted(), [1, 2]);
    assert.equal(await row.locator('.group-name').getAttribute('aria-pressed'), 'true');
    assert.equal(await names.count(), 3);
    await row.locator('.fold').click();
    assert.equal(await names.count(), 1);
    assert.equal(await row.locator('.fold').getAttribute('aria-expanded'), 'false');
    await row.locator('.fold').press('Enter');
    assert.equal(await names.count(), 3);

    await row.locator('.group-name').dblclick();
    await page.keyboard.type('Petals');
    await page.keyboard.press('Enter');
    assert.deepEqual(await groups(), ['Petals', 'Petals', null]);
    assert.equal(await page.locator('#object-name').inputValue(), 'Petals');
    for (const [button, property] of [
      ['.eye', 'visible'],
      ['.lock', 'locked'],
    ]) {
      const told = async () => (await objects()).map((object) => object[property]);
      const before = await told();
      await row.locator(button).click();
      assert.deepEqual(await told(), [!before[0], !before[1], before[2]]);
      await row.locator(button).click();
      assert.deepEqual(await told(), before);
    }

    // Keys move the whole group past the object above, and another object past the whole group.
    await row.locator('.group-name').press('Alt+ArrowUp');
    assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second']);
    await page.keyboard.press('Alt+ArrowDown');
    assert.deepEqual(await namesOf(tab), ['First', 'Second', 'Third']);
    await names.first().press('Alt+ArrowDown');
    assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second']);
    await page.keyboard.press('Alt+ArrowUp');
    assert.deepEqual(await namesOf(tab), ['First', 'Second', 'Third']);

    // A drag of the group's row moves its members along.
    await tab.drag(await middle(row.locator('.group-name')), await middle(names.first()));
    assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second']);
    assert.deepEqual(await groups(), [null, 'Petals', 'Petals']);
    assert.equal(await names.count(), 3);
    // An object dropped among the members joins them, and elsewhere leaves them.
    await tab.drag(await middle(names.nth(2)), await middle(names.nth(1)));
    assert.deepEqual(await namesOf(tab), ['First', 'Third', 'Second']);
    assert.deepEqual(await groups(), ['Petals', 'Petals', 'Petals']);
    await page.keyboard.press('Control+z');
    assert.deepEqual(await groups(), [null, 'Petals', 'Petals']);
    await tab.drag(await middle(names.nth(0)), await middle(names.nth(2)));
    assert.deepEqual(await namesOf(tab), ['Second', 'Third', 'First']);
    assert.deepEqual(await groups(), [null, null, 'Petals']);
    await tab.close();
  });

  test('a right click opens a menu for the object there, and a right drag does not turn the view', async () => {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    const menu = page.locator('#context-menu');
    const place = await tab.onCurve(0.5);
    await page.mouse.click(place.x, place.y, { button: 'right' });
    await menu.waitFor();
    assert.deepEqual((await tab.state()).chosen, [3]);
    await menu.getByRole('menuitem', { name: 'Send to back' }).click();
    assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second']);
    await page.mouse.click(place.x, place.y, { button: 'right' });
    await menu.getByRole('menuitem', { name: 'Delete' }).click();
    await tab.settled();
    const names = await namesOf(tab);
    assert.ok(!names.includes('Third'));
    await page.mouse.move(place.x, place.y);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(place.x + 60, place.y, { steps: 4 });
    await page.mouse.up({ button: 'right' });
    assert.equal(await menu.isVisible(), false);
    await tab.close();
  });

  inLongRun('a resting finger opens the menu, and adds no point', async () => {
    const tab = await Tab.open(browser, fragment);
    const { page } = tab;
    const { x, y } = await tab.middle();
    const { touch } = await touchOf(page);
    const before = JSON.stringify((await tab.state()).drawing);
    await touch('touchStart', { x: x - 30, y: y + 90 });
    await page.locator('#context-menu').waitFor();
    await touch('touchEnd');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), before);
    await page.locator('#context-menu').getByRole('menuitem', { name: 'Select all' }).click();
    assert.deepEqual((await tab.state()).chosen.toSorted(), [1, 2, 3]);
    await tab.close();
  });

  inLongRun('a finger drags rows by their grips, and scrolls elsewhere', async () => {
    const phone = await openBrowser({ viewport: { width: 390, height: 844 }, hasTouch: true });
    try {
      const tab = await Tab.open(phone, fragment);
      const { page } = tab;
      const { together } = await touchOf(page);
      await page.locator('#objects').scrollIntoViewIfNeeded();
      const still = () =>
        page.waitForFunction(() =>
          document.getAnimations().every(({ playState }) => playState !== 'running'),
        );
      const middle = async (row, part) => {
        const box = await page.locator(`#objects ${part}`).nth(row).boundingBox();
        return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      };
      /** Drags from one row to another; the finger stays down until `ended`. */
      const drag = async (part, from, to, ended = 'touchEnd') => {
        await still();
        const [start, end] = [await middle(from, part), await middle(to, part)];
        const at = (part) => ({ x: start.x, y: start.y + (end.y - start.y) * part });
        await together(
          ['touchStart', start],
          ...[1, 2, 3, 4, 5, 6].map((step) => ['touchMove', at(step / 6)]),
          [ended],
        );
        await tab.settled();
      };
      await drag('.row-grip', 0, 2);
      assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second'], 'the topmost to the foot');
      assert.equal((await tab.state()).drawing.active, 3, 'and a drag is no tap');
      await drag('.row-grip', 2, 1);
      assert.deepEqual(await namesOf(tab), ['First', 'Third', 'Second']);
      // A drag that the system cancels has no effect.
      await drag('.row-grip', 0, 2, 'touchCancel');
      assert.deepEqual(await namesOf(tab), ['First', 'Third', 'Second']);
      assert.equal(await page.locator('#objects .dragged').count(), 0);
      await drag('.object span', 0, 2);
      assert.deepEqual(await namesOf(tab), ['First', 'Third', 'Second'], 'elsewhere it scrolls');
      await page.locator('#undo').tap();
      assert.deepEqual(await namesOf(tab), ['Third', 'First', 'Second'], 'each is one step');
      assert.deepEqual(tab.logged, []);
    } finally {
      await phone.close();
    }
  });

  test('objects are copied, cut and pasted by the menu of a right click', async () => {
    await browser.context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const tab = await Tab.open(browser);
    await tab.click([-60, 10], [-20, -50], [30, 10], [70, -50]);
    await tab.page.keyboard.press('v');
    await tab.settled();
    const ask = async (name) => {
      const { x, y } = await tab.onCurve(0.5);
      await tab.page.mouse.click(x, y, { button: 'right' });
      await tab.page.getByRole('menuitem', { name, exact: true }).click();
      await tab.settled();
    };
    const drawn = async () =>
      (await tab.state()).drawing.objects.filter(({ figure }) => figure.points.length > 0);
    const count = (many) =>
      tab.page.waitForFunction(
        (wanted) =>
          window.karcherPage
            .state()
            .drawing.objects.filter(({ figure }) => figure.points.length > 0).length === wanted,
        many,
      );
    const [first] = await drawn();
    await ask('Copy');
    await ask('Paste');
    await count(2);
    await tab.settled();
    assert.deepEqual((await drawn())[1].figure, first.figure);
    await ask('Cut');
    await count(1);
    await tab.close();
  });
});
