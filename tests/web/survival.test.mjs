// The page's reaction to adverse conditions: no network, no storage, two fingers.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { dracoFile, meshoptFile } from '../wasm/compressed_files.mjs';
import { cutBox } from '../wasm/mesh_files.mjs';
import { openBrowser, openPhone, Tab, touchOf, until } from './browser.mjs';
import { part } from './part.mjs';

const places = [
  [-70, 30],
  [-20, -20],
  [30, 40],
  [70, -20],
];

describe('the page survives', () => {
  test('without a network: it says so, continues, and a reload works after the first visit', async () => {
    const browser = await openBrowser({ serviceWorkers: 'allow' });
    try {
      const tab = await Tab.open(browser);
      await tab.page.evaluate(() => navigator.serviceWorker.ready);
      await tab.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
      const chip = tab.page.getByText('offline', { exact: true });
      assert.equal(await chip.isVisible(), false);
      browser.stopServing();
      await browser.context.setOffline(true);
      await chip.waitFor();
      await tab.click(...places);
      assert.equal((await tab.view()).curve.samples.count, 128);
      await tab.pastSaving();
      await tab.page.reload();
      await tab.settled();
      assert.equal((await tab.state()).figure.points.length, 4);
      await chip.waitFor();
      // Files without an earlier request are available, too: the decompression of files, the other
      // page, and its module.
      for (const [name, write] of [
        ['draco.glb', dracoFile],
        ['meshopt.glb', meshoptFile],
      ]) {
        await tab.dropBytes(name, await write(cutBox));
        await tab.page.waitForFunction(
          (end) => window.karcherPage.state().mesh.endsWith(end),
          name,
        );
        await tab.settled();
        assert.equal((await tab.mesh()).info.triangles, 12, name);
      }
      const paper = await browser.context.newPage();
      await paper.goto(`${browser.address}paper.html`);
      await paper.getByRole('heading', { level: 1 }).waitFor();
      await browser.context.setOffline(false);
      await chip.waitFor({ state: 'hidden' });
      assert.deepEqual(tab.logged, []);
    } finally {
      await browser.close();
    }
  });

  test('a database that never answers: it says so, and shows a surface', async () => {
    const browser = await openBrowser();
    try {
      await browser.context.addInitScript(() => {
        IDBFactory.prototype.open = () => ({});
      });
      const tab = await Tab.open(browser, 'mesh=file:1abc-2:my.obj&kind=bspline&points=0,0.2,0.3');
      await tab.page.getByText('The curve is on my.obj. Drop that file here').waitFor();
      assert.ok(await tab.page.evaluate(() => window.karcherPage.triangles > 0));
      assert.deepEqual(tab.logged, []);
    } finally {
      await browser.close();
    }
  });

  test('a full or blocked storage: it says that nothing is kept', async () => {
    const browser = await openBrowser();
    try {
      await browser.context.addInitScript(() => {
        window.room = false;
        const set = Storage.prototype.setItem;
        Storage.prototype.setItem = function (...args) {
          // A short text still fits where a long one does not.
          if (this === localStorage && !window.room && args[1].length > 40)
            throw new DOMException('full', 'QuotaExceededError');
          return set.apply(this, args);
        };
        IDBFactory.prototype.open = () => {
          throw new DOMException('blocked', 'SecurityError');
        };
      });
      const tab = await Tab.open(browser);
      const chip = tab.page.getByText('not kept', { exact: true });
      await tab.click(...places);
      await chip.waitFor();
      // The store has room again, and keeps the next change.
      await tab.page.evaluate(() => {
        window.room = true;
      });
      await tab.click([0, 90]);
      await chip.waitFor({ state: 'hidden' });
      assert.match(await tab.page.evaluate(() => localStorage['karcher.last']), /points=/);
      const tetrahedron =
        'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';
      await tab.drop('tetrahedron.obj', tetrahedron);
      const note = tab.page.getByRole('status').filter({ hasText: 'tetrahedron.obj is not kept' });
      await note.waitFor();
      assert.deepEqual(tab.logged, []);
    } finally {
      await browser.close();
    }
  });

  describe('two fingers on a phone', () => {
    /** A phone's page with four points, and touches by its browser. */
    async function phone(work) {
      const browser = await openPhone();
      try {
        const tab = await Tab.open(browser);
        await tab.click(...places);
        await work(tab, await touchOf(tab.page));
        assert.deepEqual(tab.logged, []);
      } finally {
        await browser.close();
      }
    }

    const pointsOf = async (tab) => (await tab.state()).figure.points;
    /** The distance between two points on the screen. */
    const spread = async (tab) => {
      await tab.still();
      const [a, b] = [await tab.handle('Control point 1'), await tab.handle('Control point 4')];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };

    const orders = { 'the first is on a point': [0, 1], 'the second is on a point': [1, 0] };
    for (const [what, order] of part(Object.entries(orders), 1)) {
      test(`a pinch zooms where ${what}, and moves no point`, () =>
        phone(async (tab, { touch, together }) => {
          const before = await pointsOf(tab);
          const apart = await spread(tab);
          const point = await tab.handle('Control point 2');
          const middle = await tab.middle();
          const free = { x: middle.x - 100, y: middle.y + 110 };
          const [first, second] = order.map((which) => [point, free][which]);
          const moved = { x: first.x + 20, y: first.y + 10 };
          const [dx, dy] = [moved.x - second.x, moved.y - second.y];
          const pinched = (part) => [
            { x: moved.x + part * dx, y: moved.y + part * dy },
            { x: second.x - part * dx, y: second.y - part * dy },
          ];
          await together(
            ['touchStart', first],
            ['touchMove', { x: first.x + 12, y: first.y + 6 }],
            ['touchMove', moved],
            ['touchStart', moved, second],
          );
          for (const part of [0.1, 0.2, 0.3, 0.4]) await touch('touchMove', ...pinched(part));
          await touch('touchEnd', { ...pinched(0.4)[1], id: 1 });
          await touch('touchEnd');
          await tab.settled();
          assert.deepEqual(await pointsOf(tab), before, 'no point has moved, and none is new');
          assert.equal((await tab.state()).dragging, false);
          const now = await spread(tab);
          assert.ok(now > 1.3 * apart, `${apart} pixels became ${now}`);
        }));
    }

    test('one finger still moves a point, with and without an earlier pinch', () =>
      phone(async (tab, { together }) => {
        for (const pinched of [false, true]) {
          const before = await pointsOf(tab);
          if (pinched) {
            const first = await tab.handle('Control point 3');
            const second = { x: first.x + 50, y: first.y + 50 };
            await together(
              ['touchStart', first],
              ['touchStart', first, second],
              ['touchEnd', first],
              ['touchEnd'],
            );
            await tab.settled();
            assert.deepEqual(await pointsOf(tab), before);
          }
          await tab.still();
          const { x, y } = await tab.handle('Control point 3');
          await together(
            ['touchStart', { x, y }],
            ...[5, 10, 15, 20].map((step) => ['touchMove', { x: x - step, y }]),
            ['touchEnd'],
          );
          const isMoved = async () => {
            const { figure, dragging } = await tab.state();
            return !dragging && !isDeepStrictEqual(figure.points[2], before[2]);
          };
          await until(isMoved, 'the point has moved');
          await tab.settled();
          const after = await pointsOf(tab);
          assert.deepEqual(after.toSpliced(2, 1), before.toSpliced(2, 1));
        }
      }));
  });
});
