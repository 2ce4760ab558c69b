// The fill of closed lines follows every edit, responds to clicks, and remains in links and files.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, openBrowser, openPhone, Tab, touchOf } from './browser.mjs';
import { inLongRun } from './part.mjs';

describe('fills', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const square = [
    [-80, -80],
    [80, -80],
    [80, 80],
    [-80, 80],
  ];
  async function set(tab, percent) {
    await tab.page.locator('#fill').fill(`${percent}`);
    await tab.page.keyboard.press('Enter');
    await tab.page.locator('#fill').blur();
    await tab.settled();
  }
  /** The area of a region as the sum of its triangles, from the mesh alone. */
  async function areaOf(tab, { whole, parts, corners }) {
    const { positions, triangles } = await tab.mesh();
    const corner = (face, i) => {
      const at = 3 * triangles[3 * face + i];
      return positions.slice(at, at + 3);
    };
    const cross = (a, b) =>
      [0, 1, 2].map((i) => {
        const [j, k] = [(i + 1) % 3, (i + 2) % 3];
        return a[j] * b[k] - a[k] * b[j];
      });
    const minus = (a, b) => a.map((value, i) => value - b[i]);
    const area = (face) => {
      const [a, b, c] = [0, 1, 2].map((i) => corner(face, i));
      return Math.hypot(...cross(minus(b, a), minus(c, a))) / 2;
    };
    const part = (face, [ax, ay, bx, by, cx, cy]) =>
      area(face) * Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
    let sum = Object.values(whole).reduce((total, face) => total + area(face), 0);
    Object.values(parts).forEach((face, i) => {
      sum += part(face, Object.values(corners).slice(6 * i, 6 * i + 6));
    });
    return sum;
  }
  /** The color in the middle of the stage, in a picture of the page. */
  async function pixel(tab, [dx, dy]) {
    await tab.still();
    const { x, y } = await tab.middle();
    const clip = { x: x + dx, y: y + dy, width: 1, height: 1 };
    const [color] = await tab.pixels(clip);
    return color;
  }

  test('are painted, follow a drag and undo, and have the area of their triangles', async (t) => {
    const whole = await openBrowser({ viewport: { width: 1280, height: 800 }, asUsers: true });
    t.after(() => whole.close());
    const tab = await Tab.open(whole, 'mesh=sphere:1500&kind=polyline');
    await tab.click(...square);
    await tab.page.locator('#closed').check();
    await tab.settled();
    const before = JSON.stringify((await tab.state()).drawing);
    const bare = await pixel(tab, [0, 0]);
    await set(tab, 100);
    const painted = await pixel(tab, [0, 0]);
    assert.ok(Math.hypot(...painted.map((value, i) => value - bare[i])) > 60, `${painted}`);
    const { fill } = await tab.view();
    assert.equal(fill.problem, null);
    const area = await areaOf(tab, fill.region);
    assert.ok(Math.abs(area - fill.region.area) < 1e-6 * area, `${area} ${fill.region.area}`);
    const from = await tab.handle('Control point 1 of 4');
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(from.x - 30, from.y - 20, { steps: 4 });
    await tab.settled();
    const held = (await tab.view()).fill.region;
    assert.ok(held.area > 1.05 * area, 'it follows while the hand drags');
    await tab.page.mouse.up();
    await tab.settled();
    const dragged = (await tab.view()).fill.region;
    assert.ok(Math.abs((await areaOf(tab, dragged)) - dragged.area) < 1e-6 * dragged.area);
    for (let step = 0; step < 2; step++) await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), before);
    const back = await pixel(tab, [0, 0]);
    assert.deepEqual(back, bare);
    await tab.close();
  });

  test('have no pinholes beside their border, from afar and from near', async (t) => {
    const drawn = await openBrowser({ viewport: { width: 1280, height: 800 }, asUsers: true });
    t.after(() => drawn.close());
    const tab = await Tab.open(drawn, 'mesh=sphere:1500&kind=bspline');
    await tab.click([-95, -95], [95, -80], [80, 95], [-95, 85], [-130, 0]);
    await tab.page.locator('#closed').check();
    await tab.page.locator('#fill-color').fill('#d00000');
    await set(tab, 100);
    await tab.page.keyboard.press('v');
    const { x, y } = await tab.middle();
    await tab.page.mouse.move(x - 70, y - 60);
    for (const turns of [0, 5]) {
      for (let turn = 0; turn < turns; turn++) await tab.page.mouse.wheel(0, -120);
      await tab.still();
      const [width, height] = [700, 500];
      const colors = await tab.pixels({ x: x - width / 2, y: y - height / 2, width, height });
      const red = colors.map(([r, g, b]) => r - Math.max(g, b) > 60);
      const around = [-width - 1, -width, -width + 1, -1, 1, width - 1, width, width + 1];
      const holes = red.filter(
        (is, i) => !is && around.filter((step) => red[i + step]).length >= 7,
      );
      assert.ok(red.filter(Boolean).length > 20_000);
      assert.equal(holes.length, 0, `${holes.length} pinholes after ${turns} turns of the wheel`);
    }
    await tab.close();
  });

  test('are picked by a click inside, moved by a drag there, and restored by a reload', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=circle');
    await tab.page.keyboard.press('o');
    const { x, y } = await tab.middle();
    await tab.drag({ x, y }, { x: x + 60, y });
    await set(tab, 50);
    await tab.page.keyboard.press('Enter');
    await tab.page.keyboard.press('b');
    await tab.click([-150, 120], [-100, 150], [-40, 140]);
    await tab.page.keyboard.press('v');
    await tab.page.mouse.click(x + 25, y + 15);
    await tab.settled();
    assert.equal((await tab.state()).drawing.active, 1);
    assert.ok(!(await tab.state()).none);
    const before = (await tab.view()).fill.region;
    await tab.drag({ x: x + 25, y: y + 15 }, { x: x + 45, y: y - 15 });
    const after = (await tab.view()).fill.region;
    assert.notDeepEqual(Object.values(after.whole), Object.values(before.whole));
    await tab.pastSaving();
    await tab.page.reload();
    await tab.settled();
    const { fill } = await tab.view();
    assert.deepEqual(Object.values(fill.region.whole), Object.values(after.whole));
    await tab.close();
  });

  test('have a color of their own, and are in the SVG as they appear', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=polyline');
    await tab.click(...square);
    await tab.page.locator('#closed').check();
    await tab.page.locator('#fill-color').fill('#0b8457');
    await tab.settled();
    const [{ fill, fillColor }] = (await tab.state()).drawing.objects;
    assert.deepEqual([fill, fillColor], [0.5, '#0b8457']);
    const { text } = await tab.save('SVG');
    const [, path] = /<path fill="#0b8457" fill-opacity="0.5" d="([^"]+)"/.exec(text);
    const triangles = path.split('Z').slice(0, -1);
    const area = triangles.reduce((sum, triangle) => {
      const [ax, ay, bx, by, cx, cy] = triangle.match(/-?[\d.]+/g).map(Number);
      return sum + ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
    }, 0);
    const around = await tab.page.evaluate(() => {
      const { polyline } = window.karcherPage.view().curve;
      let sum = 0;
      for (let i = 3; i < polyline.length; i += 3) {
        const [a, b] = [i - 3, i].map((at) =>
          window.karcherPage.seen(polyline.subarray(at, at + 3)),
        );
        sum += (a.x * b.y - b.x * a.y) / 2;
      }
      return Math.abs(sum);
    });
    assert.ok(Math.abs(area - around) < 0.002 * around, `${area} of ${around} pixels`);
    await tab.close();
  });

  /** A closed polyline a little above the equator of a sphere, seen from the front. */
  async function nearHalf() {
    const first = await Tab.open(browser, 'mesh=sphere:3000');
    const { positions, triangles } = await first.mesh();
    await first.page.close();
    const nearest = (degrees) => {
      const angle = (degrees * Math.PI) / 180;
      const [x, y, z] = [Math.sin(angle), 0.2, Math.cos(angle)];
      const apart = (face) => {
        const at = 3 * triangles[3 * face];
        return Math.hypot(positions[at] - x, positions[at + 1] - y, positions[at + 2] - z);
      };
      let best = 0;
      for (let face = 1; face < triangles.length / 3; face++) {
        if (apart(face) < apart(best)) best = face;
      }
      return `${best},0.4,0.3`;
    };
    const points = [0, 90, 180, 270].map(nearest).join(';');
    return Tab.open(browser, `mesh=sphere:3000&kind=polyline&closed=1&points=${points}&fill=0.5`);
  }
  const filled = async (tab) => (await tab.view()).fill.region.area;

  test('keep their side when a curve is dragged over more than half of the surface', async () => {
    const tab = await nearHalf();
    const whole = 4 * Math.PI;
    const small = await filled(tab);
    assert.ok(small < 0.48 * whole, `${small}`);
    const before = JSON.stringify((await tab.state()).drawing);
    const from = await tab.handle('Control point 1 of 4');
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(from.x, from.y + 230, { steps: 12 });
    await tab.settled();
    const held = await filled(tab);
    assert.ok(held > 0.505 * whole, `while it is held: ${held}`);
    await tab.page.mouse.up();
    await tab.settled();
    const large = await filled(tab);
    assert.ok(Math.abs(large - held) < 0.01 * whole, `${large}`);
    const after = JSON.stringify((await tab.state()).drawing);

    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), before);
    assert.equal(await filled(tab), small);
    await tab.page.keyboard.press('Control+y');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), after);
    assert.equal(await filled(tab), large);

    await tab.pastSaving();
    const link = tab.page.url();
    assert.match(link, /inside=(left|right)/);
    await tab.page.reload();
    await tab.settled();
    assert.ok(Math.abs((await filled(tab)) - large) < 1e-3, 'it comes back with the page');
    const other = await Tab.open(browser, link.split('#')[1]);
    assert.ok(Math.abs((await filled(other)) - large) < 1e-3, 'a link has it');
    await other.close();

    await tab.page.keyboard.press('Control+d');
    await tab.settled();
    const [one, copy] = (await tab.state()).drawing.objects;
    assert.equal(copy.figure.inside, one.figure.inside);
    await tab.close();
  });

  test('keep to their side when the frame makes a figure larger than half of the surface', async () => {
    const tab = await nearHalf();
    const whole = 4 * Math.PI;
    const small = await filled(tab);
    const before = JSON.stringify((await tab.state()).drawing);
    await tab.page.locator('#tool-transform').click();
    await tab.page.locator('#scale').fill('125');
    await tab.page.locator('#scale').press('Enter');
    const changedFrom = (drawing) =>
      tab.page.waitForFunction((last) => {
        const state = window.karcherPage.state();
        return JSON.stringify(state.drawing) !== last && !state.dragging;
      }, drawing);
    await changedFrom(before);
    const large = await filled(tab);
    assert.ok(small < 0.48 * whole && large > 0.52 * whole, `${small}, ${large}`);
    const after = JSON.stringify((await tab.state()).drawing);
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), before);
    await tab.page.keyboard.press('Control+y');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), after);
    await tab.close();
  });

  inLongRun('change the side by a button, and keep it when the curve is reversed', async () => {
    const tab = await nearHalf();
    const whole = 4 * Math.PI;
    const before = await filled(tab);
    await tab.page.locator('#other-side').click();
    await tab.settled();
    const sum = before + (await filled(tab));
    assert.ok(Math.abs(sum - whole) < 0.01 * whole, `${sum}`);
    const turned = await filled(tab);
    await tab.page.locator('#reverse').click();
    await tab.settled();
    assert.ok(Math.abs((await filled(tab)) - turned) < 1e-6 * whole);
    for (let step = 0; step < 2; step++) await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(await filled(tab), before);
    const otherSide = tab.page.locator('#other-side');
    await tab.page.locator('#tool-select').click();
    await tab.page.locator('#stage').press('Escape');
    await tab.page.locator('#stage').press('Escape');
    assert.ok(await otherSide.isDisabled(), 'where nothing is selected');
    await tab.page.locator('#objects .object').first().click();
    assert.ok(await otherSide.isEnabled());
    await tab.page.locator('#fill').fill('0');
    await tab.page.keyboard.press('Enter');
    await tab.settled();
    assert.ok(await otherSide.isDisabled(), 'where nothing is filled');
    await tab.close();
  });

  test('the menu at a place makes offsets, cuts and booleans of the selection', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=circle');
    const { x, y } = await tab.middle();
    const items = async () => {
      await tab.page.mouse.click(x + 20, y, { button: 'right' });
      return tab.page.locator('#context-menu [role=menuitem]').allTextContents();
    };
    const made = ['Offset', 'Cut the surface', 'Union', 'Intersection'];
    assert.deepEqual(
      (await items()).filter((name) => made.includes(name)),
      [],
      'where there is nothing',
    );
    await tab.page.keyboard.press('Escape');
    for (const dx of [-40, 40]) {
      await tab.page.keyboard.press('o');
      await tab.drag({ x: x + dx, y }, { x: x + dx + 70, y });
      await tab.page.keyboard.press('Enter');
    }
    await tab.page.keyboard.press('v');
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('Control+a');
    const all = await items();
    assert.deepEqual(
      all.filter((name) => made.includes(name)),
      made,
    );
    await tab.page.getByRole('menuitem', { name: 'Intersection', exact: true }).click();
    await tab.settled();
    assert.equal((await tab.state()).figure.kind, 'intersection');
    await tab.close();
  });

  inLongRun('of an open line are empty, and the page says so', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...square);
    await set(tab, 40);
    const { fill } = await tab.view();
    assert.equal(fill.region, null);
    assert.match(await tab.page.locator('#hint').textContent(), /^Nothing is filled: /);
    await tab.page.locator('#closed').check();
    await tab.settled();
    assert.ok((await tab.view()).fill.region);
    assert.doesNotMatch(await tab.page.locator('#hint').textContent(), /filled/);
    await tab.close();
  });
});

describe('fills on a phone', () => {
  inLongRun('are picked by a tap inside', async () => {
    const browser = await openPhone();
    try {
      const tab = await Tab.open(browser);
      const { page } = tab;
      const { touch } = await touchOf(page);
      const { x, y } = await tab.middle();
      await page.locator('#tool-circle').tap();
      await touch('touchStart', { x, y: y - 60 });
      for (let step = 1; step < 6; step++) await touch('touchMove', { x: x + 9 * step, y: y - 60 });
      await touch('touchEnd');
      await tab.settled();
      await page.locator('#fill').fill('60');
      await page.keyboard.press('Enter');
      await page.locator('#tool-select').tap();
      await tab.settled();
      assert.ok((await tab.view()).fill.region);
      for (let tap = 0; tap < 2; tap++) await page.touchscreen.tap(x - 180, y - 190);
      await tab.settled();
      assert.equal((await tab.state()).none, true, 'beside the surface a tap lets go');
      await page.touchscreen.tap(x + 22, y - 50);
      await tab.settled();
      assert.equal((await tab.state()).none, false);
      assert.deepEqual(tab.logged, []);
    } finally {
      await browser.close();
    }
  });
});
