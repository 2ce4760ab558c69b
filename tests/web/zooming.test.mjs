// Zoom from the whole to a single triangle and back on difficult shapes: a smooth one, a noisy scan
// with slivers, a thin tube, and a hollow such as an eye.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { stlFile } from '../wasm/mesh_files.mjs';
import { browserOfSuite, Tab } from './browser.mjs';
import { part, randomFrom, seed } from './part.mjs';
import { zoomThrough } from './zooming.mjs';

/** A grid around an axis, by a function `place` of the angle and the height, both from 0 to 1. */
function gridOf(around, along, place) {
  const positions = [];
  const faces = [];
  for (let j = 0; j <= along; j++) {
    for (let i = 0; i < around; i++) positions.push(...place(i / around, j / along));
  }
  const at = (i, j) => (i % around) + around * j;
  for (let j = 0; j < along; j++) {
    for (let i = 0; i < around; i++) {
      faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return { positions, faces };
}

/** A ball of radius 137 whose places are off by noise, with rows of slivers. */
function noisyScan() {
  const random = randomFrom(seed);
  return gridOf(90, 60, (u, v) => {
    // Every third row lies close to the next one.
    const row = Math.round(60 * v);
    const height = row % 3 === 1 ? v + 0.99 / 60 : v;
    const [angle, polar] = [2 * Math.PI * u, Math.PI * (0.01 + 0.98 * Math.min(1, height))];
    const radius = 137 + 0.8 * (random() - 0.5);
    const ring = radius * Math.sin(polar);
    return [ring * Math.cos(angle), ring * Math.sin(angle), radius * Math.cos(polar)];
  });
}

/** A tube of radius 0.02 along a helix of radius 1. */
const thinTube = () =>
  gridOf(8, 400, (u, v) => {
    const [turn, angle] = [6 * Math.PI * v, 2 * Math.PI * u];
    const radius = 1 + 0.02 * Math.cos(angle);
    return [radius * Math.cos(turn), 2 * v + 0.02 * Math.sin(angle), radius * Math.sin(turn)];
  });

/** A ball with a pit that is wider inside than at its rim, and a smaller ball in the pit. */
const eye = () =>
  gridOf(64, 120, (u, v) => {
    const angle = 2 * Math.PI * u;
    // The profile, as x and y: outside from the back to the rim, the pit, and the inner ball.
    const [x, y] =
      v < 0.5
        ? [Math.sin(5.4 * v + 0.02), -Math.cos(5.4 * v + 0.02)]
        : v < 0.8
          ? [
              0.41 + 0.14 * Math.sin((Math.PI * (v - 0.5)) / 0.3) - 0.2 * ((v - 0.5) / 0.3),
              0.91 - 0.7 * ((v - 0.5) / 0.3),
            ]
          : [
              0.21 * Math.cos((Math.PI / 2) * ((v - 0.8) / 0.2)) + 0.0005,
              0.21 + 0.21 * Math.sin((Math.PI / 2) * ((v - 0.8) / 0.2)),
            ];
    return [x * Math.cos(angle), x * Math.sin(angle), y];
  });

const lines = ({ positions, faces }) =>
  [
    ...Array.from({ length: positions.length / 3 }, (_, i) => {
      return `v ${positions.slice(3 * i, 3 * i + 3).join(' ')}`;
    }),
    ...faces.map((face) => `f ${face.map((vertex) => vertex + 1).join(' ')}`),
  ].join('\n');

const encode = (text) => new TextEncoder().encode(text);
/** The surfaces by their names; the eye looks at the viewer, along z. */
const surfaces = [
  ['smooth', { mesh: 'sphere:20000' }],
  ['noisy', { name: 'noisy.stl', bytes: () => stlFile(noisyScan()) }],
  ['thin', { name: 'thin.obj', bytes: () => encode(lines(thinTube())) }],
  ['hollow', { name: 'eye.obj', bytes: () => encode(lines(eye())) }],
];

describe('a zoom', () => {
  const browser = browserOfSuite({ reducedMotion: 'reduce', hasTouch: true });

  for (const [what, { mesh, name, bytes }] of surfaces) {
    for (const how of part(['wheel', 'pinch', 'keys'], what === 'hollow' ? 3 : 1)) {
      test(`goes to a triangle and back by ${how}, where a surface is ${what}, KARCHER_SEED=${seed}`, async () => {
        const tab = await Tab.open(browser, mesh ? `mesh=${mesh}` : '');
        if (name) {
          await tab.dropBytes(name, bytes());
          await tab.page.waitForFunction(
            (file) => window.karcherPage.state().mesh.endsWith(file),
            name,
          );
          await tab.settled();
        }
        await tab.still();
        const { x, y } = await tab.middle();
        const steps = await zoomThrough(tab, how, { x, y });
        assert.ok(steps > 1);
        assert.deepEqual(tab.logged, []);
        await tab.close();
      });
    }
  }
});
