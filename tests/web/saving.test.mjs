// Files that the page saves and opens again.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { browserOfSuite, openBrowser, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';
import { fitsFile } from './schema.mjs';

const places = [
  [-110, 40],
  [-40, -10],
  [40, 50],
  [110, -10],
];
const octahedron = `v 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\nv 0 0 -1
f 1 2 3\nf 2 4 3\nf 4 5 3\nf 5 1 3\nf 2 1 6\nf 4 2 6\nf 5 4 6\nf 1 5 6\n`;

describe('saving', () => {
  const browser = browserOfSuite({ asUsers: true });

  test('an OBJ file has the polyline of the curve', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { name, text } = await tab.save('OBJ');
    assert.equal(name, 'bspline-on-sphere.obj');
    const lines = text.trimEnd().split('\n');
    const vertices = lines.filter((line) => line.startsWith('v ')).map((line) => line.split(' '));
    const { polyline } = await tab.view();
    assert.deepEqual(
      vertices.flatMap(([, ...place]) => place.map((value) => Math.fround(value))),
      polyline,
    );
    const element = lines.at(-1).split(' ').slice(1).map(Number);
    assert.deepEqual(
      element,
      vertices.map((_, i) => i + 1),
    );
    await tab.close();
  });

  test('a PNG is the view in twice as many pixels, transparent on request', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    await tab.still();
    const stage = await tab.page.locator('#stage').boundingBox();
    /** The image's size, its transparent part, and whether it has the curve's color. */
    const look = async (format) => {
      const coming = tab.page.waitForEvent('download');
      await tab.page.locator('#save').click();
      await tab.page.locator(`[data-save="${format}"]`).click();
      const download = await coming;
      assert.equal(download.suggestedFilename(), 'bspline-on-sphere.png');
      const bytes = readFileSync(await download.path()).toString('base64');
      return tab.page.evaluate(async (base64) => {
        const content = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([content], { type: 'image/png' }));
        const { width, height } = bitmap;
        const context = new OffscreenCanvas(width, height).getContext('2d');
        context.drawImage(bitmap, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        let [clear, blue] = [0, 0];
        for (let i = 0; i < data.length; i += 4) {
          if (data[i + 3] === 0) clear++;
          if (data[i + 2] > data[i] + 80) blue++;
        }
        return { width, height, clear: clear / (width * height), blue };
      }, bytes);
    };
    const [whole, clear] = [await look('png'), await look('clear')];
    for (const { width, height } of [whole, clear]) {
      assert.deepEqual([width, height], [2 * stage.width, 2 * stage.height]);
    }
    assert.equal(whole.clear, 0);
    assert.ok(clear.clear > 0.2 && clear.clear < 0.9, `${clear.clear} is seen through`);
    assert.ok(whole.blue > 500 && clear.blue > 500, 'the curve is on both');
    await tab.close();
  });

  test('a CSV file has the points of the curve, and a GLB or OBJ file the surface with it', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { polyline, curve } = await tab.view();
    const { name, text } = await tab.save('CSV');
    assert.equal(name, 'bspline-on-sphere.csv');
    const [header, ...lines] = text.trimEnd().split('\n');
    assert.equal(
      header,
      'x,y,z,normal_x,normal_y,normal_z,face,bary_1,bary_2,bary_3,length,parameter',
    );
    const rows = lines.map((line) => line.split(',').map(Number));
    assert.deepEqual(
      rows.flatMap((row) => row.slice(0, 3).map(Math.fround)),
      polyline,
    );
    // The sphere is about the origin, so that its normals point away from there.
    for (const [x, y, z, ...normal] of rows) {
      const cosine = (x * normal[0] + y * normal[1] + z * normal[2]) / Math.hypot(x, y, z);
      assert.ok(cosine > 0.99, `a normal is off by ${cosine}`);
    }
    const [length, parameter] = rows.at(-1).slice(-2);
    assert.ok(Math.abs(length - curve.length) <= 1e-12 * length);
    // Four points form a single segment.
    assert.equal(parameter, 1);

    // The page saves a second curve in a color of its own, also with the surface.
    await tab.page.keyboard.press('Control+d');
    await tab.settled();
    const saved = async (entry) => {
      const coming = tab.page.waitForEvent('download');
      await tab.page.locator('#save').click();
      await tab.page.locator(`[data-save="${entry}"]`).click();
      return readFileSync(await (await coming).path());
    };
    const triangles = await tab.page.evaluate(() => window.karcherPage.triangles);
    const glb = Uint8Array.from(await saved('glb'));
    const { scene } = await new GLTFLoader().parseAsync(glb.buffer, '');
    const [surface, ...tubes] = scene.children;
    assert.equal(surface.geometry.index.count, 3 * triangles);
    assert.equal(tubes.length, 2);
    for (const { geometry, material } of tubes) {
      assert.ok(material.color.b > material.color.r, 'curves are blue');
      // Lines are three pixels wide in a view of some hundred pixels.
      geometry.computeBoundingBox();
      assert.ok(geometry.attributes.normal.count > 100);
    }
    const group = new OBJLoader().parse((await saved('surface')).toString());
    const kinds = group.children.map(({ type }) => type);
    assert.deepEqual(kinds, ['Mesh', 'LineSegments', 'LineSegments']);

    // The page saves only the selection, which is one of the two curves.
    await tab.page.locator('#save').click();
    await tab.page.locator('#only-selected').click();
    await tab.page.keyboard.press('Escape');
    const alone = Uint8Array.from(await saved('glb'));
    const { scene: one } = await new GLTFLoader().parseAsync(alone.buffer, '');
    assert.equal(one.children.length, 2);
    await tab.close();
  });

  test('a JSON file opens the curve again, even elsewhere', async () => {
    const tab = await Tab.open(browser);
    await tab.page.keyboard.press('2');
    await tab.click(...places);
    const [{ figure: document }, view] = [await tab.state(), await tab.view()];
    const { name, text } = await tab.save('JSON');
    const content = JSON.parse(text);
    assert.ok(fitsFile(content), JSON.stringify(fitsFile.errors));
    assert.deepEqual(content.points, document.points);
    assert.equal(content.samples.length, 128);
    assert.ok(content.samples.every(({ center }) => center));
    assert.deepEqual([content.kind, content.quality], ['bezier', 'exact']);
    assert.ok(Math.abs(content.length - view.curve.length) <= 1e-12 * content.length);

    await tab.page.getByRole('button', { name: 'Clear' }).click();
    await tab.drop(name, text);
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.points.length === 4);
    assert.deepEqual((await tab.state()).figure, document);
    await tab.page.keyboard.press('Control+z');
    assert.equal((await tab.state()).figure.points.length, 0);
    await tab.page.close();

    const other = await openBrowser();
    try {
      const elsewhere = await Tab.open(other, 'mesh=torus:5000');
      await elsewhere.drop(name, text);
      await elsewhere.page.waitForFunction(() =>
        window.karcherPage.state().mesh.startsWith('sphere:'),
      );
      assert.deepEqual((await elsewhere.view()).polyline, view.polyline);
      assert.deepEqual(elsewhere.logged, []);
    } finally {
      await other.close();
    }
  });

  inLongRun('a curve on a file waits for that file', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('octahedron.obj', octahedron);
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 8);
    await tab.page.keyboard.press('2');
    await tab.click([-30, -20], [40, 10]);
    const { figure: document } = await tab.state();
    const { name, text } = await tab.save('JSON');
    await tab.page.close();

    const other = await openBrowser();
    try {
      const elsewhere = await Tab.open(other);
      await elsewhere.drop(name, text);
      const alert = elsewhere.page.getByRole('alert');
      await alert.waitFor();
      assert.match(await alert.textContent(), /octahedron\.obj/);
      await elsewhere.drop('octahedron.obj', octahedron);
      await elsewhere.page.waitForFunction(() => window.karcherPage.triangles === 8);
      assert.deepEqual((await elsewhere.state()).figure, document);
      await alert.waitFor({ state: 'detached' });
    } finally {
      await other.close();
    }
  });

  test('an SVG file draws the curve where it appears', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { text } = await tab.save('SVG');
    const { viewBox, dots, paths } = await tab.page.evaluate((svg) => {
      const root = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
      return {
        viewBox: root.getAttribute('viewBox'),
        dots: [...root.querySelectorAll('circle')].map((dot) => [
          Number(dot.getAttribute('cx')),
          Number(dot.getAttribute('cy')),
        ]),
        paths: [...root.querySelectorAll('path')].map((path) => path.getAttribute('d')),
      };
    }, text);
    const stage = await tab.page.locator('#stage').boundingBox();
    assert.equal(viewBox, `0 0 ${stage.width} ${stage.height}`);
    assert.equal(dots.length, 4);
    for (const [i, [x, y]] of dots.entries()) {
      const [dx, dy] = places[i];
      const off = Math.hypot(x - stage.width / 2 - dx, y - stage.height / 2 - dy);
      assert.ok(off < 1.5, `point ${i + 1} lies ${off} pixels from the click`);
    }
    assert.ok(paths.length >= 4, 'three legs and the curve');
    assert.ok(paths.every((path) => /^M-?[\d.]+ /.test(path) && !path.includes('NaN')));
    await tab.page.close();
  });

  test('an SVG file has a named group for each object, of few Bézier curves within 0.25 pixels', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    await tab.page.locator('#object-name').fill('Wave & <rim>');
    await tab.page.keyboard.press('Enter');
    await tab.page.locator('#new-object').click();
    await tab.page.keyboard.press('b');
    await tab.click([-90, -60], [-30, -90], [30, -60], [90, -80]);
    const { text } = await tab.save('SVG');
    const groups = await tab.page.evaluate((svg) => {
      const box = document.body.appendChild(document.createElement('div'));
      box.innerHTML = svg;
      const all = [...box.querySelectorAll('g[id^="object-"]')].map((group) => {
        const paths = [...group.querySelectorAll('path')];
        const samples = paths.flatMap((path) => {
          const length = path.getTotalLength();
          return Array.from({ length: 400 }, (_, i) => {
            const { x, y } = path.getPointAtLength((i * length) / 399);
            return [x, y];
          });
        });
        const commands = paths.reduce((sum, path) => {
          return sum + path.getAttribute('d').match(/[LC]/g).length;
        }, 0);
        return { name: group.querySelector('title').textContent, samples, commands };
      });
      box.remove();
      return all;
    }, text);
    assert.deepEqual(groups.map(({ name }) => name).toSorted(), ['B-spline 2', 'Wave & <rim>']);
    const lines = await tab.page.evaluate(() => {
      const { curve, others } = window.karcherPage.view();
      const stage = document.getElementById('stage').getBoundingClientRect();
      return [others[0].lines[0], curve.polyline].map((line) =>
        Array.from({ length: line.length / 3 }, (_, i) => {
          const seen = window.karcherPage.seen(line.subarray(3 * i, 3 * i + 3));
          return [seen.x - stage.left, seen.y - stage.top];
        }),
      );
    });
    const offSegment = ([x, y], [ax, ay], [bx, by]) => {
      const [dx, dy] = [bx - ax, by - ay];
      const square = dx * dx + dy * dy;
      const t = square && Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square));
      return Math.hypot(x - ax - t * dx, y - ay - t * dy);
    };
    const off = (place, line) =>
      Math.min(...line.slice(1).map((end, i) => offSegment(place, line[i], end)));
    for (const [i, name] of ['Wave & <rim>', 'B-spline 2'].entries()) {
      const { samples, commands } = groups.find((group) => group.name === name);
      for (const place of samples) assert.ok(off(place, lines[i]) < 0.25, `${name}: ${place}`);
      // Each place of the line is as near to the curve, up to two hundredths for rounded digits and
      // samples.
      for (const place of lines[i]) assert.ok(off(place, samples) < 0.27, `${name}: ${place}`);
      assert.ok(commands < lines[i].length / 6, `${commands} for ${lines[i].length} vertices`);
    }
    // The page saves only the selection, the second curve.
    const only = tab.page.locator('#only-selected');
    await tab.page.locator('#save').click();
    await only.click();
    assert.equal(await only.getAttribute('aria-checked'), 'true');
    await tab.page.keyboard.press('Escape');
    const alone = await tab.save('SVG');
    assert.deepEqual(alone.text.match(/<title>[^<]*/g), ['<title>B-spline 2']);
    assert.equal(alone.name, 'bspline-on-sphere.svg');
    assert.equal((await tab.save('OBJ')).text.match(/^l /gm).length, 1);
    await tab.page.keyboard.press('Control+a');
    await tab.page.locator('#save').click();
    assert.equal(await only.isEnabled(), false);
    await tab.page.keyboard.press('Escape');
    assert.equal((await tab.save('OBJ')).text.match(/^l /gm).length, 2);
    await tab.close();
  });

  test('an SVG file has the points and hidden parts of objects as the view has them', async () => {
    // The points and the line lie on all sides of the sphere.
    const all = Array.from({ length: 30 }, (_, i) => `${50 * i},0.3,0.3`).join(';');
    const dotted = encodeURIComponent(`kind=points&points=${all}&width=10&opacity=0.5&name=Dots`);
    const tab = await Tab.open(
      browser,
      `mesh=sphere:1500&kind=polyline&points=0,0.3,0.3;1450,0.3,0.3&name=Line&other=${dotted}`,
    );
    const { page } = tab;
    for (let times = 0; times < 3; times++) await page.keyboard.press('Escape');
    await tab.settled();
    const saved = async () => {
      const { text } = await tab.save('SVG');
      const group = (name) => {
        const [, attributes, inside] = text.match(`<g([^>]*)><title>${name}</title>([^]*?)</g>`);
        const hidden = inside.match(/<(circle|path)[^>]* opacity="0.3"/g) ?? [];
        return {
          attributes,
          elements: inside.match(/<(circle|path)[^>]*>/g) ?? [],
          hidden: hidden.length,
        };
      };
      const groups = [group('Dots'), group('Line')];
      // Without a selection, the control polygon is not visible.
      const count = text.match(/<(circle|path)/g).length;
      assert.equal(count, groups[0].elements.length + groups[1].elements.length);
      return groups;
    };
    const [dots, line] = await saved();
    assert.match(dots.attributes, / opacity="0.5"/);
    assert.equal(dots.elements.length, 30);
    assert.ok(dots.hidden > 8 && dots.hidden < 22, `${dots.hidden} hidden`);
    // A point is 2.4 times as wide as a line.
    for (const dot of dots.elements) assert.match(dot, / r="12"/);
    assert.ok(line.hidden > 0);
    await page.keyboard.press('h');
    const [seenDots, seenLine] = await saved();
    assert.deepEqual([seenDots.hidden, seenLine.hidden], [0, 0]);
    assert.equal(seenDots.elements.length, 30 - dots.hidden);
    await page.keyboard.press('h');
    await tab.close();
  });

  test('a drawing without a curve cannot be saved as one, and a file of another kind gives a sentence', async () => {
    const tab = await Tab.open(browser);
    await tab.page.locator('#save').click();
    assert.equal(await tab.page.getByRole('menuitem', { name: 'OBJ' }).first().isEnabled(), false);
    await tab.page.keyboard.press('Escape');
    await tab.page.locator('#save-menu').waitFor({ state: 'hidden' });
    await tab.click(...places);
    const { figure: document } = await tab.state();
    for (const [name, text] of Object.entries({
      'broken.json': '{',
      'other.json': '{"format":"something"}',
      'empty.json': 'null',
    })) {
      await tab.drop(name, text);
      const alert = tab.page.getByRole('alert').filter({ hasText: name });
      await alert.waitFor();
      assert.match(await alert.locator('p').textContent(), /could not be read\. .*JSON.*\.$/);
    }
    assert.deepEqual((await tab.state()).figure, document);
    await tab.close();
  });
});
