// Table 1 and the report, on small meshes.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { before, describe, test } from 'node:test';
import { loadPeers } from 'karcher/peers';
import { inRoot, load } from './load.mjs';

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

/** A worker with scripted answers. */
class StandIn {
  ended = false;
  jobs = [];
  #heard = {};
  #request;
  on(event, hear) {
    this.#heard[event] = hear;
  }
  postMessage(request) {
    this.#request = request;
    this.jobs.push(request.args[0]);
  }
  terminate() {
    this.ended = true;
  }
  tell(reply) {
    this.#heard.message({ id: this.#request.id, ...reply });
  }
  break(message) {
    this.#heard.error(new Error(message));
  }
  /** Calls the function of that name among the arguments. */
  send(event, ...args) {
    const { callback } = this.#request.args[1][event];
    this.tell({ callback, args });
  }
  place(method) {
    return { row: this.jobs.at(-1).rows[0].id, method, triangles: 500, segments: 1 };
  }
  begin(method) {
    this.send('method', this.place(method));
  }
  finish(method) {
    const result = { ok: true, reason: null, prepareMs: 1, traceMs: 1, dragMs: 1 };
    this.send('cell', { ...this.place(method), result });
  }
}

/** Waits until a worker's messages have arrived. */
const settled = () => new Promise((resolve) => setImmediate(resolve));

describe('the table on a page', () => {
  let TableClient;
  before(async () => {
    ({ TableClient } = await load('table/client.ts'));
  });

  /** A table of two rows, the workers that it started, and its cells. */
  function started(budgetMs) {
    const workers = [];
    const cells = [];
    let ends = 0;
    const events = {
      row: () => {},
      method: () => {},
      progress: () => {},
      cell: ({ row, method, result }) => cells.push([row, method, result.reason]),
      end: () => ends++,
    };
    const options = { rows: rows.tableRows.slice(0, 2), samples: 9, budgetMs };
    const client = new TableClient(options, events, () => {
      workers.push(new StandIn());
      return workers.at(-1);
    });
    client.run();
    return { client, workers, cells, ends: () => ends };
  }

  test('continues with a new worker after a failure, and says why', async () => {
    const { workers, cells, ends } = started(1e6);
    const [first, second] = rows.tableRows.map(({ id }) => id);
    workers[0].begin('vectorHeat');
    workers[0].finish('vectorHeat');
    workers[0].begin('affineHeat');
    workers[0].finish('affineHeat');
    workers[0].begin('weightedAverages');
    workers[0].break('out of memory');
    await settled();
    assert.equal(workers[0].ended, true);
    assert.deepEqual(workers[1].jobs[0].methods, ['paper', 'karcher', 'leveled']);
    for (const method of ['paper', 'karcher', 'leveled']) {
      workers[1].begin(method);
      workers[1].finish(method);
    }
    workers[1].tell({ result: undefined });
    await settled();
    assert.equal(workers[1].jobs[1].rows[0].id, second);
    // The mesh is missing, so that no method can run.
    workers[1].tell({ failure: { message: 'no such mesh', fatal: false } });
    await settled();
    assert.equal(ends(), 1);
    assert.equal(workers.length, 2);
    assert.deepEqual(cells, [
      [first, 'vectorHeat', null],
      [first, 'affineHeat', null],
      [first, 'weightedAverages', 'out of memory'],
      [first, 'paper', null],
      [first, 'karcher', null],
      [first, 'leveled', null],
      ...rows.tableMethods.map((method) => [second, method, 'no such mesh']),
    ]);
  });

  test('cuts off a step that takes too long', (context) => {
    context.mock.timers.enable({ apis: ['setTimeout'] });
    const { workers, cells } = started(5000);
    workers[0].begin('vectorHeat');
    context.mock.timers.tick(6999);
    assert.equal(workers[0].ended, false);
    context.mock.timers.tick(1);
    assert.equal(workers[0].ended, true);
    assert.deepEqual(cells, [[rows.tableRows[0].id, 'vectorHeat', 'stopped after 5 s']]);
    workers[1].begin('affineHeat');
    workers[1].finish('affineHeat');
    context.mock.timers.tick(60_000);
    assert.equal(workers[1].ended, false);
  });

  test('is cancelled inside a step', (context) => {
    context.mock.timers.enable({ apis: ['setTimeout'] });
    const { client, workers, cells, ends } = started(5000);
    workers[0].begin('vectorHeat');
    client.cancel();
    assert.equal(workers[0].ended, true);
    context.mock.timers.tick(60_000);
    assert.equal(workers.length, 1);
    assert.deepEqual(cells, []);
    assert.equal(ends(), 0);
  });
});

