// Clicks hit every control of every panel, in a wide and a narrow window.
import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { cutBox, stlFile } from '../wasm/mesh_files.mjs';
import { browserOfSuite, Tab } from './browser.mjs';
import { Controls } from './controls.mjs';
import { inLongRun } from './part.mjs';

const sizes = {
  wide: { width: 1280, height: 800 },
  narrow: { width: 390, height: 844 },
};

const at = (faces) => faces.map((face) => `${face},0.3,0.3`).join(';');
/**
 * A curve with parts that are no center of mass and a leg that is not the shortest, and beside it
 * another curve and a circle.
 */
const fragment = [
  'mesh=genus3:5000&method=karcher-fast&kind=bspline',
  `points=${at([3713, 2975, 4071, 3269, 3294, 1757])}&legs=0:303,0.3,0.3`,
  `other=${encodeURIComponent(`kind=polyline&points=${at([10, 500])}`)}`,
  'circle=100,0.3,0.3;0.1,1,0,0',
].join('&');

/** Derived kinds, which have no tool. */
const made = ['union', 'intersection', 'difference', 'exclusion'];
/** Two overlapping circles, the sources of derived objects. */
const twoCircles = [
  'mesh=sphere:6000&kind=circle&circle=100,0.3,0.3;0.5,1,0,0',
  `other=${encodeURIComponent('kind=circle&circle=110,0.3,0.3;0.5,1,0,0')}`,
].join('&');

const coloredTetrahedron = `v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 0 1 0 0 0 1
v 0 0 1 1 1 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
`;

