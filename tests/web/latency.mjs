// Prints the time from a pointer event until the engine's answer reaches the page, with 20 objects in
// the document, in Chromium on the built page. Also prints the longest tasks of the main thread then
// and while a large surface loads:
//
//   node tests/web/latency.mjs [SURFACE …]
//
// A surface is a mesh's file, a sphere's number of triangles, or a key such as `bunny:4`. The word
// `loading` stands for a file of two million triangles that the page only opens. WebGL draws nothing,
// and frames run at once. Times are in milliseconds: the least, which a busy machine disturbs little,
// the median and the 95 % quantile; and the processor time per step of the main thread and of the
// engine, until everything beside the curve has followed.
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { openBrowser, Tab } from './browser.mjs';
import { gridStl } from './large_file.mjs';
import { tasksDuring } from './main_thread.mjs';

const given = process.argv.slice(2);
const surfaces = given.length > 0 ? given : ['70000', '1000000', 'loading'];
const steps = 60;
const loaded = 2_000_000;

const quantile = (values, part) =>
  values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(part * values.length))];
const told = (values) => ({
  least: Number(quantile(values, 0)?.toFixed(1)),
  median: Number(quantile(values, 0.5)?.toFixed(1)),
  p95: Number(quantile(values, 0.95)?.toFixed(1)),
  steps: values.length,
});

/** Makes WebGL draw nothing, and `heard` report a worker's answers. Runs before the page's code. */
function watch() {
  for (const name of ['drawElements', 'drawArrays']) {
    for (const whole of [name, `${name}Instanced`]) {
      WebGL2RenderingContext.prototype[whole] = () => {};
    }
  }
  window.Worker = class extends Worker {
    constructor(...given) {
      super(...given);
      this.addEventListener('message', () => window.heard?.());
    }
  };
}

/** Twenty curves of four points, each a little below the one before. */
async function draw20(tab) {
  await tab.click([-60, 0], [-20, -70], [30, -10], [70, -70]);
  await tab.page.keyboard.press('Control+a');
  for (let count = 1; count < 20; count++) {
    await tab.page.keyboard.press('Control+d');
    await tab.page.waitForFunction(
      (more) => window.karcherPage.state().drawing.objects.length > more,
      count,
    );
    const { revision } = await tab.state();
    await tab.page.locator('#stage').press('ArrowDown');
    await tab.page.waitForFunction((seen) => window.karcherPage.state().revision > seen, revision);
    await tab.settled();
  }
}

/** Opens a surface: a file, a key, or a sphere of this many triangles. */
async function openSurface(browser, surface) {
  if (!existsSync(surface)) {
    return Tab.open(browser, `mesh=${/^\d+$/.test(surface) ? `sphere:${surface}` : surface}`);
  }
  const tab = await Tab.open(browser);
  await load(tab, surface);
  return tab;
}

/** Opens a file, and waits until it is shown; returns the time of opening, by the page's clock. */
async function load(tab, path) {
  const dropped = await tab.page.evaluate(() => performance.now());
  // The browser reads the file itself: it is too large to pass through the test.
  await tab.page.locator('#file').setInputFiles(path);
  await tab.page.waitForFunction(
    () => {
      const { karcherPage: shown } = window;
      const isFile = shown.state().mesh.startsWith('file:') && shown.triangles > 0;
      return isFile && shown.settled && shown.still;
    },
    null,
    { timeout: 300_000 },
  );
  return dropped;
}

/** The cost of a drag at a place. */
async function measured(tab, place) {
  const { result, longest, main, workers } = await tasksDuring(tab, () => dragged(tab, place));
  const ofProcessor = Number(((main + workers) / (steps + 3)).toFixed(1));
  return { times: { ...told(result), ofProcessor }, longest };
}

