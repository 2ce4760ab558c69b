import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, openBrowser, Tab, until } from './browser.mjs';
import { inLongRun, part } from './part.mjs';

const places = [
  [-100, 30],
  [-30, -20],
  [40, 40],
  [100, -20],
];
const tetrahedron = `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1
f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n`;
const badFiles = {
  'empty.obj': '',
  'no-faces.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\n',
  'index.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n',
  'nan.obj': 'v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'one-sided.obj': `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1
f 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n`,
  'picture.obj': '\x89PNG\r\n\x1a\n\0\0\0\rIHDR',
};

describe('no work is lost', () => {
  const browser = browserOfSuite({ profile: true, asUsers: true });

  test('a bad file gives a sentence, and the curve stays', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const [document, { polyline }] = [(await tab.state()).figure, await tab.view()];
    for (const [name, text] of part(Object.entries(badFiles), 3)) {
      await tab.drop(name, text);
      const alert = tab.page.getByRole('alert');
      await alert.waitFor();
      const said = await alert.locator('p').textContent();
      assert.ok(said.startsWith(`${name} could not be opened. `) && said.endsWith('.'), said);
      await alert.getByRole('button', { name: 'Dismiss' }).click();
      await alert.waitFor({ state: 'detached' });
      assert.deepEqual((await tab.state()).figure, document);
      assert.deepEqual((await tab.view()).polyline, polyline);
      assert.equal(await tab.page.locator('#surface').inputValue(), 'sphere');
    }
    await tab.dragHandle('Control point 2 of 4', 10, 10);
    assert.notDeepEqual((await tab.view()).polyline, polyline, 'the curve is still edited');
    await tab.close();
  });

  const rooms = [
    ['where there is room', () => false],
    ['where the tab has little', (storage) => storage === sessionStorage],
    ['where nothing has any', () => true],
  ];
  for (const [where, isFull] of part(rooms, 2)) {
    test(`a large drawing replaces a small one, ${where}: a reload shows it, or the page says that it is lost`, async () => {
      const tab = await Tab.open(browser);
      await tab.click(...places);
      await tab.pastSaving();
      const { drawing } = await tab.state();
      const [{ figure, ...rest }] = drawing.objects;
      const pointOf = (i) => {
        const [u, v] = [((i * 37) % 997) / 2000 + 1e-4 / 3, ((i * 53) % 991) / 2100 + 1e-4 / 7];
        return { face: (i * 7) % 1500, bary: [1 - u - v, u, v] };
      };
      const objects = Array.from({ length: 5 }, (_, k) => {
        const points = Array.from({ length: k ? 9000 : 4 }, (_, i) => pointOf(i + k));
        return { ...rest, id: k + 1, visible: k === 0, figure: { ...figure, points } };
      });
      const large = { format: 'karcher-drawing', version: 1, active: 1, objects };
      await tab.page.evaluate((test) => {
        // As in a full store, there is still room for shorter texts.
        const full = new Function(`return ${test}`)();
        const set = Storage.prototype.setItem;
        Storage.prototype.setItem = function (name, value) {
          if (full(this) && value.length > 20_000)
            throw new DOMException('full', 'QuotaExceededError');
          set.call(this, name, value);
        };
      }, `${isFull}`);
      const link = 'mesh=sphere:1500&kind=bspline&method=karcher&points=1,0.2,0.3';
      const text = JSON.stringify({ format: 'karcher-curve', version: 2, link, drawing: large });
      await tab.drop('large.json', text);
      await tab.page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 5);
      await tab.settled();
      await tab.pastSaving();
      const said = await tab.page.getByRole('alert').allTextContents();
      assert.equal(said.length, where === 'where nothing has any' ? 1 : 0, `${said}`);
      if (said.length > 0) assert.match(said[0], /no room for this drawing/);
      await tab.page.reload();
      await tab.settled();
      const counts = (await tab.state()).drawing.objects.map((one) => one.figure.points.length);
      if (said.length === 0) assert.deepEqual(counts, [4, 9000, 9000, 9000, 9000]);
      assert.deepEqual(tab.logged, []);
      await tab.page.evaluate(() => localStorage.clear());
      await tab.page.close();
    });
  }

  /** Waits until the browser has stored the shown file. */
  const isKept = (tab, mesh) =>
    tab.page.waitForFunction(
      (key) =>
        new Promise((resolve) => {
          const opening = indexedDB.open('karcher', 1);
          // The page creates the database itself.
          opening.onupgradeneeded = () => opening.transaction.abort();
          opening.onerror = () => resolve(false);
          opening.onsuccess = () => {
            const files = opening.result.transaction('files').objectStore('files');
            files.getKey(key).onsuccess = ({ target }) => resolve(target.result === key);
          };
        }),
      mesh,
    );

  test('a file is opened, reloaded, replaced by a sample, and opened again', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('tetrahedron.obj', tetrahedron);
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 4);
    await tab.page.keyboard.press('2');
    await tab.click([-10, 0], [15, 10]);
    const [{ figure: document, mesh }, { polyline }] = [await tab.state(), await tab.view()];
    assert.equal(document.points.length, 2);
    await tab.page.waitForFunction(() => location.hash.includes('points='));
    await isKept(tab, mesh);

    await tab.page.reload();
    await tab.settled();
    assert.equal((await tab.state()).mesh, mesh);
    assert.deepEqual((await tab.view()).polyline, polyline);

    await tab.page.locator('#surface').selectOption('torus');
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('torus:'));
    assert.equal((await tab.state()).figure.points.length, 0);
    await tab.drop('tetrahedron.obj', tetrahedron);
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 4);
    assert.deepEqual((await tab.view()).polyline, polyline);
    await tab.close();
  });

  test('a file that was stored as bytes is found', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('tetrahedron.obj', tetrahedron);
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 4);
    const { mesh } = await tab.state();
    await isKept(tab, mesh);
    await tab.page.evaluate(
      ([key, text]) =>
        new Promise((resolve) => {
          indexedDB.open('karcher', 1).onsuccess = ({ target }) => {
            const writing = target.result.transaction('files', 'readwrite');
            const files = writing.objectStore('files');
            files.clear();
            files.put({ bytes: new TextEncoder().encode(text), opened: 1 }, key);
            writing.oncomplete = resolve;
          };
        }),
      [mesh, tetrahedron],
    );
    await tab.page.reload();
    await tab.settled();
    assert.equal((await tab.state()).mesh, mesh);
    await tab.close();
  });

  const named = (name) => `# ${name}\n${tetrahedron}`;
  /** Drops a tetrahedron of its own under a name, and waits until the browser has stored it. */
  async function dropped(tab, name) {
    await tab.drop(name, named(name));
    await tab.page.waitForFunction((end) => window.karcherPage.state().mesh.endsWith(end), name);
    const { mesh } = await tab.state();
    await isKept(tab, mesh);
    return mesh;
  }
  /** Opens a file by its link, as the browser's Back does. */
  async function reopened(tab, mesh) {
    await tab.page.evaluate((key) => {
      location.hash = `mesh=${key}`;
    }, mesh);
    await tab.page.waitForFunction((key) => window.karcherPage.state().mesh === key, mesh);
    await tab.settled();
  }
  const parts = ['part_1.obj', 'part_2.obj', 'part_3.obj', 'part_4.obj', 'part_5.obj'];

  test('small files are kept, however many there are', async () => {
    const tab = await Tab.open(browser);
    const meshes = [];
    for (const name of ['whole.obj', ...parts]) meshes.push(await dropped(tab, name));
    for (const mesh of meshes) await reopened(tab, mesh);
    await tab.close();
  });

  test('with little room, files that were opened last are kept, and the page names the others', async () => {
    const tab = await Tab.open(browser);
    // There is room for three files.
    await tab.page.evaluate((size) => {
      navigator.storage.estimate = async () => ({ quota: 2 * 3 * size, usage: 0 });
    }, named(parts[0]).length);
    const whole = await dropped(tab, 'whole.obj');
    for (const [i, name] of parts.entries()) {
      const removed = tab.page.getByText(`${parts[i - 2]} is no longer kept by this browser`);
      const told = i < 2 || removed.waitFor();
      await dropped(tab, name);
      await told;
      await reopened(tab, whole);
    }
    await tab.close();
  });

  test('a failed engine is started again, and the curve can still be edited', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { polyline } = await tab.view();
    const [engine] = tab.engines();
    await engine.evaluate(() => {
      setTimeout(() => {
        throw new Error('out of luck');
      });
    });
    await tab.page.getByRole('alert').waitFor();
    assert.deepEqual((await tab.view()).polyline, polyline);
    await tab.dragHandle('Control point 2 of 4', 10, 10);
    assert.notDeepEqual((await tab.view()).polyline, polyline);
    await tab.page.close();
  });

  test('the page draws again after the browser takes its drawing context away and returns it', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { width, height } = tab.page.viewportSize();
    const picture = () =>
      tab.page.screenshot({
        clip: { x: 280, y: 60, width: width - 280, height: height - 120 },
        animations: 'disabled',
      });
    await tab.page.mouse.move(0, 0);
    const whole = await picture();
    const lost = await tab.page.evaluateHandle(() => {
      const context = document.getElementById('canvas').getContext('webgl2');
      const switched = context.getExtension('WEBGL_lose_context');
      switched.loseContext();
      return switched;
    });
    await until(async () => !(await picture()).equals(whole), 'the stage is empty');
    await lost.evaluate((switched) => switched.restoreContext());
    await until(async () => (await picture()).equals(whole), 'it is drawn again');
    // The page disposes of the earlier surface and lines, and draws others.
    await tab.page.locator('#surface').selectOption('torus');
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('torus:'));
    await tab.click([0, 100], [60, 100]);
    await tab.close();
  });

  test('a reload and the link alone restore the drawing', async () => {
    const tab = await Tab.open(browser);
    await tab.page.keyboard.press('2');
    await tab.click(...places);
    const [{ figure: document }, { polyline }] = [await tab.state(), await tab.view()];
    await tab.page.reload();
    const reloaded = await tab.view();
    assert.deepEqual((await tab.state()).figure, document);
    assert.deepEqual(reloaded.polyline, polyline);
    const address = tab.page.url();
    assert.match(address, /#mesh=sphere:1500&kind=bezier&/);
    await tab.page.close();

    const other = await openBrowser();
    try {
      const elsewhere = await Tab.open(other, address.split('#')[1]);
      assert.deepEqual((await elsewhere.view()).polyline, polyline);
      assert.deepEqual(elsewhere.logged, []);
    } finally {
      await other.close();
    }
  });

  test('leaving the page and coming back restores the drawing', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const [{ figure: document }, { polyline }] = [await tab.state(), await tab.view()];
    await tab.page.goto('about:blank');
    await tab.page.goBack();
    await tab.settled();
    assert.deepEqual((await tab.state()).figure, document);
    assert.deepEqual((await tab.view()).polyline, polyline);
    await tab.page.close();
  });

  test('the address of Back stays while its surface still opens, even if the view changes', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { figure: document } = await tab.state();
    await tab.pastSaving();
    const address = tab.page.url();
    const at = (start) =>
      tab.page.waitForFunction((key) => window.karcherPage?.state().mesh.startsWith(key), start);
    await tab.page.evaluate(() => {
      location.hash = 'mesh=torus:2000';
    });
    await at('torus');
    await tab.settled();
    await tab.pastSaving();
    for (const arrives of [false, true]) {
      // The engine of the surface gets no work yet.
      await tab.page.evaluate(() => {
        window.held = [];
        window.Worker = class extends Worker {
          postMessage(...message) {
            const send = () => super.postMessage(...message);
            if (window.held) window.held.push(send);
            else send();
          }
        };
      });
      await tab.page.goBack();
      await tab.page.waitForFunction(() => window.held.length > 0);
      const middle = await tab.middle();
      await tab.page.mouse.move(middle.x, middle.y);
      await tab.page.mouse.wheel(0, -240);
      await tab.still();
      await tab.pastSaving();
      assert.equal((await tab.state()).mesh, 'torus:2000');
      assert.equal(tab.page.url(), address);
      if (arrives) {
        await tab.page.evaluate(() => {
          const { held } = window;
          window.held = null;
          for (const send of held) send();
        });
      } else await tab.page.reload();
      await at('sphere');
      await tab.settled();
      assert.deepEqual((await tab.state()).figure, document);
      await tab.page.goForward();
      await at('torus');
      await tab.settled();
      await tab.pastSaving();
    }
    await tab.close();
  });

  inLongRun('a link pasted over the address is shown, and can be taken back', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { figure: document } = await tab.state();
    await tab.page.evaluate(() => {
      location.hash = 'mesh=sphere:1500&kind=bezier&points=1,0.2,0.3;700,0.1,0.5;99999,0,0';
    });
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.kind === 'bezier');
    assert.deepEqual(
      (await tab.state()).figure.points.map(({ face }) => face),
      [1, 700],
      'points beyond the surface are left out',
    );
    const note = tab.page.getByText('1 point of the link is not on this surface and was left out.');
    await note.waitFor();
    await tab.page.keyboard.press('Control+z');
    assert.deepEqual((await tab.state()).figure, document);
    await tab.close();
  });

  inLongRun(
    'a link to a file that is not here waits for it, through reloads and edits',
    async () => {
      const tab = await Tab.open(browser);
      await tab.drop('tetrahedron.obj', tetrahedron);
      await tab.page.waitForFunction(() => window.karcherPage.triangles === 4);
      await tab.page.keyboard.press('2');
      await tab.click([-10, 0], [15, 10]);
      const { figure: document } = await tab.state();
      await tab.page.waitForFunction(() => location.hash.includes('kind=bezier'));
      const fragment = tab.page.url().split('#')[1];
      await tab.page.close();

      const other = await openBrowser();
      try {
        const elsewhere = await Tab.open(other, fragment);
        const asksForFile = async () => {
          const alert = elsewhere.page.getByRole('alert');
          await alert.waitFor();
          assert.match(await alert.textContent(), /The curve is on tetrahedron\.obj\./);
          await elsewhere.pastSaving();
          assert.ok(await alert.isVisible(), 'it stays');
          assert.equal(elsewhere.page.url().split('#')[1], fragment);
        };
        await asksForFile();
        await elsewhere.page.reload();
        await elsewhere.settled();
        await asksForFile();
        await elsewhere.click([0, 0]);
        assert.equal((await elsewhere.state()).figure.points.length, 1);
        await elsewhere.page.waitForFunction(() => location.hash.startsWith('#mesh=bunny:1'));
        await elsewhere.page.reload();
        await elsewhere.settled();

        await elsewhere.drop('tetrahedron.obj', tetrahedron);
        await elsewhere.page.waitForFunction(() => window.karcherPage.triangles === 4);
        assert.deepEqual((await elsewhere.state()).figure, document);
        await elsewhere.page.waitForFunction(() => location.hash.startsWith('#mesh=file:'));
        assert.deepEqual(elsewhere.logged, []);
      } finally {
        await other.close();
      }
    },
  );

  const wrongLinks = [
    ['sphere:5', /^Sphere could not be opened\. .*500 to 1000000/],
    ['sphere:1999999', /^The link asks for a surface 'sphere:1999999'/],
    ['cube:5', /^The link asks for a surface 'cube:5'/],
  ];
  for (const [mesh, sentence] of part(wrongLinks, 1)) {
    test(`a link to ${mesh}, which cannot be made, gives a sentence, and stays`, async () => {
      const fragment = `mesh=${mesh}&kind=bezier&points=1,0.2,0.3`;
      const tab = await Tab.open(browser, fragment);
      const alert = tab.page.getByRole('alert');
      await tab.pastSaving();
      assert.match(await alert.locator('p').textContent(), sentence);
      assert.equal((await tab.state()).mesh, 'bunny:1');
      assert.equal(tab.page.url().split('#')[1], fragment);
      await tab.page.keyboard.press('c');
      await tab.page.waitForFunction(() => location.hash.startsWith('#mesh=bunny:1'));
      await tab.page.close();
    });
  }

  inLongRun('another detail of a surface takes the curve along', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0');
    await tab.click(...places);
    const { polyline } = await tab.view();
    await tab.page.locator('#detail').selectOption('1');
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh === 'bunny:1');
    const finer = await tab.view();
    const { info } = await tab.mesh();
    assert.equal((await tab.state()).figure.points.length, 4);
    // Loop subdivision moves the coarse bunny's surface by less than an edge.
    const off = [0, 1, 2].map((axis) => finer.polyline[axis] - polyline[axis]);
    assert.ok(Math.hypot(...off) < 2 * info.meanEdge);
    await tab.close();
  });

  inLongRun('opening a surface is cancelled, and the one before stays', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const { polyline } = await tab.view();
    const engines = tab.engines().length;
    await tab.page.evaluate(() => {
      const surface = document.getElementById('surface');
      surface.value = 'genus3';
      surface.dispatchEvent(new Event('change'));
      document.getElementById('cancel').click();
    });
    await tab.page.waitForFunction(() => document.getElementById('progress').hidden);
    await until(() => tab.engines().length === engines, 'its engine has ended');
    assert.equal((await tab.state()).mesh, 'sphere:1500');
    assert.deepEqual((await tab.view()).polyline, polyline);
    assert.equal(await tab.page.locator('#surface').inputValue(), 'sphere');
    await tab.close();
  });

  test('a surface chosen while other reading options take effect opens', async () => {
    const two = `o one\n${tetrahedron}o two\nv 2 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n`;
    const sequences = [
      [
        ['up', 'y'],
        ['surface', 'genus3'],
        ['up', '-y'],
      ],
      [
        ['part', '1'],
        ['surface', 'genus3'],
      ],
    ];
    for (const choices of sequences) {
      const tab = await Tab.open(browser);
      await tab.drop('two.obj', two);
      await tab.page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('two.obj'));
      await tab.settled();
      await tab.page.evaluate((choices) => {
        for (const [id, value] of choices) {
          const select = document.getElementById(id);
          select.value = value;
          select.dispatchEvent(new Event('change'));
        }
      }, choices);
      await tab.page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('genus3'));
      await tab.close();
    }
  });
});
