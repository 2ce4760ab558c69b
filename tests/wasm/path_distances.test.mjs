// Distances of points from the nearest of paths.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { loadInWorker } from 'karcher/worker';
import { randomFrom, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';

const karcher = await load();
const cells = 10;
const mesh = karcher.meshFromObj(grid(cells));

/** The point of the grid at (x, y). */
function at([x, y]) {
  const [i, j] = [Math.min(cells - 1, Math.floor(x)), Math.min(cells - 1, Math.floor(y))];
  const [u, v] = [x - i, y - j];
  const face = 2 * (i + cells * j) + (u >= v ? 0 : 1);
  return { face, bary: u >= v ? [1 - u, u - v, v] : [1 - v, u, v - u] };
}

test('in the plane are distances from line segments, near and far, at vertices and within faces', async () => {
  const random = randomFrom(seed);
  const within = () => [cells * random(), cells * random()];
  const remote = await loadInWorker();
  const other = await remote.meshFromObj(grid(cells));
  for (let drawing = 0; drawing < 10; drawing++) {
    const ends = [0, 1].map(() => [within(), within()]);
    const paths = ends.map(([from, to]) => mesh.shortestPath(at(from), at(to)));
    const places = [...Array.from({ length: 60 }, within), [0, 0], [3, 4], [cells, cells]];
    const expected = places.map((place) =>
      Math.min(
        ...ends.map(([[ax, ay], [bx, by]]) => {
          const [dx, dy] = [bx - ax, by - ay];
          const along = ((place[0] - ax) * dx + (place[1] - ay) * dy) / (dx * dx + dy * dy);
          const part = Math.min(1, Math.max(0, along));
          return Math.hypot(place[0] - ax - part * dx, place[1] - ay - part * dy);
        }),
      ),
    );
    const distances = mesh.distanceFromPaths(paths, places.map(at));
    distances.forEach((distance, i) => {
      const what = `KARCHER_SEED=${seed}, drawing ${drawing}, ${places[i]}: ${distance}`;
      assert.ok(Math.abs(distance - expected[i]) < 1e-9, what);
    });
    assert.deepEqual(await other.distanceFromPaths(paths, places.map(at)), distances);
    const arrays = {
      face: places.map((place) => at(place).face),
      bary: places.flatMap((place) => at(place).bary),
    };
    assert.deepEqual(mesh.distanceFromPaths(paths, arrays), distances);
  }
  remote.dispose();
});

test('are NaN if no path leads there, and refuse invalid paths', () => {
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n';
  const both = karcher.meshFromObj(
    `${square}${square
      .replaceAll(/v (\d) /g, (_, x) => `v ${+x + 3} `)
      .replaceAll(
        /f (\d) (\d) (\d)/g,
        (_, ...of) =>
          `f ${of
            .slice(0, 3)
            .map((i) => +i + 4)
            .join(' ')}`,
      )}`,
  );
  const path = both.shortestPath({ vertex: 0 }, { vertex: 1 });
  const [near, far] = both.distanceFromPaths([path], [{ vertex: 3 }, { vertex: 7 }]);
  assert.ok(Math.abs(near - 1) < 1e-12);
  assert.ok(Number.isNaN(far));
  const code = { code: 'badArgument' };
  assert.throws(() => both.distanceFromPaths([[{ vertex: 0 }, { vertex: 0 }]], []), code);
  assert.throws(() => both.distanceFromPaths(path, []), code);
});
