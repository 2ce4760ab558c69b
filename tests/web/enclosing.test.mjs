// What lines enclose: the rule for lines that cross themselves, the side that a click chooses, and
// the perimeter and the centroid of a fill.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { fitsFile } from './schema.mjs';

describe('what lines enclose', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });
  const drawingOf = async (tab) => (await tab.state()).drawing;
  const bytesOf = async (tab) => JSON.stringify(await drawingOf(tab));
  const near = (value, wanted, part, what) =>
    assert.ok(
      Math.abs(value - wanted) <= part * Math.abs(wanted),
      `${what}: ${value}, not ${wanted}`,
    );
  const fillWith = async (tab, percent) => {
    await tab.page.locator('#fill').fill(percent);
    await tab.page.keyboard.press('Enter');
    await tab.settled();
  };
  const area = async (tab) => (await tab.view()).fill.region.area;
  const placesOf = async (tab, points) => {
    const { positions, triangles } = await tab.mesh();
    return points.map(({ face, bary }) =>
      [0, 1, 2].map((k) =>
        bary.reduce((sum, w, i) => sum + w * positions[3 * triangles[3 * face + i] + k], 0),
      ),
    );
  };
  /** A closed polyline on a plane through places around the middle of the stage. */
  async function polygon(places) {
    const tab = await Tab.open(browser, 'mesh=plane:fair:200&kind=polyline&closed=1');
    const { x, y } = await tab.middle();
    for (const [dx, dy] of places) await tab.page.mouse.click(x + dx, y + dy);
    await tab.settled();
    const corners = await placesOf(tab, (await tab.state()).figure.points);
    assert.equal(corners.length, places.length);
    return { tab, corners };
  }
  /** The area that a closed polygon goes round, as often as it does. */
  const around = (corners) =>
    Math.abs(
      corners.reduce((sum, [x, y], i) => {
        const [u, v] = corners[(i + 1) % corners.length];
        return sum + (x * v - u * y) / 2;
      }, 0),
    );
  const sides = (corners) =>
    corners.reduce((sum, p, i) => {
      const q = corners[(i + 1) % corners.length];
      return sum + Math.hypot(...p.map((value, k) => value - q[k]));
    }, 0);
  const pentagram = Array.from({ length: 5 }, (_, i) => {
    const angle = (4 * Math.PI * i) / 5 + 0.2;
    return [130 * Math.cos(angle), 130 * Math.sin(angle)];
  });
  const status = (tab) => tab.page.locator('#status-length').textContent();

  test('a pentagram is filled even-odd or nonzero; undo, a link and a file keep the choice', async () => {
    const { tab, corners } = await polygon(pentagram);
    const { page } = tab;
    assert.ok(await page.locator('#rule-line').isHidden());
    await fillWith(tab, '50');
    const odd = await area(tab);
    const before = await bytesOf(tab);
    const length = sides(corners);
    // All sides bound the five tips.
    assert.match(await status(tab), new RegExp(`perimeter ${length.toFixed(2)}`));
    await page.locator('#fill-rule').selectOption('nonZero');
    await tab.settled();
    const whole = await area(tab);
    near(2 * whole - odd, around(corners), 1e-6, 'the tips and twice the pentagon');
    assert.ok(whole > 1.2 * odd);
    const perimeter = Number((await status(tab)).match(/perimeter ([\d.]+)/)[1]);
    assert.ok(perimeter < 0.9 * length, `${perimeter} of ${length}`);
    assert.equal((await drawingOf(tab)).objects[0].figure.rule, 'nonZero');
    const saved = await tab.save(/^JSON the whole/);
    assert.ok(fitsFile(JSON.parse(saved.text)), JSON.stringify(fitsFile.errors));
    await tab.pastSaving();
    const other = await Tab.open(browser, page.url().split('#')[1]);
    near(await area(other), whole, 1e-6, 'of the link');
    await other.close();
    await page.reload();
    await tab.settled();
    near(await area(tab), whole, 1e-6, 'after a reload');
    assert.equal(await page.locator('#fill-rule').inputValue(), 'nonZero');
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(await bytesOf(tab), before);
    near(await area(tab), odd, 1e-9, 'even-odd again');
    await page.keyboard.press('Control+Shift+z');
    await tab.settled();
    // A boolean takes the rule of its operands.
    await page.locator('#stage').focus();
    await page.keyboard.press('Control+d');
    await tab.settled();
    await page.keyboard.press('Control+a');
    await page
      .locator('#makers')
      .getByRole('button', { name: 'Intersection', exact: true })
      .click();
    await fillWith(tab, '50');
    const { objects } = await drawingOf(tab);
    assert.deepEqual(
      objects.slice(0, 2).map(({ figure }) => figure.rule),
      ['nonZero', 'nonZero'],
    );
    assert.ok(await page.locator('#fill-rule').isDisabled());
    await tab.close();
  });

  test('the centroid of a fill is marked by a point, in one step', async () => {
    const { tab, corners } = await polygon([
      [-100, 60],
      [120, 80],
      [-20, -110],
    ]);
    await fillWith(tab, '50');
    const before = await bytesOf(tab);
    await tab.page.locator('#centroid').click();
    await tab.page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
    await tab.settled();
    const mark = (await drawingOf(tab)).objects[1];
    assert.equal(mark.figure.kind, 'points');
    assert.match(mark.name, /^Centroid of /);
    const [place] = await placesOf(tab, mark.figure.points);
    for (const k of [0, 1]) {
      const mean = corners.reduce((sum, corner) => sum + corner[k] / 3, 0);
      assert.ok(Math.abs(place[k] - mean) < 1e-4, `${place[k]}, not ${mean}`);
    }
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(await bytesOf(tab), before);
    await tab.close();
  });

  test('the menu beside a fill on a closed surface chooses the side that was clicked', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:3000&kind=circle');
    const { page } = tab;
    const { x, y } = await tab.middle();
    await tab.drag({ x, y }, { x: x + 90, y });
    await fillWith(tab, '50');
    const cap = await area(tab);
    const before = await bytesOf(tab);
    await page.mouse.click(x + 20, y + 160, { button: 'right' });
    await page.getByRole('menuitem', { name: 'Fill this side', exact: true }).click();
    await tab.settled();
    const rest = await area(tab);
    near(cap + rest, 4 * Math.PI, 0.01, 'both sides');
    assert.ok(rest > cap);
    await page.mouse.click(x + 20, y + 160, { button: 'right' });
    await page.getByRole('menuitem', { name: 'Fill the other side', exact: true }).waitFor();
    await page.keyboard.press('Escape');
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(await bytesOf(tab), before);
    await tab.close();
  });

  test('a cut shows no settings of lines and fills, since it has neither', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=circle');
    const { x, y } = await tab.middle();
    await tab.drag({ x, y }, { x: x + 90, y });
    const rows = ['#line-style', '#line-opacity', '#fill-line', '#pattern-line'];
    const hidden = () => Promise.all(rows.map((row) => tab.page.locator(row).isHidden()));
    assert.deepEqual(await hidden(), [false, false, false, false]);
    await tab.page.locator('#makers').getByRole('button', { name: 'Cut', exact: true }).click();
    await tab.settled();
    assert.deepEqual(await hidden(), [true, true, true, true]);
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.deepEqual(await hidden(), [false, false, false, false]);
    await tab.close();
  });
});
