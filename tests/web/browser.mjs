// A browser with the built page, for the tests of the page.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { after, before } from 'node:test';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { chromiumPath } from '../../.tools/setup.mjs';

const built = fileURLToPath(new URL('../../build/page', import.meta.url));
const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};
const flags = [
  '--no-sandbox',
  '--disable-gpu-sandbox',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
  // Without a graphics card the page draws faster if it does without OpenGL.
  '--disable-gpu-rasterization',
  '--disable-gpu-compositing',
  // Chromium uses the last of several such lists, so this one repeats Playwright's.
  `--disable-features=${[
    ...['AvoidUnnecessaryBeforeUnloadCheckSync', 'DestroyProfileOnBrowserClose', 'HttpsUpgrades'],
    ...['HttpsFirstBalancedModeAutoEnable', 'LensOverlay', 'MediaRouter', 'PaintHolding'],
    ...['ThirdPartyStoragePartitioning', 'AvoidCorsURLLoaderRestartOnRedirect'],
    ...['OptimizationHints', 'NetworkTimeServiceQuerying', 'AimEnabled', 'PreconnectToSearch'],
    // The menus of the address bar, some 400 scripts in each window, take as long to load as the
    // page.
    ...['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup'],
  ]}`,
];
/**
 * The engine compiles the module's code once, without optimization. Tabs of a suite share a
 * process, which has compiled the page's scripts before.
 */
const quickFlags = ['--js-flags=--liftoff-only', '--process-per-site'];
export const launching = { executablePath: chromiumPath(), args: flags };
/**
 * The limit of waits is generous: software graphics on a busy machine start slowly, and more files run at once than
 * there are cores.
 */
const patience = 120_000;

/** Polls a condition that the page cannot await, and fails if it never holds. */
export async function until(condition, what) {
  const end = performance.now() + patience;
  while (!(await condition())) {
    if (performance.now() > end) throw new Error(`waited in vain until ${what}`);
    await setTimeout(20);
  }
}

