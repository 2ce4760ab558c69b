// Lengths: the page guesses the surface's unit, the user may choose another, and a ruler measures
// along the surface and in a straight line.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { cutBox, objFile, stlFile } from '../wasm/mesh_files.mjs';
import { browserOfSuite, Tab } from './browser.mjs';

describe('lengths', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const hint = (tab) => tab.page.locator('#hint');
  const ruled = (unit = '') =>
    new RegExp(`^([\\d.]+)${unit} along the surface · ([\\d.]+)${unit} straight$`);
  const told = async (tab, unit) => {
    await tab.page.waitForFunction(
      (source) => new RegExp(source).test(document.getElementById('hint').textContent),
      ruled(unit).source,
    );
    const [, along, straight] = ruled(unit).exec(await hint(tab).textContent());
    return [Number(along), Number(straight)];
  };

  test('between two clicks on a sphere are an arc and its chord', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:20000');
    const { x, y } = await tab.middle();
    await tab.page.locator('#tool-measure').click();
    await tab.page.mouse.click(x - 120, y + 20);
    await tab.page.waitForFunction(() =>
      /Click where/.test(document.getElementById('hint').textContent),
    );
    // The ruler follows the pointer until the second click.
    await tab.page.mouse.move(x - 20, y, { steps: 3 });
    const [short] = await told(tab);
    // The click is a single move, since the ruler would also measure places on the way.
    await tab.page.mouse.click(x + 130, y - 60);
    await tab.settled();
    await tab.page.waitForFunction(
      ([source, before]) => {
        const found = new RegExp(source).exec(document.getElementById('hint').textContent);
        return found && Number(found[1]) > 1.5 * before;
      },
      [ruled().source, short],
    );
    const [along, straight] = await told(tab);
    // The sphere has the mesh's radius; facets are within 1 part in 1000 of it.
    const { positions } = await tab.mesh();
    const radius = Math.hypot(...positions.slice(0, 3));
    const arc = 2 * radius * Math.asin(straight / (2 * radius));
    assert.ok(Math.abs(along - arc) < 2e-3 * arc, `${along} is not ${arc}`);
    assert.equal(await tab.page.locator('.preview:visible').count(), 0, 'no mark is left behind');
    // The measurement stays while the pointer moves on, and draws nothing.
    await tab.page.mouse.move(x, y, { steps: 3 });
    await tab.still();
    assert.deepEqual(await told(tab), [along, straight]);
    assert.equal((await tab.state()).figure.points.length, 0);
    await tab.page.keyboard.press('Escape');
    await tab.page.keyboard.press('v');
    assert.doesNotMatch(await hint(tab).textContent(), /straight/);
    await tab.close();
  });

  test('between components are straight only, and the status says why', async () => {
    const tab = await Tab.open(browser);
    const far = 7;
    const { positions, faces } = cutBox;
    const two = {
      positions: [...positions, ...positions.map((value, i) => value + (i % 3 === 0 ? far : 0))],
      faces: [...faces, ...faces.map((face) => face.map((k) => k + positions.length / 3))],
    };
    await tab.dropFiles([['two.obj', objFile(two)]]);
    await tab.page.waitForFunction(() => window.karcherPage.info().components === 2);
    await tab.settled();
    await tab.still();
    // The front faces of the boxes lie in z = 4.
    const seen = await tab.page.evaluate(
      (places) => places.map((place) => window.karcherPage.seen(Float32Array.from(place))),
      [0, 0.3, far].map((aside) => [1 + aside, 1.5, 4]),
    );
    const [from, near, to] = seen;
    await tab.page.locator('#tool-measure').click();
    await tab.page.mouse.click(from.x, from.y);
    await tab.page.mouse.move(near.x, near.y, { steps: 3 });
    await told(tab);
    await tab.page.mouse.click(to.x, to.y);
    const words = /^No path along the surface: different components · ([\d.]+) straight$/;
    await tab.page.waitForFunction(
      (source) => new RegExp(source).test(document.getElementById('hint').textContent),
      words.source,
    );
    const [, straight] = words.exec(await hint(tab).textContent());
    assert.ok(Math.abs(Number(straight) - far) < 0.1, straight);
    await tab.close();
  });

  test('have the unit of the file: guessed, chosen, and kept', async () => {
    const tab = await Tab.open(browser);
    const unit = tab.page.locator('#unit');
    assert.equal(await unit.inputValue(), '');
    await tab.dropBytes('part.stl', stlFile(cutBox));
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('part.stl'));
    await tab.settled();
    assert.equal(await unit.inputValue(), 'mm');
    await tab.click([-40, 20], [0, -20], [40, 10], [20, 40]);
    const length = tab.page.locator('#status-length');
    assert.match(await length.textContent(), /^length [\d.]+ mm$/);
    await unit.selectOption('in');
    assert.match(await length.textContent(), /^length [\d.]+ in$/);
    await tab.page.locator('#closed').check();
    await tab.page.locator('#fill').fill('50');
    await tab.page.keyboard.press('Enter');
    await tab.settled();
    assert.match(
      await length.textContent(),
      /^length [\d.]+ in · area [\d.]+ in² · perimeter [\d.]+ in$/,
    );
    await tab.pastSaving();
    await tab.page.reload();
    await tab.settled();
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('part.stl'));
    assert.equal(await unit.inputValue(), 'in');
    // The unit is that of the file, whichever way the page reads it.
    const choose = async (up, other) => {
      await tab.page.locator('#up').selectOption(up);
      await tab.page.waitForFunction(
        (key) => window.karcherPage.state().mesh.includes(key),
        `~${up}`,
      );
      await tab.settled();
      assert.equal(await unit.inputValue(), other);
    };
    await choose('x', 'in');
    await unit.selectOption('cm');
    await choose('y', 'cm');
    await tab.close();
  });
});
