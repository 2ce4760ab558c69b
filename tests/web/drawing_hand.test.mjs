// Drawing protects other work: the pen leaves other lines alone, all paths continue after undo and
// close in the same way, and a drag draws a circle.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { browserOfSuite, openPhone, Tab, touchOf } from './browser.mjs';
import { part } from './part.mjs';

describe('drawing by hand', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const objectsOf = async (tab) => (await tab.state()).drawing.objects;
  const at = async (tab, [dx, dy]) => {
    const { x, y } = await tab.middle();
    return { x: x + dx, y: y + dy };
  };
  const path = [
    [-100, 60],
    [0, 90],
    [100, 60],
  ];

  test('the pen continues over another object’s line, and does not change that', async () => {
    const tab = await Tab.open(browser);
    await tab.click([-100, -60], [-30, -90], [30, -60], [100, -80]);
    const before = JSON.stringify((await objectsOf(tab))[0].figure);
    await tab.page.keyboard.press('p');
    await tab.click(...path);
    const { x, y } = await tab.onCurve(0.5, 0);
    await tab.page.mouse.click(x, y);
    await tab.settled();
    const objects = await objectsOf(tab);
    assert.equal(JSON.stringify(objects[0].figure), before);
    assert.equal(objects[1].figure.kind, 'pen');
    assert.equal(objects[1].figure.points.length, 4);
    assert.equal((await tab.state()).drawing.active, objects[1].id);
    await tab.close();
  });

  test('after undo the path of the pen continues where it was', async () => {
    const tab = await Tab.open(browser);
    await tab.page.keyboard.press('p');
    await tab.click(...path);
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    await tab.click([120, 0]);
    const objects = await objectsOf(tab);
    assert.deepEqual(
      objects.map(({ figure }) => figure.points.length),
      [3],
    );
    await tab.close();
  });

  for (const [key, name] of [
    ['p', 'Anchor 1 of 3'],
    ['b', 'Control point 1 of 3'],
  ]) {
    test(`a click on the first point closes the path of tool ${key}`, async () => {
      const tab = await Tab.open(browser);
      await tab.page.keyboard.press(key);
      await tab.click(...path);
      const { x, y } = await tab.handle(name);
      await tab.page.mouse.click(x, y);
      await tab.settled();
      const [{ figure }] = await objectsOf(tab);
      assert.equal(figure.settings.closed, true);
      assert.equal(figure.points.length, 3);
      await tab.close();
    });
  }

  test('a click on the first point closes the edited curve, and no other selected one', async () => {
    const tab = await Tab.open(browser);
    const { keyboard } = tab.page;
    const places = [...path, [60, 20]];
    await keyboard.press('b');
    await tab.click(...places.map(([x, y]) => [x, y - 130]));
    await keyboard.press('Enter');
    await tab.click(...places);
    await tab.page
      .locator('#objects .object')
      .nth(1)
      .click({ modifiers: ['Shift'] });
    await tab.settled();
    for (const name of ['Control point 4 of 4', 'Control point 1 of 4']) {
      const { x, y } = await tab.handle(name);
      await tab.page.mouse.click(x, y);
      await tab.settled();
    }
    const { drawing } = await tab.state();
    assert.equal(drawing.objects.length, 2);
    const closed = drawing.objects.filter(({ figure }) => figure.settings.closed);
    assert.deepEqual(
      closed.map(({ id }) => id),
      [drawing.active],
    );
    await tab.close();
  });

  for (const [key, kind] of [
    ['o', 'circle'],
    ['e', 'ellipse'],
  ]) {
    test(`a drag draws the ${kind} from its center, as one step`, async () => {
      const tab = await Tab.open(browser);
      await tab.page.keyboard.press(key);
      await tab.settled();
      await tab.drag(await at(tab, [20, 10]), await at(tab, [90, 30]));
      const [{ figure }] = await objectsOf(tab);
      assert.equal(figure.kind, kind);
      assert.ok('face' in figure.circle.rim, 'its rim is where the drag ended');
      const view = await tab.page.evaluate(() => location.hash);
      await tab.page.keyboard.press('Control+z');
      await tab.settled();
      assert.equal((await objectsOf(tab))[0].figure.circle, null, view);
      await tab.close();
    });
  }

  test('a tool that was only tried leaves no object, and no selection', async () => {
    const tab = await Tab.open(browser);
    // The curve has enough points to remain: the page removes an unfinished curve when it is
    // deselected.
    const whole = [...path, [-90, -40]];
    await tab.click(...whole);
    const before = JSON.stringify(await objectsOf(tab));
    for (const key of ['o', 'p', 'e']) await tab.page.keyboard.press(key);
    await tab.settled();
    const rows = tab.page.locator('#objects .object');
    assert.deepEqual(await rows.allTextContents(), ['B-spline 1']);
    await tab.page.keyboard.press('v');
    await tab.settled();
    assert.equal(JSON.stringify(await objectsOf(tab)), before);
    assert.equal(await tab.page.locator('#objects [aria-current]').count(), 0);
    assert.equal(await tab.page.locator('.handle').count(), 0);
    // The next drawing is another object, which undo removes.
    await tab.page.keyboard.press('p');
    await tab.click(...whole.map(([x, y]) => [x, y - 120]));
    assert.equal(await rows.count(), 2);
    while ((await rows.count()) > 1) await tab.page.keyboard.press('Control+z');
    await tab.settled();
    const left = (await objectsOf(tab)).filter(({ figure }) => figure.points.length > 0);
    assert.equal(JSON.stringify(left), before);
    await tab.close();
  });
});

describe('drawing by a finger', () => {
  let browser;
  before(async () => {
    browser = await openPhone();
  });
  after(() => browser.close());

  for (const kind of part(['circle', 'ellipse'], 1)) {
    test(`a finger's drag draws the ${kind} from its center`, async () => {
      const tab = await Tab.open(browser);
      await tab.page.locator(`#tool-${kind}`).tap();
      await tab.settled();
      const { touch } = await touchOf(tab.page);
      const { x, y } = await tab.middle();
      await touch('touchStart', { x, y: y - 100 });
      for (let step = 1; step < 6; step++) {
        await touch('touchMove', { x: x + 12 * step, y: y - 100 + 3 * step });
      }
      await touch('touchEnd');
      await tab.settled();
      const { drawing } = await tab.state();
      const { figure } = drawing.objects[0];
      assert.equal(figure.kind, kind);
      assert.ok(figure.circle && 'face' in figure.circle.rim, 'its rim is where the finger was');
      await tab.close();
    });
  }
});
