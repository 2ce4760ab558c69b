// No mesh and no file passes through the page's main thread, so that nothing blocks it for long.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openBrowser, Tab } from './browser.mjs';
import { gridStl } from './large_file.mjs';
import { inLongRun } from './part.mjs';

/** The limit in bytes: more than a drawing takes, and far less than the mesh. */
const most = 1 << 16;
/** The number of bytes that the page reads of a file at once, to identify it. */
const mostRead = 1 << 21;
const triangles = 50_000;

/** Records the bytes that a page posts, stores and reads, before the page's own code runs. */
function watch() {
  const bytesOf = (value, seen = new Set()) => {
    if (typeof value !== 'object' || value === null || seen.has(value)) return 0;
    seen.add(value);
    if (value instanceof ArrayBuffer) return value.byteLength;
    if (ArrayBuffer.isView(value)) return bytesOf(value.buffer, seen);
    return Object.values(value).reduce((sum, part) => sum + bytesOf(part, seen), 0);
  };
  window.passed = { posted: [], kept: [], read: [], made: [] };
  const noting = (owner, name, kind, bytes) => {
    const call = owner[name];
    owner[name] = function (...args) {
      window.passed[kind].push(bytes(this, ...args));
      return call.apply(this, args);
    };
  };
  noting(Worker.prototype, 'postMessage', 'posted', (_, message) => bytesOf(message));
  noting(IDBObjectStore.prototype, 'put', 'kept', (_, value) => bytesOf(value));
  noting(Blob.prototype, 'arrayBuffer', 'read', ({ size }) => size);
  window.Blob = class extends Blob {
    constructor(...given) {
      super(...given);
      window.passed.made.push(this.size);
    }
  };
}

describe('the page’s main thread', () => {
  let browser;
  const folder = mkdtempSync(join(tmpdir(), 'karcher-copies-'));
  const file = join(folder, 'grid.stl');
  before(async () => {
    writeFileSync(file, gridStl(triangles));
    browser = await openBrowser();
    await browser.context.addInitScript(watch);
  });
  after(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });

  /** Checks the bytes since the page's load, and those that it stored of files. */
  async function checked(tab, { reads }) {
    const { posted, kept, read, made } = await tab.page.evaluate(() => window.passed);
    const largest = (list) => Math.max(0, ...list);
    assert.ok(posted.length > 0, 'messages are noted');
    assert.ok(largest(posted) <= most, `${largest(posted)} bytes were posted to a worker`);
    assert.ok(largest(kept) <= most, `${largest(kept)} bytes were kept in a database`);
    assert.ok(largest(read) <= mostRead, `${largest(read)} bytes were read at once`);
    assert.equal(largest(read) > most, reads, 'only what tells files apart is read');
    assert.ok(largest(made) <= most, `a Blob of ${largest(made)} bytes was made`);
    return kept.length;
  }
  const opened = (tab) =>
    tab.page.waitForFunction((least) => {
      const page = window.karcherPage;
      return page?.state().mesh.startsWith('file:') && page.triangles > least && page.settled;
    }, triangles - 1000);

  inLongRun(
    'stays free of every file that is opened, drawn on, checked, kept and opened again',
    async () => {
      const tab = await Tab.open(browser);
      const { page } = tab;
      await page.locator('#file').setInputFiles(file);
      await opened(tab);
      await page.keyboard.press('2');
      await tab.click([-90, 20], [-30, -40], [30, 20], [90, -30]);
      await tab.dragHandle('Control point 2 of 4', 25, 10);
      // A second engine computes the exact curve on the same mesh.
      assert.equal(await page.locator('#status-quality').textContent(), 'exact');
      assert.equal(tab.engines().length, 2);
      await page.locator('#facts-line').click();
      await page.getByText('Check-up').click();
      await page.locator('#checkup-found > *').first().waitFor();
      await page.waitForFunction(() => window.passed.kept.length > 0);
      assert.equal(await checked(tab, { reads: true }), 1);

      await tab.pastSaving();
      await page.reload();
      await opened(tab);
      assert.equal(await checked(tab, { reads: false }), 0);
      await tab.close();
    },
  );

  test('stays free of the surface when its outline is saved', async () => {
    const tab = await Tab.open(browser, 'mesh=torus:80000');
    await tab.click([-90, 60], [90, 60]);
    const { text } = await tab.save('with the surface’s outline');
    assert.match(text, /id="outline"/);
    await checked(tab, { reads: false });
    await tab.close();
  });
});
