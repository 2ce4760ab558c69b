// Lines respond: the target of a click has a mark, the selection is visible beside any line, hidden
// parts are thin and can be switched off, dashes are as long as the line is wide, and the magnet
// shows whether it is on.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab, until } from './browser.mjs';
import { inLongRun } from './part.mjs';

const upper = [
  [-120, -90],
  [120, -90],
];
const lower = [
  [-120, 70],
  [120, 70],
];

describe('lines', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 }, asUsers: true });

  /**
   * Colors, red, green and blue each, in a column of the stage's pixels through a place of the
   * window.
   */
  async function column(tab, { x, y }, reach = 16) {
    await tab.still();
    const clip = { x: Math.round(x), y: Math.round(y) - reach, width: 1, height: 2 * reach };
    return tab.pixels(clip);
  }
  const yellow = ([red, green, blue]) => red > 200 && green > 150 && blue < 90;
  const unlike = (a, b, by = 40) =>
    a.filter((color, i) => Math.hypot(...color.map((one, k) => one - b[i][k])) > by);

  async function two() {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=polyline');
    await tab.click(...upper);
    await tab.page.keyboard.press('Enter');
    await tab.click(...lower);
    await tab.page.keyboard.press('v');
    await tab.page.keyboard.press('Escape');
    await tab.page.keyboard.press('Escape');
    await tab.settled();
    return tab;
  }

  test('are marked as the target of a click, and the pointer shows that they can be moved', async () => {
    const tab = await two();
    for (const other of [0, null]) {
      const place = await tab.onCurve(0.5, other);
      await tab.page.mouse.move(place.x, place.y + 200);
      const bare = await column(tab, place);
      await tab.page.mouse.move(place.x, place.y, { steps: 3 });
      await tab.page.locator('.stage[data-action="move"]').waitFor();
      assert.equal(
        await tab.page.locator('#stage').evaluate((stage) => getComputedStyle(stage).cursor),
        'move',
      );
      assert.ok(unlike(await column(tab, place), bare).length >= 2, 'it is marked');
      await tab.page.mouse.move(place.x, place.y + 200);
      await tab.page.locator('.stage:not([data-action])').waitFor();
      assert.deepEqual(unlike(await column(tab, place), bare), []);
    }
    await tab.close();
  });

  test('look selected when they are, whatever their width and color', async () => {
    const tab = await two();
    await tab.page.keyboard.press('Control+a');
    for (const width of ['1', '20']) {
      await tab.page.locator('#width').fill(width);
      await tab.page.keyboard.press('Enter');
      // The line takes the color of the mark itself.
      await tab.page.locator('#color').fill('#f2b705');
      await tab.page.locator('#color').blur();
      await tab.settled();
      for (const other of [0, null]) {
        const place = await tab.onCurve(0.5, other);
        const colors = await column(tab, place, 24);
        const marked = colors.map(yellow);
        // The column shows yellow, a seam, the yellow line, a seam and yellow again.
        const runs = marked.filter((is, i) => is && !marked[i - 1]).length;
        assert.equal(runs, 3, `${width}: ${marked.map(Number).join('')}`);
      }
    }
    await tab.close();
  });

  inLongRun('that are dashed and selected have no white between their dashes', async () => {
    const tab = await two();
    await tab.page.keyboard.press('Control+a');
    await tab.page.locator('#width').fill('12');
    await tab.page.keyboard.press('Enter');
    await tab.page.locator('#dash').selectOption('dashed');
    await tab.page.locator('#color').fill('#c81e5b');
    await tab.page.locator('#color').blur();
    await tab.settled();
    // Both lines cross the stage: the search for their middles runs from left to right.
    const kinds = new Set();
    for (let i = 0; i < 40; i++) {
      const place = await tab.onCurve(0.3 + 0.01 * i);
      const [[r, g, b]] = await column(tab, place, 1);
      kinds.add(r - g > 100 ? 'dash' : Math.min(r, g, b) > 248 ? 'white' : 'between');
    }
    assert.deepEqual([...kinds].sort(), ['between', 'dash']);
    await tab.close();
  });

  inLongRun('that differ have settings that say so in complete words', async () => {
    const tab = await two();
    const { x, y } = await tab.onCurve(0.5);
    await tab.page.mouse.click(x, y);
    await tab.page.locator('#width').fill('12');
    await tab.page.keyboard.press('Enter');
    await tab.page.locator('#dash').selectOption('dashed');
    for (const id of ['#opacity', '#fill']) {
      await tab.page.locator(id).fill('30');
      await tab.page.keyboard.press('Enter');
    }
    await tab.page.locator('#width-unit').selectOption('surface');
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('Control+a');
    await tab.settled();
    const cut = await tab.page.evaluate(() => {
      const context = new OffscreenCanvas(1, 1).getContext('2d');
      const fields = [...document.querySelectorAll('.panel input, .panel select')].filter(
        (field) =>
          field.checkVisibility() &&
          (field.placeholder === 'mixed' || field.selectedOptions?.[0]?.text === 'mixed'),
      );
      return fields.map((field) => {
        const { paddingLeft, paddingRight } = getComputedStyle(field);
        const words = getComputedStyle(field, field.placeholder ? '::placeholder' : null);
        context.font = `${words.fontSize} ${words.fontFamily}`;
        const room = field.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
        return [field.id, room - context.measureText('mixed').width];
      });
    });
    assert.ok(cut.length >= 4, JSON.stringify(cut));
    assert.deepEqual(
      cut.filter(([, left]) => left < 0),
      [],
    );
    await tab.close();
  });

  test('behind the surface are visible until that is switched off', async () => {
    const tab = await two();
    const place = await tab.onCurve(0.5);
    await tab.page.locator('#view').click();
    await tab.page.getByRole('menuitem', { name: 'Back' }).click();
    await tab.still();
    const { x } = await tab.middle();
    const at = { x, y: place.y };
    const shown = await column(tab, at, 110);
    await tab.page.locator('#view').click();
    const item = tab.page.locator('#hidden-lines');
    assert.equal(await item.getAttribute('aria-checked'), 'true');
    await item.click();
    assert.equal(await item.getAttribute('aria-checked'), 'false');
    await tab.page.keyboard.press('Escape');
    const without = await column(tab, at, 110);
    // Two lines 4 pixels wide cross the column, and are faint and thin behind the surface.
    const seen = unlike(shown, without, 8).length;
    assert.ok(seen >= 2 && seen <= 7, `${seen} pixels`);
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('h');
    assert.equal(await item.getAttribute('aria-checked'), 'true');
    assert.deepEqual(unlike(await column(tab, at, 110), shown), []);
    await tab.close();
  });

  test('of a color that the surface has too get a rim, light in the dark and dark in the light', async () => {
    const tab = await two();
    await tab.page.keyboard.press('Control+a');
    const place = await tab.onCurve(0.5);
    for (const [theme, color, isRim] of [
      ['dark', '#222831', (rgb) => Math.min(...rgb) > 215],
      ['light', '#f8f9fa', (rgb) => Math.max(...rgb) < 70],
    ]) {
      await tab.page.emulateMedia({ colorScheme: theme });
      await tab.page.locator('#width').fill('8');
      await tab.page.keyboard.press('Enter');
      await tab.page.locator(`.swatch[data-color="${color}"]`).click();
      await tab.page.keyboard.press('Escape');
      await tab.page.keyboard.press('Escape');
      await tab.settled();
      const rims = (await column(tab, place)).map(isRim);
      const runs = rims.filter((is, i) => is && !rims[i - 1]).length;
      assert.equal(runs, 2, `${theme}: ${rims.map(Number).join('')}`);
      await tab.page.keyboard.press('Control+a');
      // Lines of other colors are visible without a rim.
      await tab.page.locator('.swatch[data-color="#d9480f"]').click();
      await tab.page.keyboard.press('Escape');
      await tab.page.keyboard.press('Escape');
      await tab.settled();
      assert.ok(!(await column(tab, place)).some(isRim), theme);
      await tab.page.keyboard.press('Control+a');
    }
    await tab.close();
  });

  inLongRun(
    'have the same width where the surface turns away and where it faces the view',
    async () => {
      const tab = await Tab.open(browser, 'mesh=sphere:5000&kind=polyline');
      const { y } = await tab.middle();
      // The uppermost visible place of the sphere.
      const top = await tab.page.evaluate(() => {
        let least = Infinity;
        for (let i = 0; i < 4000; i++) {
          const height = 1 - (2 * i + 1) / 4000;
          const [turn, ring] = [2.399963 * i, Math.sqrt(1 - height * height)];
          const place = [ring * Math.cos(turn), ring * Math.sin(turn), height];
          least = Math.min(least, window.karcherPage.seen(place)?.y ?? Infinity);
        }
        return least;
      });
      const up = 0.95 * (y - top);
      await tab.click([-60, -up], [60, -up]);
      await tab.page.locator('#width').fill('16');
      await tab.page.keyboard.press('Enter');
      await tab.page.locator('.swatch[data-color="#d9480f"]').click();
      await tab.page.keyboard.press('v');
      await tab.page.keyboard.press('Escape');
      await tab.page.keyboard.press('Escape');
      await tab.settled();
      const place = await tab.onCurve(0.5);
      const orange = (await column(tab, place, 24)).filter(
        ([red, green, blue]) => red > 150 && green < 130 && blue < 80,
      );
      assert.ok(orange.length >= 14, `${orange.length} of 16 pixels`);
      await tab.close();
    },
  );

  test('of the rubber band show the next piece, even out of a handle', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500');
    const { x, y } = await tab.middle();
    await tab.page.keyboard.press('p');
    await tab.click([-160, 40]);
    await tab.drag({ x: x - 60, y: y + 40 }, { x: x - 60, y: y - 100 });
    const to = { x: x + 130, y: y + 60 };
    const hover = async () => {
      await tab.page.mouse.move(to.x, to.y + 3);
      await tab.page.mouse.move(to.x, to.y, { steps: 3 });
    };
    // The place of the next segment, high above the path from its anchor.
    await tab.page.mouse.click(to.x, to.y);
    // The band is dashed: some places lie between dashes.
    const places = [];
    for (const part of [0.7, 0.71, 0.72, 0.73, 0.74]) places.push(await tab.onCurve(part));
    for (const place of places) assert.ok(place.y < y + 10, `${place.y}`);
    const columns = async () => {
      const all = [];
      for (const place of places) all.push(...(await column(tab, place, 8)));
      return all;
    };
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    await tab.page.mouse.move(x, 20);
    const bare = await columns();
    await hover();
    await until(
      async () => unlike(await columns(), bare).length > 4,
      'the band is where the piece will be',
    );
    await tab.close();
  });

  test('have dashes as long as they are wide and as the view is near, even in the SVG', async () => {
    const tab = await two();
    const { page } = tab;
    await page.keyboard.press('Control+a');
    await page.locator('#dash').selectOption('dashed');
    const dashes = async () => {
      const { text } = await tab.save('SVG');
      const [dash] = text.match(/<path[^>]* stroke-dasharray="[^"]*"[^>]*/);
      assert.match(dash, / stroke-linecap="butt"/);
      return /stroke-dasharray="([\d. ]+)"/.exec(dash)[1].split(' ').map(Number);
    };
    const isTimes = (factor, after, before) => {
      for (const [i, length] of after.entries()) {
        assert.ok(Math.abs(length - factor * before[i]) < 0.05, `${after}, ${before}`);
      }
    };
    const thin = await dashes();
    await page.locator('#width').fill('12');
    await page.keyboard.press('Enter');
    await page.locator('#width').blur();
    await tab.settled();
    const wide = await dashes();
    isTimes(3, wide, thin);
    // The length of a segment at the middle of the first line, in pixels.
    const length = () =>
      page.evaluate(() => {
        const [line] = window.karcherPage.view().others[0].lines;
        const middle = Math.floor(line.length / 6);
        const [a, b] = [middle - 1, middle + 1].map((i) =>
          window.karcherPage.seen(line.subarray(3 * i, 3 * i + 3)),
        );
        return Math.hypot(a.x - b.x, a.y - b.y);
      });
    const before = await length();
    const { x, y } = await tab.middle();
    await page.mouse.move(x, y);
    for (let notch = 0; notch < 4; notch++) {
      await page.mouse.wheel(0, -120);
      await tab.still();
    }
    const grown = (await length()) / before;
    assert.ok(grown > 1.2, `${grown}`);
    const near = await dashes();
    const factor = near[0] / wide[0];
    assert.ok(Math.abs(factor - grown) < 0.1 * grown, `${factor}, not ${grown}`);
    await tab.close();
  });

  test('snap to a magnet that shows whether it is on', async () => {
    const tab = await two();
    const magnet = tab.page.locator('#snap');
    const look = () =>
      magnet.evaluate((button) => [
        button.getAttribute('aria-pressed'),
        button.dataset.tip,
        getComputedStyle(button).color,
      ]);
    await tab.page.mouse.move(5, 5);
    const [off, offTip, offColor] = await look();
    await tab.page.keyboard.press('g');
    const [on, onTip, onColor] = await look();
    assert.deepEqual([off, on], ['false', 'true']);
    assert.deepEqual([offTip, onTip], ['Snapping is off (G)', 'Snapping is on (G)']);
    assert.notEqual(offColor, onColor);
    await tab.close();
  });
});