describe('clicks hit every control', () => {
  const looked = [];
  const browser = browserOfSuite();

  /** Looks at the controls of a page of some size. They count together with those of all pages. */
  async function look(page, viewport) {
    await page.setViewportSize(viewport);
    const controls = new Controls(page);
    await controls.install();
    looked.push({
      controls,
      names: await page.evaluate(() => window.reach.names()),
      panels: await page.evaluate(() => window.reach.panels()),
    });
    await controls.look('at first');
    return controls;
  }

  for (const [name, viewport] of Object.entries(sizes)) {
    inLongRun(`in a ${name} window`, async (t) => {
      const tab = await Tab.open(browser, fragment);
      const { page } = tab;
      const controls = await look(page, viewport);
      await unfold(controls);
      await controls.click(page.locator('#points button').first());
      await controls.look('a point selected');
      await page.keyboard.press('d');
      await page.locator('#distance-legend[aria-busy="false"]').waitFor();
      await controls.look('distances');
      await controls.click(page.locator('#distance-off'));
      await page.locator('#distance-legend').waitFor({ state: 'hidden' });
      await tab.holdEngine();
      await page.keyboard.press('d');
      await page.locator('#stop').waitFor();
      await controls.look('while something is computed');
      await controls.click(page.locator('#stop'));
      await page.locator('#distance-legend').waitFor({ state: 'hidden' });
      await page.keyboard.press('u');
      await controls.look('the curvature');
      await controls.click(page.locator('#comb-off'));
      await controls.click(page.locator('#tool-select'));
      await controls.look('objects are only selected');
      await controls.click(page.locator('#tool-freehand'));
      await controls.look('freehand');
      await controls.click(page.locator('#tool-transform'));
      await controls.look('objects are turned and scaled');
      await controls.click(page.locator('#mirror'));
      await controls.look('objects are mirrored');
      await page.locator('#mirror-in').selectOption('symmetry');
      await page.locator('#mirror-now').waitFor();
      await controls.look('objects are mirrored in the surface’s symmetry');
      await controls.click(page.locator('#tool-select'));
      await controls.click(page.locator('#go-on'));
      const chosen = new Set();
      // The choices belong to the present curve: another kind of tool begins another curve.
      await chooseAll(tab, controls, 'the curve', chosen);
      await page.locator('#compare').selectOption('paper-exact');
      await page.locator('#compare-off').waitFor();
      await tab.settled();
      await controls.look('two methods');
      await controls.click(page.locator('#compare-off'));
      const radios = page.locator('[name="kind"]');
      const kinds = await radios.evaluateAll((inputs) => inputs.map(({ value }) => value));
      for (const kind of [...kinds.filter((one) => !made.includes(one)), 'pen']) {
        await tab.choose(kind);
        const radio = page.locator(`[name="kind"][value="${kind}"]`).filter({ visible: true });
        if ((await radio.count()) > 0) await controls.click(radio);
        await tab.settled();
        assert.equal((await tab.state()).figure.kind, kind);
        assert.ok((await controls.look(kind)) > 10, kind);
        await checkBoxes(tab, controls, kind);
        await chooseAll(tab, controls, kind, chosen);
      }
      for (const opener of await all(controls, '[aria-haspopup]')) {
        await controls.click(opener);
        assert.ok((await controls.look('opened')) > 0);
        await closeByKey(page);
      }
      const { x, y } = await tab.middle();
      await page.mouse.click(x, y, { button: 'right' });
      assert.ok((await controls.look('the menu at a place')) > 0);
      await closeByKey(page);
      await controls.click(page.locator('#help'));
      await controls.click(page.locator('#tour-start'));
      await page.locator('.tour').waitFor();
      assert.ok((await controls.look('the tour')) > 0);
      await controls.click(page.locator('#tour-skip'));
      await tab.drop('bad.obj', 'nothing');
      await page.getByRole('alert').waitFor();
      await page.locator('#progress').waitFor({ state: 'hidden' });
      await controls.look('a message');
      await page.getByRole('alert').getByRole('button', { name: 'Dismiss' }).click();
      const two = ['one.obj', 'two.obj'].map((name) => [name, new TextEncoder().encode('nothing')]);
      await tab.dropFiles(two);
      await page.locator('#which-dialog').waitFor();
      assert.ok((await controls.look('several files')) > 0);
      await page.locator('#which-dialog').getByRole('button', { name: 'Close' }).click();
      await tab.dropBytes('solids.stl', stlFile(cutBox, { text: true, solids: 3 }));
      await page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('solids.stl'));
      await tab.settled();
      await page.locator('#progress').waitFor({ state: 'hidden' });
      await controls.look('a file of several parts');
      await tab.drop('colored.obj', coloredTetrahedron);
      await page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('colored.obj'));
      await tab.settled();
      await page.locator('#progress').waitFor({ state: 'hidden' });
      await controls.click(page.locator('[popovertarget="view-menu"]'));
      assert.ok((await controls.look('the view of a file with colors')) > 0);
      await closeByKey(page);
      const open = await holdEngine(page);
      await page.locator('#surface').selectOption('torus');
      await page.locator('#progress').waitFor();
      await controls.look('while a surface opens');
      open();
      await page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('torus:'));

      t.diagnostic(`${controls.reached.size} kinds of controls`);
      await tab.close();
    });
  }

  for (const [name, viewport] of Object.entries(sizes)) {
    inLongRun(`of objects made of others, in a ${name} window`, async () => {
      const tab = await Tab.open(browser, twoCircles);
      const { page } = tab;
      const controls = await look(page, viewport);
      const make = async (maker) => {
        await page.locator('#stage').focus();
        await page.keyboard.press('Control+a');
        await controls.click(page.locator('#makers').getByRole('button', { name: maker }));
        await tab.settled();
        await controls.look(maker);
      };
      await make('Union');
      const radios = page.locator('[name="kind"]').filter({ visible: true });
      assert.equal(await radios.count(), made.length);
      for (const radio of (await radios.all()).toReversed()) {
        await controls.click(radio);
        await tab.settled();
        assert.equal((await tab.state()).figure.kind, await radio.getAttribute('value'));
      }
      await page.locator('#fill').fill('50');
      await page.locator('#fill').press('Enter');
      await page.locator('#pattern').selectOption('hatched');
      await page.locator('#pattern-spacing').waitFor();
      await tab.settled();
      await controls.look('a hatched fill');
      await page.locator('#stage').focus();
      for (const _ of ['the pattern', 'the fill']) await page.keyboard.press('Control+z');
      for (const maker of ['Offset', 'Cut']) {
        await page.locator('#stage').focus();
        await page.keyboard.press('Control+z');
        await make(maker);
      }
      await tab.close();
    });
  }

  inLongRun('and no control or panel is left out', () => {
    assert.equal(looked.length, 4);
    const [names, panels, reached, withControls] = [
      looked.flatMap((one) => one.names),
      looked.flatMap((one) => one.panels),
      looked.flatMap((one) => [...one.controls.reached]),
      looked.flatMap((one) => [...one.controls.panels]),
    ];
    assert.deepEqual(
      [...new Set(names)].filter((name) => !reached.includes(name)),
      [],
    );
    assert.ok(panels.length > 0);
    assert.deepEqual(
      [...new Set(panels)].filter((panel) => !withControls.includes(panel)),
      [],
    );
  });
});

