// Table 1 and the report, on small meshes.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { loadPeers } from 'karcher/peers';
import { load } from './load.mjs';

let rows;
let run;
let csv;
let peers;
before(async () => {
  rows = await load('table/rows.ts');
  run = (await load('table/run.ts')).runTable;
  csv = (await load('table/csv.ts')).tableCsv;
  peers = await loadPeers();
});

/** Runs some rows and returns the cells, and the names of the events. */
async function measured(chosen, options = {}, signal = undefined) {
  const cells = [];
  const events = [];
  await run(
    peers,
    { rows: chosen, samples: 9, budgetMs: 60_000, ...options },
    {
      row: (row) => events.push(row.id),
      method: ({ method }) => events.push(method),
      progress: () => {},
      cell: (cell) => cells.push(cell),
    },
    signal,
  );
  return { cells, events };
}

describe('the table', () => {
  test('measures every method in every row', async () => {
    const small = rows.smallRows(0.02).slice(0, 3);
    const { cells, events } = await measured(small);
    assert.deepEqual(
      events,
      small.flatMap(({ id }) => [id, ...rows.tableMethods]),
    );
    assert.equal(cells.length, 12);
    for (const { method, result, segments, triangles } of cells) {
      assert.equal(result.ok, true, `${method}: ${result.reason}`);
      for (const key of ['prepareMs', 'traceMs', 'dragMs']) assert.ok(result[key] >= 0, key);
      assert.equal(result.samples, 9 * segments);
      assert.ok(triangles >= 450 && triangles <= 1_100);
    }
  });

  test('has rows from 500 to 500,000 triangles', () => {
    const sizes = rows.tableRows.map(({ mesh }) => rows.expectedTriangles(mesh));
    assert.equal(Math.min(...sizes), 500);
    assert.equal(Math.max(...sizes), 500_000);
    assert.equal(rows.tableRows.filter(({ points }) => points.length === 2).length, 2);
  });

  test('leaves empty what a method did not do, and says why', async () => {
    const [row] = rows.smallRows(0.02).slice(2, 3);
    const { cells } = await measured([row], { budgetMs: -1, samples: 20_000 });
    const heat = cells.find(({ method }) => method === 'vectorHeat');
    assert.equal(heat.result.traceMs, null);
    assert.match(heat.result.reason, /stopped/);
    const about = { browser: 'a "browser", of a kind', build: '1.2.3', samples: 20_000 };
    const lines = csv(rows.tableRows, [heat], about).split('\n');
    assert.match(lines[0], /^browser,build,row,mesh,triangles,/);
    assert.match(lines[1], /^"a ""browser"", of a kind",1\.2\.3,/);
    assert.match(lines[1], /Vector heat,false,stopped after -?0 s,[0-9.]*,,,/);
  });

  test('ends when it is told to', async () => {
    const signal = AbortSignal.abort(new Error('enough'));
    await assert.rejects(measured(rows.smallRows(0.02), {}, signal), /enough/);
  });
});

test('the report names every figure and every line', async () => {
  const { smallFigures } = await load('figures/index.ts');
  const { report } = await load('report.ts');
  const figures = smallFigures(0.02, 5).filter(({ id }) => ['circles', 'plane'].includes(id));
  const text = await report(figures);
  for (const { name, title, panels } of figures) {
    assert.ok(text.includes(`## ${name}: ${title}`));
    for (const panel of panels) assert.ok(text.includes(`### ${panel.title}, `));
  }
  assert.match(text, /\| Karcher \| [^|]+ \| [^|]+ \| [^|]+ \| 0 of 15 \|/);
});
