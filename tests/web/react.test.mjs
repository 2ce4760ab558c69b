// `karcher/react` in Chromium: a curve by hooks, mounted twice as in StrictMode, dragged and
// unmounted.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { chromium } from 'playwright-core';
import { TorusGeometry } from 'three';
import { build } from 'vite';
import { inRoot } from '../../.tools/shell.mjs';
import { glbFile } from '../wasm/mesh_files.mjs';
import { launching, until } from './browser.mjs';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };

/** Builds a page in memory and serves it, together with more files. */
async function serve(root, more) {
  const { output } = await build({
    configFile: false,
    root,
    base: './',
    logLevel: 'error',
    worker: { format: 'es' },
    build: {
      write: false,
      target: 'es2022',
      minify: false,
      rolldownOptions: { input: ['index.html', 'example.html'].map((name) => join(root, name)) },
    },
  });
  const files = new Map(output.map((file) => [`/${file.fileName}`, file.code ?? file.source]));
  for (const [name, content] of Object.entries(more)) files.set(`/${name}`, content);
  const server = createServer((request, response) => {
    const body = files.get(request.url);
    const type = types[extname(request.url)] ?? 'application/octet-stream';
    response.writeHead(body ? 200 : 404, { 'content-type': type }).end(body);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { server, address: `http://127.0.0.1:${server.address().port}` };
}

/** A torus as a GLB file. */
function model() {
  const { attributes, index } = new TorusGeometry(1, 0.4, 16, 48);
  const corners = Array.from(index.array);
  const faces = Array.from({ length: corners.length / 3 }, (_, i) =>
    corners.slice(3 * i, 3 * i + 3),
  );
  return glbFile({ positions: Array.from(attributes.position.array), faces });
}

/** Counts the drawn fat lines, whose segments are instances. Runs before the page's scripts. */
function countLines() {
  window.lines = 0;
  const { prototype } = WebGL2RenderingContext;
  const { drawArraysInstanced } = prototype;
  prototype.drawArraysInstanced = function (mode, first, count, segments) {
    if (segments > 0) window.lines++;
    drawArraysInstanced.call(this, mode, first, count, segments);
  };
}

const points = [10, 200, 420, 630].map((vertex) => ({ vertex }));
const shown = { options: { kind: 'bspline', points }, worker: false, segments: 48 };

describe('hooks of react-three-fiber', () => {
  let browser;
  let served;
  before(async () => {
    served = await serve(inRoot('tests/web/react_page'), { 'model.glb': model() });
    browser = await chromium.launch(launching);
  });
  after(async () => {
    await browser?.close();
    served?.server.close();
  });

  async function open(name = 'index') {
    const page = await browser.newPage();
    await page.addInitScript(countLines);
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('console', (message) => {
      if (message.type() === 'error') complaints.push(message.text());
    });
    await page.goto(`${served.address}/${name}.html`);
    return { page, complaints };
  }

  const isDrawn = (page) => page.waitForFunction(() => window.page.seen.curve?.view);
  const pointsOf = (page) => page.evaluate(() => window.page.seen.curve.value.points);

  for (const worker of [false, true]) {
    test(`show a curve that is dragged, with the engine ${worker ? 'in a worker' : 'in the page'}`, async () => {
      const { page, complaints } = await open();
      await page.evaluate((value) => window.page.show(value), { ...shown, worker });
      await isDrawn(page);
      const [x, y] = await page.evaluate(() => window.page.at(1));
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 6, y + 4, { steps: 3 });
      await page.mouse.up();
      await until(async () => 'face' in (await pointsOf(page))[1], 'the point is moved');
      // Equal options in a new object leave the curve as the drag left it.
      const dragged = await pointsOf(page);
      await page.evaluate((value) => window.page.show(value), { ...shown, worker });
      assert.deepEqual(await pointsOf(page), dragged);
      // Other options change the curve, and keep the object.
      const made = await page.evaluate(() => window.page.seen.made.size);
      const closed = { ...shown, worker, options: { ...shown.options, closed: true } };
      await page.evaluate((value) => window.page.show(value), closed);
      await page.waitForFunction(() => window.page.seen.curve.value.closed === true);
      assert.deepEqual(await pointsOf(page), points);
      assert.equal(await page.evaluate(() => window.page.seen.made.size), made);
      assert.equal(page.workers().length, worker ? 1 : 0);
      // Another look keeps the curve.
      const thick = { ...closed, look: { width: 7, color: '#0000ff' } };
      await page.evaluate((value) => window.page.show(value), thick);
      await page.waitForFunction(() => {
        const { linewidth, color } = window.page.seen.curve.material;
        return linewidth === 7 && color.getHexString() === '0000ff';
      });
      assert.equal(await page.evaluate(() => window.page.seen.made.size), made);
      // Another geometry is another surface and another curve.
      await page.evaluate((value) => window.page.show(value), { ...closed, segments: 50 });
      await page.waitForFunction((count) => window.page.seen.made.size > count, made);
      await isDrawn(page);
      await page.evaluate(() => window.page.unmount());
      await until(() => page.workers().length === 0, 'the worker has ended');
      assert.deepEqual(complaints, []);
      await page.close();
    });
  }

  test('show a changed curve on another surface at once', async () => {
    const { page, complaints } = await open();
    await page.evaluate((value) => window.page.show(value), shown);
    await isDrawn(page);
    const other = { ...shown, segments: 50, options: { ...shown.options, closed: true } };
    await page.evaluate((value) => {
      window.before = window.page.seen.curve;
      window.page.show(value);
    }, other);
    await page.waitForFunction(() => {
      const { curve, message } = window.page.seen;
      return message !== '' || (curve && curve !== window.before && curve.view);
    });
    assert.equal(await page.evaluate(() => window.page.seen.message), '');
    assert.equal(await page.evaluate(() => window.page.seen.curve.value.closed), true);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('take a basis that each render defines anew', async () => {
    const { page, complaints } = await open();
    const options = { kind: 'custom', points: points.slice(0, 2) };
    await page.evaluate((value) => window.page.show(value), { ...shown, options, inline: true });
    await page.waitForFunction(
      () => window.page.seen.message !== '' || window.page.seen.curve?.view,
    );
    assert.equal(await page.evaluate(() => window.page.seen.message), '');
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('report the options that recreate a dragged curve', async () => {
    const { page } = await open();
    const options = { kind: 'polyline', points };
    await page.evaluate((value) => window.page.show(value), { ...shown, options });
    await isDrawn(page);
    const told = await page.evaluate(async () => {
      const { curve } = window.page.seen;
      const { mesh } = curve.surface;
      await Promise.allSettled([
        curve.movePoint(1, { vertex: 230 }),
        curve.movePoint(1, { vertex: 99_999 }),
      ]);
      const { value } = window.page.seen;
      return [value.points[1], mesh.curve(value).view().length - curve.view.length];
    });
    assert.deepEqual(told[0], { vertex: 230 });
    assert.ok(Math.abs(told[1]) < 1e-9, `${told[1]}`);
    await page.close();
  });

  test('load the engine again after a failure, when a component mounts anew', async () => {
    const { page } = await open();
    await page.route('**/*.wasm', (route) => route.abort());
    await page.evaluate((value) => window.page.show(value), { ...shown, attempt: 1 });
    await page.waitForFunction(() => window.page.seen.message !== '');
    await page.unroute('**/*.wasm');
    await page.evaluate((value) => window.page.show(value), { ...shown, attempt: 2 });
    await isDrawn(page);
  });

  test('free the memory when they are unmounted', async () => {
    const { page, complaints } = await open();
    const cycle = async () => {
      await page.evaluate((value) => window.page.show(value), shown);
      await isDrawn(page);
      const used = await page.evaluate(() => window.page.seen.bytes());
      await page.evaluate(() => window.page.unmount());
      // The page still holds the engine, which has no user left.
      await page.waitForFunction((bytes) => window.page.seen.bytes() < bytes, used);
      const left = await page.evaluate(() => {
        const { made, bytes } = window.page.seen;
        const held = [...made].filter(({ parent }) => parent !== null).length;
        window.page.seen.curve = undefined;
        return { held, bytes: bytes() };
      });
      assert.equal(left.held, 0);
      return left.bytes;
    };
    const left = [await cycle(), await cycle(), await cycle()];
    const fresh = await page.evaluate(() => window.page.seen.fresh);
    assert.deepEqual(left, [fresh, fresh, fresh]);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('suffice for a GLB, as the example shows', async () => {
    const { page, complaints } = await open('example');
    await page.waitForFunction(() => window.lines > 0);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('throw failures to the error boundary', async () => {
    const { page } = await open();
    const wrong = {
      ...shown,
      options: { kind: 'bspline', points: [{ vertex: 99_999 }, ...points] },
    };
    await page.evaluate((value) => window.page.show(value), wrong);
    await page.waitForFunction(() => window.page.seen.message !== '');
    assert.match(await page.evaluate(() => window.page.seen.message), /99999/);
    await page.close();
  });
});
