// The surface cut along curves by hand: the user shows, hides, deletes, thickens and saves parts.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { browserOfSuite, openBrowser, Tab } from './browser.mjs';
import { fitsFile } from './schema.mjs';

describe('cuts', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const near = (value, wanted, part, what) =>
    assert.ok(Math.abs(value - wanted) < part * wanted, `${what}: ${value}, not ${wanted}`);
  const parts = async (tab) => (await tab.view()).cut.parts;
  const maker = (tab, name) =>
    tab.page.locator('#makers').getByRole('button', { name, exact: true });
  const button = (tab, name) => tab.page.getByRole('button', { name, exact: true });
  const picked = (tab) => tab.page.evaluate(() => window.karcherPage.state().figure.points.length);

  async function cutSphere(shown = browser) {
    const tab = await Tab.open(shown, 'mesh=sphere:6000&kind=circle');
    const { x, y } = await tab.middle();
    await tab.drag({ x, y }, { x: x + 90, y });
    const { radius } = (await tab.view()).circle;
    const bare = JSON.stringify((await tab.state()).drawing);
    await maker(tab, 'Cut').click();
    await tab.settled();
    return { tab, radius, bare, x, y };
  }
  /** A part's file with its contents. */
  async function savedPart(tab, name) {
    const coming = tab.page.waitForEvent('download');
    await button(tab, `Save ${name}`).click();
    const download = await coming;
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  }
  /** Volume and area of a binary STL, computed from its numbers alone. */
  function measured(bytes) {
    let [volume, area] = [0, 0];
    const count = bytes.readUInt32LE(80);
    assert.equal(bytes.length, 84 + 50 * count);
    for (let i = 0; i < count; i++) {
      const at = (corner, axis) => bytes.readFloatLE(84 + 50 * i + 12 * (corner + 1) + 4 * axis);
      const [a, b, c] = [0, 1, 2].map((corner) => [0, 1, 2].map((axis) => at(corner, axis)));
      const [u, v] = [b, c].map((to) => to.map((value, axis) => value - a[axis]));
      const n = [0, 1, 2].map(
        (k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3],
      );
      area += Math.hypot(...n) / 2;
      volume += (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / 6;
    }
    return { volume, area };
  }

  test('a circle leaves a cap and the rest, which are hidden, deleted and restored', async () => {
    const { tab, radius, bare, x, y } = await cutSphere();
    const [rest, cap] = await parts(tab);
    assert.equal((await parts(tab)).length, 2);
    near(cap.area, 2 * Math.PI * (1 - Math.cos(radius)), 0.01, 'the cap');
    near(cap.area + rest.area, 4 * Math.PI, 0.01, 'both');
    const made = JSON.stringify((await tab.state()).drawing);
    await button(tab, 'Show or hide Part 2').click();
    await tab.settled();
    assert.deepEqual(
      (await parts(tab)).map(({ state }) => state),
      ['kept', 'hidden'],
    );
    await button(tab, 'Delete Part 1').click();
    await tab.settled();
    assert.deepEqual(
      (await parts(tab)).map(({ state }) => state),
      ['deleted', 'hidden'],
    );
    // A click does not reach invisible parts.
    await tab.page.keyboard.press('b');
    await tab.page.mouse.click(x, y);
    await tab.settled();
    assert.equal(await picked(tab), 0);
    // Undoes the two choices and the unfinished curve.
    for (let step = 0; step < 3; step++) await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), made);
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), bare);
    await tab.close();
  });

  test('a mirrored cut lacks the mirrored part', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:3000&kind=circle');
    const { page } = tab;
    const { x, y } = await tab.middle();
    await tab.drag({ x: x - 90, y }, { x: x - 40, y });
    await maker(tab, 'Cut').click();
    await tab.settled();
    await button(tab, 'Delete Part 2').click();
    await tab.settled();
    const [, cap] = await parts(tab);
    const states = async () => (await parts(tab)).map(({ state }) => state);
    assert.deepEqual(await states(), ['kept', 'deleted']);
    const before = JSON.stringify((await tab.state()).drawing);
    const { revision } = await tab.state();
    await page.locator('#mirror').click();
    await page.locator('#mirror-copies').setChecked(false);
    await page.mouse.click(x, y - 100);
    await page.getByText('second point').waitFor();
    await page.mouse.click(x, y + 100);
    await page.waitForFunction((from) => window.karcherPage.state().revision > from, revision);
    await tab.settled();
    assert.deepEqual(await states(), ['kept', 'deleted']);
    near((await parts(tab))[1].area, cap.area, 0.02, 'the mirrored cap');
    const { objects } = (await tab.state()).drawing;
    const was = JSON.parse(before).objects[0].figure.circle.center;
    assert.notDeepEqual(objects[0].figure.circle.center, was);
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing), before);
    await tab.close();
  });

  test('of hidden parts no triangles are seen', async (t) => {
    const drawn = await openBrowser({ viewport: { width: 1280, height: 800 }, asUsers: true });
    t.after(() => drawn.close());
    const { tab, x, y } = await cutSphere(drawn);
    await button(tab, 'Show or hide Part 1').click();
    await tab.settled();
    await tab.page.keyboard.press('v');
    await tab.page.locator('#stage').focus();
    const seen = async () => {
      await tab.still();
      return tab.pixels({ x: x - 200, y: y - 200, width: 400, height: 400 });
    };
    const without = await seen();
    await tab.page.keyboard.press('t');
    await tab.page.waitForFunction(
      () => document.querySelector('#edges').getAttribute('aria-checked') === 'true',
    );
    const shown = await seen();
    const away = (i) => Math.hypot((i % 400) - 200, Math.floor(i / 400) - 200);
    const changed = shown.flatMap((color, i) => (`${color}` === `${without[i]}` ? [] : [away(i)]));
    assert.ok(changed.filter((far) => far < 80).length > 500, 'the triangles of the cap are seen');
    assert.equal(changed.filter((far) => far > 110).length, 0, 'beside the cap');
    await tab.close();
  });

  test('the progress of a cut is shown', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:6000&kind=circle');
    const { x, y } = await tab.middle();
    await tab.drag({ x, y }, { x: x + 90, y });
    await tab.page.evaluate(() => {
      window.said = [];
      const busy = document.querySelector('#status-busy');
      new MutationObserver(() => window.said.push(busy.textContent)).observe(busy, {
        childList: true,
        characterData: true,
        subtree: true,
      });
    });
    await maker(tab, 'Cut').click();
    await tab.settled();
    const said = (await tab.page.evaluate(() => window.said)).join('\n');
    assert.match(said, /Cutting… 0 %/);
    assert.match(said, /Measuring part 2 of 2… 67 %/);
    await tab.close();
  });

  test('parts are saved alone or together, as surfaces or thickened, with their quality for printing', async () => {
    const { tab, radius } = await cutSphere();
    const open = await savedPart(tab, 'Part 2');
    assert.match(open.name, /^part-2-of-.*\.stl$/);
    const cap = 2 * Math.PI * (1 - Math.cos(radius));
    near(measured(open.bytes).area, cap, 0.01, 'the cap in its file');
    assert.match(await tab.page.locator('#parts li').last().textContent(), /open/);
    await tab.page.locator('#thickness').fill('0.1');
    await tab.page.keyboard.press('Enter');
    await tab.settled();
    const shell = (cap * (1.1 ** 3 - 1)) / 3;
    const solid = await savedPart(tab, 'Part 2');
    near(measured(solid.bytes).volume, shell, 0.01, 'the shell in its file');
    const { thick } = (await parts(tab))[1];
    assert.ok(thick.closed);
    near(thick.volume, shell, 0.01, 'the shell');
    assert.equal(thick.most, null);
    await tab.page.locator('#part-format').selectOption('obj');
    const names = [];
    tab.page.on('download', (download) => names.push(download.suggestedFilename()));
    await button(tab, 'Delete Part 1').click();
    await tab.settled();
    const coming = tab.page.waitForEvent('download');
    await tab.page.locator('#save-parts').click();
    const text = readFileSync(await (await coming).path(), 'utf8');
    assert.match(text, /^(#.*\n)*v /);
    assert.equal(names.length, 1);
    assert.match(names[0], /^part-2-of-.*\.obj$/);
    await tab.close();
  });

  test('the parts fill the width of a phone, with buttons for fingers', async () => {
    const { tab } = await cutSphere();
    await tab.page.setViewportSize({ width: 390, height: 844 });
    const { list, panel, buttons } = await tab.page.evaluate(() => {
      const box = (id) => document.getElementById(id).getBoundingClientRect().toJSON();
      const all = [...document.querySelectorAll('#parts button:not(.object)')];
      const sizes = all.map((one) => one.getBoundingClientRect().toJSON());
      return { list: box('parts'), panel: box('cut-settings'), buttons: sizes };
    });
    assert.ok(list.right >= panel.right, `${list.right}, not ${panel.right}`);
    assert.equal(buttons.length, 8);
    for (const { width, height } of buttons) assert.ok(width >= 44 && height >= 44);
    await tab.close();
  });

  test('a cut follows its curve, and a reload and a link restore it', async () => {
    const { tab } = await cutSphere();
    await button(tab, 'Show or hide Part 1').click();
    await tab.settled();
    const before = (await parts(tab)).map(({ area, state }) => ({ area, state }));
    const saved = await tab.save(/^JSON the whole/);
    assert.ok(fitsFile(JSON.parse(saved.text)), JSON.stringify(fitsFile.errors));
    await tab.pastSaving();
    const link = tab.page.url().split('#')[1];
    await tab.page.reload();
    await tab.settled();
    const after = await parts(tab);
    after.forEach(({ area, state }, i) => {
      near(area, before[i].area, 1e-4, 'a part');
      assert.equal(state, before[i].state);
    });
    const other = await Tab.open(browser, link);
    assert.deepEqual(
      (await parts(other)).map(({ state }) => state),
      ['hidden', 'kept'],
    );
    await other.close();
    await tab.page.locator('#objects .object').last().click();
    await tab.settled();
    const rim = await tab.handle('Radius of the circle');
    await tab.drag(rim, { x: rim.x + 40, y: rim.y });
    const cut = (await tab.view()).others.find((one) => one.cut).cut;
    assert.ok(cut.parts[1].area > 1.2 * before[1].area);
    assert.deepEqual(
      cut.parts.map(({ state }) => state),
      ['hidden', 'kept'],
    );
    await tab.close();
  });
});