describe('the table', () => {
  test('estimates the time with a log map at each evaluation by the time of log maps alone', () => {
    const logMaps = { made: 10, asked: 200, ms: 30 };
    assert.equal(rows.asUsedMs({ traceMs: 100, logMaps }), 100 + 19 * 30);
    assert.equal(rows.asUsedMs({ traceMs: 100, logMaps: { ...logMaps, asked: 10 } }), 100);
    assert.equal(rows.asUsedMs({ traceMs: 100, logMaps: { made: 0, asked: 0, ms: 0 } }), null);
    assert.equal(rows.asUsedMs({ traceMs: 100, logMaps: null }), null);
    assert.equal(rows.asUsedMs({ traceMs: null, logMaps }), null);
  });

  test('measures every method in every row', async () => {
    const small = rows.smallRows(0.02).slice(0, 3);
    const { cells, events } = await measured(small);
    assert.deepEqual(
      events,
      small.flatMap(({ id }) => [id, ...rows.tableMethods]),
    );
    assert.equal(cells.length, 18);
    for (const { method, result, segments, triangles } of cells) {
      assert.equal(result.ok, true, `${method}: ${result.reason}`);
      const times = ['prepareMs', 'traceMs', 'fieldsMs', 'dragMs', 'dragFieldMs'];
      for (const key of times) assert.ok(result[key] >= 0, key);
      assert.ok(result.fieldsMs <= result.traceMs && result.dragFieldMs <= result.dragMs, method);
      assert.equal(result.fieldsMs > 0, ['paper', 'karcher', 'leveled'].includes(method), method);
      assert.ok(result.memory > 1000 && result.memory < 1e9, `${method}: ${result.memory} bytes`);
      const used = rows.asUsedMs(result);
      assert.equal(used !== null, ['vectorHeat', 'affineHeat'].includes(method), method);
      if (used !== null) {
        const { made, asked, ms } = result.logMaps;
        assert.ok(used >= result.traceMs && ms < result.traceMs, method);
        assert.ok(used < (result.traceMs * asked) / made, `${method}: ${used}`);
      }
      assert.equal(result.samples, 9 * segments);
      assert.ok(triangles >= 450 && triangles <= 1_100);
    }
  });

  test('has a residual and an energy for every method in the report', async () => {
    const { tableReport } = await load('report.ts');
    const chosen = rows.smallRows(0.02).slice(2, 3);
    const { text, cells } = await tableReport({ rows: chosen, samples: 9, budgetMs: 60_000 });
    const lines = text.split('\n').filter((line) => line.startsWith('| Genus 3'));
    assert.equal(lines.length, cells.length);
    for (const [k, { method, result }] of cells.entries()) {
      const [residual, energy] = lines[k].split(' | ').slice(-2).map(Number.parseFloat);
      const { ruler } = result;
      assert.ok(Math.abs(residual / ruler.residual.median - 1) < 0.01, `${method}: ${lines[k]}`);
      assert.ok(Math.abs(energy / ruler.energy.median - 1) < 0.01, `${method}: ${lines[k]}`);
    }
  });

  test('has rows from 500 to 500,000 triangles', () => {
    const sizes = rows.tableRows.map(({ mesh }) => rows.expectedTriangles(mesh));
    assert.equal(Math.min(...sizes), 500);
    assert.equal(Math.max(...sizes), 500_000);
    assert.equal(rows.tableRows.filter(({ points }) => points.length === 2).length, 2);
  });

  test('leaves missing values empty, and says why', async () => {
    const [row] = rows.smallRows(0.02).slice(2, 3);
    const { cells } = await measured([row], { budgetMs: -1, samples: 20_000 });
    const heat = cells.find(({ method }) => method === 'vectorHeat');
    assert.equal(heat.result.traceMs, null);
    assert.match(heat.result.reason, /stopped/);
    const about = { browser: 'a "browser", of a kind', build: '1.2.3', samples: 20_000 };
    const lines = csv(rows.tableRows, [heat], about).split('\n');
    assert.match(lines[0], /^browser,build,row,mesh,triangles,/);
    assert.match(lines[1], /^"a ""browser"", of a kind",1\.2\.3,/);
    assert.match(lines[1], /,"?Genus 3, simplified"?,simplified:1000:genus3:50000,/);
    assert.match(lines[1], /Vector heat,false,stopped after -?0 s,[0-9.]*,,,/);
  });

  test('has a chart with gaps for missing values', async () => {
    const { seriesOf } = await load('table/series.ts');
    const cell = (triangles, method, result) => ({
      row: '',
      method,
      triangles,
      segments: 4,
      result,
    });
    const cells = [
      cell(500, 'karcher', { ok: true, traceMs: 2 }),
      // The time is below a clock's step.
      cell(1000, 'karcher', { ok: true, traceMs: 0 }),
      cell(2000, 'karcher', { ok: false, traceMs: 3 }),
      cell(2000, 'paper', { ok: true, traceMs: 4 }),
    ];
    const [triangles, ...series] = seriesOf(cells, 'traceMs');
    assert.deepEqual(triangles, [500, 1000, 2000]);
    assert.deepEqual(series[rows.tableMethods.indexOf('karcher')], [2, null, null]);
    assert.deepEqual(series[rows.tableMethods.indexOf('paper')], [null, null, 4]);
  });

  test('ends when it is aborted', async () => {
    const signal = AbortSignal.abort(new Error('enough'));
    await assert.rejects(measured(rows.smallRows(0.02), {}, signal), /enough/);
  });
});

