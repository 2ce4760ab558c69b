// The drawing of a file stays with the way in which the file was read.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { everyFile } from '../wasm/mesh_files.mjs';
import { browserOfSuite, Tab } from './browser.mjs';

/** A cone on z = 0, without a base. */
const ring = Array.from({ length: 60 }, (_, i) => (Math.PI * i) / 30);
const cone = {
  positions: [...ring.flatMap((t) => [Math.cos(t), Math.sin(t), 0]), 0, 0, 3],
  faces: ring.map((_, i) => [i, (i + 1) % 60, 60]),
};

describe('a file that is read in another way', () => {
  const browser = browserOfSuite({ asUsers: true });

  test('has the drawing that was kept with this way, unless another one comes along', async () => {
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
    // The user drops the file again.
    await tab.dropBytes('cone.ply', file);
    await page.waitForFunction(() => !window.karcherPage.state().mesh.includes('~'));
    await tab.settled();
    assert.equal(await count(), 0);
    await turn('Y up', '~y:cone.ply');
    assert.equal(await count(), 4);
    await turn('X up', '~x:cone.ply');
    assert.equal(await count(), 4);
    await tab.close();
  });
});