function servePage() {
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://page').pathname));
    const file = join(built, path.endsWith('/') ? `${path}index.html` : path);
    try {
      const body = readFileSync(file);
      response.writeHead(200, { 'content-type': types[extname(file)] ?? 'text/plain' }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

/** The driver's message about a page that may have no service worker. */
const blocked = 'Service Worker registration blocked by Playwright';

/**
 * Whether a message is a complaint of the page. Two messages are not: the driver warns when a
 * script reads a canvas, and a service worker cannot be registered where the test blocks it.
 */
export function isComplaint(message) {
  if (!['error', 'warning'].includes(message.type())) return false;
  const text = message.text();
  return !(/GL Driver Message .*GPU stall due to ReadPixels/.test(text) || text.includes(blocked));
}

/** Makes three.js clear a small picture and draw no triangles. Runs before the page's scripts. */
function drawNothing() {
  // Only three.js reads the ratio; the layout of the page does not change.
  Object.defineProperty(window, 'devicePixelRatio', { value: 0.25 });
  // Without a graphics card the processor must compile every shader and transform every triangle of
  // each frame.
  const { prototype } = WebGL2RenderingContext;
  for (const name of [
    ...['drawElements', 'drawArrays'],
    ...['drawElementsInstanced', 'drawArraysInstanced'],
  ]) {
    prototype[name] = () => {};
  }
}

/** Opens the initially folded sections. Runs before the page's scripts. */
function unfold() {
  try {
    for (const name of ['advanced', 'points']) localStorage[`karcher.${name}`] ??= 'open';
  } catch {
    // Some tests forbid storage.
  }
}

/** The browsers, one `asUsers` have it and one without drawing, and their numbers of windows. */
const shared = new Map();
/** The time in milliseconds for which a browser without a window waits for the next suite. */
const lingering = 1000;

const argsOf = (asUsers) => (asUsers ? flags : [...flags, ...quickFlags]);

/** Starts a browser that suites share until it closes or crashes. */
function share(asUsers) {
  const launched = chromium.launch({ ...launching, args: argsOf(asUsers) });
  const entry = { launched, windows: 0, end: undefined };
  entry.forget = () => {
    if (shared.get(asUsers) === entry) shared.delete(asUsers);
  };
  launched.then((browser) => browser.once('disconnected', entry.forget), entry.forget);
  shared.set(asUsers, entry);
  return entry;
}

/** A new window, with a storage of its own, of a browser that all suites of a process share. */
async function openWindow(asUsers, settings) {
  const entry = shared.get(asUsers) ?? share(asUsers);
  clearTimeout(entry.end);
  entry.windows++;
  const browser = await entry.launched;
  const context = await browser.newContext(settings);
  const close = async () => {
    await context.close();
    if (--entry.windows > 0) return;
    entry.end = globalThis.setTimeout(() => {
      entry.forget();
      browser.close();
    }, lingering);
  };
  return { context, close };
}

/** A window of a browser of its own, whose storage is on disk. */
async function openProfile(asUsers, settings) {
  const folder = mkdtempSync(join(tmpdir(), 'karcher-page-'));
  const started = { ...launching, args: argsOf(asUsers) };
  const context = await chromium.launchPersistentContext(folder, { ...started, ...settings });
  const close = async () => {
    await context.close();
    rmSync(folder, { recursive: true, force: true });
  };
  return { context, close };
}

/**
 * Serves the page and opens a window with a storage of its own, in memory, or with `profile` on disk. The
 * window has no service worker, which would answer in place of the test's server. Tests that look at the
 * picture, compute much or measure times need a browser `asUsers` have it. Others draw nothing and do not
 * optimize the module's code: drawing without a graphics card and compiling took a fifth of the processor
 * time. With `unfolded`, sections that a new user finds folded are open. With `manyTabs` the process of the
 * tabs lives on between them: no tab starts a process or compiles the scripts again.
 */
export async function openBrowser({
  profile = false,
  asUsers = false,
  unfolded = true,
  manyTabs = false,
  ...options
} = {}) {
  const server = await servePage();
  const settings = { viewport: { width: 900, height: 640 }, serviceWorkers: 'block', ...options };
  const open = profile ? openProfile : openWindow;
  const { context, close } = await open(asUsers, settings);
  context.setDefaultTimeout(patience);
  if (!asUsers) await context.addInitScript(drawNothing);
  if (unfolded) await context.addInitScript(unfold);
  const address = `http://127.0.0.1:${server.address().port}/`;
  if (manyTabs && !asUsers) await (await context.newPage()).goto(`${address}icon.svg`);
  return {
    context,
    address,
    /** Makes the server silent from then on. */
    stopServing() {
      server.close();
      server.closeAllConnections();
    },
    async close() {
      await close();
      server.close();
    },
  };
}

/**
 * A browser for the tests of a suite: it opens before the first of them and closes after the last.
 */
export function browserOfSuite(options) {
  const browser = {};
  before(async () => {
    Object.assign(browser, await openBrowser({ manyTabs: true, ...options }));
  });
  after(() => browser.close());
  return browser;
}

/** A browser of a phone, for the touches of `touchOf`. */
export const openPhone = () =>
  openBrowser({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

/**
 * Senders of touches to a page: their type, and the places of the fingers, numbered from 0 unless
 * they have an `id`. `together` sends several without time between them, in which a finger would
 * rest.
 */
export async function touchOf(page) {
  const devtools = await page.context().newCDPSession(page);
  const touch = (type, ...places) =>
    devtools.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: places.map(({ x, y, id }, i) => ({ x, y, id: id ?? i })),
    });
  const together = (...touches) => Promise.all(touches.map((each) => touch(...each)));
  return { touch, together };
}

/** The tools of kinds without control points. */
const toolOf = {
  pen: 'pen',
  circle: 'circle',
  ellipse: 'ellipse',
  center: 'center',
  points: 'center',
};

/** A tab with the page; `logged` lists the page's complaints. */
export class Tab {
  logged = [];
  #waits = 0;

  constructor(page, address) {
    this.page = page;
    this.address = address;
    page.on('console', (message) => {
      if (isComplaint(message)) this.logged.push(message.text());
    });
    page.on('pageerror', (error) => this.logged.push(`${error}`));
    page.on('requestfailed', (request) => {
      // A reload cancels requests under way.
      if (request.failure()?.errorText === 'net::ERR_ABORTED') return;
      this.logged.push(`failed: ${request.url()}`);
    });
  }

  /** Opens the page with a fragment such as `mesh=sphere:1500`, and waits until it is ready. */
  static async open(browser, fragment = 'mesh=sphere:1500') {
    const tab = new Tab(await browser.context.newPage(), browser.address);
    await tab.page.goto(`${browser.address}?antialias=off#${fragment}`);
    await tab.settled();
    return tab;
  }

  /** Closes the tab, and fails if the page complained. */
  async close() {
    assert.deepEqual(this.logged, []);
    await this.page.close();
  }

  /**
   * Waits until the engine has answered the newest state, and until the frame that shows the
   * answer. Playwright's own waits run in every frame, and make the browser compose frames without
   * changes.
   */
  async settled() {
    await this.page.waitForFunction(
      (wait) => {
        window.testWaits ??= {};
        const waits = window.testWaits;
        if (!window.karcherPage?.settled || window.karcherPage.triangles === 0) {
          waits[wait] = 'begun';
        } else if (waits[wait] === 'begun') {
          waits[wait] = 'answered';
          requestAnimationFrame(() => {
            if (waits[wait] === 'answered') waits[wait] = 'shown';
          });
        } else return waits[wait] !== 'answered';
        return false;
      },
      ++this.#waits,
      { polling: 20 },
    );
  }

  /** Waits until the view has come to rest. */
  async still() {
    await this.page.waitForFunction(() => window.karcherPage.still);
  }

  /** The workers that run an engine: that of the page, and the one that refines, once it exists. */
  engines = () => this.page.workers().filter((worker) => worker.url().includes('engine'));

  /** Keeps the first engine busy forever from its next call on: it receives nothing more. */
  holdEngine() {
    return this.engines()[0].evaluate(() => {
      const post = globalThis.postMessage;
      globalThis.postMessage = (reply, transfer) => {
        post.call(globalThis, reply, transfer);
        while (reply.begun);
      };
    });
  }

  /** Waits longer than the delay of saving, by the page's clock, so that pending saves have run. */
  async pastSaving() {
    await this.page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500)));
  }

  /** The colors of a small part of the window, row by row: red, green and blue of each pixel. */
  async pixels(clip) {
    const png = (await this.page.screenshot({ clip })).toString('base64');
    const bytes = await this.page.evaluate(async (base64) => {
      const file = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([file], { type: 'image/png' }));
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
      context.drawImage(image, 0, 0);
      // A typed array passes to the test as bytes, an array as a list of many objects.
      return new Uint8Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
    }, png);
    return Array.from({ length: bytes.length / 4 }, (_, i) => [
      ...bytes.subarray(4 * i, 4 * i + 3),
    ]);
  }

  state = () => this.page.evaluate(() => window.karcherPage.state());

  /** The view, checked and read together once the engine has answered the newest state. */
  async view() {
    const view = await this.page.waitForFunction(() => {
      const page = window.karcherPage;
      if (!page?.settled || page.triangles === 0) return null;
      const { curve, legs, ...rest } = page.view();
      const polyline = curve && Array.from(curve.polyline);
      return { ...rest, legs: legs.map((leg) => Array.from(leg)), curve, polyline };
    });
    return view.jsonValue();
  }

  mesh = () =>
    this.page.evaluate(async () => {
      const { info, positions, triangles } = await window.karcherPage.mesh();
      return { info, positions: Array.from(positions), triangles: Array.from(triangles) };
    });

  /** The middle of the stage, in the window's pixels. */
  async middle() {
    const box = await this.page.locator('#stage').boundingBox();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /** Clicks the stage at offsets from its middle. */
  async click(...offsets) {
    const { x, y } = await this.middle();
    for (const [dx, dy] of offsets) await this.page.mouse.click(x + dx, y + dy);
    await this.settled();
  }

  /**
   * Chooses the kind of the drawing as a user would: by the tool of its group, and then in the
   * group's menu.
   */
  async choose(kind) {
    const radio = this.page.locator(`#kind input[value="${kind}"]`).filter({ visible: true });
    if ((await radio.count()) === 0) {
      await this.page.locator(`#tool-${toolOf[kind] ?? 'curve'}`).click();
    }
    if ((await radio.count()) > 0) await radio.check({ force: true });
  }

  /** The middle of a handle, in the window's pixels. */
  async handle(name) {
    // Handles follow the state in the next frame.
    await this.page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
    const box = await this.page.getByRole('button', { name, exact: false }).boundingBox();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /**
   * A visible place of a curve in the window, at about that part of its vertices and away from
   * handles. The curve is the edited one, or another one by its index.
   */
  async onCurve(part, other = null) {
    await this.settled();
    return this.page.evaluate(
      ([from, index]) => {
        const { curve, others } = window.karcherPage.view();
        const polyline = index === null ? curve.polyline : others[index].lines[0];
        const handles = [...document.querySelectorAll('.handle')].map((handle) => {
          const box = handle.getBoundingClientRect();
          return [box.left + box.width / 2, box.top + box.height / 2];
        });
        const count = polyline.length / 3;
        for (let step = 0; step < count; step++) {
          const at = 3 * ((Math.floor(from * count) + step) % count);
          const place = window.karcherPage.seen(polyline.subarray(at, at + 3));
          if (place && handles.every(([x, y]) => Math.hypot(x - place.x, y - place.y) > 24)) {
            return place;
          }
        }
        throw new Error('no part of the curve is free');
      },
      [part, other],
    );
  }

  /** Drags from one place of the window to another, in several steps. */
  async drag(from, to) {
    await this.page.mouse.move(from.x, from.y);
    await this.page.mouse.down();
    await this.page.mouse.move(to.x, to.y, { steps: 6 });
    await this.page.mouse.up();
    await this.settled();
  }

  async dragHandle(name, dx, dy) {
    const from = await this.handle(name);
    await this.drag(from, { x: from.x + dx, y: from.y + dy });
  }

  /** Saves in one of the menu's formats, and returns the file's name and text. */
  async save(format) {
    const coming = this.page.waitForEvent('download');
    await this.page.locator('#save').click();
    await this.page.getByRole('menuitem', { name: format }).first().click();
    const download = await coming;
    const text = readFileSync(await download.path(), 'utf8');
    return { name: download.suggestedFilename(), text };
  }

  /** Drops a file with that text onto the page. */
  drop(name, text) {
    return this.dropBytes(name, new TextEncoder().encode(text));
  }

  dropBytes(name, bytes) {
    return this.dropFiles([[name, bytes]]);
  }

  /** Drops files together, each a name and its bytes. */
  dropFiles(files) {
    return this.page.evaluate(
      (texts) => {
        const dataTransfer = new DataTransfer();
        for (const [name, base64] of texts) {
          const content = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
          dataTransfer.items.add(new File([content], name));
        }
        window.dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
      },
      files.map(([name, bytes]) => [name, Buffer.from(bytes).toString('base64')]),
    );
  }
}