/** The milliseconds from each move of the pointer, in a drag at a place, to its answer. */
async function dragged(tab, { x, y }) {
  const { mouse } = tab.page;
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 12, y + 2, { steps: 3 });
  await tab.page.waitForFunction(() => window.karcherPage.state().dragging);
  const times = await tab.page.evaluate(
    async ([left, top, count]) => {
      const next = () =>
        new Promise((resolve) => {
          const { port1, port2 } = new MessageChannel();
          port1.onmessage = resolve;
          port2.postMessage(0);
        });
      const answered = () =>
        new Promise((resolve) => {
          window.heard = resolve;
          setTimeout(resolve, 1000);
        }).then(next);
      const frame = window.requestAnimationFrame;
      const target = document.elementFromPoint(left, top);
      const found = [];
      for (let i = 0; i < count; i++) {
        const angle = (2 * Math.PI * i) / count;
        const at = { clientX: left + 14 * Math.cos(angle), clientY: top + 14 * Math.sin(angle) };
        const before = window.karcherPage.shown;
        // Frames that the event requests run at once.
        window.requestAnimationFrame = (run) => {
          queueMicrotask(() => run(performance.now()));
          return 1;
        };
        const start = performance.now();
        target.dispatchEvent(
          new PointerEvent('pointermove', {
            ...{ ...at, pointerId: 1, isPrimary: true, pointerType: 'mouse' },
            ...{ buttons: 1, bubbles: true },
          }),
        );
        window.requestAnimationFrame = frame;
        const end = start + 3000;
        while (window.karcherPage.shown === before && performance.now() < end) await answered();
        if (window.karcherPage.shown !== before) found.push(performance.now() - start);
        // The geodesics beside the curve are requested after it.
        while (!window.karcherPage.settled && performance.now() < end) {
          await new Promise((resolve) => setTimeout(resolve, 5));
        }
      }
      return found;
    },
    [x, y, steps],
  );
  await mouse.up();
  await tab.settled();
  return times;
}

async function ofSurface(surface) {
  const browser = await openBrowser({ profile: true, asUsers: true });
  try {
    await browser.context.addInitScript(watch);
    const tab = await openSurface(browser, surface);
    const triangles = await tab.page.evaluate(() => window.karcherPage.triangles);
    await draw20(tab);
    const point = await measured(tab, await tab.handle('Control point 2 of 4'));
    await tab.page.keyboard.press('Escape');
    await tab.page.locator('#tool-select').click();
    const line = await measured(tab, await tab.onCurve(0.5));
    await tab.page.keyboard.press('Control+a');
    const all = await measured(tab, await tab.onCurve(0.5));
    console.log(
      JSON.stringify({
        ...{ surface: basename(surface), triangles, objects: 20, asked: 16 },
        controlPoint: point.times,
        objectMoved: line.times,
        all20Moved: all.times,
        longestTask: { point: point.longest, line: line.longest, all: all.longest, asked: 50 },
      }),
    );
  } finally {
    await browser.close();
  }
}

/** The longest task while a file of this many triangles is read and shown. */
async function ofLoading(triangles) {
  const browser = await openBrowser({ profile: true, asUsers: true });
  const folder = mkdtempSync(join(tmpdir(), 'karcher-large-'));
  try {
    await browser.context.addInitScript(watch);
    const tab = await Tab.open(browser);
    const file = join(folder, 'large.stl');
    writeFileSync(file, gridStl(triangles));
    const { result: dropped, longest } = await tasksDuring(tab, () => load(tab, file));
    const seconds = (await tab.page.evaluate((start) => performance.now() - start, dropped)) / 1000;
    console.log(
      JSON.stringify({
        loading: await tab.page.evaluate(() => window.karcherPage.triangles),
        seconds: Math.round(seconds),
        longestTask: { ...longest, asked: 50 },
      }),
    );
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true });
  }
}

for (const surface of surfaces) {
  if (surface === 'loading') await ofLoading(loaded);
  else await ofSurface(surface);
}
