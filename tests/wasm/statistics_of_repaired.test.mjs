// Statistics of meshes with repairs: the surface has each of its points once.
import assert from 'node:assert/strict';
import { after, describe, test } from 'node:test';
import { load } from 'karcher';
import { centroid, isolines, median, voronoi } from 'karcher/statistics';
import { loadInWorker } from 'karcher/worker';

const engine = await load();
const remote = await loadInWorker();
after(() => remote.dispose());

const near = (a, b) => assert.ok(Math.hypot(...a.map((x, k) => x - b[k])) < 1e-12, `${a}, ${b}`);
const kinds = ({ info }) => info.repairs.map(({ kind }) => kind);

for (const [where, karcher] of Object.entries({ 'in the page': engine, 'in a worker': remote })) {
  describe(`with the engine ${where}`, () => {
    const corners = [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
    ];
    const repeated = [0, 1, 2, 0, 2, 3, 1, 2, 0];
    const squares = {
      'with common vertices': [corners.flat(), repeated],
      'with vertices of its own': [
        repeated.flatMap((v) => corners[v]),
        Array.from(repeated.keys()),
      ],
    };
    for (const [name, [positions, triangles]] of Object.entries(squares)) {
      test(`a face that is repeated ${name} counts once`, async () => {
        const mesh = await karcher.meshFromArrays(positions, triangles);
        assert.ok(kinds(mesh).includes('duplicate'));
        near((await centroid(mesh, 'all')).position, [0.5, 0.5, 0]);
        const heights = positions.filter((_, i) => i % 3 === 1);
        const [[line, ...others]] = await isolines(mesh, heights, [0.5]);
        assert.deepEqual([line.length, others], [1, []]);
        const { areas, borders, cell } = await voronoi(mesh, [{ vertex: 0 }]);
        near([...areas], [1]);
        assert.deepEqual(borders, []);
        near([cell(0).area, cell(0).perimeter], [1, 4]);
        near((await centroid(mesh, cell(0))).position, [0.5, 0.5, 0]);
        // The border between two sites runs through the repeated face.
        const two = await voronoi(mesh, [{ vertex: 0 }, { vertex: 1 }]);
        near([...two.areas], [0.5, 0.5]);
        near([two.borders.length, two.borders[0].path.length], [1, 1]);
        near((await centroid(mesh, two.cell(1))).position, [0.75, 0.5, 0]);
      });
    }

    test('a lone face without area does not count', async () => {
      const line = [5, 0, 0, 6, 1, 0, 7, 2, 0];
      const mesh = await karcher.meshFromArrays(
        [...corners.flat(), ...line],
        [0, 1, 2, 0, 2, 3, 4, 5, 6],
      );
      near((await centroid(mesh, 'all')).position, [0.5, 0.5, 0]);
    });

    test('both sides of a double surface count', async () => {
      const mesh = await karcher.meshFromArrays(
        [corners, corners].flat(2),
        [0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 1, 2],
      );
      assert.ok(kinds(mesh).includes('duplicate'));
      const { areas } = await voronoi(mesh, [{ vertex: 0 }]);
      near([...areas], [2]);
    });

    test('vertices of parts that only touch have their own distances', async () => {
      const tetrahedron = (at) =>
        [
          [0, 0, 0],
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
        ].map((corner) => corner.map((x, k) => at[k] + x));
      const faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
      // The second and the third touch where the second has its corner 1 and the third its corner 0.
      // A last face has no area, and its vertices, one of them there, are dropped.
      const parts = [
        [9, 9, 9],
        [0, 0, 0],
        [1, 0, 0],
      ].map(tetrahedron);
      const flat = [
        [1, 0, 0],
        [1, -1, -1],
        [1, -2, -2],
      ];
      const area = (3 + Math.sqrt(3)) / 2;
      for (const isWelded of [true, false]) {
        for (const more of [[], flat]) {
          const all = [...more, ...parts.flat()];
          const own = parts.flatMap((_, i) => faces.map((v) => more.length + 4 * i + v));
          const triangles = [...more.keys(), ...own];
          const mesh = isWelded
            ? await karcher.meshFromArrays(all.flat(), triangles)
            : await karcher.meshFromArrays(
                triangles.flatMap((v) => all[v]),
                Array.from(triangles.keys()),
              );
          assert.ok(kinds(mesh).includes('keptApart'));
          assert.equal(kinds(mesh).includes('dropped'), more.length > 0);
          const face = (part, k) => more.length / 3 + 4 * part + k;
          const bary = [0.25, 0.25, 0.5];
          const sites = [0, 1, 2].map((part) => ({ face: face(part, 0), bary }));
          const { areas, borders, cell } = await voronoi(mesh, sites);
          near([...areas], [area, area, area]);
          assert.deepEqual(borders, []);
          for (const part of [0, 1, 2]) {
            // The tetrahedra are closed.
            assert.equal(cell(part).perimeter, 0);
            for (const k of [0, 1, 2, 3])
              assert.ok(cell(part).contains({ face: face(part, k), bary }));
          }
        }
      }
    });

    /** A tetrahedron, and one of twice its size, which share a vertex. */
    const twoTetrahedra = async () => {
      const corner = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
      const positions = [...corner, ...corner.slice(3).map((x) => -2 * x)];
      const faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
      const other = faces.map((v) => (v === 0 ? 0 : v + 3)).toReversed();
      const mesh = await karcher.meshFromArrays(positions, [...faces, ...other]);
      assert.ok(kinds(mesh).includes('bowTie'));
      return mesh;
    };

    test('parts with a common vertex have cells of their own', async () => {
      const mesh = await twoTetrahedra();
      const area = (3 + Math.sqrt(3)) / 2;
      const sites = [1, 6].map((face) => ({ face, bary: [0.25, 0.25, 0.5] }));
      for (const order of [sites, sites.toReversed()]) {
        const { areas, borders, nearest, cell } = await voronoi(mesh, order);
        const first = order === sites ? 0 : 1;
        near([areas[first], areas[1 - first]], [area, 4 * area]);
        assert.deepEqual(borders, []);
        assert.deepEqual(
          [...nearest],
          [first, first, first, first, 1 - first, 1 - first, 1 - first],
        );
        near([cell(0).perimeter, cell(1).perimeter], [0, 0]);
      }
    });

    test('a site with points on parts that touch has the distances of each part there', async () => {
      const mesh = await twoTetrahedra();
      // On each part, two far sites divide the faces at the common vertex, which the other part's
      // point is near.
      for (const [far, near0] of [
        [[{ vertex: 1 }, { vertex: 2 }], { face: 6, bary: [0.01, 0.01, 0.98] }],
        [[{ vertex: 4 }, { vertex: 5 }], { face: 0, bary: [0.98, 0.01, 0.01] }],
      ]) {
        const [one, two] = far;
        const alone = await voronoi(mesh, far);
        const { areas } = await voronoi(mesh, [[one, near0], two]);
        near([areas[1]], [alone.areas[1]]);
      }
    });

    test('isolines do not cross from a fin to the sheet on which it stands', async () => {
      const places = [0, 1, 2].flatMap((x) => [x, 0, 0, x, 1, 0]);
      const sheet = [0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3];
      const fin = [2, 6, 7, 2, 7, 3];
      for (const triangles of [
        [...sheet, ...fin],
        [...fin, ...sheet],
      ]) {
        const mesh = await karcher.meshFromArrays([...places, 1, 0, 1, 1, 1, 1], triangles);
        assert.ok(kinds(mesh).includes('branching'));
        const [lines] = await isolines(mesh, [0, 1, 0, 1, 0, 1, 0, 1], [0.25]);
        near(lines.map(({ length }) => length).sort(), [1, 2]);
        for (const line of lines) await mesh.offset([line], { distance: 0.1 });
      }
    });

    // Faces around the origin, where the median of two near and close points and a far one is not.
    const around = Array.from({ length: 6 }, (_, i) => {
      const turn = (i * Math.PI) / 3;
      return [200 * Math.cos(turn), i % 3 === 0 ? 0 : 200 * Math.sin(turn), 0];
    });
    const sectors = [0, 1, 2, 3, 4, 5].map((i) => [0, 1 + i, 1 + ((i + 1) % 6)]);
    const turned = sectors.with(3, sectors[3].toReversed());
    const touching = [
      [0, 0, 0],
      [0, 0, 400],
      [-400, 0, -400],
    ];
    const below = [0, -300, 0];
    const fans = {
      'of which one is turned over': [around, turned, { face: 5, bary: [1, 0, 0] }],
      'that another part touches': [
        [...around, ...touching],
        [...sectors, [7, 8, 9]],
        { vertex: 0 },
      ],
      // The last face has no area; the one before it is cut at the origin.
      'that a repair has cut there': [
        [...around.slice(0, 4), below],
        [...sectors.slice(0, 3), [5, 1, 4], [4, 1, 0]],
        { vertex: 0 },
      ],
    };
    for (const [name, [places, triangles, origin]] of Object.entries(fans)) {
      test(`the median leaves a vertex of faces ${name}`, async () => {
        const mesh = await karcher.meshFromArrays([0, 0, 0, ...places.flat()], triangles.flat());
        assert.equal(mesh.info.repairs.length, 1);
        for (const way of [1, -1]) {
          const points = [origin];
          for (const place of [
            [way, 0.01, 0],
            [way, -0.01, 0],
            [-100 * way, 0.01, 0],
          ]) {
            points.push((await mesh.nearestPoint(place)).point);
          }
          const { value } = await median(mesh, points, [1.5, 1, 1, 0.3], { start: origin });
          // At the origin, the value is 32.
          assert.ok(value < 31.85, `${value}`);
        }
        const alone = await median(mesh, [origin]);
        const { vectors } = await mesh.logMap(alone.point, [origin]);
        near([...vectors], [0, 0, 0]);
      });
    }

    test('a face without area at an edge changes no cell and no line', async () => {
      // The diagonal has the two faces of the square, and faces to its middle without area.
      const positions = [...corners, [0.5, 0.5, 0], [0.25, 0.25, 0]].flat();
      const fins = [
        [0, 2, 4],
        [0, 4, 2],
        [0, 4, 5],
      ];
      for (const some of [[0], [0, 1], [0, 2], [0, 1, 2]]) {
        const triangles = [[0, 1, 2], [0, 2, 3], ...some.map((k) => fins[k])].flat();
        const mesh = await karcher.meshFromArrays(positions, triangles);
        assert.ok(kinds(mesh).includes('noArea'));
        const { areas, cell } = await voronoi(mesh, [{ vertex: 1 }]);
        near([areas[0], cell(0).perimeter], [1, 4]);
        const heights = positions.filter((_, i) => i % 3 === 0);
        const [lines] = await isolines(mesh, heights, [0.125]);
        near(
          lines.map(({ length }) => length),
          [1],
        );
      }
    });

    test('a face that is cut has the welded vertices of its neighbors', async () => {
      // The third face lies on the diagonal, whose middle is a vertex. The last one touches the
      // square there.
      const middle = [0.5, 0.5, 0];
      const [a, b, c, d] = corners;
      const places = [
        [a, b, c],
        [a, middle, d],
        [a, c, middle],
        [middle, c, d],
        [middle, [0, 0, 1], [1, 0, 1]],
      ];
      const vertices = Array.from({ length: 15 }, (_, v) => v);
      const mesh = await karcher.meshFromArrays(places.flat(2), vertices);
      assert.deepEqual(kinds(mesh), ['welded', 'keptApart', 'noArea']);
      const sites = [0, 3].map((face) => ({ face, bary: face ? [0, 0, 1] : [0, 1, 0] }));
      const along = await voronoi(mesh, sites);
      near([...along.areas], [0.5, 0.5]);
      near([along.borders.length, along.borders[0].path.length], [1, Math.SQRT2]);
      const { areas, borders } = await voronoi(mesh, [{ vertex: 0 }, { vertex: 1 }]);
      near([...areas], [0.5, 0.5]);
      near([borders.length, borders[0].path.length], [1, 1]);
      const heights = places.flat().map(([x]) => x);
      const [lines] = await isolines(mesh, heights, [0.25]);
      near(lines.map(({ length }) => length).sort(), [Math.hypot(0.25, 0.5), 1]);
    });
  });
}
