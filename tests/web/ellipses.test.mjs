// Ellipses, their handles, and changes to and from circles.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { flatGrid, typeRadius } from './circle_views.mjs';
import { farthestFromSurface } from './on_surface.mjs';
import { inLongRun } from './part.mjs';
import { far, vertices } from './polylines.mjs';

const onSurface = 2e-6;
const alongHandle = 'Radius along and direction of the ellipse';
const acrossHandle = 'Radius across of the ellipse';

const dot = (a, b) => a.reduce((sum, value, axis) => sum + value * b[axis], 0);
const radiiOf = ({ circle }) => [circle.radius, circle.across.radius];
/** The start and the direction of a drawn radius, on a plane. */
function axisOf({ path, radius }) {
  const drawn = Object.values(path);
  const start = drawn.slice(0, 3);
  return [start, drawn.slice(-3).map((value, axis) => (value - start[axis]) / radius)];
}
const near = (a, b) => Math.abs(a - b) <= 1e-9 * Math.abs(b);

describe('ellipses', () => {
  const browser = browserOfSuite();

  test('on a plane are ellipses, and turn with their handle', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('flat.obj', flatGrid(16));
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 512);
    await tab.page.keyboard.press('8');
    assert.equal((await tab.state()).figure.kind, 'ellipse');
    assert.equal(
      await tab.page.locator('#hint').textContent(),
      'Click the surface to place the center',
    );
    await tab.click([3, 5]);
    const expectEllipse = (view) => {
      const { circle, curve } = view;
      const [along, across] = radiiOf(view);
      const [center, u] = axisOf(circle);
      const [, v] = axisOf(circle.across);
      assert.ok(Math.abs(dot(u, v)) < 1e-6);
      for (const place of vertices(Object.values(curve.samples.position))) {
        const step = place.map((value, axis) => value - center[axis]);
        const x = dot(step, u) / along;
        const y = dot(step, v) / across;
        // Center and axes come from drawn lines, in single precision.
        assert.ok(Math.abs(x * x + y * y - 1) < 1e-5, `${x}, ${y}`);
      }
    };
    await typeRadius(tab, '4', 'Along');
    const typed = await typeRadius(tab, '1.5', 'Across');
    assert.deepEqual(radiiOf(typed), [4, 1.5]);
    expectEllipse(typed);
    await tab.dragHandle(alongHandle, -25, 70);
    const turned = await tab.view();
    const [was, is] = [typed, turned].map(({ circle }) => axisOf(circle)[1]);
    assert.ok(dot(was, is) < 0.98, 'it is turned');
    assert.equal(turned.circle.across.radius, 1.5);
    expectEllipse(turned);
    await tab.close();
  });

  inLongRun('have a handle along, one across and a center, each undone in one step', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&kind=ellipse');
    await tab.click([0, 40]);
    const surface = await tab.mesh();
    const views = [await tab.view()];
    assert.equal(views[0].legs.length, 2, 'both radii are drawn');
    const lies = ({ polyline, circle }) => {
      const { diagonal } = surface.info;
      assert.ok(farthestFromSurface(polyline, surface) <= onSurface * diagonal);
      // The ends of the handles are on the curve, up to its deviation where the surface bends.
      for (const path of [circle.path, circle.across.path]) {
        const end = Object.values(path).slice(-3);
        const gap = Math.min(...vertices(polyline).map((place) => far(place, end)));
        assert.ok(gap < 0.1 * circle.radius, `${gap}`);
      }
    };
    lies(views[0]);
    const drag = async (name, dx, dy) => {
      await tab.dragHandle(name, dx, dy);
      const view = await tab.view();
      assert.equal(view.problem, null);
      assert.notDeepEqual(view.polyline, views.at(-1).polyline);
      lies(view);
      views.push(view);
      return radiiOf(view);
    };
    const [along, across] = radiiOf(views[0]);
    const wider = await drag(acrossHandle, 0, -14);
    assert.ok(wider[1] > 1.1 * across && near(wider[0], along));
    const back = await drag(acrossHandle, 4, 10);
    assert.ok(back[1] < wider[1] && near(back[0], along));
    const longer = await drag(alongHandle, 15, 10);
    assert.ok(longer[0] > 1.1 * along && near(longer[1], back[1]), 'only that one');
    const moved = await drag('Center of the ellipse', -20, -10);
    assert.ok(
      moved.every((radius, i) => near(radius, longer[i])),
      'the radii go along',
    );
    for (const view of views.slice(0, -1).reverse()) {
      await tab.page.keyboard.press('Control+z');
      assert.deepEqual((await tab.view()).polyline, view.polyline);
    }
    for (const view of views.slice(1)) {
      await tab.page.keyboard.press('Control+Shift+z');
      assert.deepEqual((await tab.view()).polyline, view.polyline);
    }
    await tab.close();
  });

  inLongRun('are shaped with the keys alone', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=ellipse');
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('Enter');
    const first = await tab.view();
    assert.ok(first.curve);
    for (const [handle, key] of [
      [alongHandle, 'ArrowDown'],
      [acrossHandle, 'ArrowUp'],
      ['Center of the ellipse', 'ArrowLeft'],
    ]) {
      const before = await tab.view();
      await tab.page.getByRole('button', { name: handle }).focus();
      await tab.page.keyboard.press(key);
      await tab.page.keyboard.press(key);
      assert.notDeepEqual((await tab.view()).polyline, before.polyline, handle);
    }
    await tab.page.keyboard.press('Delete');
    assert.equal((await tab.state()).figure.circle, null);
    await tab.close();
  });

  test('share center and radius with circles, and are restored by link and file', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&kind=circle');
    await tab.click([0, 40]);
    const circle = await tab.view();
    await tab.choose('ellipse');
    const ellipse = await tab.view();
    assert.equal(ellipse.circle.radius, circle.circle.radius);
    assert.notDeepEqual(ellipse.polyline, circle.polyline);
    await tab.dragHandle(acrossHandle, 0, -12);
    const wider = await tab.view();
    await tab.choose('circle');
    assert.deepEqual((await tab.view()).polyline, circle.polyline);
    await tab.page.keyboard.press('8');
    assert.deepEqual((await tab.view()).polyline, wider.polyline);

    const { figure: document } = await tab.state();
    await tab.page.waitForFunction(() => location.hash.includes('kind=ellipse&'));
    await tab.page.reload();
    assert.deepEqual((await tab.view()).polyline, wider.polyline);
    assert.deepEqual((await tab.state()).figure, document);
    const { name, text } = await tab.save('JSON');
    const content = JSON.parse(text);
    assert.equal(content.kind, 'ellipse');
    assert.deepEqual(content.radii, radiiOf(wider));
    assert.deepEqual(content.direction, wider.circle.direction);
    assert.match((await tab.save('SVG')).text, /<path [^>]*stroke-width="4"/);
    assert.match((await tab.save('OBJ')).text, /\nl 1 2 /);
    await tab.page.getByRole('button', { name: 'Clear' }).click();
    assert.equal((await tab.view()).curve, null);
    await tab.drop(name, text);
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.circle !== null);
    assert.deepEqual((await tab.view()).polyline, wider.polyline);
    await tab.close();
  });

  inLongRun('keep both radii on another mesh of their surface', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000&kind=ellipse');
    await tab.click([0, 0]);
    const onFiner = async (triangles) => {
      await tab.page.locator('#detail').selectOption(`${triangles}`);
      await tab.page.waitForFunction(
        (mesh) => window.karcherPage.state().mesh === mesh,
        `sphere:${triangles}`,
      );
      return tab.view();
    };
    const typed = await typeRadius(tab, '0.1', 'Across');
    assert.deepEqual(radiiOf(await onFiner(20000)), radiiOf(typed), 'lengths stay');
    // A drag of its handle makes the axis as long as the path to a point, which lies elsewhere in
    // other triangles.
    await tab.dragHandle(acrossHandle, 0, -14);
    const dragged = await tab.view();
    const { meanEdge } = (await tab.mesh()).info;
    const carried = radiiOf(await onFiner(5000));
    for (const [i, radius] of radiiOf(dragged).entries()) {
      assert.ok(Math.abs(carried[i] - radius) < 0.5 * meanEdge, `${carried[i]}, was ${radius}`);
    }
    await tab.close();
  });

  inLongRun('that cannot be, or go beyond shortest ways, are said so', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('flat.obj', flatGrid(16));
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 512);
    await tab.page.keyboard.press('8');
    await tab.click([3, 5]);
    assert.equal((await tab.view()).problem, null);
    const hint = () => tab.page.locator('#hint').textContent();
    const outside = await typeRadius(tab, '9', 'Across');
    assert.equal(outside.curve, null);
    assert.match(await hint(), /^[A-Z].*boundary.*\.$/);
    await tab.page.getByRole('button', { name: acrossHandle }).waitFor();
    assert.ok((await typeRadius(tab, '2', 'Across')).curve);
    assert.equal((await typeRadius(tab, '99', 'Along')).curve, null);
    assert.match(await hint(), /^[A-Z].*\.$/);

    // On a tube of radius 0.4, paths from the center in both directions meet on its other side.
    const torus = await Tab.open(browser, 'mesh=torus:2000&kind=ellipse');
    await torus.click([0, 120]);
    const badge = torus.page.locator('#status-arcs');
    assert.equal(await badge.isVisible(), false);
    await typeRadius(torus, '1.4', 'Along');
    const far = await typeRadius(torus, '1.4', 'Across');
    assert.ok(far.curve.arcsNotShortest > 0);
    assert.match(await badge.textContent(), /arcs? not shortest/);
    assert.deepEqual([...tab.logged, ...torus.logged], []);
    await torus.page.close();
    await tab.page.close();
  });
});
