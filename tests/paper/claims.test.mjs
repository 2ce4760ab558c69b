// The paper's claims and their verdicts.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, describe, test } from 'node:test';
import { loadPeers } from 'karcher/peers';
import { loadConfigFromFile } from 'vite';
import { aboutReport, kept, keptJson, measuredOf } from '../../.tools/paper_report.mjs';
import { digestOf, sourcesDigest } from '../../.tools/sources.mjs';
import { inRoot, load } from './load.mjs';

const verdicts = ['holds', 'does not', 'depends', 'settled here', 'open', 'not measured here'];
const nothing = { panels: {}, table: [], studies: {}, meshes: null, load: null };

let judge;
let claims;
before(async () => {
  ({ judge } = await load('claims/judge.ts'));
  ({ claims } = await load('claims/claims.ts'));
});

describe('claims', () => {
  test('every section with claims has a row, and every row an existing figure', async () => {
    const { figures } = await load('figures/index.ts');
    const known = [...figures.map(({ id }) => id), 'table', undefined];
    for (const { id, figure } of claims) assert.ok(known.includes(figure), id);
    assert.equal(new Set(claims.map(({ id }) => id)).size, claims.length);
    const places = ['Abstract', '1', '2', '3', '4', '5,', '5.1', '5.2', '6', 'Table 1'];
    for (const place of places) {
      assert.ok(
        claims.some(({ where }) => where.startsWith(place)),
        place,
      );
    }
    for (const number of [1, 3, 4, 5, 6, 7, 8]) {
      assert.ok(
        claims.some(({ where }) => where.includes(`Fig. ${number}`)),
        `Fig. ${number}`,
      );
    }
  });

  test('a claim without measurements has no verdict', () => {
    for (const row of judge(nothing)) assert.equal(row.verdict, 'not measured here', row.id);
  });

  test('the saved report has the present claims, a verdict and numbers each', () => {
    const report = JSON.parse(readFileSync(inRoot('docs/paper-report.json'), 'utf8'));
    assert.match(report.date, /^\d{4}-\d{2}-\d{2}$/);
    for (const key of ['machine', 'version']) assert.ok(report[key].length > 3, key);
    // The report marks the times of a busy machine.
    assert.match(report.machine, /, load \d+\.\d$/);
    assert.ok(Number.isInteger(report.seed));
    const asNow = ({ id, where, claim, figure }) => ({ id, where, claim, figure });
    assert.deepEqual(report.claims.map(asNow), claims.map(asNow));
    for (const { id, verdict, on, measured } of report.claims) {
      assert.ok(verdicts.includes(verdict), id);
      assert.notEqual(verdict, 'not measured here', id);
      assert.match(measured, /\d/, id);
      assert.equal(verdict === 'depends', Boolean(on), id);
    }
    assert.doesNotMatch(JSON.stringify(report), /\/(home|work|tmp|Users)\//);
  });
});

test('the saved verdicts and their sentences follow from the saved numbers', () => {
  const report = JSON.parse(readFileSync(inRoot('docs/paper-report.json'), 'utf8'));
  // Older reports have no meshes of a folder, which these rows need.
  const onMeshes = report.meshes === undefined ? ['against-averages'] : [];
  let followed = 0;
  for (const row of judge(measuredOf(report))) {
    if (row.verdict === 'not measured here' || onMeshes.includes(row.id)) continue;
    const { renewed: _, ...saved } = report.claims.find(({ id }) => id === row.id);
    assert.deepEqual(JSON.parse(JSON.stringify(row)), saved, 'npm run paper -- --judge');
    followed++;
  }
  const least = report.studies ? report.claims.length : 12;
  assert.ok(followed >= least, `${followed}`);
});

test('a saved report says what its verdicts depend on', () => {
  const studies = {
    ...{ oneCenter: { fieldsMs: 47.123456, centerMs: 0.0451234 }, roughness: [] },
    convergence: [{ error: 1 / 3 }],
  };
  const numbers = kept({ panels: {}, studies, meshes: null, load: { most: 1.2, cores: 2 } });
  const { convergence, roughness, ...others } = numbers.studies;
  const whole = { ...numbers, studies: others, plots: { convergence, roughness }, table: null };
  const claims = judge(measuredOf(whole));
  const saved = JSON.parse(keptJson({ claims, ...whole }));
  assert.deepEqual(JSON.parse(JSON.stringify(judge(measuredOf(saved)))), saved.claims);
  const row = saved.claims.find(({ id }) => id === 'one-center');
  assert.match(row.measured, /47 ms; another center of mass in them: 0\.045 ms/);
  assert.deepEqual(measuredOf(saved).studies.convergence, [{ error: 0.3333 }]);
});

describe('numbers older than the code that they judge', () => {
  test('are recognized by the digest of the sources, or by the commit if none was saved', async () => {
    const { isOlder } = await load('claims/saved.ts');
    const build = { version: '1.0.0 abc', sources: '12' };
    assert.equal(isOlder({ version: '1.0.0 abc', sources: '12' }, build), false);
    // Commits that leave the sources unchanged make nothing older.
    assert.equal(isOlder({ version: '0.9.0 def', sources: '12' }, build), false);
    assert.equal(isOlder({ version: '1.0.0 abc', sources: '34' }, build), true);
    assert.equal(isOlder({ version: '1.0.0 abc' }, build), false);
    assert.equal(isOlder({ version: '0.9.0 def' }, build), true);
  });

  test('do not include a report that is saved now, which has the digest of its sources', async () => {
    const { isOlder } = await load('claims/saved.ts');
    const sources = sourcesDigest();
    const report = {
      ...aboutReport({ seed: 16, sources, load: 0.25 }),
      claims: [],
      panels: { a: 1 / 3 },
    };
    const saved = JSON.parse(keptJson(report));
    assert.deepEqual(saved, { ...report, panels: { a: 0.3333 }, table: null });
    assert.equal(isOlder(saved, { version: 'another', sources }), false);
    assert.equal(isOlder(saved, { version: saved.version, sources: digestOf([['a', 'b']]) }), true);
  });

  test('have a digest that depends on names and lines, not on the machine', () => {
    const digest = digestOf([
      ['a.h', 'x\ny\n'],
      ['b.h', ''],
    ]);
    assert.equal(
      digestOf([
        ['b.h', ''],
        ['a.h', 'x\r\ny\r\n'],
      ]),
      digest,
    );
    for (const other of [
      [
        ['a.h', 'x\n'],
        ['b.h', 'y\n'],
      ],
      [
        ['a.h', 'x\ny\n'],
        ['c.h', ''],
      ],
      [['a.h', 'x\ny\n']],
    ]) {
      assert.notEqual(digestOf(other), digest);
    }
    assert.match(sourcesDigest(), /^[0-9a-f]{64}$/);
  });

  test('have a digest that does not depend on comments, but on strings that look like them', () => {
    const digest = (text) => digestOf([['a.h', text]]);
    const code = 'f("a // b");\nconst x = 1;\n';
    const commented = '/// Says f.\n/* and\nmore */ f("a // b");  // "here"\n\n  const x = 1;\n';
    assert.equal(digest(commented), digest(code));
    for (const [from, to] of [
      ['// b', '// c'],
      ['x = 1', 'x = 2'],
      ['f(', '// f('],
    ]) {
      assert.notEqual(digest(code.replace(from, to)), digest(code));
    }
  });

  test('are reported by the page, which is built with the digest of its sources', async () => {
    const command = { command: 'build', mode: 'production' };
    const { config } = await loadConfigFromFile(command, inRoot('vite.config.ts'));
    assert.equal(config.define.__KARCHER_SOURCES__, JSON.stringify(sourcesDigest()));
  });
});

/** The quick measurements: the lines of each panel that these claims depend on. */
const quickly = {
  'means/torus': ['paper', 'karcher'],
  'means/plane': ['paper', 'karcher'],
  'resolution/coarse': ['karcher'],
  'plane/fair': ['paper', 'paperGraph6', 'karcher'],
  'plane/delaunay': ['paper', 'paperGraph6', 'karcher'],
  'plane/grid': ['paper', 'paperGraph6', 'karcher'],
  'plane/anisotropic': ['paper', 'paperGraph6', 'karcher'],
};
const judgedByThese = ['four-points', 'regular', 'plane', 'bad-meshes'];

test('the saved report agrees with new measurements', async () => {
  const { figures } = await load('figures/index.ts');
  const { Lab } = await load('lab/lab.ts');
  const lab = new Lab(await loadPeers());
  const panels = {};
  for (const { id, panels: all, points } of figures) {
    for (const panel of all) {
      const lines = quickly[`${id}/${panel.id}`];
      if (!lines) continue;
      panels[`${id}/${panel.id}`] = await lab.lines({ ...panel, lines }, points[panel.points]);
    }
  }
  const report = JSON.parse(readFileSync(inRoot('docs/paper-report.json'), 'utf8'));
  const number = /\d+(?:\.\d+)?(?:e−\d+)?/g;
  const numbersOf = (text) => text.match(number).map((one) => Number(one.replace('−', '-')));
  for (const row of judge({ ...nothing, panels })) {
    if (!judgedByThese.includes(row.id)) continue;
    const saved = report.claims.find(({ id }) => id === row.id);
    assert.equal(row.verdict, saved.verdict, row.id);
    assert.equal(row.measured.replaceAll(number, '#'), saved.measured.replaceAll(number, '#'));
    const [now, then] = [row.measured, saved.measured].map(numbersOf);
    for (const [k, value] of now.entries()) {
      // Rounding differs: searches that nearly fail may succeed, and values near 0 change.
      const isCount = Number.isInteger(value) && Number.isInteger(then[k]);
      const rounding = isCount ? 20 : 1e-6;
      const most = Math.max(rounding, 0.1 * Math.max(value, then[k]));
      assert.ok(
        Math.abs(value - then[k]) <= most,
        `npm run paper -- --save: ${row.id} has ${value}, not ${then[k]}: ${row.measured}`,
      );
    }
  }
});

describe('studies', () => {
  test('Karcher’s condition is that of the sphere, by angles too', async () => {
    const { conditionOf, largestCurvature } = await load('claims/radius.ts');
    const { karcher } = await loadPeers();
    const mesh = karcher.shape('sphere', 20_000);
    const curvature = largestCurvature(mesh);
    mesh.dispose();
    assert.ok(curvature > 0.98 && curvature < 1.2, `${curvature}`);
    assert.equal(conditionOf(1, Math.PI), Math.PI / 4);
    // A thin tube has short loops.
    assert.equal(conditionOf(1, 0.1), 0.05);
  });

  test('a mean in a small ball is found from all points, and is unique', async () => {
    const { radius } = await load('claims/radius.ts');
    const rows = radius(await loadPeers(), 2);
    assert.equal(rows.length, 48);
    for (const row of rows) {
      assert.ok(row.same <= row.found && row.found <= row.cases);
      if (row.noise === 0 && row.radius < row.condition) assert.equal(row.same, row.cases);
    }
  });

  test('Newton’s searches add up, with the same curves from warm and cold starts', async () => {
    const { newton } = await load('claims/newton.ts');
    const only = ['a coarse torus', 'a plane of random points'];
    const rows = await newton(await loadPeers(), { curves: 2, only });
    assert.equal(rows.length, 8);
    for (const row of rows) {
      assert.equal(row.searches, row.start === 'warm' ? 128 : 130);
      assert.ok(row.inside <= row.converged && row.converged <= row.searches);
      assert.ok(row.shortened + row.stuck <= row.traced && row.needed <= row.shortened);
      assert.ok(row.half <= row.nearlyAll && row.nearlyAll <= row.most);
    }
    const steps = (start) =>
      rows.filter((row) => row.start === start).reduce((all, row) => all + row.traced, 0);
    assert.ok(steps('warm') < steps('cold'));
  });

  test('noise moves vertices by no more than its bound, and equally for equal seeds', async () => {
    const { roughened } = await load('claims/roughness.ts');
    const { karcher } = await loadPeers();
    const mesh = karcher.shape('torus', 500);
    const [smooth, rough] = [mesh.positions(), roughened(karcher, mesh, 0.2, 16).positions()];
    let most = 0;
    for (let v = 0; v < smooth.length; v += 3) {
      const step = [0, 1, 2].map((c) => rough[v + c] - smooth[v + c]);
      most = Math.max(most, Math.hypot(...step) / mesh.info.meanEdge);
    }
    assert.ok(most > 0.15 && most <= 0.2 + 1e-12, `${most}`);
    assert.deepEqual(roughened(karcher, mesh, 0.2, 16).positions(), rough);
    assert.notDeepEqual(roughened(karcher, mesh, 0.2, 17).positions(), rough);
  });

  test('an unknown mesh gets control points a tenth of its diagonal apart', async () => {
    const { wanderingPoints } = await load('claims/meshes.ts');
    const { karcher } = await loadPeers();
    const mesh = karcher.shape('sphere', 2000);
    const points = wanderingPoints(mesh, 16);
    assert.equal(points.length, 7);
    for (let k = 1; k < points.length; k++) {
      const { length } = mesh.shortestPath(points[k - 1], points[k]);
      assert.ok(Math.abs(length / mesh.info.diagonal - 0.1) < 0.001, `${length}`);
    }
    assert.notDeepEqual(wanderingPoints(mesh, 17), points);
  });
});
