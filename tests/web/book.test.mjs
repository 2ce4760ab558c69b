// The book beside the page: its links, its search, and that it sends no request to another host.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join, relative } from 'node:path';
import { describe, test } from 'node:test';
import axe from 'axe-core';
import { filesBelow, inRoot } from '../../.tools/shell.mjs';
import { browserOfSuite, isComplaint, openBrowser, until } from './browser.mjs';
import { part } from './part.mjs';

const built = inRoot('build/page');
const book = join(built, 'book');
const live = filesBelow('build/page/book/live', /\.html$/);
const pages = filesBelow('build/page/book', /\.html$/);

// Headings of TypeDoc's side bar fold and are also links: a link within a summary.
const options = {
  runOnly: ['wcag2a', 'wcag2aa'],
  rules: { 'nested-interactive': { enabled: false } },
};

/**
 * The hues by which an example's canvas shows its result: nothing else there has them. Curves are
 * red by default.
 */
const hues = { red: [0, 30], yellow: [40, 70], blue: [200, 260] };
const colors = { decal: ['blue'], distance_colors: ['yellow', 'blue'] };
/** The least number of pixels of a curve as long as a handle is wide. */
const fewest = 20;

/** The number of pixels of a page's canvas with a strong color of that hue. */
async function count(page, hue) {
  const picture = (await page.locator('canvas').screenshot()).toString('base64');
  return page.evaluate(
    async ([url, [least, most]]) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      const { width, height } = image;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      let found = 0;
      for (let at = 0; at < data.length; at += 4) {
        const [red, green, blue] = data.subarray(at, at + 3);
        const [high, low] = [Math.max(red, green, blue), Math.min(red, green, blue)];
        if (high - low < 80) continue;
        const third = high === red ? green - blue : high === green ? blue - red : red - green;
        const turn = (high === red ? 0 : high === green ? 2 : 4) + third / (high - low);
        const degrees = (60 * turn + 360) % 360;
        if (degrees >= least && degrees <= most) found++;
      }
      return found;
    },
    [`data:image/png;base64,${picture}`, hues[hue]],
  );
}

const unescaped = (text) => text.replaceAll('&amp;', '&').replaceAll('&quot;', '"');

/** The addresses in a page, and the page's anchors. */
function read(path) {
  const text = readFileSync(path, 'utf8');
  const all = (pattern) => [...text.matchAll(pattern)].map(([, found]) => unescaped(found));
  return { links: all(/\s(?:href|src)="([^"]*)"/g), anchors: new Set(all(/\sid="([^"]*)"/g)) };
}

test('no link of the book is dead', () => {
  const known = new Map(pages.map((path) => [path, read(path)]));
  const dead = [];
  let looked = 0;
  for (const [path, { links }] of known) {
    for (const link of new Set(links)) {
      if (/^(https?|mailto):/.test(link)) continue;
      looked++;
      const [place, anchor] = link.split('#');
      const target = place === '' ? path : join(dirname(path), decodeURIComponent(place));
      const found = existsSync(target);
      const anchors = known.get(target)?.anchors;
      if (!found || (anchor && anchors && !anchors.has(decodeURIComponent(anchor)))) {
        dead.push(`${relative(book, path)}: ${link}`);
      }
    }
  }
  assert.ok(live.length >= 8);
  assert.ok(pages.length > 100 && looked > 1000, `${pages.length} pages, ${looked} links`);
  assert.deepEqual(dead, []);
});

