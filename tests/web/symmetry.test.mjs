// Mirroring in planes: the plane in which a surface is its own mirror image, computed from its
// places, or the plane of three clicks.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { pageModule } from './page_module.mjs';
import { inLongRun } from './part.mjs';

/** An egg with a nose, symmetric in x only, as places and normals at directions. */
function lopsided([x, y, z]) {
  const place = ([x, y, z]) => [x, 1.4 * y + 0.3 * y * y * y, 0.8 * z + 0.25 * y * y + 0.1 * z * z];
  return place([x, y, z]);
}

/** The angle about the vertical axis, so that no axis is the plane's normal. */
const turn = 0.35;
const turned = ([x, y, z]) => [
  x * Math.cos(turn) + z * Math.sin(turn),
  y,
  z * Math.cos(turn) - x * Math.sin(turn),
];
const normal = turned([1, 0, 0]);
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);

describe('the plane of symmetry', () => {
  let symmetry;
  before(async () => {
    symmetry = await pageModule('../../web/model/symmetry.ts');
  });

  /** Evenly spread directions on a sphere, deformed, turned and shifted, with normals. */
  function cloud(count, change = (place) => place) {
    const shift = [0.3, -0.2, 0.1];
    const at = (direction) =>
      turned(change(lopsided(direction), direction)).map((value, i) => value + shift[i]);
    return Array.from({ length: count }, (_, i) => {
      const z = 1 - (2 * i + 1) / count;
      const radius = Math.sqrt(1 - z * z);
      const angle = i * Math.PI * (3 - Math.sqrt(5));
      const direction = [radius * Math.cos(angle), z, radius * Math.sin(angle)];
      const place = at(direction);
      // The normal by differences along two directions on the sphere.
      const along = (way) => {
        const moved = direction.map((value, axis) => value + 1e-4 * way[axis]);
        const length = Math.hypot(...moved);
        return at(moved.map((value) => value / length)).map((value, axis) => value - place[axis]);
      };
      const first = [-direction[2], 0, direction[0] + 1e-9];
      const second = [
        direction[1] * first[2],
        direction[2] * first[0] - direction[0] * first[2],
        -direction[1] * first[0],
      ];
      const [a, b] = [along(first), along(second)];
      const cross = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
      ];
      const length = Math.hypot(...cross);
      return { place, normal: cross.map((value) => value / length) };
    });
  }
  const nearestOf = (places) => (at) => {
    let best = null;
    let least = Number.POSITIVE_INFINITY;
    for (const one of places) {
      // The vector has its components written out, since there are hundreds of millions of places.
      const [x, y, z] = one.place;
      const square = (x - at[0]) ** 2 + (y - at[1]) ** 2 + (z - at[2]) ** 2;
      if (square < least) {
        best = one;
        least = square;
      }
    }
    return best;
  };
  const axes = [
    [1, 0, 0],
    [0, 0, 1],
    [0, 1, 0],
  ];
  const find = (samples, places) =>
    symmetry.symmetryOf(
      samples.map(({ place }) => place),
      nearestOf(places),
      axes,
      async () => {},
    );
  const within = (degrees) => Math.cos((degrees * Math.PI) / 180);

  test('of a symmetric surface is found, wherever the surface lies', async () => {
    const places = cloud(1500);
    const { plane, apart } = await find(
      places.filter((_, i) => i % 5 === 0),
      places,
    );
    assert.ok(Math.abs(dot(plane.normal, normal)) > within(1), `${plane.normal}`);
    // Neighboring places of the cloud are 0.1 apart.
    assert.ok(apart < 0.08, `${apart}`);
    const through = dot(plane.normal, [0.3, -0.2, 0.1]) - plane.offset;
    assert.ok(Math.abs(through) < 0.02, `${through}`);
  });

  test('is found if a part of the surface is missing or dented', async () => {
    const places = cloud(1500, (place, [x, y]) =>
      x > 0.6 && y > 0 ? place.map((value) => 0.85 * value) : place,
    ).filter(({ place }) => place[1] > -1.2);
    const { plane } = await find(
      places.filter((_, i) => i % 5 === 0),
      places,
    );
    assert.ok(Math.abs(dot(plane.normal, normal)) > within(3), `${plane.normal}`);
  });

  test('is the first of the preferred ones if a surface has many', async () => {
    const places = Array.from({ length: 1500 }, (_, i) => {
      const z = 1 - (2 * i + 1) / 1500;
      const radius = Math.sqrt(1 - z * z);
      const angle = i * Math.PI * (3 - Math.sqrt(5));
      const place = [radius * Math.cos(angle), z, radius * Math.sin(angle)];
      return { place, normal: place };
    });
    const { plane } = await find(
      places.filter((_, i) => i % 5 === 0),
      places,
    );
    assert.ok(Math.abs(plane.normal[0]) > within(3), `${plane.normal}`);
  });

  test('planes pass through three places, and mirror places and directions', () => {
    const plane = symmetry.planeThrough([0, 0, 2], [1, 0, 2], [0, 5, 2]);
    assert.deepEqual(
      symmetry.mirroredPlace(plane, [3, 4, 5]).map((value) => Math.round(value * 1e9) / 1e9),
      [3, 4, -1],
    );
    assert.deepEqual(symmetry.mirroredDirection(plane, [3, 4, 5]), [3, 4, -5]);
    assert.equal(symmetry.planeThrough([0, 0, 0], [1, 1, 1], [3, 3, 3]), null);
  });
});

