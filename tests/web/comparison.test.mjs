// Two methods of one curve side by side: their distance, as numbers and on the page.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';
import { lengthOf } from './polylines.mjs';

describe('the distance of two polylines', () => {
  let gapBetween;
  before(async () => {
    const file = fileURLToPath(new URL('./page_parts.ts', import.meta.url));
    const { module } = await runnerImport(file, { configFile: false, logLevel: 'error' });
    gapBetween = module.gapBetween;
  });

  /** Points x, y, z at parameters from 0 to 1. */
  const line = (count, place) =>
    Array.from({ length: count }, (_, i) => place(i / (count - 1))).flat();
  const near = (value, wanted, within) =>
    assert.ok(Math.abs(value - wanted) <= within, `${value}, not ${wanted}`);

  test('of parallel lines is the same everywhere, however they are divided', () => {
    const a = line(2, (t) => [3 * t, 0, 0]);
    const b = line(700, (t) => [3 * t * t, 0.3, 0.4]);
    for (const { mean, largest } of [gapBetween(a, b), gapBetween(b, a)]) {
      near(mean, 0.5, 1e-12);
      near(largest, 0.5, 1e-12);
    }
    const { mean, largest } = gapBetween(
      b,
      line(33, (t) => [3 * t, 0.3, 0.4]),
    );
    near(mean, 0, 1e-12);
    near(largest, 0, 1e-12);
  });

  test('of concentric circles is the difference of their radii', () => {
    const circle = (radius, count) =>
      line(count, (t) => [
        radius * Math.cos(2 * Math.PI * t),
        radius * Math.sin(2 * Math.PI * t),
        1,
      ]);
    const { mean, largest } = gapBetween(circle(1, 2001), circle(1.25, 3001));
    // A polyline of this many vertices lies inside by radius * (pi / count)^2 / 2.
    near(mean, 0.25, 1e-5);
    near(largest, 0.25, 1e-5);
  });

  test('includes the part of one line beyond the other, in either order', () => {
    const [short, long] = [line(5, (t) => [t, 0, 0]), line(5, (t) => [2 * t, 0, 0])];
    for (const { mean, largest } of [gapBetween(short, long), gapBetween(long, short)]) {
      // The short line's distance is 0; the long line's is 0 along its half, then rises to 1.
      near(mean, 0.125, 1e-3);
      near(largest, 1, 1 / 256);
    }
    assert.equal(gapBetween([], short), null);
    assert.deepEqual(gapBetween([0, 0, 0], [0, 3, 4]), { mean: 5, largest: 5 });
  });
});

describe('a comparison', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 900 }, asUsers: true });

  const said = (tab, id) => tab.page.locator(`#compare-${id}`).textContent();
  /** The displayed mean edges and percentages. */
  const numbers = (tab, id) =>
    Promise.all(
      [id, `${id}-part`].map(async (one) => {
        const told = /^(?:< )?([\d.]+)$/.exec(await said(tab, one));
        assert.ok(told, await said(tab, one));
        return Number(told[1]);
      }),
    );
  const answered = async (tab) => {
    await tab.settled();
    await tab.page.waitForFunction(
      () =>
        !document.getElementById('comparison').classList.contains('late') &&
        /\d/.test(document.getElementById('compare-mean').textContent),
    );
  };

  test('draws the curve by a second method, and shows the distance from the first', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000');
    const { page } = tab;
    await tab.click([-150, 40], [-60, -90], [60, 100], [150, -30]);
    const alone = await page.locator('#stage').screenshot();
    await page.locator('#compare').selectOption('paper-exact');
    await answered(tab);
    await tab.still();
    assert.equal(await said(tab, 'own'), 'Karcher');
    assert.equal(await said(tab, 'other'), 'Paper (exact)');
    assert.notDeepEqual(await page.locator('#stage').screenshot(), alone);
    // The words of each row lie within the row, and the rows below each other.
    const edges = await page.locator('.comparison .compared').evaluateAll((rows) =>
      rows.flatMap((row) => {
        const { top, bottom } = row.getBoundingClientRect();
        const words = row.querySelector('span').getBoundingClientRect();
        return [top, words.top, words.bottom, bottom];
      }),
    );
    const inOrder = edges.every((edge, i) => i === 0 || edges[i - 1] <= edge);
    assert.ok(inOrder, `${edges}`);
    const [mean, part] = await numbers(tab, 'mean');
    const [largest, largestPart] = await numbers(tab, 'largest');
    assert.ok(0 < mean && mean <= largest && part <= largestPart, `${mean} ${largest}`);
    // Both units give the same length, to the two displayed digits.
    const { polyline } = await tab.view();
    const { info } = await tab.mesh();
    const ratio = (largest * info.meanEdge) / ((largestPart / 100) * lengthOf(polyline));
    assert.ok(Math.abs(ratio - 1) < 0.11, `${ratio}`);

    const before = [await said(tab, 'mean'), await said(tab, 'largest')].join();
    await tab.dragHandle('Control point 2 of 4', 20, -60);
    await page.waitForFunction(
      (old) =>
        ['mean', 'largest']
          .map((id) => document.getElementById(`compare-${id}`).textContent)
          .join() !== old,
      before,
    );
    await answered(tab);

    await page.locator('#compare-off').click();
    assert.ok(!(await page.locator('#comparison').isVisible()));
    assert.equal(await page.locator('#compare').inputValue(), '');
    await tab.close();
  });

  inLongRun(
    'with a method of the same curve finds no distance, and ends when the methods are equal',
    async () => {
      const tab = await Tab.open(browser);
      const { page } = tab;
      await tab.click([-60, 40], [-20, -30], [30, 30], [70, -30]);
      await page.locator('#compare').selectOption('karcher-exact');
      await answered(tab);
      await page.waitForFunction(() => window.karcherPage.view().quality === 'exact');
      await answered(tab);
      const [largest] = await numbers(tab, 'largest');
      assert.ok(largest <= 1e-4, `${largest}`);
      await page.locator('#method').selectOption('karcher-exact');
      await page.locator('#comparison').waitFor({ state: 'hidden' });
      // The page reports an object without a curve.
      await page.locator('#compare').selectOption('karcher');
      await page.keyboard.press('Escape');
      await page.locator('#clear').click();
      await page.waitForFunction(() =>
        /no curve to compare/.test(document.getElementById('compare-problem').textContent),
      );
      await tab.close();
    },
  );

  inLongRun('keeps its layout while it fills, with every method', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000&method=karcher');
    const { page } = tab;
    await tab.click([-150, 40], [-60, -90], [60, 100], [150, -30]);
    const menu = page.locator('#compare');
    await menu.scrollIntoViewIfNeeded();
    await menu.selectOption('paper-exact');
    // Records the box of each of its parts, in every frame.
    await page.evaluate(() => {
      const places = () =>
        ['compare', 'comparison', 'compare-off', 'compare-numbers', 'knots'].map((id) => {
          const { x, y, width, height } = document.getElementById(id).getBoundingClientRect();
          return `${id}: ${[x, y, width, height].map((value) => value.toFixed(1))}`;
        });
      window.seenPlaces = new Set();
      const look = () => {
        for (const place of places()) window.seenPlaces.add(place);
        requestAnimationFrame(look);
      };
      look();
    });
    for (const method of ['karcher-exact', 'paper-graph', 'karcher-fast', 'paper-ring']) {
      await menu.selectOption(method);
      await answered(tab);
      await tab.still();
    }
    const seen = await page.evaluate(() => [...window.seenPlaces]);
    assert.equal(seen.length, 5, seen.join('\n'));
    await tab.close();
  });
});
