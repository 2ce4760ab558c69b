// The drawing of a file stays with its content, under any name and whatever points up.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { everyFile } from '../wasm/mesh_files.mjs';
import { browserOfSuite, openBrowser, Tab } from './browser.mjs';

/** A cone on z = 0, without a base. */
const ring = Array.from({ length: 60 }, (_, i) => (Math.PI * i) / 30);
const cone = {
  positions: [...ring.flatMap((t) => [Math.cos(t), Math.sin(t), 0]), 0, 0, 3],
  faces: ring.map((_, i) => [i, (i + 1) % 60, 60]),
};

const tetrahedron = `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1
f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n`;

describe('a file under another name', () => {
  const browser = browserOfSuite();
  const shown = (tab, name) =>
    tab.page
      .waitForFunction((part) => window.karcherPage?.state().mesh.includes(part), name)
      .then(() => tab.settled());

  test('is the same surface: with its drawing, its steps, its unit and its links', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    const points = async () => (await tab.state()).figure.points;
    const unit = page.locator('#unit');
    await tab.drop('one.obj', tetrahedron);
    await shown(tab, 'one.obj');
    await page.keyboard.press('2');
    await tab.click([-10, 0], [15, 10]);
    const drawn = await points();
    assert.equal(drawn.length, 2);
    await unit.selectOption('cm');
    await tab.pastSaving();
    const { mesh } = await tab.state();
    const link = page.url().split('#')[1];
    const renamed = (name) => link.replace('one.obj', name);

    await page.locator('#surface').selectOption('torus');
    await shown(tab, 'torus:');
    await tab.drop('other.obj', tetrahedron);
    await shown(tab, 'other.obj');
    assert.deepEqual(await points(), drawn);
    assert.equal(await unit.inputValue(), 'cm');
    await page.keyboard.press('Control+z');
    assert.deepEqual(await points(), drawn.slice(0, 1));
    await page.keyboard.press('Control+y');
    await tab.pastSaving();
    await page.reload();
    await shown(tab, 'other.obj');
    assert.deepEqual(await points(), drawn);
    await page.locator('#surface').selectOption('torus');
    await shown(tab, 'torus:');
    await page.evaluate(
      (key) => {
        location.hash = `mesh=${key}`;
      },
      mesh.replace('one.obj', 'third.obj'),
    );
    await shown(tab, 'third.obj');
    await tab.close();

    const elsewhere = await openBrowser();
    try {
      const there = await Tab.open(elsewhere, link);
      await there.page.getByText('The curve is on one.obj. Drop that file').waitFor();
      await there.drop('fourth.obj', tetrahedron);
      await there.page.waitForFunction(() => window.karcherPage.triangles === 4);
      await there.settled();
      assert.deepEqual((await there.state()).figure.points, drawn);
      await there.page.keyboard.press('Control+z');
      await there.page.evaluate((fragment) => {
        location.hash = fragment;
      }, renamed('fifth.obj'));
      await there.page.waitForFunction(() => window.karcherPage.state().figure.points.length === 2);
      assert.deepEqual(await there.page.locator('.message').allTextContents(), []);
      await there.close();
    } finally {
      await elsewhere.close();
    }
  });
});

describe('a file that is read in another way', () => {
  const browser = browserOfSuite({ asUsers: true });

  test('has its drawing and its steps, whatever points up', async () => {
    const tab = await Tab.open(browser);
    const { page } = tab;
    const file = everyFile(cone)['little.ply'];
    const shown = (name) =>
      page.waitForFunction((end) => window.karcherPage?.state().mesh.endsWith(end), name);
    const turn = async (option, ending) => {
      await page.getByRole('combobox', { name: 'What points up' }).selectOption(option);
      await shown(ending);
      await tab.settled();
    };
    const count = async () => (await tab.state()).figure.points.length;
    await tab.dropBytes('cone.ply', file);
    await shown('cone.ply');
    await turn('Y up', '~y:cone.ply');
    await tab.click([-30, 10], [0, 25], [30, 0], [0, -25]);
    assert.equal(await count(), 4);
    const undone = async () => {
      await page.keyboard.press('Control+z');
      assert.equal(await count(), 3);
      await page.keyboard.press('Control+y');
      assert.equal(await count(), 4);
    };
    await turn('X up', '~x:cone.ply');
    await undone();
    await turn('Y up', '~y:cone.ply');
    await undone();
    // The user drops the file again.
    await tab.dropBytes('cone.ply', file);
    await page.waitForFunction(() => !window.karcherPage.state().mesh.includes('~'));
    await tab.settled();
    await undone();
    await turn('Z down', '~-z:cone.ply');
    await tab.pastSaving();
    await page.reload();
    await shown('~-z:cone.ply');
    await tab.settled();
    await undone();
    await tab.close();
  });
});