describe('mirroring in planes', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const placesOf = (points, { positions, triangles }) =>
    points.map(({ face, bary }) =>
      [0, 1, 2].map((axis) =>
        bary.reduce(
          (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
          0,
        ),
      ),
    );
  const rows = (values, letter, add) =>
    Array.from({ length: values.length / 3 }, (_, i) =>
      [letter, ...values.slice(3 * i, 3 * i + 3).map((value) => value + add)].join(' '),
    );

  let opened = 0;

  /** The lopsided body with an unfinished curve on one side, and the mirror tool. */
  async function open() {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=polyline');
    const { positions, triangles } = await tab.mesh();
    const places = [];
    for (let i = 0; i < positions.length; i += 3) {
      places.push(...turned(lopsided(positions.slice(i, i + 3))));
    }
    // Each test has a file of its own, since the page would restore the file's drawing.
    await tab.drop(
      'body.obj',
      [`# ${opened++}`, ...rows(places, 'v', 0), ...rows(triangles, 'f', 1)].join('\n'),
    );
    await tab.page
      .locator('#surface option', { hasText: 'body.obj' })
      .waitFor({ state: 'attached' });
    await tab.settled();
    await tab.click([60, -60], [90, 20], [110, -50]);
    await tab.page.locator('#mirror').click();
    return tab;
  }
  const mirrored = ([x, y, z]) => {
    const by = 2 * dot(normal, [x, y, z]);
    return [x, y, z].map((value, axis) => value - by * normal[axis]);
  };
  async function checkCopies(tab, most = 0.06) {
    await tab.page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
    const mesh = await tab.mesh();
    const { drawing } = await tab.state();
    const [own, copy] = drawing.objects.map(({ figure }) => placesOf(figure.points, mesh));
    for (const [i, place] of own.entries()) {
      const off = Math.hypot(...mirrored(place).map((value, axis) => value - copy[i][axis]));
      assert.ok(off < most, `${off}`);
    }
  }

  test('a click mirrors a copy in the surface’s symmetry, as does its button', async () => {
    const tab = await open();
    const { page } = tab;
    const before = JSON.stringify((await tab.state()).drawing.objects);
    await page.locator('#mirror-copies').check();
    await page.locator('#mirror-in').selectOption('symmetry');
    await page.getByText('both sides of it are alike').waitFor();
    assert.match(
      await page.locator('#mirror-apart').textContent(),
      /^(|Sides differ by [\d.]+ %)$/,
    );
    const { x, y } = await tab.middle();
    await page.mouse.click(x, y);
    await checkCopies(tab);
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(JSON.stringify((await tab.state()).drawing.objects), before);
    await page.locator('#mirror').click();
    await page.getByText('both sides of it are alike').waitFor();
    await page.locator('#mirror-now').click();
    await checkCopies(tab);
    await tab.close();
  });

  test('three clicks mirror in the plane through them; on one line they give a sentence', async () => {
    const tab = await open();
    const { page } = tab;
    await page.locator('#mirror-copies').check();
    await page.locator('#mirror-in').selectOption('plane');
    const { x, y } = await tab.middle();
    await page.mouse.click(x, y);
    await page.getByText('second point').waitFor();
    await page.mouse.click(x, y);
    await page.getByText('third point').waitFor();
    await page.mouse.click(x, y);
    await page.getByText('do not lie on a line').waitFor();
    assert.equal((await tab.state()).drawing.objects.length, 1);
    // The clicks are on three visible vertices near the plane of symmetry, at different heights.
    const { positions } = await tab.mesh();
    const near = [];
    for (let i = 0; i < positions.length; i += 3) {
      const place = positions.slice(i, i + 3);
      if (Math.abs(dot(normal, place)) < 0.02) near.push(place);
    }
    near.sort((a, b) => a[1] - b[1]);
    const seen = await page.evaluate(
      (places) => places.map((place) => window.karcherPage.seen(place)).filter((one) => one),
      near,
    );
    for (const part of [0.1, 0.5, 0.9]) {
      const place = seen[Math.floor(part * seen.length)];
      await page.mouse.click(place.x, place.y);
    }
    await checkCopies(tab, 0.15);
    await tab.close();
  });

  inLongRun('a surface without symmetry gives a sentence, and mirrors nothing', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=polyline');
    const { positions, triangles } = await tab.mesh();
    const places = [];
    for (let i = 0; i < positions.length; i += 3) {
      const [x, y, z] = positions.slice(i, i + 3);
      const [a, b, c] = [x + 0.5 * y * y, 1.5 * y + 0.4 * x * z + 0.3 * z, 2 * z + 0.8 * x * x * y];
      places.push(a + 0.6 * c * b, b, c + 0.3 * a * a);
    }
    await tab.drop('odd.obj', [...rows(places, 'v', 0), ...rows(triangles, 'f', 1)].join('\n'));
    await tab.page
      .locator('#surface option', { hasText: 'odd.obj' })
      .waitFor({ state: 'attached' });
    await tab.settled();
    await tab.click([0, -30], [30, 20]);
    await tab.page.locator('#mirror').click();
    await tab.page.locator('#mirror-in').selectOption('symmetry');
    await tab.page.getByText('no plane of symmetry').waitFor();
    assert.ok(await tab.page.locator('#mirror-symmetric').isHidden());
    const { x, y } = await tab.middle();
    await tab.page.mouse.click(x, y);
    await tab.settled();
    assert.equal((await tab.state()).drawing.objects.length, 1);
    await tab.close();
  });
});
