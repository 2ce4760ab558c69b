// Files of surfaces dropped on the page: their formats, parts, and the upward axis.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import {
  box,
  cutBox,
  encode,
  everyFile,
  glbFile,
  gltfParts,
  objFile,
  stlFile,
} from '../wasm/mesh_files.mjs';
import { browserOfSuite, openBrowser, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';
import { fitsFile } from './schema.mjs';

/** A cone on z = 0, without a base; its tip is the last vertex. */
const ring = Array.from({ length: 60 }, (_, i) => (Math.PI * i) / 30);
const cone = {
  positions: [...ring.flatMap((t) => [Math.cos(t), Math.sin(t), 0]), 0, 0, 3],
  faces: ring.map((_, i) => [i, (i + 1) % 60, 60]),
};

describe('files of surfaces', () => {
  const browser = browserOfSuite({ asUsers: true });

  const opened = (tab, name) =>
    tab.page.waitForFunction((ending) => window.karcherPage?.state().mesh.endsWith(ending), name);

  /** The vertical distance of two places of the surface in the window, in pixels. */
  const above = (tab, high, low) =>
    tab.page.evaluate(
      ([a, b]) => {
        const [top, bottom] = [a, b].map((place) => window.karcherPage.seen(place));
        return { up: bottom.y - top.y, aside: Math.abs(top.x - bottom.x) };
      },
      [high, low],
    );

  test('every format is opened', async () => {
    const tab = await Tab.open(browser);
    for (const [name, bytes] of Object.entries(everyFile(cutBox))) {
      await tab.dropBytes(name, bytes);
      await opened(tab, name);
      await tab.settled();
      assert.deepEqual((await tab.mesh()).info.triangles, 12, name);
    }
    await tab.close();
  });

  test('files dropped together belong together, in any order', async () => {
    const tab = await Tab.open(browser);
    const { json, buffer } = gltfParts(cutBox);
    json.buffers = [{ uri: 'my%20buffers/a box.bin', byteLength: buffer.length }];
    const gltf = (name) => [
      [name, encode(JSON.stringify(json))],
      ['a box.bin', buffer],
    ];
    const obj = (name) => [
      [name, Buffer.concat([encode('mtllib box.mtl\n'), objFile(cutBox)])],
      ['box.mtl', encode('newmtl red\n')],
      ['red.png', Uint8Array.of(0x89, 0x50, 0x4e, 0x47)],
    ];
    const sets = [
      gltf('one.gltf'),
      gltf('two.gltf').reverse(),
      obj('one.obj'),
      obj('two.obj').reverse(),
    ];
    for (const files of sets) {
      const name = files.map(([one]) => one).find((one) => /gltf$|obj$/.test(one));
      await tab.dropFiles(files);
      await opened(tab, name);
      await tab.settled();
      assert.equal((await tab.mesh()).info.triangles, 12, name);
    }
    assert.deepEqual(await tab.page.locator('.message').allTextContents(), []);
    // The page stores the buffers with the file.
    await tab.dropFiles(gltf('three.gltf'));
    await opened(tab, 'three.gltf');
    await tab.page.keyboard.press('2');
    await tab.click([0, 0], [10, 20]);
    await tab.pastSaving();
    await tab.page.reload();
    await tab.settled();
    assert.match((await tab.state()).mesh, /three\.gltf$/);
    // The next drop is a surface and a drawing on it.
    const { drawing, mesh } = await tab.state();
    const { name, text } = await tab.save('JSON');
    await tab.dropFiles([
      [name, encode(text)],
      ...gltf('three.gltf'),
      ['notes.txt', encode('hello')],
    ]);
    await tab.page.getByText('notes.txt is no surface or drawing').waitFor();
    await tab.settled();
    assert.equal((await tab.state()).mesh, mesh);
    assert.deepEqual((await tab.state()).drawing, drawing);
    await tab.close();
  });

  /** Red, green and blue of the stage's middle. */
  async function seenColor(tab) {
    const { x, y } = await tab.middle();
    const [color] = await tab.pixels({ x: x + 9, y: y + 9, width: 1, height: 1 });
    return color;
  }

  test('a file’s colors are those of its surface, until clay is wanted', async () => {
    const tab = await Tab.open(browser);
    const text = new TextDecoder().decode(objFile(cutBox));
    const ofColor = (color) => encode(text.replace(/^v .*$/gm, (line) => `${line} ${color}`));
    const item = tab.page.locator('#file-colors');
    const strong = ([one, ...others]) => others.every((other) => one > 2 * other);
    await tab.dropBytes('red.obj', ofColor('0.8 0.1 0.1'));
    await opened(tab, 'red.obj');
    await tab.settled();
    assert.ok(strong(await seenColor(tab)), 'red');
    await tab.page.locator('#view').click();
    await item.click();
    await tab.page.keyboard.press('Escape');
    await tab.settled();
    assert.ok(!strong(await seenColor(tab)), 'clay');
    await tab.page.locator('#view').click();
    await item.click();
    await tab.page.keyboard.press('Escape');
    await tab.dropBytes('blue.obj', ofColor('0.1 0.1 0.8'));
    await opened(tab, 'blue.obj');
    await tab.settled();
    assert.ok(strong((await seenColor(tab)).reverse()), 'blue');
    await tab.dropBytes('plain.obj', objFile(cutBox));
    await opened(tab, 'plain.obj');
    await tab.settled();
    assert.ok(!strong((await seenColor(tab)).reverse()), 'plain');
    await tab.page.locator('#view').click();
    assert.equal(await item.isVisible(), false);
    await tab.close();
  });

  test('the user chooses one of several surfaces to open', async () => {
    const tab = await Tab.open(browser);
    const several = Array.from({ length: 20 }, (_, i) => [`box ${i}.obj`, objFile(cutBox)]);
    await tab.dropFiles(several);
    const dialog = tab.page.getByRole('dialog', { name: 'Which one is to be opened?' });
    await dialog.waitFor();
    assert.equal(await dialog.getByRole('listitem').count(), 20);
    await tab.page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
    assert.equal((await tab.state()).mesh, 'sphere:1500');
    // A second question replaces the first.
    await tab.dropFiles(several.slice(0, 2));
    await dialog.waitFor();
    await tab.dropFiles(several);
    await dialog.getByRole('button', { name: 'box 13.obj' }).click();
    await opened(tab, 'box 13.obj');
    await tab.settled();
    assert.equal((await tab.mesh()).info.triangles, 12);
    await tab.close();
  });

  inLongRun(
    'the page names the files that it did not open and that belong to no opened file',
    async () => {
      const tab = await Tab.open(browser);
      const notes = ['notes.txt', encode('hello')];
      const scene = ['scene.blend', encode('hello')];
      const log = ['log', encode('hello')];
      const surface = ['cut box.obj', objFile(cutBox)];
      const material = ['cut box.mtl', encode('newmtl red')];
      for (const [files, words] of [
        [[notes, surface, material], 'notes.txt is no surface or drawing, and is left out.'],
        [
          [notes, material, surface, scene],
          'notes.txt and scene.blend are no surfaces or drawings, and are left out.',
        ],
        [
          [scene, surface, notes, log],
          'scene.blend and 2 more are no surfaces or drawings, and are left out.',
        ],
      ]) {
        await tab.dropFiles(files);
        await tab.page.getByText(words, { exact: true }).waitFor();
        await opened(tab, 'cut box.obj');
        await tab.settled();
      }
      // The page also names the surfaces that were not chosen, and shows both names in full.
      const long = 'the relic as it was scanned, cleaned and decimated, version';
      const two = [1, 2].map((version) => [`${long} ${version}.obj`, objFile(cutBox)]);
      await tab.dropFiles([...two, notes]);
      const buttons = tab.page.getByRole('dialog').locator('li button');
      await buttons.first().waitFor();
      for (const button of await buttons.all()) {
        const hidden = await button.evaluate((one) => [
          one.scrollWidth - one.clientWidth,
          one.scrollHeight - one.clientHeight,
        ]);
        assert.deepEqual(hidden, [0, 0]);
      }
      await buttons.last().click();
      await opened(tab, `${long} 2.obj`);
      await tab.settled();
      await tab.close();
    },
  );

  test('a file that is no surface gives a sentence, and the visible surface stays', async () => {
    const tab = await Tab.open(browser);
    await tab.dropBytes('photo.ply', Uint8Array.of(0x89, 0x50, 0x4e, 0x47));
    const alert = tab.page.getByRole('alert');
    await alert.waitFor();
    assert.match(await alert.textContent(), /photo\.ply could not be opened\. The file is a PNG/);
    assert.equal((await tab.state()).mesh, 'sphere:1500');
    assert.equal(await tab.page.locator('#reading').isVisible(), false);
    await tab.page.close();
  });

  test('a surface’s file can be inside a drawing, which then opens everywhere', async () => {
    const tab = await Tab.open(browser);
    const low = { ...cone, positions: [...cone.positions.slice(0, -1), 2] };
    const file = everyFile(low)['little.ply'];
    await tab.dropBytes('my cone.ply', file);
    await opened(tab, 'my cone.ply');
    await tab.settled();
    await tab.page.locator('#tool-curve').click();
    await tab.click([-60, 20], [-20, -20], [20, 30], [50, -10]);
    const { mesh, drawing } = await tab.state();
    assert.equal(drawing.objects[0].figure.points.length, 4);
    const { name, text } = await tab.save('file inside');
    const alone = (await tab.save('JSON')).text;
    assert.equal(JSON.parse(alone).file, undefined);
    const { file: inside, ...rest } = JSON.parse(text);
    for (const one of [alone, text]) assert.ok(fitsFile(JSON.parse(one)), fitsFile.errors);
    assert.deepEqual(rest, JSON.parse(alone), 'it is the same drawing');
    assert.deepEqual(
      Buffer.from(inside.base64, 'base64'),
      Buffer.from(file),
      'with every byte of the file',
    );
    await tab.close();

    const elsewhere = await openBrowser();
    try {
      const other = await Tab.open(elsewhere);
      await other.drop(name, alone);
      await other.page.getByText('The curve is on my cone.ply. Drop that file').waitFor();
      const damaged = {
        ...JSON.parse(text),
        file: { ...inside, base64: `AAAA${inside.base64.slice(4)}` },
      };
      await other.drop(name, JSON.stringify(damaged));
      await other.page.getByText('is another one than it was drawn on').waitFor();
      await other.drop(
        name,
        JSON.stringify({ ...damaged, file: { name: 'my cone.ply', base64: '?' } }),
      );
      await other.page.getByText('that is inside cannot be read').waitFor();
      assert.equal((await other.state()).mesh, 'sphere:1500');
      await other.drop(name, text);
      await opened(other, 'my cone.ply');
      await other.settled();
      const there = await other.state();
      assert.equal(there.mesh, mesh);
      assert.deepEqual(there.drawing, drawing);
      await other.pastSaving();
      await other.page.reload();
      await other.settled();
      assert.deepEqual((await other.state()).drawing, drawing, 'and is kept there');
      assert.deepEqual(other.logged, []);
    } finally {
      await elsewhere.close();
    }
  });

  test('a scan with z up stands upright, the choice is kept, and keeps the curve', async () => {
    const tab = await Tab.open(browser);
    await tab.dropBytes('cone.ply', everyFile(cone)['little.ply']);
    await opened(tab, 'cone.ply');
    await tab.settled();
    const [tip, foot] = [
      [0, 0, 3],
      [0, -1, 0],
    ];
    const up = tab.page.getByRole('combobox', { name: 'What points up' });
    assert.equal(await up.inputValue(), 'z');
    const standing = await above(tab, tip, foot);
    assert.ok(standing.up > 100, JSON.stringify(standing));
    await tab.click([-20, 60], [30, 0], [0, -60], [10, 90]);
    const before = await tab.view();
    assert.equal(before.curve.samples.count, 128);

    await up.selectOption('Y up');
    await opened(tab, '~y:cone.ply');
    await tab.still();
    const after = await tab.view();
    assert.deepEqual(after.polyline, before.polyline, 'the curve stays where it is on the surface');
    const lying = await above(tab, tip, foot);
    assert.ok(lying.up < standing.up / 2, JSON.stringify(lying));
    // A click hits the visible place.
    await tab.click([60, 20]);
    assert.equal((await tab.state()).figure.points.length, 5);

    await tab.pastSaving();
    await tab.page.reload();
    await opened(tab, '~y:cone.ply');
    await tab.settled();
    assert.equal(await up.inputValue(), 'y');
    assert.equal((await tab.state()).figure.points.length, 5);

    // The user turns over a scan that lies on its head.
    await up.selectOption('Z down');
    await opened(tab, '~-z:cone.ply');
    await tab.still();
    const turned = await above(tab, tip, foot);
    assert.ok(turned.up < -100, JSON.stringify(turned));
    await tab.pastSaving();
    await tab.page.reload();
    await opened(tab, '~-z:cone.ply');
    await tab.settled();
    assert.equal(await up.inputValue(), '-z');
    assert.equal((await tab.state()).figure.points.length, 5);
    await tab.close();
  });

  inLongRun('of several parts one can be chosen', async () => {
    const tab = await Tab.open(browser);
    await tab.dropBytes('solids.stl', stlFile(cutBox, { text: true, solids: 3 }));
    await opened(tab, 'solids.stl');
    const part = tab.page.getByRole('combobox', { name: 'Part of the file' });
    assert.deepEqual(await part.locator('option').allTextContents(), [
      'All 3 parts',
      'part 0 · 4',
      'part 1 · 4',
      'part 2 · 4',
    ]);
    await part.selectOption('part 1');
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 4);
    await tab.pastSaving();
    await tab.page.reload();
    await tab.page.waitForFunction(() => window.karcherPage?.triangles === 4);
    await tab.settled();
    assert.equal(await part.inputValue(), '1');
    await tab.page.close();
  });

  inLongRun(
    'one of the pieces of a file without parts can be chosen, even after a reload',
    async () => {
      const tab = await Tab.open(browser);
      // Two tetrahedra and a square, far from each other.
      const corners = [
        ...[0, 5].flatMap((x) => [`v ${x} 0 0`, `v ${x + 1} 0 0`, `v ${x} 1 0`, `v ${x} 0 1`]),
        ...['v 9 0 0', 'v 10 0 0', 'v 10 1 0', 'v 9 1 0'],
      ];
      const faces = [
        ...['f 9 10 11', 'f 9 11 12'],
        ...[1, 5].flatMap((i) =>
          [
            [0, 2, 1],
            [0, 1, 3],
            [1, 2, 3],
            [2, 0, 3],
          ].map((face) => `f ${face.map((corner) => i + corner).join(' ')}`),
        ),
      ];
      await tab.drop('pieces.obj', [...corners, ...faces].join('\n'));
      await tab.page.waitForFunction(() => window.karcherPage.triangles === 10);
      const part = tab.page.getByRole('combobox', { name: 'Part of the file' });
      assert.deepEqual(await part.locator('option').allTextContents(), [
        ...['All 3 parts', 'Piece 1 · 4', 'Piece 2 · 4', 'Piece 3 · 2'],
      ]);
      for (const [value, triangles, least] of [
        ['2', 2, 9],
        ['0', 4, 0],
        ['1', 4, 5],
      ]) {
        await part.selectOption(value);
        await tab.page.waitForFunction(
          async ([count, from]) => {
            const { triangles } = window.karcherPage;
            if (triangles !== count || !window.karcherPage.settled) return false;
            const { positions } = await window.karcherPage.mesh();
            return Math.min(...positions.filter((_, i) => i % 3 === 0)) === from;
          },
          [triangles, least],
        );
      }
      await tab.pastSaving();
      await tab.page.reload();
      await tab.page.waitForFunction(() => window.karcherPage?.triangles === 4);
      await tab.settled();
      assert.equal(await part.inputValue(), '1');
      assert.equal(await part.locator('option').count(), 4);
      await tab.close();
    },
  );

  inLongRun('the menu at a place shows only the piece there, and all pieces again', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    const square = (x) => [`v ${x} 0 0`, `v ${x + 4} 0 0`, `v ${x + 4} 4 0`, `v ${x} 4 0`];
    // The second square has a face more, so it is Piece 1.
    const faces = ['f 1 2 3', 'f 1 3 4', 'f 5 6 7', 'f 5 7 9', 'f 9 7 8'];
    const text = [...square(0), ...square(5), 'v 6 3 0', ...faces].join('\n');
    await tab.drop('squares.obj', text);
    await page.waitForFunction(() => window.karcherPage.triangles === 5);
    await tab.settled();
    await tab.still();
    const { x, y } = await tab.middle();
    const menu = page.locator('#context-menu');
    const item = (name) => menu.getByRole('menuitem', { name });
    await page.mouse.click(x - 60, y, { button: 'right' });
    await item('Show only Piece 2').click();
    await page.waitForFunction(() => window.karcherPage.triangles === 2);
    await tab.settled();
    await tab.still();
    assert.equal(await page.locator('#part').inputValue(), '1');
    await page.locator('#stage').press('Shift+F10');
    await item('Show all 2 parts').click();
    await page.waitForFunction(() => window.karcherPage.triangles === 5);
    await tab.settled();
    await page.mouse.click(x - 60, y, { button: 'right' });
    await item('Show only Piece 2').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('#stage').press('Shift+F10');
    assert.equal(await item('Show').count(), 0, 'nothing is pointed at');
    await tab.close();
  });

  test('the check-up describes the surface, and shows the places of its findings', async () => {
    const tab = await Tab.open(browser);
    await tab.dropBytes('cone.ply', everyFile(cone)['little.ply']);
    await opened(tab, 'cone.ply');
    await tab.page.locator('#facts-line').click();
    await tab.page.getByText('Check-up').click();
    const found = tab.page.locator('#checkup-found');
    const show = found.getByRole('button', { name: 'Show 60 boundary edges' });
    await show.waitFor();
    // The lengths of the base's edges, and of those from it to the tip.
    const [foot, side] = [2 * Math.sin(Math.PI / 60), Math.hypot(1, 3)];
    assert.match(
      await found.textContent(),
      new RegExp(`${foot.toPrecision(3)} to ${side.toPrecision(3)}`),
    );
    await tab.still();
    const picture = () => tab.page.locator('#stage').screenshot({ animations: 'disabled' });
    const before = await picture();
    await show.click();
    await tab.still();
    assert.equal(await show.getAttribute('aria-pressed'), 'true');
    const shown = await picture();
    assert.notDeepEqual(shown, before, 'the places are drawn');
    await show.click();
    await tab.still();
    assert.deepEqual(await picture(), before, 'and taken away');
    // Another surface needs a new check.
    await tab.page.locator('#surface').selectOption('torus');
    await tab.page.getByText('No defect disturbs curves.').waitFor();
    assert.equal(await found.getByRole('button').count(), 0);
    await tab.close();
  });

  test('a click joins boundaries that coincide, and the curve stays', async () => {
    const tab = await Tab.open(browser);
    const x = [0, 1, 1.00005, 2];
    const corners = x.flatMap((at) => [0, 1].map((y) => `v ${at} ${y} 0`));
    const text = `${corners.join('\n')}\nf 1 3 4 2\nf 5 7 8 6\n`;
    const drop = async () => {
      await tab.drop('gap.obj', text);
      await tab.page.waitForFunction(() =>
        /^file:[^*]*:gap\.obj$/.test(window.karcherPage.state().mesh),
      );
      await tab.settled();
    };
    const info = async () => (await tab.mesh()).info;
    await drop();
    await tab.click([-60, 20], [-30, -20], [30, 20], [60, -20]);
    assert.equal((await info()).components, 2);
    const { points } = (await tab.state()).figure;
    await tab.page.getByText('the points lie on different components', { exact: false }).waitFor();
    await tab.page.locator('#facts-line').click();
    await tab.page.getByText('Check-up').click();
    const weld = tab.page.locator('#checkup-found').getByRole('button', { name: 'Weld' });
    await weld.click();
    await opened(tab, '*0.000051:gap.obj');
    await tab.settled();
    const joined = async () => {
      const { components, boundaryLoops, repairs } = await info();
      assert.deepEqual([components, boundaryLoops], [1, 1]);
      assert.equal(repairs.find(({ kind }) => kind === 'welded').count, 2);
      const { curve } = await tab.view();
      assert.ok(curve.samples.count > 0);
      assert.deepEqual((await tab.state()).figure.points, points);
    };
    await joined();
    await tab.page.keyboard.press('Control+z');
    assert.deepEqual((await tab.state()).figure.points, points.slice(0, -1));
    await tab.page.keyboard.press('Control+y');
    await joined();
    await weld.waitFor({ state: 'hidden' });
    await tab.pastSaving();
    await tab.page.reload();
    await opened(tab, '*0.000051:gap.obj');
    await tab.settled();
    await joined();
    // The same file opens with the default options again.
    await drop();
    assert.equal((await info()).components, 2);
    await tab.close();
  });

  inLongRun('names in a file are text', async () => {
    const tab = await Tab.open(browser);
    const nodes = [
      { mesh: 0, name: '<img src=x onerror="window.ran = true">' },
      { mesh: 0, name: 'two', translation: [9, 0, 0] },
    ];
    const file = glbFile(
      { ...cutBox, positions: box.positions },
      { nodes, scenes: [{ nodes: [0, 1] }] },
    );
    await tab.dropBytes('<b>names</b>.glb', file);
    await opened(tab, '<b>names</b>.glb');
    const part = tab.page.getByRole('combobox', { name: 'Part of the file' });
    assert.equal(await part.locator('option').nth(1).textContent(), nodes[0].name);
    assert.equal(
      await tab.page.evaluate(() => document.querySelectorAll('#panel img, #panel b').length),
      0,
    );
    await tab.close();
  });
});
