// A move that would tear a figure has no effect, and the page explains why a stroke ends that
// leaves its part of the surface.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { Vector3 } from 'three';
import { browserOfSuite, Tab } from './browser.mjs';
import { pageModule } from './page_module.mjs';

describe('a figure', () => {
  let isTorn;
  before(async () => {
    ({ isTorn } = await pageModule('../../web/editor/engine/tearing.ts'));
  });

  /**
   * Points of the unit circle, whose face is the angle: there is a path around it, and short cuts
   * in space.
   */
  const surface = {
    frame: { scale: 1 },
    position: ({ face }, target) => target.copy(new Vector3(Math.cos(face), Math.sin(face), 0)),
  };
  const client = {
    mesh: { shortestPath: async (a, b) => ({ length: Math.abs(a.face - b.face) }) },
  };
  const at = (angle) => ({ face: angle, bary: [1, 0, 0] });
  const figure = (angles, closed = false, kind = 'polyline') => ({
    ...{ kind, points: angles.map(at), settings: { closed } },
  });
  const torn = (from, to, scale) => isTorn(client, surface, [{ figure: from }], [to], scale);

  test('is torn if neighbors move far apart, compared with the path between them before', async () => {
    assert.equal(await torn(figure([0, 0.2, 0.4]), figure([1, 1.2, 1.4])), false);
    assert.equal(await torn(figure([0, 0.2, 0.4]), figure([1, 1.2, 1.2 + Math.PI])), true);
    assert.equal(await torn(figure([0, 0.2]), figure([0, 0.7])), false, 'it is stretched');
    // The places are near in space and far along the surface: no leg exceeds the earlier path.
    const near = 2 * Math.PI - 0.1;
    assert.equal(await torn(figure([0, near]), figure([0, Math.PI])), false);
    assert.equal(await torn(figure([0, 0.2, 0.4], true), figure([0, 0.2, 0.4], true)), false);
    // The next cases are the last leg of a closed figure, and a larger figure.
    assert.equal(await torn(figure([0, 0.6, 0.1], true), figure([0, 1.6, 3], true)), true);
    assert.equal(await torn(figure([0, 0.2]), figure([0, 1]), 2), false, 'it is scaled');
    assert.equal(await torn(figure([0, 0.2], false, 'points'), figure([0, 3])), false);
  });
});

describe('a stroke', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  test('over separate parts ends with its own one, and says so', async () => {
    const tab = await Tab.open(browser);
    const plate = (x) => [x, x + 0.9].flatMap((at) => [`v ${at} 0 0`, `v ${at} 1 0`]);
    const faces = (from) =>
      [
        [1, 3, 4],
        [1, 4, 2],
      ].map((f) => `f ${f.map((i) => i + from).join(' ')}`);
    const text = [...plate(0), ...plate(1.1), ...faces(0), ...faces(4)].join('\n');
    await tab.dropBytes('plates.obj', new TextEncoder().encode(text));
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('plates.obj'));
    await tab.settled();
    await tab.page.keyboard.press('f');
    const { x, y } = await tab.middle();
    await tab.page.mouse.move(x - 150, y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(x + 150, y + 20, { steps: 30 });
    await tab.page.mouse.up();
    await tab.page.getByText('The stroke ends where another part of the surface begins').waitFor();
    // The stroke becomes a curve once the worker has fitted it.
    await tab.page.waitForFunction(
      () => window.karcherPage.state().drawing.objects.at(-1).figure.points.length >= 2,
    );
    const { drawing } = await tab.state();
    const { points } = drawing.objects.at(-1).figure;
    for (const { face } of points) assert.ok(face < 2, `${face}`);
    await tab.close();
  });
});
