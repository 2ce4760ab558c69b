// Relief, a light that turns, and blues that are told apart.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';
import { pageModule } from './page_module.mjs';

describe('hollows', () => {
  let hollowsOf;
  before(async () => {
    ({ hollowsOf } = await pageModule('../../web/viewer/hollows.ts'));
  });

  /** A square grid of heights, with the normals of its faces' mean. */
  function grid(cells, height) {
    const [positions, normals, triangles] = [[], [], []];
    const at = (i) => i / cells - 0.5;
    for (let j = 0; j <= cells; j++) {
      for (let i = 0; i <= cells; i++) {
        const [x, y, h] = [at(i), at(j), 1e-5];
        positions.push(x, y, height(x, y));
        const slope = [
          (height(x + h, y) - height(x - h, y)) / (2 * h),
          (height(x, y + h) - height(x, y - h)) / (2 * h),
        ];
        const length = Math.hypot(...slope, 1);
        normals.push(-slope[0] / length, -slope[1] / length, 1 / length);
      }
    }
    for (let j = 0; j < cells; j++) {
      for (let i = 0; i < cells; i++) {
        const a = j * (cells + 1) + i;
        triangles.push(a, a + 1, a + cells + 2, a, a + cells + 2, a + cells + 1);
      }
    }
    return [Float32Array.from(positions), Float32Array.from(normals), Uint32Array.from(triangles)];
  }
  const middle = (cells) => (cells / 2) * (cells + 1) + cells / 2;

  test('are none in a plane, deep in a pit, and as deep whatever the size; hills are the opposite', () => {
    const cells = 40;
    const flat = hollowsOf(...grid(cells, () => 0));
    assert.ok(Math.abs(flat[middle(cells)]) < 1e-6);
    const pit = (x, y) => -0.15 * Math.exp(-40 * (x * x + y * y));
    const [positions, normals, triangles] = grid(cells, pit);
    const deep = hollowsOf(positions, normals, triangles)[middle(cells)];
    assert.ok(deep > 0.2 && deep <= 1, `${deep}`);
    const large = hollowsOf(
      positions.map((value) => 1000 * value),
      normals,
      triangles,
    );
    assert.ok(Math.abs(large[middle(cells)] - deep) < 1e-3);
    const hill = hollowsOf(...grid(cells, (x, y) => -pit(x, y)))[middle(cells)];
    assert.ok(Math.abs(hill + deep) < 1e-3, `${hill} ${deep}`);
  });
});

describe('looks', () => {
  let browser;
  before(async () => {
    browser = await openBrowser({ viewport: { width: 1280, height: 800 }, pixelRatio: 1 });
  });
  after(() => browser.close());

  /** How bright the stage is at offsets from its middle. */
  async function brightness(tab, offsets) {
    await tab.still();
    const { x, y } = await tab.middle();
    const clip = { x: x - 200, y: y - 200, width: 400, height: 400 };
    const png = (await tab.page.screenshot({ clip })).toString('base64');
    return tab.page.evaluate(
      async ([base64, places]) => {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const context = new OffscreenCanvas(400, 400).getContext('2d', {
          willReadFrequently: true,
        });
        context.drawImage(bitmap, 0, 0);
        return places.map(([dx, dy]) => {
          const [r, g, b] = context.getImageData(200 + dx, 200 + dy, 1, 1).data;
          return r + g + b;
        });
      },
      [png, offsets],
    );
  }

  test('the light turns by a click, with the hand or by keys', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000');
    const sides = [
      [-120, -120],
      [120, -120],
    ];
    const [left, right] = await brightness(tab, sides);
    assert.ok(left > right + 30, `${left} ${right}`);
    await tab.page.locator('#view').click();
    for (let turn = 0; turn < 2; turn++) await tab.page.locator('#light').click();
    await tab.page.locator('#light').focus();
    for (let turn = 0; turn < 6; turn++) await tab.page.keyboard.press('Enter');
    await tab.page.keyboard.press('Escape');
    const round = await brightness(tab, sides);
    assert.ok(Math.abs(round[0] - left) < 6 && Math.abs(round[1] - right) < 6, `${round}`);
    await tab.page.locator('#view').click();
    for (let turn = 0; turn < 6; turn++) await tab.page.locator('#light').click();
    await tab.page.keyboard.press('Escape');
    const [turnedLeft, turnedRight] = await brightness(tab, sides);
    assert.ok(turnedRight > turnedLeft + 30, `${turnedLeft} ${turnedRight}`);
    assert.deepEqual(tab.logged, []);
    await tab.page.close();
  });

  test('relief is shown until it is switched off', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:2');
    const places = Array.from({ length: 1600 }, (_, i) => [
      10 * (i % 40) - 200,
      10 * Math.floor(i / 40) - 200,
    ]);
    const shown = await brightness(tab, places);
    await tab.page.locator('#view').click();
    await tab.page.locator('#relief').click();
    assert.equal(await tab.page.locator('#relief').getAttribute('aria-checked'), 'false');
    await tab.page.keyboard.press('Escape');
    const plain = await brightness(tab, places);
    const darker = shown.filter((value, i) => value < plain[i] - 10).length;
    assert.ok(darker > 50, `${darker}`);
    assert.deepEqual(tab.logged, []);
    await tab.page.close();
  });

  test('the color fields show the default color where a line has no color of its own', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:320&kind=polyline');
    await tab.click([-60, 0], [60, 0]);
    const shown = () =>
      tab.page.evaluate(() =>
        ['color', 'fill-color'].map((id) => document.getElementById(id).value),
      );
    const plain = await shown();
    assert.equal(plain[0], plain[1]);
    await tab.page.locator('#swatches button').nth(3).click();
    assert.deepEqual(await shown(), ['#8a3ffc', '#8a3ffc']);
    await tab.page.locator('#swatches button').first().click();
    assert.deepEqual(await shown(), plain);
    await tab.page.emulateMedia({ colorScheme: 'dark' });
    await tab.page.locator('#swatches button').nth(3).click();
    await tab.page.locator('#swatches button').first().click();
    assert.notDeepEqual(await shown(), plain, 'the dark theme has another one');
    await tab.page.close();
  });

  for (const colorScheme of ['light', 'dark']) {
    test(`controls, handles and the default line are told apart, ${colorScheme}`, async () => {
      const tab = await Tab.open(browser, 'mesh=sphere:320');
      await tab.page.emulateMedia({ colorScheme });
      const colors = await tab.page.evaluate(() => {
        const context = new OffscreenCanvas(1, 1).getContext('2d');
        const probe = document.body.appendChild(document.createElement('i'));
        return ['accent', 'handle', 'curve'].map((name) => {
          probe.style.color = `var(--${name})`;
          context.fillStyle = getComputedStyle(probe).color;
          context.fillRect(0, 0, 1, 1);
          return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
        });
      });
      for (let i = 0; i < 3; i++) {
        for (let j = 0; j < i; j++) {
          const apart = Math.hypot(...colors[i].map((value, k) => value - colors[j][k]));
          assert.ok(apart > 60, `${colors[i]} and ${colors[j]}`);
        }
      }
      await tab.page.close();
    });
  }
});
