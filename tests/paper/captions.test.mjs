// Every number in a caption equals that of its figure, or comes from the saved report; a number
// without a check fails.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, test } from 'node:test';
import { loadPeers } from 'karcher/peers';
import { inRoot, load } from './load.mjs';

let figures;
let lineStyles;
let lab;
before(async () => {
  ({ figures } = await load('figures/index.ts'));
  ({ lineStyles } = await load('figures/lines.ts'));
  const { Lab } = await load('lab/lab.ts');
  lab = new Lab(await loadPeers());
});

/** Each line with k in its name has that k. */
function rings(figure, texts) {
  for (const [, k] of texts) {
    const named = figure.panels.flatMap(({ lines }) => lines.filter((id) => id.endsWith(k)));
    assert.ok(named.length > 0, `${figure.id}: k = ${k}`);
    for (const id of named) assert.equal(lineStyles[id].options.rings, Number(k));
  }
}

/** Checks numbers of triangles, to three digits. */
async function triangles({ id, panels }, texts) {
  const counts = [];
  for (const { mesh } of panels) counts.push((await lab.mesh(mesh)).info.triangles);
  for (const text of texts.flatMap(([, one, other]) => (other ? [one, other] : [one]))) {
    const number = Number(text.replace(',', ''));
    assert.ok(
      counts.some((count) => Math.abs(count / number - 1) < 0.005),
      `${id}: ${number} of ${counts}`,
    );
  }
}

const curvesOf = ({ panels }, kind) =>
  panels.map(({ curve }) => curve).filter((curve) => curve.kind === kind);

/** Texts with numbers and their checks: applied in order, each to the rest of the caption. */
const rules = [
  { text: /([\d,]+)(?: and of ([\d,]+))? triangles/g, check: triangles },
  {
    text: /distances are exact where the paper has k = 6/g,
    check({ panels }) {
      for (const { lines } of panels) {
        const ofPaper = lines.filter((id) => id.startsWith('paper'));
        assert.ok(ofPaper.length > 0);
        for (const id of ofPaper) assert.equal(lineStyles[id].options.solver, 'exact');
      }
    },
  },
  { text: /k = (\d)/g, check: rings },
  { text: /Fig(?:ure|\.) \d/g, check: () => {} },
  { text: /Section \d\.\d/g, check: () => {} },
  { text: /level 0/g, check: () => assert.match(lineStyles.karcher.label, /level 0$/) },
  { text: /Eq\. 3/g, check: () => {} },
  { text: /\b1-ring/g, check: () => {} },
  {
    text: /weights ([\d.]+), ([\d.]+), ([\d.]+) and ([\d.]+)/g,
    check(figure, [[, ...told]]) {
      const curves = curvesOf(figure, 'center');
      assert.equal(curves.length, figure.panels.length);
      for (const { weights } of curves) assert.deepEqual(weights, told.map(Number));
    },
  },
  // Weights along a path, by their formula.
  { text: /\(1 − w, w\) with w from 0 to 1|w = 1/g, check: () => {} },
  {
    text: /all weights 1, then with the inner ones (\d+) times the outer ones/g,
    check(figure, [[, times]]) {
      const [equal, pulled] = curvesOf(figure, 'rational').map(({ weights }) => weights);
      assert.deepEqual(equal, [1, 1, 1, 1]);
      assert.equal(pulled[1] / pulled[0], Number(times));
      assert.deepEqual(pulled, pulled.toReversed());
    },
  },
  {
    text: /weights ([\d.]+) and ([\d.]+) are the paper’s/g,
    check(figure, [[, outer, inner]]) {
      const weights = curvesOf(figure, 'rational').map((curve) => curve.weights.slice(0, 2));
      assert.deepEqual(weights.at(-1), [Number(outer), Number(inner)]);
    },
  },
  {
    // The text of the paper has two values, one of which the figure draws.
    text: /of β it says (\d+\.\d+) in its text and 1\/4 in its caption, here it is (\d+\.\d+)/g,
    check(figure, [[, paper, here]]) {
      assert.equal(here, paper);
      const betas = curvesOf(figure, 'barycentric').map((curve) => curve.betas[1]);
      assert.ok(betas.includes(Number(here)), `${betas}`);
    },
  },
];