test('the book loads nothing from another host, and has no address of this machine', () => {
  for (const path of pages) {
    const text = readFileSync(path, 'utf8');
    assert.doesNotMatch(text, /<(script|link|img|iframe)[^>]*(src|href)="https?:/, path);
    assert.ok(!text.includes(inRoot('')), path);
    assert.ok(!text.includes('page.invalid'), path);
  }
});

test('every link of the editor to the book leads to a page', () => {
  const text = readFileSync(join(built, 'index.html'), 'utf8');
  const links = [...text.matchAll(/href="\.\/(book\/[^"#]*)/g)].map(([, link]) => link);
  assert.ok(links.length > 0);
  for (const link of links) assert.ok(existsSync(join(built, link)), link);
});

describe('in a browser the book', () => {
  const browser = browserOfSuite({ asUsers: true });

  const open = async (path) => {
    const page = await browser.context.newPage();
    const complaints = [];
    page.on('console', (message) => {
      // React-three-fiber uses a clock that three.js has deprecated.
      const isTheirs = message.text().startsWith('THREE.Clock: ');
      if (isComplaint(message) && !isTheirs) complaints.push(message.text());
    });
    page.on('request', (request) => {
      const url = request.url();
      if (!/^(data|blob):/.test(url) && !url.startsWith(browser.address)) complaints.push(url);
    });
    await page.goto(`${browser.address}book/${path}`);
    return { page, complaints };
  };

  test('finds the words of a search, and leads to the editor', async () => {
    const { page, complaints } = await open('index.html');
    await page.locator('#tsd-search-trigger').click();
    await page.locator('#tsd-search-input').fill('centerOfMass');
    await page.locator('#tsd-search-results li a').first().click();
    await page.waitForURL(/\/book\/\w+\//);
    await page
      .locator('a', { hasText: /^Editor$/ })
      .first()
      .click();
    await page.waitForURL(`${browser.address}index.html`);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  for (const path of part(live, 4)) {
    test(`shows ${relative(book, path)}`, async () => {
      const { page, complaints } = await open(relative(book, path));
      await page.locator('canvas, pre:not(:empty)').first().waitFor();
      await page.waitForLoadState('networkidle');
      if ((await page.locator('canvas').count()) === 0) {
        // Waits for the last number of each output, printed with all of its digits.
        await page.waitForFunction(() => /\d\.\d\d/.test(document.querySelector('pre').innerText));
      } else {
        const name = basename(path, '.html');
        for (const wanted of colors[name] ?? ['red']) {
          await until(
            async () => (await count(page, wanted)) >= fewest,
            `${name} shows what is ${wanted}`,
          );
        }
      }
      assert.deepEqual(complaints, []);
      assert.doesNotMatch(await page.locator('body').innerText(), /NaN|undefined|Error/);
      await page.close();
    });
  }

  const looked = ['documents/Errors.html', 'documents/Which_call_to_take.html'];
  for (const path of ['index.html', ...looked, 'classes/karcher.Mesh.html']) {
    test(`is accessible: ${path}`, async () => {
      const { page, complaints } = await open(path);
      await page.locator('.tsd-navigation a').first().waitFor({ state: 'attached' });
      // The policy allows only the book's own scripts.
      const client = await page.context().newCDPSession(page);
      const run = `(() => { ${axe.source}\nreturn axe.run(${JSON.stringify(options)}); })()`;
      const { result } = await client.send('Runtime.evaluate', {
        ...{ expression: run, awaitPromise: true, returnByValue: true },
      });
      const found = result.value.violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`);
      assert.deepEqual(found, []);
      assert.deepEqual(complaints, []);
      await page.close();
    });
  }
});

test('the book can be read without a network after a visit to one of its pages', async () => {
  const { files } = JSON.parse(readFileSync(join(book, 'files.json'), 'utf8'));
  const browser = await openBrowser({ serviceWorkers: 'allow' });
  try {
    const page = await browser.context.newPage();
    await page.goto(`${browser.address}book/index.html`);
    const isKept = async (count) => {
      const name = (await caches.keys()).find((one) => one.startsWith('karcher-book-'));
      return name && (await (await caches.open(name)).keys()).length >= count;
    };
    await until(() => page.evaluate(isKept, files.length), 'the book is kept');
    browser.stopServing();
    await browser.context.setOffline(true);
    await page.goto(`${browser.address}book/documents/Errors.html`);
    await page.locator('h1, h2').first().waitFor();
    await page.goto(`${browser.address}book/${relative(book, live[0])}`);
    await page.locator('canvas, pre:not(:empty)').first().waitFor({ timeout: 20_000 });
  } finally {
    await browser.close();
  }
});
