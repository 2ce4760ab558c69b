// Relief, the light that turns, the shadow on the ground, and distinct blues.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { pageModule } from './page_module.mjs';
import { inLongRun, part } from './part.mjs';

describe('hollows', () => {
  let hollowsOf;
  before(async () => {
    ({ hollowsOf } = await pageModule('../../web/viewer/hollows.ts'));
  });

  /** A square grid of heights, with mean normals of its faces. */
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

  /** The hollow of a vertex, from the widest to the narrowest neighborhood, from -1 to 1. */
  const at = (hollows, vertex) =>
    [...hollows.slice(4 * vertex, 4 * vertex + 4)].map((v) => v / 127);
  const pit = (x, y) => -0.15 * Math.exp(-40 * (x * x + y * y));

  test('are 0 in a plane and where a saddle bends equally to both sides', () => {
    const cells = 40;
    for (const height of [() => 0, (x, y) => x * x - y * y, (x, y) => x + 2 * y]) {
      for (const value of at(hollowsOf(...grid(cells, height)), middle(cells))) {
        assert.ok(Math.abs(value) < 0.02, `${value}`);
      }
    }
  });

  test('are deep in a pit, and hills are the opposite', () => {
    const cells = 40;
    const deep = at(hollowsOf(...grid(cells, pit)), middle(cells));
    assert.ok(deep[0] > 0.7, `${deep}`);
    // A neighborhood that bends like a ball of its own size is dark, a narrower one less so.
    for (let i = 1; i < 4; i++) assert.ok(deep[i] > 0 && deep[i] < deep[i - 1], `${deep}`);
    const hill = at(hollowsOf(...grid(cells, (x, y) => -pit(x, y))), middle(cells));
    for (const [i, value] of hill.entries()) assert.ok(Math.abs(value + deep[i]) < 0.01);
  });

  test('do not depend on the size of triangles', () => {
    const values = [20, 40, 80].map((cells) => at(hollowsOf(...grid(cells, pit)), middle(cells)));
    // The grid has lines four times as dense on one side as on the other.
    const graded = grid(80, pit);
    const cells = 80;
    const warp = (t) => t + 0.6 * (t * t - 0.25);
    const place = (k) => warp(k / cells - 0.5);
    const h = 1e-5;
    for (let j = 0; j <= cells; j++) {
      for (let i = 0; i <= cells; i++) {
        const [x, y] = [place(i), place(j)];
        const slope = [pit(x + h, y) - pit(x - h, y), pit(x, y + h) - pit(x, y - h)];
        const normal = [-slope[0] / (2 * h), -slope[1] / (2 * h), 1];
        const length = Math.hypot(...normal);
        const to = 3 * (j * (cells + 1) + i);
        graded[0].set([x, y, pit(x, y)], to);
        graded[1].set(
          normal.map((value) => value / length),
          to,
        );
      }
    }
    // The vertices next to the pit's middle.
    let nearest = 0;
    for (let k = 0; k < graded[0].length / 3; k++) {
      const far = (v) => Math.hypot(graded[0][3 * v], graded[0][3 * v + 1]);
      if (far(k) < far(nearest)) nearest = k;
    }
    values.push(at(hollowsOf(...graded), nearest));
    for (const [i, value] of values.entries()) {
      for (const width of [0, 1]) {
        const apart = Math.abs(value[width] - values[1][width]);
        assert.ok(apart < 0.06, `${i}: ${value} beside ${values[1]}`);
      }
    }
  });

  test('have a value at each vertex, whatever the triangles: needles, missing, or without area', () => {
    const positions = Float32Array.from([0, 0, 0, 1, 0, 0, 0.5, 1e-7, 0, 0.5, 0, 0, 9, 9, 9]);
    const normals = Float32Array.from({ length: 15 }, (_, i) => (i % 3 === 2 ? 1 : 0));
    const hollows = hollowsOf(positions, normals, Uint32Array.from([0, 1, 2, 0, 3, 1, 0, 0, 1]));
    assert.equal(hollows.length, 20);
    assert.ok(hollows.every((value) => Math.abs(value) <= 127));
  });
});