test('every number of a caption is checked, and equals that of the figure', async () => {
  let told = 0;
  for (const figure of figures) {
    let rest = figure.caption.replaceAll(/\{[^}]*\}/g, '');
    for (const { text, check } of rules) {
      const found = [...rest.matchAll(text)];
      if (found.length === 0) continue;
      told += found.length;
      await check(figure, found);
      rest = rest.replace(text, '');
    }
    assert.doesNotMatch(rest, /\d/, `${figure.id}: ${rest}`);
  }
  assert.ok(told >= 20, `${told}`);
});

test('a figure says which form of Eq. 3 and which seeds each line of the paper’s method has', async () => {
  const { captionOf } = await load('figures/captions.ts');
  let named = 0;
  for (const figure of figures) {
    const whole = captionOf(figure);
    const lines = new Set(figure.panels.flatMap((panel) => panel.lines));
    for (const id of lines) {
      const { label, options } = lineStyles[id];
      const told = whole
        .split('. “')
        .slice(1)
        .find((part) => part.includes(`${label}”`));
      assert.equal(told !== undefined, options?.method === 'paper', `${figure.id}: ${id}`);
      if (told === undefined) continue;
      assert.equal(/as printed/.test(told), options.star === 'ring', `${figure.id}: ${id}`);
      assert.equal(
        /start as theirs/.test(told),
        options.seeds === 'authors',
        `${figure.id}: ${id}`,
      );
      named++;
    }
  }
  assert.ok(named >= 12, `${named}`);
});

test('numbers of segments, arcs and points in words', () => {
  const of = (id) => figures.find((figure) => figure.id === id);
  const resolution = of('resolution');
  assert.match(resolution.caption, /B-spline of four segments/);
  // A uniform cubic B-spline has three more control points than segments.
  for (const { points } of resolution.panels) {
    assert.equal(resolution.points[points].length, 4 + 3);
  }
  assert.match(of('circles').caption, /by seven rational quadratic arcs/);
  assert.deepEqual(
    curvesOf(of('circles'), 'circle').map(({ arcs }) => arcs),
    [7],
  );
  assert.match(of('means').caption, /^Four points/);
  for (const { points } of of('means').panels) assert.equal(of('means').points[points].length, 4);
  assert.match(of('paths').caption, /between two points/);
  for (const { points } of of('paths').panels) assert.equal(of('paths').points[points].length, 2);
  assert.match(of('rational').caption, /passes through its three points/);
  for (const { points, curve } of of('rational').panels) {
    assert.equal(of('rational').points[points].length, curve.kind === 'rational' ? 4 : 3);
  }
});

test('numbers that a caption quotes are in the saved report and in a new one', async () => {
  const { captionOf } = await load('figures/captions.ts');
  const report = JSON.parse(readFileSync(inRoot('docs/paper-report.json'), 'utf8'));
  const far = figures.find(({ id }) => id === 'far');
  const of = (id) => report.panels['far/bezier'].find((line) => line.id === id).sharpestTurn;
  const { degrees, t } = of('bridged');
  const told = captionOf(far);
  const angle = `turns by ${degrees.toFixed(1)}° at t = ${t.toFixed(3)}`;
  assert.ok(told.includes(angle), told);
  assert.ok(told.includes(`turns by ${of('leveled').degrees.toFixed(1)}° at most`), told);
  const bezier = [{ id: 'bridged', sharpestTurn: { degrees: 12.34, t: 0.5 } }];
  assert.match(captionOf(far, { 'far/bezier': bezier }), /turns by 12\.3° at t = 0\.500/);
  for (const figure of figures) {
    assert.doesNotMatch(captionOf(figure), /[{}]|undefined|not measured/, figure.id);
    assert.doesNotMatch(captionOf(figure, {}), /[{}]|undefined/, figure.id);
  }
});
