// Prints how long it takes in Chromium, on the built page, from a pointer event until the page has
// heard what the engine made of it, with 20 objects in the document; and the longest tasks of the main
// thread then and while a large surface loads: node tests/web/latency.mjs [triangles of each surface]
//
// Drawing is left out: WebGL draws nothing, and what is called on a frame is called at once. Times are
// medians and 95 % quantiles in milliseconds.
import { openBrowser, Tab } from './browser.mjs';

const sizes = process.argv.slice(2).map(Number);
const surfaces = sizes.length > 0 ? sizes : [70_000, 1_000_000];
const steps = 60;
const loaded = 2_000_000;

const quantile = (values, part) =>
  values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(part * values.length))];
const told = (values) => ({
  median: Number(quantile(values, 0.5)?.toFixed(1)),
  p95: Number(quantile(values, 0.95)?.toFixed(1)),
  steps: values.length,
});

/** Runs in each page before its own code. */
function watch() {
  window.longest = 0;
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) {
      window.longest = Math.max(window.longest, duration);
    }
  }).observe({ type: 'longtask' });
  for (const name of ['drawElements', 'drawArrays']) {
    for (const whole of [name, `${name}Instanced`]) {
      WebGL2RenderingContext.prototype[whole] = () => {};
    }
  }
}

/** The longest task since it was last asked for; the browser tells of those above 50 ms. */
const longestTask = async (tab) => {
  const longest = await tab.page.evaluate(() => {
    const found = window.longest;
    window.longest = 0;
    return found;
  });
  return longest === 0 ? '50 or less' : Math.round(longest);
};

/** Twenty curves of four points round the middle of what is seen; all but the last are copies. */
async function draw20(tab) {
  await tab.click([-60, 40], [-20, -30], [30, 30], [70, -30]);
  await tab.page.keyboard.press('Escape');
  for (let count = 1; count < 20; count++) {
    await tab.page.keyboard.press('Control+d');
    await tab.page.waitForFunction(
      (more) => window.karcherPage.state().drawing.objects.length > more,
      count,
    );
  }
  await tab.settled();
}

/** Milliseconds from each move of the pointer, which drags what is at a place, to its answer. */
async function measured(tab, { x, y }) {
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
      const frame = window.requestAnimationFrame;
      const target = document.elementFromPoint(left, top);
      const found = [];
      for (let i = 0; i < count; i++) {
        const angle = (2 * Math.PI * i) / count;
        const at = { clientX: left + 14 * Math.cos(angle), clientY: top + 14 * Math.sin(angle) };
        const before = window.karcherPage.shown;
        // Frames that are asked for by the event come at once.
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
        while (window.karcherPage.shown === before && performance.now() < end) await next();
        if (window.karcherPage.shown !== before) found.push(performance.now() - start);
        // The geodesics beside the curve are asked for after it.
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

async function ofSurface(triangles) {
  const browser = await openBrowser();
  try {
    await browser.context.addInitScript(watch);
    const tab = await Tab.open(browser, `mesh=sphere:${triangles}`);
    const opening = await longestTask(tab);
    await draw20(tab);
    await longestTask(tab);
    const point = await measured(tab, await tab.handle('Control point 2 of 4'));
    const dragging = await longestTask(tab);
    await tab.page.keyboard.press('Escape');
    await tab.page.locator('#tool-select').click();
    const line = await measured(tab, await tab.onCurve(0.5));
    const moving = await longestTask(tab);
    await tab.page.keyboard.press('Control+a');
    const all = await measured(tab, await tab.onCurve(0.5));
    const movingAll = await longestTask(tab);
    console.log(
      JSON.stringify({
        ...{ triangles, objects: 20, askedMs: 16 },
        controlPoint: told(point),
        objectMoved: told(line),
        all20Moved: told(all),
        longestTask: { opening, dragging, moving, movingAll, asked: 50 },
      }),
    );
  } finally {
    await browser.close();
  }
}

/** A flat grid of about so many triangles, as the bytes of a binary STL file. */
function gridStl(triangles) {
  const cells = Math.round(Math.sqrt(triangles / 2));
  const bytes = Buffer.alloc(84 + 50 * 2 * cells * cells);
  bytes.writeUInt32LE(2 * cells * cells, 80);
  const height = (i, j) => 0.1 * Math.sin((6 * i) / cells) * Math.cos((5 * j) / cells);
  let at = 84;
  const write = (corners) => {
    for (const [k, [i, j]] of corners.entries()) {
      const place = at + 12 + 12 * k;
      bytes.writeFloatLE(i / cells, place);
      bytes.writeFloatLE(j / cells, place + 4);
      bytes.writeFloatLE(height(i, j), place + 8);
    }
    at += 50;
  };
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      write([
        [i, j],
        [i + 1, j],
        [i + 1, j + 1],
      ]);
      write([
        [i, j],
        [i + 1, j + 1],
        [i, j + 1],
      ]);
    }
  }
  return bytes;
}

/** The longest task while a file of so many triangles is read and shown. */
async function ofLoading(triangles) {
  const browser = await openBrowser();
  try {
    await browser.context.addInitScript(watch);
    const tab = await Tab.open(browser);
    const file = gridStl(triangles);
    await browser.context.route('**/large.stl', (route) => route.fulfill({ body: file }));
    await longestTask(tab);
    const dropped = await tab.page.evaluate(async () => {
      const content = await (await fetch('large.stl')).blob();
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], 'large.stl'));
      window.longest = 0;
      const start = performance.now();
      window.dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
      return start;
    });
    await tab.page.waitForFunction(() => window.karcherPage.triangles > 1e5, null, {
      timeout: 300_000,
    });
    await tab.settled();
    await tab.still();
    const seconds = (await tab.page.evaluate((start) => performance.now() - start, dropped)) / 1000;
    const longest = await longestTask(tab);
    console.log(
      JSON.stringify({
        loading: triangles,
        seconds: Math.round(seconds),
        longestTask: longest,
        asked: 50,
      }),
    );
  } finally {
    await browser.close();
  }
}

for (const triangles of surfaces) await ofSurface(triangles);
await ofLoading(loaded);
