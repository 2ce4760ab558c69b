// Thousands of edits by hand in one tab do not increase the memory of the page and its engine.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';
import { long, randoms, seed } from './part.mjs';

const edits = long ? 2000 : 20;
/** The number of measurements, evenly spaced among the edits. */
const measurements = 10;
const places = [
  [-110, 40],
  [-40, -10],
  [40, 50],
  [110, -10],
];

/** The bytes that the page holds after a garbage collection. */
async function heldBytes(devtools) {
  await devtools.send('HeapProfiler.collectGarbage');
  return (await devtools.send('Runtime.getHeapUsage')).usedSize;
}

const statusOf = (id) => readFileSync(`/proc/${id}/status`, 'utf8');
const parentOf = (id) => Number(/^PPid:\s*(\d+)/m.exec(statusOf(id))[1]);

/** Whether this process, or one of its descendants, started a process. */
function isOurs(id) {
  for (let one = id; one > 1; one = parentOf(one)) if (one === process.pid) return true;
  return false;
}

/**
 * The resident bytes of the tab's process, including its workers' engines; null if the system does
 * not report them.
 */
function residentBytes() {
  if (!existsSync('/proc/self/status')) return null;
  let most = null;
  for (const name of readdirSync('/proc').filter((entry) => /^\d+$/.test(entry))) {
    try {
      const command = readFileSync(`/proc/${name}/cmdline`, 'utf8');
      if (!command.includes('--type=renderer') || !isOurs(Number(name))) continue;
      const [, kilobytes] = /^VmRSS:\s*(\d+)/m.exec(statusOf(name));
      most = Math.max(most ?? 0, 1024 * Number(kilobytes));
    } catch {
      // The process ended meanwhile.
    }
  }
  return most;
}

const inMegabytes = (bytes) => (bytes === null ? '?' : (bytes / 1e6).toFixed(1));

test(`${edits} edits by hand leave no memory behind`, { timeout: 7_200_000 }, async () => {
  console.log(`Edits are drawn with KARCHER_SEED=${seed}`);
  const browser = await openBrowser();
  try {
    const tab = await Tab.open(browser);
    const devtools = await browser.context.newCDPSession(tab.page);
    await devtools.send('HeapProfiler.enable');
    await tab.click(...places);
    const random = randoms(seed);
    const below = (count) => Math.floor(random.next().value * count);
    const drag = async () => {
      const handles = tab.page.locator('.handle').filter({ visible: true });
      const box = await handles.nth(below(await handles.count())).boundingBox();
      if (box === null) return;
      const from = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      const middle = await tab.middle();
      // The step leads back towards the middle, so that points stay on the surface.
      const toward = (at, center) => at + (center - at) * 0.3 + below(61) - 30;
      await tab.drag(from, { x: toward(from.x, middle.x), y: toward(from.y, middle.y) });
    };
    const press = async (key) => {
      await tab.page.keyboard.press(key);
      await tab.settled();
    };
    const edit = async () => {
      const what = below(10);
      if (what === 0) return press('Control+z');
      if (what === 1) return tab.choose(['bspline', 'bezier', 'catmullrom'][below(3)]);
      if (what === 2) return press('Control+Shift+z');
      return drag();
    };
    const curve = [];
    for (let i = 0; i < edits; i++) {
      await edit();
      await tab.settled();
      if ((i + 1) % (edits / measurements) > 0) continue;
      // The edited object is still a curve after any edits.
      assert.ok((await tab.state()).figure.points.length >= 3);
      const [held, resident] = [await heldBytes(devtools), residentBytes()];
      curve.push({ held, resident });
      console.log(
        `after ${i + 1} edits the page holds ${inMegabytes(held)} MB, its process ${inMegabytes(resident)} MB`,
      );
    }
    const last = curve.at(-1);
    const middle = curve[Math.floor(measurements / 2)];
    // An edit may remain in the history, in a few hundred bytes.
    assert.ok(last.held - middle.held < 1e6 + 2000 * edits, JSON.stringify(curve));
    // The engine's memory only grows, and by steps.
    assert.ok(last.resident === null || last.resident < 1.5 * middle.resident);
    assert.deepEqual(tab.logged, []);
  } finally {
    await browser.close();
  }
});
