// What happens to a page, and what it does then: no network, no storage, two fingers.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';
import { sometimes } from './part.mjs';

const places = [
  [-70, 30],
  [-20, -20],
  [30, 40],
  [70, -20],
];

describe('the page survives', () => {
  test('without a network: it says so, goes on, and a reload works after the first visit', async () => {
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
      // What was not asked for yet is there, too: the other page, and its module.
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

  sometimes('where storage is full or blocked, it says that nothing is kept', async () => {
    const browser = await openBrowser();
    try {
      await browser.context.addInitScript(() => {
        window.room = false;
        const set = Storage.prototype.setItem;
        Storage.prototype.setItem = function (...args) {
          // A short text finds room where a long one finds none.
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
      // There is room again, and what comes next is kept.
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
    /** A phone's page with four points, and fingers as its browser hears of them. */
    async function phone(work) {
      const browser = await openBrowser({
        viewport: { width: 390, height: 844 },
        hasTouch: true,
        isMobile: true,
      });
      try {
        const tab = await Tab.open(browser);
        await tab.click(...places);
        const cdp = await browser.context.newCDPSession(tab.page);
        const touch = (type, ...points) =>
          cdp.send('Input.dispatchTouchEvent', {
            type,
            touchPoints: points.map(([id, x, y]) => ({ id, x, y })),
          });
        await work(tab, touch);
        assert.deepEqual(tab.logged, []);
      } finally {
        await browser.close();
      }
    }

    const pointsOf = async (tab) => (await tab.state()).figure.points;
    /** How far two points are apart on the screen. */
    const spread = async (tab) => {
      await tab.still();
      const [a, b] = [await tab.handle('Control point 1'), await tab.handle('Control point 4')];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };

    for (const [what, order] of Object.entries({
      'the first is on a point': [0, 1],
      'the second is on a point': [1, 0],
    })) {
      test(`a pinch zooms where ${what}, and moves no point`, () =>
        phone(async (tab, touch) => {
          const before = await pointsOf(tab);
          const apart = await spread(tab);
          const point = await tab.handle('Control point 2');
          const middle = await tab.middle();
          const free = { x: middle.x - 100, y: middle.y + 110 };
          const [first, second] = order.map((which) => [point, free][which]);
          await touch('touchStart', [0, first.x, first.y]);
          await touch('touchMove', [0, first.x + 12, first.y + 6]);
          await touch('touchMove', [0, first.x + 20, first.y + 10]);
          await touch('touchStart', [0, first.x + 20, first.y + 10], [1, second.x, second.y]);
          const [dx, dy] = [first.x + 20 - second.x, first.y + 10 - second.y];
          for (const part of [0.1, 0.2, 0.3, 0.4]) {
            await touch(
              'touchMove',
              [0, first.x + 20 + part * dx, first.y + 10 + part * dy],
              [1, second.x - part * dx, second.y - part * dy],
            );
          }
          await touch('touchEnd', [1, second.x - 0.4 * dx, second.y - 0.4 * dy]);
          await touch('touchEnd');
          await tab.settled();
          assert.deepEqual(await pointsOf(tab), before, 'no point has moved, and none is new');
          assert.equal((await tab.state()).dragging, false);
          const now = await spread(tab);
          assert.ok(now > 1.3 * apart, `${apart} pixels became ${now}`);
        }));
    }

    test('one finger still moves a point, once and after a pinch', () =>
      phone(async (tab, touch) => {
        for (const pinched of [false, true]) {
          const before = await pointsOf(tab);
          const { x, y } = await tab.handle('Control point 3');
          if (pinched) {
            await touch('touchStart', [0, x, y]);
            await touch('touchStart', [0, x, y], [1, x + 50, y + 50]);
            await touch('touchEnd', [0, x, y]);
            await touch('touchEnd');
            assert.deepEqual(await pointsOf(tab), before);
          }
          // Sent at once: a finger that waits for a busy machine rests, and opens the menu.
          await Promise.all([
            touch('touchStart', [0, x, y]),
            ...[5, 10, 15, 20].map((step) => touch('touchMove', [0, x - step, y])),
          ]);
          await touch('touchEnd');
          await tab.settled();
          const after = await pointsOf(tab);
          assert.notDeepEqual(after[2], before[2]);
          assert.deepEqual(after.toSpliced(2, 1), before.toSpliced(2, 1));
        }
      }));
  });
});