/** Closes a menu by Escape, which takes a moment on a busy machine. */
async function closeByKey(page) {
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => document.querySelector(':popover-open') === null);
}

/** Delays the loading of engines that start from now on, until the returned function is called. */
async function holdEngine(page) {
  let open;
  const opened = new Promise((resolve) => {
    open = resolve;
  });
  await page.context().route('**/*.wasm', async (route) => {
    await opened;
    await route.continue();
  });
  return open;
}

/** Opens folded sections by clicks. */
async function unfold(controls) {
  const folded = '[aria-expanded="false"]:not([aria-haspopup]), details:not([open]) > summary';
  for (;;) {
    const next = controls.page.locator(folded).filter({ visible: true }).first();
    if ((await next.count()) === 0) return;
    const element = await next.elementHandle();
    await controls.click(element);
    const shown = await element.evaluate(
      (one) => one.getAttribute('aria-expanded') === 'true' || one.parentElement.open,
    );
    assert.ok(shown, 'a click shows what is folded');
    await checkedUp(controls.page);
    await controls.look('unfolded');
  }
}

/** Waits until an open check-up has its answer, which moves the elements below. */
const checkedUp = (page) =>
  page.waitForFunction(() => {
    const [details, found] = ['checkup', 'checkup-found'].map((id) => document.getElementById(id));
    return !details.open || found.childElementCount > 0;
  });

const all = (controls, selector) =>
  controls.page.locator(selector).filter({ visible: true }).elementHandles();

/** A click on a box, or on its words, changes the curve, and the change stays. */
async function checkBoxes(tab, controls, kind) {
  for (const box of await all(controls, 'input[type="checkbox"]')) {
    for (const words of [false, true]) {
      const before = await box.isChecked();
      const { revision } = await tab.state();
      await controls.click(box, { words });
      await tab.settled();
      assert.equal(await box.isChecked(), !before, `${kind}: the ${words ? 'words' : 'box'}`);
      assert.ok((await tab.state()).revision > revision, `${kind}: the curve is another one`);
      await controls.look(`${kind}, checked`);
    }
  }
}

/** Tries every choice of settings that no earlier kind had; a choice may reveal others. */
async function chooseAll(tab, controls, kind, chosen) {
  for (const select of await all(controls, '.settings select')) {
    const id = await select.getAttribute('id');
    if (chosen.has(id)) continue;
    chosen.add(id);
    const values = await select.evaluate((one) => [...one.options].map(({ value }) => value));
    const first = await select.inputValue();
    for (const value of [...values.filter((one) => one !== first), first]) {
      const offers = await select.evaluate(
        (one, wanted) => [...one.options].some((option) => option.value === wanted),
        value,
      );
      assert.ok(offers, `#${id} offers ${value} no more`);
      await select.selectOption(value);
      // The page prepares the method first; only then does the comparison offer the others.
      if (id === 'method') {
        await tab.page.waitForFunction(
          (method) => window.karcherPage.state().method === method,
          value,
        );
      }
      await tab.settled();
      await controls.look(`${kind}, ${value}`);
    }
  }
}
