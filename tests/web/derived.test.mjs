// Derived objects, which follow others: offsets and booleans, created and changed by hand.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';
import { fitsFile } from './schema.mjs';

describe('objects made of others', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const drawingOf = async (tab) => (await tab.state()).drawing;
  const near = (value, wanted, part, what) =>
    assert.ok(Math.abs(value - wanted) < part * wanted, `${what}: ${value}, not ${wanted}`);
  const type = async (tab, field, text) => {
    await tab.page.locator(field).fill(text);
    await tab.page.keyboard.press('Enter');
    await tab.settled();
  };
  const maker = (tab, name) =>
    tab.page.locator('#makers').getByRole('button', { name, exact: true });
  const side = (tab, name) =>
    tab.page.locator('#offset-side').getByText(name, { exact: true }).click();
  /** The length of a circle on the unit sphere. */
  const around = (radius) => 2 * Math.PI * Math.sin(radius);

  /** A circle around the middle of a sphere. */
  async function withCircle(fields = '') {
    const tab = await Tab.open(browser, `mesh=sphere:6000&kind=circle${fields}`);
    const { x, y } = await tab.middle();
    await tab.drag({ x, y }, { x: x + 90, y });
    const { radius } = (await tab.view()).circle;
    return { tab, radius };
  }

  test('an offset keeps its distance, outwards, inwards and on both sides, and follows its source', async () => {
    const { tab, radius } = await withCircle();
    await maker(tab, 'Offset').click();
    await tab.settled();
    // The user has selected the field of the distance, so that typing replaces its content.
    await tab.page.keyboard.type('0.1');
    await tab.page.keyboard.press('Enter');
    await tab.settled();
    const lengths = async () => (await tab.view()).isolines.lines.map(({ length }) => length);
    near((await lengths())[0], around(radius + 0.1), 0.005, 'outwards');
    await side(tab, 'Inwards');
    await tab.settled();
    near((await lengths())[0], around(radius - 0.1), 0.005, 'inwards');
    await side(tab, 'Both sides');
    await tab.settled();
    const both = (await lengths()).toSorted((a, b) => a - b);
    assert.equal(both.length, 2);
    near(both[0], around(radius - 0.1), 0.005, 'the inner one');
    near(both[1], around(radius + 0.1), 0.005, 'the outer one');
    // With a fill the object is a band, whose area the page shows.
    await type(tab, '#fill', '50');
    const cap = (r) => 2 * Math.PI * (1 - Math.cos(r));
    const band = cap(radius + 0.1) - cap(radius - 0.1);
    assert.equal((await tab.view()).problem, null);
    assert.equal((await tab.view()).fill.problem, null);
    near((await tab.view()).fill.region.area, band, 0.01, 'the band');
    // The user enlarges the source, and the offset follows during the drag.
    await tab.page.locator('#objects .object').last().click();
    await tab.settled();
    const rim = await tab.handle('Radius of the circle');
    await tab.page.mouse.move(rim.x, rim.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(rim.x + 40, rim.y, { steps: 5 });
    await tab.settled();
    const held = await tab.view();
    assert.ok(held.circle.radius > radius + 0.05);
    const outer = (view) => {
      const [line] = view.others[0].lines.toSorted((a, b) => b.length - a.length);
      let sum = 0;
      for (let i = 3; i < line.length; i += 3) {
        sum += Math.hypot(...[0, 1, 2].map((k) => line[i + k] - line[i + k - 3]));
      }
      return sum;
    };
    near(outer(held), around(held.circle.radius + 0.1), 0.005, 'while the source is dragged');
    await tab.page.mouse.up();
    await tab.settled();
    const after = await tab.view();
    near(outer(after), around(after.circle.radius + 0.1), 0.005, 'after the drag');
    await tab.close();
  });

  test('corners of an offset are round, mitred or bevelled; undo, a link and a file keep the choice', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:fair:400&kind=polyline');
    const { x, y } = await tab.middle();
    for (const [dx, dy] of [
      [-60, -60],
      [60, -60],
      [60, 60],
      [-60, 60],
      [-60, -60],
    ]) {
      await tab.page.mouse.click(x + dx, y + dy);
    }
    await tab.settled();
    await maker(tab, 'Offset').click();
    await tab.settled();
    const length = async () => (await tab.view()).isolines.length;
    const corners = async (name) => {
      await tab.page.locator('#offset-corners').getByText(name, { exact: true }).click();
      await tab.settled();
      return length();
    };
    const round = await length();
    const distance = Number(await tab.page.locator('#offset-distance').inputValue());
    const sides = round - 2 * Math.PI * distance;
    const before = JSON.stringify(await drawingOf(tab));
    near(await corners('Bevelled'), sides + 4 * Math.SQRT2 * distance, 1e-3, 'bevelled');
    near(await corners('Mitred'), sides + 8 * distance, 1e-3, 'mitred');
    assert.equal((await drawingOf(tab)).objects.at(-1).figure.derived.offset.corners, 'miter');
    const saved = await tab.save(/^JSON the whole/);
    assert.ok(fitsFile(JSON.parse(saved.text)), JSON.stringify(fitsFile.errors));
    await tab.pastSaving();
    const other = await Tab.open(browser, tab.page.url().split('#')[1]);
    near((await other.view()).isolines.length, sides + 8 * distance, 1e-3, 'of the link');
    await other.close();
    near(await corners('Round'), round, 1e-9, 'round again');
    assert.equal(JSON.stringify(await drawingOf(tab)), before);
    await tab.close();
  });

  test('the settings of an offset fill the width of a narrow panel, its fields below each other', async () => {
    const { tab } = await withCircle();
    await maker(tab, 'Offset').click();
    await tab.settled();
    for (const viewport of [
      { width: 390, height: 844 },
      { width: 1280, height: 800 },
    ]) {
      await tab.page.setViewportSize(viewport);
      const { left, right } = await tab.page.evaluate(() => {
        const box = (id) => document.getElementById(id).getBoundingClientRect();
        const fields = ['offset-distance', 'offset-end'].map((id) => box(id).left);
        const ids = ['derived-settings', 'offset-side', 'offset-corners'];
        return { left: fields, right: ids.map((id) => box(id).right) };
      });
      assert.equal(new Set(left).size, 1, `${left}`);
      assert.equal(new Set(right).size, 1, `${right}`);
    }
    await tab.close();
  });

  test('an offset has another distance at the end; a step back, a link and a file know it', async () => {
    const { tab, radius } = await withCircle();
    await maker(tab, 'Offset').click();
    await tab.settled();
    await type(tab, '#offset-distance', '0.1');
    const otherEnd = ({ page }) => page.locator('#offset-end-name').textContent();
    assert.equal(await otherEnd(tab), 'Halfway');
    const before = JSON.stringify(await drawingOf(tab));
    const length = async () => (await tab.view()).isolines.length;
    const least = await length();
    await type(tab, '#offset-end', '0.3');
    const offset = { distance: 0.1, end: 0.3, side: 'outwards' };
    assert.deepEqual((await drawingOf(tab)).objects.at(-1).figure.derived.offset, offset);
    assert.equal((await tab.view()).problem, null);
    const wide = await length();
    assert.ok(wide > least + 0.05 && wide < around(radius + 0.3));
    const mitred = tab.page.locator('#offset-corners label', { hasText: 'Mitred' });
    assert.ok(await mitred.locator('input').isDisabled());
    assert.equal(await mitred.getAttribute('title'), 'With two distances corners are round');
    const faint = (name) =>
      tab.page
        .locator('#offset-corners label', { hasText: name })
        .evaluate((label) => Number(getComputedStyle(label.querySelector('span')).opacity) < 1);
    assert.deepEqual(await Promise.all(['Round', 'Mitred', 'Bevelled'].map(faint)), [
      false,
      true,
      true,
    ]);
    // The inward offset is on the other side.
    await side(tab, 'Inwards');
    await tab.settled();
    assert.ok((await length()) < around(radius - 0.1));
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    const saved = await tab.save(/^JSON the whole/);
    assert.ok(fitsFile(JSON.parse(saved.text)), JSON.stringify(fitsFile.errors));
    await tab.pastSaving();
    const other = await Tab.open(browser, tab.page.url().split('#')[1]);
    near((await other.view()).isolines.length, wide, 1e-3, 'of the link');
    await other.page.keyboard.press('Control+a');
    await other.page.keyboard.press('Delete');
    await other.drop('drawing.json', saved.text);
    await other.page.waitForFunction(() => window.karcherPage.state().figure.derived);
    await other.settled();
    assert.deepEqual((await other.state()).figure.derived.offset, offset);
    await other.close();
    const open = await Tab.open(browser, 'mesh=sphere:1500&kind=polyline');
    await open.click([-60, 10], [60, -10]);
    await open.page.keyboard.press('Escape');
    await maker(open, 'Offset').click();
    await open.settled();
    assert.equal(await otherEnd(open), 'At the end');
    await open.close();
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify(await drawingOf(tab)), before);
    await tab.close();
  });

  test('each step can be undone and redone; a reload, a link and a file have the same result', async () => {
    const { tab } = await withCircle();
    const bare = JSON.stringify(await drawingOf(tab));
    await maker(tab, 'Offset').click();
    await tab.settled();
    await type(tab, '#offset-distance', '0.2');
    await side(tab, 'Inwards');
    await tab.settled();
    const made = JSON.stringify(await drawingOf(tab));
    for (let step = 0; step < 3; step++) await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify(await drawingOf(tab)), bare);
    for (let step = 0; step < 3; step++) await tab.page.keyboard.press('Control+Shift+z');
    await tab.settled();
    assert.equal(JSON.stringify(await drawingOf(tab)), made);
    const length = (await tab.view()).isolines.length;
    const saved = await tab.save(/^JSON the whole/);
    assert.ok(fitsFile(JSON.parse(saved.text)), JSON.stringify(fitsFile.errors));
    await tab.pastSaving();
    const link = tab.page.url().split('#')[1];
    await tab.page.reload();
    await tab.settled();
    assert.equal(JSON.stringify(await drawingOf(tab)), made);
    const other = await Tab.open(browser, link);
    near((await other.view()).isolines.length, length, 1e-4, 'as long as before');
    await other.page.keyboard.press('Control+a');
    await other.page.keyboard.press('Delete');
    await other.drop('drawing.json', saved.text);
    await other.page.waitForFunction(() => window.karcherPage.state().figure.derived);
    await other.settled();
    const { derived } = (await other.state()).figure;
    assert.deepEqual(derived.offset, { distance: 0.2, side: 'inwards' });
    near((await other.view()).isolines.length, length, 1e-4, 'as long as before');
    await other.close();
    await tab.close();
  });

  inLongRun(
    'copies keep their own sources; an object without sources is removed with the last one',
    async () => {
      const { tab } = await withCircle();
      await maker(tab, 'Offset').click();
      await tab.settled();
      await tab.page.keyboard.press('Escape');
      await tab.page.locator('#stage').focus();
      await tab.page.keyboard.press('Control+a');
      await tab.page.keyboard.press('Control+d');
      await tab.settled();
      const { objects } = await drawingOf(tab);
      const sources = objects.map(({ figure }) => figure.derived?.sources ?? []);
      assert.deepEqual(
        objects.map(({ id }) => id),
        [1, 2, 3, 4],
      );
      assert.deepEqual(sources, [[], [1], [], [3]]);
      await tab.page.locator('#objects [data-id="1"] .object').click();
      await tab.page.locator('#stage').focus();
      await tab.page.keyboard.press('Delete');
      await tab.settled();
      const left = (await drawingOf(tab)).objects.filter(
        ({ figure }) => figure.circle || figure.derived,
      );
      assert.deepEqual(
        left.map(({ id }) => id),
        [3, 4],
      );
      await tab.page.keyboard.press('Control+z');
      assert.equal((await drawingOf(tab)).objects.length, 4);
      await tab.close();
    },
  );

  test('a drag of its line moves its sources, and is one step', async () => {
    const { tab } = await withCircle();
    await maker(tab, 'Offset').click();
    await tab.settled();
    const before = JSON.stringify(await drawingOf(tab));
    const { lines, length } = (await tab.view()).isolines;
    const places = lines[0].polyline;
    const seen = await tab.page.evaluate(
      (place) => window.karcherPage.seen(place),
      [0, 1, 2].map((axis) => places[axis]),
    );
    await tab.drag(seen, { x: seen.x - 30, y: seen.y + 40 });
    const { objects } = await drawingOf(tab);
    const { objects: old } = JSON.parse(before);
    assert.notDeepEqual(objects[0].figure.circle.center, old[0].figure.circle.center);
    assert.deepEqual(objects[1], old[1]);
    near((await tab.view()).isolines.length, length, 0.01, 'as long as it was');
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify(await drawingOf(tab)), before);
    await tab.close();
  });

  /** Two overlapping circles of about the same radius, both selected. */
  async function withTwo() {
    const { tab } = await withCircle();
    const { x, y } = await tab.middle();
    await tab.page.keyboard.press('Enter');
    await tab.page.keyboard.press('o');
    await tab.drag({ x: x + 80, y: y + 110 }, { x: x + 160, y: y + 110 });
    await tab.page.keyboard.press('v');
    await tab.page.keyboard.press('Control+a');
    await type(tab, '#fill', '40');
    return tab;
  }

  test('booleans of two circles have consistent areas, can be exchanged, and follow a drag', async () => {
    const tab = await withTwo();
    await maker(tab, 'Union').click();
    await tab.settled();
    const area = async () => (await tab.view()).fill.region.area;
    const kind = async (name) => {
      await tab.page.locator('#kind').getByText(name, { exact: true }).click();
      await tab.settled();
      return area();
    };
    const union = await area();
    const intersection = await kind('Intersection');
    const difference = await kind('Difference');
    const exclusion = await kind('Exclusion');
    near(exclusion + intersection, union, 1e-9, 'exclusion and intersection are the union');
    const { objects } = await drawingOf(tab);
    // Operands appear as thin dashed lines.
    assert.deepEqual(
      objects.map(({ dash, fill }) => [dash, fill]),
      [
        ['dashed', 0],
        ['dashed', 0],
        ['solid', 0.4],
      ],
    );
    assert.ok(difference > 0 && difference < union);
    await kind('Union');
    await tab.page.locator('#objects [data-id="2"] .object').click();
    await tab.settled();
    const rim = await tab.handle('Radius of the circle');
    await tab.drag(rim, { x: rim.x + 30, y: rim.y });
    const other = (await tab.view()).others.find(({ id }) => id === 3);
    assert.ok(other.region.area > 1.02 * union, `${other.region.area} ${union}`);
    await tab.close();
  });

  inLongRun(
    'an intersection of separate regions is empty and says so, and expanding makes independent curves',
    async () => {
      const tab = await withTwo();
      await maker(tab, 'Difference').click();
      await tab.settled();
      const { length } = (await tab.view()).isolines;
      await tab.page.locator('#expand').click();
      await tab.settled();
      const { objects, active } = await drawingOf(tab);
      const expanded = objects.find(({ id }) => id === active).figure;
      assert.equal(expanded.kind, 'pen');
      assert.ok(expanded.settings.closed && expanded.derived === undefined);
      assert.ok(expanded.points.length < 40, `${expanded.points.length} anchors`);
      near((await tab.view()).curve.length, length, 0.01, 'the curve');
      await tab.page.keyboard.press('Control+z');
      await tab.settled();
      assert.equal((await tab.view()).isolines.length, length);
      // The user moves the operand far away.
      await tab.page.locator('#objects [data-id="2"] .object').click();
      await tab.settled();
      const center = await tab.handle('Center of the circle');
      await tab.page.locator('#objects [data-id="3"] .object').click();
      await tab.page.locator('#kind').getByText('Intersection', { exact: true }).click();
      await tab.settled();
      assert.equal((await tab.view()).problem, null);
      await tab.page.locator('#objects [data-id="2"] .object').click();
      await tab.drag(center, { x: center.x + 60, y: center.y + 60 });
      await tab.page.locator('#objects [data-id="3"] .object').click();
      await tab.settled();
      assert.match((await tab.view()).problem, /no part in common/);
      await tab.close();
    },
  );
});
