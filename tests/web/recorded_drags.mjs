// Records drags, or compares them with recorded ones, by the page's modules in Node. A change of the
// code for moving legs must not change these drags.
//
//   node tests/web/recorded_drags.mjs FILE              (writes the file)
//   node tests/web/recorded_drags.mjs FILE --against    (compares, and fails where they differ)
//
// There are 200 drags on five surfaces, of all kinds that have legs. Each is a walk of a control point
// over the surface, without a wait after some of the steps. The record has the levels, the statuses and
// the samples' places of each answer, and the legs after each drag.
import { readFileSync, writeFileSync } from 'node:fs';
import { load } from 'karcher';
import { openPage } from './engine_in_node.mjs';
import { randomFrom } from './part.mjs';

const [file, mode] = process.argv.slice(2);
const shapes = ['sphere', 'torus', 'knot', 'genus3', 'openSheet'];
const triangles = 2000;
const drags = 40;
const steps = 12;
/** The tolerance as a part of the diagonal. */
const tolerance = 1e-9;

// The duration of steps must not decide the levels.
performance.now = () => 0;

const cases = [
  ['bspline', {}],
  ['bspline', { degree: 2, closed: true }],
  ['bezier', {}],
  ['catmullrom', {}],
  ['catmullrom', { closed: true }],
  ['polyline', {}],
  ['polyline', { closed: true }],
  ['rational', {}],
  ['bspline', { levels: 3 }],
  ['bspline', { levels: 'limit' }],
];

function diagonalOf(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  });
  return Math.hypot(...low.map((value, axis) => high[axis] - value));
}

const answerOf = ({ curve, problem }) => ({
  problem,
  levels: curve?.levels ?? null,
  statuses: curve ? curve.samples.status.join() : null,
  places: curve ? Array.from(curve.samples.position) : [],
});

async function recorded(shape) {
  const mesh = (await load()).shape(shape, triangles);
  const positions = mesh.positions();
  const faces = mesh.triangles().length / 3;
  const diagonal = diagonalOf(positions);
  const random = randomFrom(20261126 + shapes.indexOf(shape));
  const below = (count) => Math.floor(random() * count);
  const page = await openPage({ positions, triangles: mesh.triangles() });
  const { editor, session, edits } = page;
  editor.onEnded = (figure) => session.ended(figure);
  const result = [];
  for (let k = 0; k < drags; k++) {
    const [kind, settings] = cases[k % cases.length];
    const first = { face: below(faces), bary: [0.3, 0.4, 0.3] };
    const size = diagonal * (0.05 + 0.25 * random());
    const places = [first];
    let turn = 0;
    for (let i = 1; i < 5; i++) {
      turn += random() * 2 - 1;
      const way = [Math.cos(turn), Math.sin(turn), random() - 0.5];
      places.push(mesh.straightest(places[i - 1], way, size).end);
    }
    editor.open(`${shape}:${k}`, page.emptyDrawing);
    editor.setKind(kind);
    for (const place of places) await edits.append(place);
    editor.setSettings({ ...settings, samples: 24 });
    await page.settled();
    const answers = [answerOf(session.view)];
    for (let drag = 0; drag < 2; drag++) {
      const index = below(places.length);
      let place = editor.state.figure.points[index];
      let heading = random() * 7;
      for (let step = 0; step < steps; step++) {
        heading += random() - 0.5;
        const way = [Math.cos(heading), Math.sin(heading), Math.sin(2 * heading)];
        place = mesh.straightest(place, way, 0.04 * diagonal).end;
        const from = editor.state.base.points[index];
        const to = { ...from, face: place.face, bary: place.bary };
        editor.preview({ type: 'change', index, from, to });
        if (random() < 0.2) continue;
        await page.settled();
        answers.push(answerOf(session.view));
      }
      await page.settled();
      editor.commitDrag();
      await page.settled();
      answers.push(answerOf(session.view));
    }
    const legs = editor.state.figure.points.map(({ leg }) => leg !== undefined && leg !== null);
    result.push({ shape, kind, diagonal, answers, legs });
  }
  session.client.close();
  return result;
}

function compared(before, after) {
  let worst = 0;
  let differ = 0;
  let answers = 0;
  before.forEach((one, i) => {
    const other = after[i];
    let isSame = one.answers.length === other.answers.length;
    one.answers.forEach((answer, j) => {
      const next = other.answers[j];
      answers++;
      const alike =
        next?.levels === answer.levels &&
        next.statuses === answer.statuses &&
        next.places.length === answer.places.length;
      isSame &&= alike;
      if (!alike) return;
      answer.places.forEach((value, at) => {
        const gap = Math.abs(value - next.places[at]) / one.diagonal;
        worst = Math.max(worst, gap);
        if (gap > tolerance) isSame = false;
      });
    });
    if (isSame) return;
    differ++;
    console.log(`drag ${i} of ${one.kind} on the ${one.shape} differs`);
  });
  const legs = (list) => list.flatMap((one) => one.legs).filter(Boolean).length;
  console.log(
    `${before.length} pairs of drags, ${answers} answers: ${differ} differ; the others by ${worst} diagonals at most; ` +
      `legs told: ${legs(before)} before, ${legs(after)} now`,
  );
  return differ === 0;
}

const all = [];
for (const shape of shapes) all.push(...(await recorded(shape)));
if (mode === '--against') {
  if (!compared(JSON.parse(readFileSync(file, 'utf8')), all)) process.exitCode = 1;
} else writeFileSync(file, JSON.stringify(all));
process.exit();
