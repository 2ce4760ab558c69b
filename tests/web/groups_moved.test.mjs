// Several objects moved together keep their sizes, each in its own frame, and a single one moves as before.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load } from 'karcher';
import { Vector3 } from 'three';
import { browserOfSuite, Tab } from './browser.mjs';
import { arraysOfShape, openPage } from './engine_in_node.mjs';
import { pageModule } from './page_module.mjs';

/** The places of surface points. */
const placesOf = (points, { positions, triangles }) =>
  points.map(({ face, bary }) =>
    [0, 1, 2].map((axis) =>
      bary.reduce(
        (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
        0,
      ),
    ),
  );
const far = (p, q) => Math.hypot(...p.map((value, axis) => value - q[axis]));
const at = (face, u = 0.2, v = 0.3) => ({ face, bary: [1 - u - v, u, v] });

describe('objects that move together', () => {
  let page;
  let arrays;
  let togetherOf;
  before(async () => {
    arrays = await arraysOfShape('sphere', 1500);
    page = await openPage(arrays);
    ({ togetherOf } = await pageModule('../../web/model/together.ts'));
  });

  const place = (point) => placesOf([point], arrays)[0];
  const sphere = {
    frame: { scale: 1 },
    position: (point, target) => target.fromArray(place(point)),
    normal: (point) => new Vector3(...place(point)).normalize(),
    directionFromScene: (direction) => direction.toArray(),
  };
  const objectOf = (id, points, more = {}) => {
    const { figure, ...rest } = page.emptyDrawing.objects[0];
    return { ...rest, id, figure: { ...figure, kind: 'polyline', points, ...more } };
  };
  const moveOf = (objects, pivot) =>
    page.Move.of(
      page.session,
      sphere,
      { drawing: { ...page.emptyDrawing, objects }, objects },
      pivot,
    );

  test('are one part if they share a place or make one object', () => {
    const union = { kind: 'union', derived: { sources: [3, 4] } };
    const objects = [
      objectOf(1, [at(5), at(9)]),
      objectOf(2, [at(7), at(9)]),
      objectOf(3, [at(20)]),
      objectOf(4, [at(30)]),
      objectOf(6, [at(9, 0.3)]),
      objectOf(7, [at(5), at(40)]),
    ];
    const drawing = { objects: [...objects, objectOf(5, [], union)], active: 1 };
    const ids = togetherOf(drawing, objects).map((part) => part.map(({ id }) => id));
    assert.deepEqual(ids, [[1, 2, 7], [3, 4], [6]]);
  });

  test('are aligned as one if they are the sources of a selected object', async () => {
    const { alignedParts } = await pageModule('../../web/editor/engine/aligning.ts');
    const objects = [1, 2, 3, 4, 6].map((id) => objectOf(id, [at(10 * id), at(10 * id + 3)]));
    const union = objectOf(5, [], { kind: 'union', derived: { sources: [1, 2] } });
    const partsOf = (chosen, grouped = []) => {
      const all = [...objects, union].map((one) =>
        grouped.includes(one.id) ? { ...one, group: 'Group 1' } : one,
      );
      const drawing = { objects: all, active: chosen.at(-1) };
      const { figure } = all.find(({ id }) => id === drawing.active);
      const state = { figure, selection: null, more: [], drawing, chosen, none: false };
      return alignedParts(state).map((part) => part.map(({ id }) => id).sort());
    };
    const inOrder = (parts) => parts.sort(([a], [b]) => a - b);
    assert.deepEqual(inOrder(partsOf([3, 4, 5])), [[1, 2], [3], [4]]);
    assert.deepEqual(partsOf([5]), [], 'a union alone is one part');
    assert.deepEqual(partsOf([5, 3]), [], 'and two parts lie on a line already');
    assert.deepEqual(inOrder(partsOf([1, 5, 3, 4])), [[1, 2], [3], [4]], 'with a source of it');
    assert.deepEqual(inOrder(partsOf([3, 5, 4, 6], [3, 5])), [[1, 2, 3], [4], [6]], 'in a group');
    assert.deepEqual(inOrder(partsOf([1, 2, 3])), [[1], [2], [3]], 'the sources themselves');
  });

  test('keep the shared places, and all sizes on a sphere', async () => {
    const objects = [
      objectOf(1, [at(5), at(9), at(14)]),
      objectOf(2, [at(14), at(20)]),
      objectOf(3, [at(600), at(610), at(620)]),
    ];
    const move = await moveOf(objects, at(9));
    const { figures } = await move.placed({ point: at(300), angle: 0.7 });
    assert.deepEqual(figures[0].points[2], figures[1].points[0]);
    for (const [i, { figure }] of objects.entries()) {
      for (const [j, point] of figure.points.entries()) {
        const was = far(place(point), place(figure.points[0]));
        const is = far(place(figures[i].points[j]), place(figures[i].points[0]));
        // The triangles of a sphere are flat.
        assert.ok(Math.abs(is - was) <= 0.01 * was, `${was} ${is}`);
      }
    }
  });

  test('grow about the pivot, each in its frame', async () => {
    const objects = [objectOf(1, [at(5), at(9), at(14)]), objectOf(2, [at(60), at(66)])];
    const move = await moveOf(objects, at(9));
    const { figures } = await move.placed({ scale: 1.5 });
    for (const [i, { figure }] of objects.entries()) {
      const [first, last] = [figure.points[0], figure.points.at(-1)];
      const [was, is] = [
        far(place(first), place(last)),
        far(place(figures[i].points[0]), place(figures[i].points.at(-1))),
      ];
      assert.ok(Math.abs(is / was - 1.5) < 0.05, `${is / was}`);
    }
  });

  test('a single one moves by the maps of its pivot, to the last bit', async () => {
    const points = [at(5), at(9), at(14, 0.1)];
    const { mesh } = page.session.client;
    const [pivot, to] = [at(9), at(300)];
    const move = await moveOf([objectOf(1, points)], pivot);
    const { vectors } = await mesh.logMap(pivot, points);
    const carried = await mesh.transport(pivot, to, vectors);
    const { points: moved } = await mesh.expMap(to, carried);
    const told = (all) => all.map(({ face, bary }) => ({ face, bary }));
    assert.deepEqual((await move.placed({ point: to })).figures[0].points, told(moved));
  });
});

describe('a group of a heart and a ring on the bunny', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  /** The face whose middle appears nearest to a place of the window. */
  const faceAt = (tab, { x, y }) =>
    tab.page.evaluate(
      async ([px, py]) => {
        const { positions, triangles } = await window.karcherPage.mesh();
        let [best, least] = [0, Infinity];
        for (let face = 0; face < triangles.length / 3; face++) {
          const corners = triangles.subarray(3 * face, 3 * face + 3);
          const middle = [0, 1, 2].map((axis) =>
            corners.reduce((sum, corner) => sum + positions[3 * corner + axis] / 3, 0),
          );
          const seen = window.karcherPage.seen(middle);
          const distance = seen ? Math.hypot(seen.x - px, seen.y - py) : Infinity;
          if (distance < least) [best, least] = [face, distance];
        }
        return best;
      },
      [x, y],
    );

  /** The ends of geodesics of these lengths in all directions from a face's middle. */
  function around(mesh, face, lengths) {
    const middle = { face, bary: [1 / 3, 1 / 3, 1 / 3] };
    const normal = new Vector3(...mesh.normal(middle));
    const first = new Vector3(normal.y, -normal.x, 0).normalize();
    const vectors = lengths.flatMap((length, i) =>
      first
        .clone()
        .applyAxisAngle(normal, (2 * Math.PI * i) / lengths.length)
        .multiplyScalar(length)
        .toArray(),
    );
    return mesh.expMap(middle, vectors).points;
  }

  const fragmentOf = (points, more = '') =>
    `kind=polyline&closed=1&points=${points
      .map(({ face, bary }) => `${face},${bary[1]},${bary[2]}`)
      .join(';')}${more}`;

  /** Selects everything, drags, and waits for the end of the drag. */
  async function dragAll(tab, from, to) {
    const { page } = tab;
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await tab.settled();
    const before = await tab.state();
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 6 });
    await page.waitForFunction(() => window.karcherPage.state().dragging);
    await page.mouse.up();
    await page.waitForFunction(() => !window.karcherPage.state().dragging);
    await tab.settled();
    return { before, after: await tab.state() };
  }

  test('is dragged as one step, and the ring keeps the widths that it has alone there', async () => {
    const bare = await Tab.open(browser, 'mesh=bunny:1');
    const arrays = await bare.mesh();
    const { x, y } = await bare.middle();
    const faces = [
      await faceAt(bare, { x: x - 230, y: y + 80 }),
      await faceAt(bare, { x: x - 80, y: y - 60 }),
    ];
    await bare.close();
    const engine = await load();
    const mesh = engine.meshFromArrays(
      Float64Array.from(arrays.positions),
      Int32Array.from(arrays.triangles),
    );
    const radius = 0.065 * arrays.info.diagonal;
    const heart = around(
      mesh,
      faces[0],
      [1, 1.3, 1, 0.8, 1, 1.3].map((part) => part * radius),
    );
    const ring = around(mesh, faces[1], Array(8).fill(radius));
    const group = '&group=Both';
    const other = encodeURIComponent(fragmentOf(ring, group));
    const tab = await Tab.open(browser, `mesh=bunny:1&${fragmentOf(heart, group)}&other=${other}`);
    const alone = await Tab.open(browser, `mesh=bunny:1&${fragmentOf(ring)}`);
    const seen = (place) =>
      tab.page.evaluate((position) => window.karcherPage.seen(position), place);
    const middleOf = (from, to) => {
      const { vectors } = mesh.logMap(from, [to]);
      return placesOf(
        mesh.expMap(
          from,
          vectors.map((value) => value / 2),
        ).points,
        arrays,
      )[0];
    };
    /** The lowest visible middle of a side: the bunny's back would hide those above. */
    const sideOf = async (points, also = points) => {
      const sides = await Promise.all(
        points.map((_, i) => {
          const next = (i + 1) % points.length;
          return Promise.all([points, also].map((all) => seen(middleOf(all[i], all[next]))));
        }),
      );
      const visible = sides.filter((ends) => ends.every(Boolean));
      return visible.sort(([p], [q]) => q.y - p.y)[0];
    };

    const [hold] = await sideOf(heart);
    const { before, after } = await dragAll(tab, hold, { x: hold.x + 80, y: hold.y + 120 });
    const ringOf = ({ drawing }) =>
      drawing.objects.find(({ figure }) => figure.points.length === 8).figure.points;
    const [from, to] = [ringOf(before), ringOf(after)];
    const [was, together] = [from, to].map((points) => placesOf(points, arrays));
    assert.ok(far(was[0], together[0]) > radius, 'it has moved');
    await tab.page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(
      JSON.stringify((await tab.state()).drawing.objects),
      JSON.stringify(before.drawing.objects),
    );

    const [start, end] = await sideOf(from, to);
    const there = placesOf(ringOf((await dragAll(alone, start, end)).after), arrays);
    const widths = (places) => [0, 1, 2, 3].map((i) => far(places[i], places[i + 4]));
    const [first, ...moved] = [was, together, there].map(widths);
    const [grouped, single] = moved.map((all) =>
      Math.max(...first.map((width, i) => Math.abs(all[i] / width - 1))),
    );
    // From the pivot of the heart the ring lost up to .47 of its width.
    assert.ok(grouped < single + 0.03, `${grouped} beside ${single}`);
    await tab.close();
    await alone.close();
  });
});
