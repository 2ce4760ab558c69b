// Saved numbers are reproducible: `npm run check:long` computes the Paper page's report and the
// studies that docs quote anew. It compares neither times nor verdicts that depend on them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { buildNative } from '../../.tools/build.mjs';
import { found, savedStudies, studyLines } from '../../.tools/saved_study.mjs';
import { inRoot, run } from '../../.tools/shell.mjs';
import { differences, isNear, lineDifferences } from './near.mjs';

const long = process.env.KARCHER_LONG === '1';
const json = (path) => JSON.parse(readFileSync(inRoot(path), 'utf8'));

describe('near values', () => {
  test('rounding is no difference, three per cent are', () => {
    assert.ok(isNear(1, 1.019) && !isNear(1.5, 1.55));
    assert.ok(isNear(1e-14, 3e-8) && !isNear(0, 1e-3));
    assert.ok(isNear(5, 8) && !isNear(5, 9) && isNear(500, 509));
    assert.ok(isNear('holds', 'holds') && !isNear('holds', 'open') && !isNear(null, 1.5));
  });

  test('a changed number is found anywhere, a changed time is not', () => {
    const report = json('docs/paper-report.json');
    assert.deepEqual(differences(report, report), []);
    const other = structuredClone(report);
    other.panels['far/bezier'][0].traceMs = 1e6;
    assert.deepEqual(differences(other, report), []);
    const line = other.panels['far/bezier'].find(({ id }) => id === 'leveled');
    line.sharpestTurn.degrees *= 1.1;
    assert.equal(differences(other, report).length, 1);
    delete other.panels['plane/grid'];
    assert.equal(differences(other, report).length, 2);
  });

  test('a changed cell of a table is found, one with a time is not', () => {
    const table = [
      ...['| a | exact: us | ns a vertex |', '| --- | --- | --- |', '| 1.5e-3 of 12 | 3.5 | 222 |'],
      'worst 4.8 %, in 3.5 ms, 2 s and 3 more',
    ];
    assert.deepEqual(lineDifferences(table, table), []);
    const other = (from, to) => table.map((line) => line.replace(from, to));
    assert.deepEqual(lineDifferences(other('3.5', '9.5'), table), []);
    assert.deepEqual(lineDifferences(other('222', '138'), table), []);
    assert.equal(lineDifferences(other('1.5e-3', '1.6e-3'), table).length, 1);
    assert.equal(lineDifferences(other('4.8', '5.8'), table).length, 1);
    assert.equal(lineDifferences(other('worst', 'best'), table).length, 1);
    assert.deepEqual(lineDifferences(other('3.5 ms, 2 s', '9 ms, 31.5 s'), table), []);
    assert.equal(lineDifferences(other('3 more', '9 more'), table).length, 1);
  });
});

describe('saved numbers', { skip: !long }, () => {
  for (const { study, arguments: saved, lines } of savedStudies()) {
    // The project has no mesh files.
    const { args, missing } = found(saved, process.env.KARCHER_MESHES);
    const skip =
      missing.length > 0 &&
      `not run: needs ${missing.join(', ')}, in the folder of npm run check:long -- --meshes`;
    if (long && skip) console.log(`npm run study -- ${study}: ${skip}`);
    test(`npm run study -- ${[study, ...saved].join(' ')}`, { skip }, async () => {
      await buildNative('native', `${study}_study`);
      const differing = lineDifferences(await studyLines(study, args), lines);
      const where = `--save writes it anew: ${differing.length} differ`;
      assert.deepEqual(differing.slice(0, 10), [], where);
    });
  }

  test('npm run paper', async () => {
    const saved = json('docs/paper-report.json');
    await run(process.execPath, ['.tools/paper.mjs', '--built'], { quiet: true, minutes: 60 });
    const now = json('build/paper.json');
    const numbers = ({ panels, table, plots }) => ({ panels, table, plots });
    const differing = differences(numbers(now), numbers(saved));
    const where = `--save writes it anew: ${differing.length} differ`;
    assert.deepEqual(differing.slice(0, 10), [], where);
    for (const { id, verdict } of now.claims) {
      // The row needs a quiet machine, or meshes outside the project.
      if (['open', 'not measured here'].includes(verdict)) continue;
      const before = saved.claims.find((claim) => claim.id === id);
      if (before.verdict !== 'open') assert.equal(verdict, before.verdict, id);
    }
  });
});