test('the report names every figure and every line', async () => {
  const { smallFigures } = await load('figures/index.ts');
  const { report } = await load('report.ts');
  const figures = smallFigures(0.02, 5).filter(({ id }) => ['circles', 'plane'].includes(id));
  const { text, panels } = await report(figures);
  for (const { name, title, panels } of figures) {
    assert.ok(text.includes(`## ${name}: ${title}`));
    for (const panel of panels) assert.ok(text.includes(`### ${panel.title}, `));
  }
  // Five numbers, with those by exact paths first, precede the counts, in a row beside level 0.
  const row = (name) =>
    new RegExp(`\\| ${name} \\| (?:[^|]+ \\| ){5}0 of 15 \\| 0 \\| 0 \\| [^|]+ \\| – \\|`);
  assert.match(text, /\| {2}\| residual h \| energy − reference’s h² \| median h \|/);
  for (const name of ['Karcher, level 0', 'Karcher, default']) assert.match(text, row(name));
  // The claims depend on these measurements.
  const karcher = panels['plane/grid'].find(({ id }) => id === 'karcher');
  assert.ok(karcher.ruler.residual.median < 1e-9);
  assert.equal('polylines' in karcher, false);
});

test('npm run paper refuses invalid numbers, and keeps the last report', () => {
  const report = inRoot('build/paper.md');
  const before = existsSync(report) ? readFileSync(report, 'utf8') : null;
  for (const [args, reason] of [
    [['--figure', 'none', '--table', 'abc'], /--table must be a number of triangles, not 'abc'/],
    [['--detail', 'abc'], /--detail must be over 0 and up to 1, not 'abc'/],
    [['--figure', 'none'], /^Nothing to write/],
  ]) {
    const command = [inRoot('.tools/paper.mjs'), '--built', ...args];
    const { status, stderr } = spawnSync(process.execPath, command, { encoding: 'utf8' });
    assert.equal(status, 1, `${args}`);
    assert.match(stderr, reason);
    assert.equal(existsSync(report) ? readFileSync(report, 'utf8') : null, before);
  }
});