describe('looks', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 }, asUsers: true });

  /** The brightness of the stage at offsets from its middle. */
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

  /** The numbers of the stage's pixels with the warm clay of inner sides, and of the others. */
  async function specksOf(tab) {
    const { x, y } = await tab.middle();
    const clip = { x: x - 300, y: y - 250, width: 600, height: 500 };
    const png = (await tab.page.screenshot({ clip })).toString('base64');
    return tab.page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const context = new OffscreenCanvas(600, 500).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, 600, 500);
      const [inner, front] = [[], []];
      for (let i = 0; i < data.length; i += 4) {
        if (data[i] > data[i + 2] + 8) inner.push([(i / 4) % 600, Math.floor(i / 2400)]);
        else if (data[i] < data[i + 2] - 3) front.push(i);
      }
      return { inner, seen: front.length };
    }, png);
  }

  test('the light turns by a click, by a drag or by keys', async () => {
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
    await tab.close();
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
    await tab.close();
  });

  /** The brightness of places to the left and right of the middle, at a height below it. */
  const besides = (tab, below) =>
    brightness(
      tab,
      [-80, -60, 60, 80].map((x) => [x, below]),
    );
  async function chooseLook(tab, id) {
    await tab.page.locator('#view').click();
    await tab.page.locator(`#${id}`).click();
    await tab.page.keyboard.press('Escape');
  }

  test('the ground has a shadow if the user chooses it, even after a reload', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&view=0,20,2,0,0,0');
    // A unit of the scene is 200 pixels. The ground's middle lies below the ball, whose rim is 40
    // pixels to the side there.
    const below = 108;
    const plain = await besides(tab, below);
    const above = await besides(tab, -below);
    await chooseLook(tab, 'ground-shadow');
    const shaded = await besides(tab, below);
    const isDarker = (values, before) => values.every((value, i) => value < 0.97 * before[i] - 1);
    assert.ok(isDarker(shaded, plain), `${shaded} beside ${plain}`);
    assert.deepEqual(await besides(tab, -below), above, 'nothing else is darker');
    await tab.page.reload();
    await tab.settled();
    assert.deepEqual(await besides(tab, below), shaded);
    // The browser takes the drawing context away and returns it empty.
    await tab.page.evaluate(async () => {
      const canvas = document.querySelector('#canvas');
      const context = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
      context.loseContext();
      // The page's own listener runs first, so that the context may come back.
      await new Promise((resolve) => setTimeout(resolve));
      const restored = new Promise((resolve) =>
        canvas.addEventListener('webglcontextrestored', resolve, { once: true }),
      );
      context.restoreContext();
      await restored;
    });
    assert.deepEqual(await besides(tab, below), shaded);
    await tab.page.emulateMedia({ colorScheme: 'dark' });
    // On a dark background the ground has light, and the shadow is visible on it.
    const [dark, beyond] = [
      await brightness(
        tab,
        [-60, 60].map((x) => [x, below]),
      ),
      await brightness(
        tab,
        [-190, 190].map((x) => [x, below]),
      ),
    ];
    const lit = Math.min(...beyond);
    assert.ok(
      dark.every((value) => value < 0.85 * lit),
      `${dark} beside ${beyond}`,
    );
    await chooseLook(tab, 'ground-shadow');
    assert.ok(isDarker(await brightness(tab, [[190, below]]), [lit]), 'without it nothing is lit');
    await tab.page.emulateMedia({ colorScheme: 'light' });
    assert.deepEqual(await besides(tab, below), plain);
    await tab.page.close();
  });

  inLongRun(
    'the shadow lies below the surface in every position: on the ground of another upward axis',
    async () => {
      const tab = await Tab.open(browser, 'mesh=sphere:320');
      // A board that stands on its rim with y up, and lies flat with z up.
      const corners = [0, 1].flatMap((z) => [0, 1].flatMap((y) => [0, 1].map((x) => [x, y, z])));
      const quads = ['1 2 4 3', '5 7 8 6', '1 5 6 2', '3 4 8 7', '1 3 7 5', '2 6 8 4'];
      const board = [
        ...corners.map(([x, y, z]) => `v ${10 * x} ${10 * y} ${2 * z}`),
        ...quads.map((quad) => `f ${quad.split(' ').reverse().join(' ')}`),
      ];
      await tab.drop('board.obj', board.join('\n'));
      await tab.page.getByText('12 triangles').first().waitFor();
      await tab.settled();
      await chooseLook(tab, 'ground-shadow');
      // From directly above, the darker area is the shadow beside the board.
      const shadowFrom = async (axis) => {
        await tab.page.locator('#up').selectOption(axis);
        await tab.settled();
        await tab.page.locator('#view').click();
        await tab.page.getByRole('menuitem', { name: 'Top' }).click();
        await tab.still();
        await tab.page.locator('#stage').focus();
        for (let i = 0; i < 6; i++) await tab.page.keyboard.press('-');
        await tab.still();
        const places = Array.from({ length: 17 }, (_, i) => [0, 10 * i + 25]);
        const shown = await brightness(tab, places);
        await chooseLook(tab, 'ground-shadow');
        const plain = await brightness(tab, places);
        await chooseLook(tab, 'ground-shadow');
        return places.filter((_, i) => shown[i] < plain[i] - 2).map(([, y]) => y);
      };
      const [standing, lying] = [await shadowFrom('y'), await shadowFrom('z')];
      assert.ok(standing.length > 0 && standing.every((y) => y > 20 && y < 80), `${standing}`);
      assert.ok(lying.length > 0 && lying.every((y) => y > 120), `${lying}`);
      await tab.page.close();
    },
  );

  inLongRun('the rim of an open surface shows no specks of its inner side', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:2');
    const { positions, triangles } = await tab.mesh();
    const rows = (values, letter, add) =>
      Array.from({ length: values.length / 3 }, (_, i) =>
        [letter, ...values.slice(3 * i, 3 * i + 3).map((value) => value + add)].join(' '),
      );
    // The search leaves out one invisible triangle at the bottom.
    let lowest = 0;
    for (let i = 0; i < triangles.length; i += 3) {
      const height = (at) => positions[3 * triangles[at] + 1];
      if (height(i) < height(lowest)) lowest = i;
    }
    triangles.splice(lowest, 3);
    await tab.drop('open.obj', [...rows(positions, 'v', 0), ...rows(triangles, 'f', 1)].join('\n'));
    await tab.page.getByText('1 boundary').first().waitFor();
    await tab.settled();
    await tab.still();
    const specks = await specksOf(tab);
    assert.ok(specks.seen > 20_000, `${specks.seen} pixels are the surface's`);
    assert.deepEqual(specks.inner, []);
    await tab.page.close();
  });

  for (const colorScheme of part(['light', 'dark'], 1)) {
    test(`the status is legible before a surface that fills the view, ${colorScheme}`, async () => {
      const tab = await Tab.open(browser, 'mesh=sphere:5000&kind=polyline');
      await tab.page.emulateMedia({ colorScheme });
      await tab.click([-60, 0], [60, 0]);
      const { x, y } = await tab.middle();
      await tab.page.mouse.move(x, y);
      for (let notch = 0; notch < 12; notch++) await tab.page.mouse.wheel(0, -120);
      await tab.still();
      const words = tab.page.locator('#status-length');
      const clip = await words.boundingBox();
      const png = (await tab.page.screenshot({ clip })).toString('base64');
      const contrast = await words.evaluate(async (element, base64) => {
        const light = ([r, g, b]) => {
          const linear = [r, g, b].map((value) => {
            const part = value / 255;
            return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
          });
          return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2] + 0.05;
        };
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const { width, height } = bitmap;
        const context = new OffscreenCanvas(width, height).getContext('2d');
        context.fillStyle = getComputedStyle(element).color;
        context.fillRect(0, 0, 1, 1);
        const ink = light(context.getImageData(0, 0, 1, 1).data);
        context.drawImage(bitmap, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        const lights = Array.from({ length: width * height }, (_, i) =>
          light(data.slice(4 * i, 4 * i + 3)),
        ).sort((a, b) => a - b);
        // Most of the pixels belong to the background.
        const behind = lights[lights.length >> 1];
        return Math.max(ink, behind) / Math.min(ink, behind);
      }, png);
      assert.ok(contrast >= 4.5, `${contrast}`);
      await tab.page.close();
    });
  }

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

  for (const colorScheme of part(['light', 'dark'], 1)) {
    test(`controls, handles and the default line are distinguishable, ${colorScheme}`, async () => {
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
