// Plain words first: the mathematics is folded until the user opens it, and so are long lists of
// numbers.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';

const places = [
  [-110, 60],
  [-40, 30],
  [20, 60],
  [90, 40],
];

describe('the panel of a new user', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 }, unfolded: false });

  const mathematics = [
    '#kind',
    '#degree',
    '#clamped',
    '#levels',
    '#samples',
    '#method',
    '#compare',
  ];
  const shown = async (tab, ids) => {
    const seen = await Promise.all(ids.map((id) => tab.page.locator(id).isVisible()));
    return ids.filter((_, i) => seen[i]);
  };

  test('has the mathematics folded, and a reload keeps its state', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    const hidden = [...mathematics, '#status-samples', '#status-time'];
    assert.deepEqual(await shown(tab, hidden), []);
    assert.deepEqual(await shown(tab, ['#status-length', '#closed']), [
      '#status-length',
      '#closed',
    ]);
    await tab.page.locator('#fine > summary').click();
    assert.deepEqual(await shown(tab, hidden), hidden);
    await tab.page.reload();
    await tab.settled();
    assert.deepEqual(await shown(tab, hidden), hidden);
    await tab.page.locator('#fine > summary').click();
    // The folded section does not contain the plain controls.
    await tab.page.keyboard.press('n');
    await tab.choose('circle');
    await tab.choose('ellipse');
    assert.equal((await tab.state()).figure.kind, 'ellipse');
    await tab.close();
  });

  test('measures only lengths until the mathematics is opened', async () => {
    const tab = await Tab.open(browser);
    await tab.click(...places);
    await tab.page.keyboard.press('m');
    const { x, y } = await tab.onCurve(0.5);
    const hint = tab.page.locator('#hint');
    await tab.page.mouse.click(x, y);
    await tab.page.waitForFunction(() =>
      /^Length [\d.]+ of [\d.]+$/.test(document.getElementById('hint').textContent),
    );
    await tab.page.locator('#fine > summary').click();
    await tab.page.mouse.click(x, y);
    await tab.page.waitForFunction(() =>
      /tangent/.test(document.getElementById('hint').textContent),
    );
    assert.match(await hint.textContent(), /^Parameter [\d.]+ · length/);
    await tab.page.locator('#fine > summary').click();
    await tab.page.close();
  });

  test('folds a long list of points, but not while it grows, and keeps the user’s choice', async () => {
    const tab = await Tab.open(browser);
    const list = tab.page.locator('#points');
    const many = Array.from({ length: 9 }, (_, i) => [25 * i - 100, 40 * (i % 2) - 60]);
    await tab.click(many[0]);
    const before = await tab.page.locator('#surface').boundingBox();
    await tab.click(...many.slice(1));
    assert.equal(await list.isVisible(), true, 'it is not folded under the hand');
    assert.deepEqual(await tab.page.locator('#surface').boundingBox(), before, 'nothing jumps');
    await tab.page.keyboard.press('Enter');
    await tab.click(...places);
    await tab.page.locator('#objects .object').last().click();
    await tab.settled();
    assert.equal(await list.isVisible(), false);
    assert.equal(await tab.page.locator('#points-count').textContent(), '9');
    await tab.page.locator('#points-group > summary').click();
    await tab.page.locator('#objects .object').first().click();
    await tab.page.locator('#objects .object').last().click();
    await tab.settled();
    assert.equal(await list.isVisible(), true);
    await tab.close();
  });

  inLongRun(
    'has two columns if there is room, with the settings of objects beside their list',
    async () => {
      const tab = await Tab.open(browser);
      await tab.click(...places);
      await tab.page.setViewportSize({ width: 1920, height: 1080 });
      const left = async (id) => (await tab.page.locator(id).boundingBox()).x;
      assert.equal(await left('#objects-title'), await left('#surface-title'));
      assert.ok((await left('#object-name')) > (await left('#objects-title')) + 200);
      await tab.close();
    },
  );

  inLongRun('writes large counts of repaired places like its other numbers', async () => {
    const tab = await Tab.open(browser);
    const side = 40;
    const lines = [];
    for (let i = 0; i <= side; i++) {
      for (let j = 0; j <= side; j++) lines.push(`v ${i} ${j} 0`);
    }
    const vertex = (i, j) => i * (side + 1) + j + 1;
    for (let i = 0; i < side; i++) {
      for (let j = 0; j < side; j++) {
        const corners = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        lines.push(`f ${corners.join(' ')}`);
      }
    }
    await tab.drop('quads.obj', lines.join('\n'));
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('quads.obj'));
    await tab.settled();
    const notes = await tab.page.locator('#repairs').textContent();
    assert.match(notes, /^1,600 polygons were cut into triangles/);
    await tab.close();
  });
});
