// Verdicts follow from the numbers: a test of each rule on invented lines.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load } from './load.mjs';

const quiet = { most: 1.2, cores: 2 };
const busy = { most: 4.2, cores: 2 };
const nothing = { panels: {}, table: [], studies: {}, meshes: null, load: quiet };
let judge;
before(async () => {
  ({ judge } = await load('claims/judge.ts'));
});

const rowOf = (measured, id) => judge({ ...nothing, ...measured }).find((row) => row.id === id);

/** An empty line with the given fields. */
const line = (id, more) => ({
  ...{ id, ok: true, reason: null, prepareMs: 1, traceMs: 1, samples: 100, lost: 0 },
  ...{ lostByOwnRule: 0, deviation: null, turningNoise: null, breaks: 0, ruler: null },
  ...more,
});
const residual = (median) => ({
  ruler: { residual: { median, max: median }, measured: 33, of: 33 },
});
const deviation = (median, max = median) => ({ deviation: { median, max, samples: 100 } });

/** Lines of a method that failed before its first sample, and of one that lost all samples. */
const failed = (id) =>
  line(id, {
    ...{ ok: false, reason: 'it gave up', prepareMs: null, traceMs: null, samples: null },
    ...{ lost: null, lostByOwnRule: null, breaks: null },
  });
const allLost = (id) =>
  line(id, { ok: false, reason: 'no sample converged: noSolution', lost: 100, lostByOwnRule: 100 });

describe('descent on coarse meshes', () => {
  const found = (mesh, worse, pairs = 40) => ({
    ...{ mesh, pairs, worse, descent: 0.14, paper: 0.23, ours: 0.015 },
  });
  const of = (...descent) => rowOf({ studies: { descent } }, 'paths-descent');

  test('is judged by the number of worse pairs, compared with chance', () => {
    // Two standard deviations of 40 throws are 6.3.
    assert.equal(of(found('coarse', 27), found('fine', 20)).verdict, 'holds');
    assert.equal(of(found('coarse', 13), found('fine', 20)).verdict, 'does not');
    const row = of(found('coarse', 17), found('fine', 34));
    assert.equal(row.verdict, 'depends');
    assert.equal(
      row.on,
      'the pair: on the coarse mesh descent is worse as often as not, and on the fine mesh it is',
    );
    assert.match(
      row.measured,
      /coarse torus .* in 17 of 40 .* 0\.14, 0\.23 and 0\.015 h\); on the/,
    );
    assert.match(of(found('coarse', 13), found('fine', 34)).on, /^the mesh: .* it is$/);
  });

  test('is not measured on one mesh alone', () => {
    assert.equal(of(found('fine', 40)).verdict, 'not measured here');
  });
});

describe('more accurate than weighted averages, and slightly slower', () => {
  const panel = (paper, averages, traceMs = 1) => [
    line('paper', { ...residual(paper), traceMs }),
    line('paperGraph6', residual(paper)),
    line('karcher', residual(0.001)),
    line('weightedAverages', residual(averages)),
  ];
  const of = (panels, table = []) => rowOf({ panels, table }, 'against-averages');
  const cell = (method, traceMs) => ({
    ...{ row: 'torus', method, triangles: 9, segments: 4 },
    result: { ok: true, traceMs },
  });

  test('the nearer method is counted panel by panel', () => {
    assert.equal(of({ 'a/b': panel(1, 2), 'a/c': panel(1, 3) }).verdict, 'holds');
    assert.equal(of({ 'a/b': panel(2, 1), 'a/c': panel(3, 1) }).verdict, 'does not');
    const mixed = of({ 'a/b': panel(2, 1), 'a/c': panel(1, 3) });
    assert.equal(mixed.verdict, 'depends');
    assert.match(
      mixed.measured,
      /1 of 2 panels .* with exact distances on a\/b; with k = 6 on a\/b/,
    );
    assert.match(mixed.on, /not nearer in 2 of 4 cases/);
    assert.doesNotMatch(mixed.on, /time/);
  });

  test('the meshes of a folder count as well', () => {
    const method = (name, median) => ({
      method: name,
      result: { ok: true, lost: 0, samples: 9, ...residual(median) },
    });
    const mesh = (paper, exact, averages) => ({
      ...{ name: 'spot.obj', triangles: 9 },
      methods: [
        method('paper', paper),
        method('paperExact', exact),
        method('weightedAverages', averages),
        method('karcher', 0.01),
        method('leveled', 0.02),
        method('bSurf', 0.001),
      ],
    });
    const on = (...meshes) =>
      rowOf({ panels: { 'a/b': panel(1, 2) }, table: [], meshes }, 'against-averages');
    assert.equal(on(mesh(1, 1, 2)).verdict, 'holds');
    assert.match(on(mesh(1, 3, 2)).on, /not nearer in 1 of 4 cases/);
    const row = on(mesh(4, 3, 2));
    assert.match(row.on, /not nearer in 2 of 4 cases/);
    assert.match(
      row.measured,
      /both ways on spot; residuals .* spot 4, 3, 2, 0\.01, 0\.02, 0\.001\./,
    );
  });

  test('a tie is won by neither', () => {
    const row = of({ 'a/b': panel(1, 1), 'a/c': panel(1, 3) });
    assert.equal(row.verdict, 'depends');
    assert.match(row.measured, /weighted averages are nearer in none/);
    assert.equal(of({ 'a/b': panel(1, 1) }).verdict, 'does not');
  });

  test('the time decides as well', () => {
    assert.equal(of({ 'a/b': panel(1, 2, 2) }).verdict, 'holds');
    const slow = of({ 'a/b': panel(1, 2, 117) });
    assert.equal(slow.verdict, 'depends');
    assert.equal(slow.on, 'the time: 117 times as long is not slightly slower');
    const table = [cell('paper', 10), cell('weightedAverages', 8)];
    const mixed = of({ 'a/b': panel(1, 2, 117) }, table);
    assert.match(mixed.on, /117 times as long in the figures with exact distances is not slightly/);
    assert.match(
      mixed.measured,
      /117 times as long in the figures with exact distances and 1\.3 times as long in Table 1 with k = 6/,
    );
    table[0].result.traceMs = 24;
    assert.match(of({ 'a/b': panel(1, 2, 117) }, table).on, /at least 3 times as long is not/);
  });

  test('a method that failed has the largest residual, and no time', () => {
    const lines = panel(1, 2);
    lines[3] = failed('weightedAverages');
    assert.equal(of({ 'a/b': lines }).verdict, 'not measured here');
    assert.equal(of({ 'a/b': lines, 'a/c': panel(1, 3) }).verdict, 'holds');
    lines[0] = allLost('paper');
    const row = of({ 'a/b': lines, 'a/c': panel(1, 3) });
    assert.match(row.measured, /in 1 of 2 panels with exact distances/);
  });
});

describe('more stable than vector heat', () => {
  const cell = (method, traceMs, logMaps) => ({
    ...{ row: 'torus', method, triangles: 9, segments: 4 },
    result: { ok: true, traceMs, logMaps },
  });
  const table = [cell('paper', 1, null), cell('vectorHeat', 100, { made: 1, asked: 100, ms: 100 })];
  const of = (...lines) => rowOf({ panels: { 'a/b': lines }, table }, 'against-vector-heat');

  test('more lost samples decide, and equally many are not fewer', () => {
    const two = (heat, paper) =>
      of(line('vectorHeat', { lost: heat, lostByOwnRule: heat }), line('paper', { lost: paper }));
    assert.equal(two(5, 4).verdict, 'holds');
    assert.equal(two(5, 5).verdict, 'does not');
    assert.equal(two(4, 5).verdict, 'does not');
  });

  test('fewer lost samples by one rule alone depend on the rule', () => {
    const row = of(line('vectorHeat', { lost: 5, lostByOwnRule: 3 }), line('paper', { lost: 4 }));
    assert.equal(row.verdict, 'depends');
    assert.match(row.on, /counted: by its library’s rule vector heat loses fewer/);
  });

  test('the times are distinguished: as in the library, and with log maps kept', () => {
    const lines = [line('vectorHeat', { lost: 5, lostByOwnRule: 5 }), line('paper', { lost: 4 })];
    const timed = (traceMs, asked) =>
      rowOf(
        {
          panels: { 'a/b': lines },
          table: [table[0], cell('vectorHeat', traceMs, { made: 1, asked, ms: traceMs })],
        },
        'against-vector-heat',
      );
    assert.equal(timed(100, 100).verdict, 'holds');
    assert.match(
      timed(2, 100).on,
      /^whether log maps are kept; as the library has it, vector heat/,
    );
    assert.equal(timed(2, 5).on, 'the time: 10 times is no orders');
  });

  test('a method that failed has lost all samples', () => {
    for (const one of [failed, allLost]) {
      const row = of(line('vectorHeat', { lost: 5 }), one('paper'));
      assert.equal(row.verdict, 'does not');
      assert.match(row.measured, /the paper’s method 100 of 100\./);
      assert.match(row.measured, /Failed, so that all of its samples count as lost: paper of a\/b/);
    }
    const none = of(failed('vectorHeat'), failed('paper'));
    assert.equal(none.verdict, 'not measured here');
  });
});

describe('a B-spline on a coarse and on a fine mesh', () => {
  const degree = Math.PI / 180;
  const lines = ({ paper = 0.5, averages = 0.5, heat = 0.4, ms = 9 }) => [
    line('paperGraph6', { turningNoise: paper * degree, ...residual(1) }),
    line('weightedAverages', { turningNoise: averages * degree, ...residual(2) }),
    line('vectorHeat', { turningNoise: heat * degree, traceMs: ms }),
    line('karcher', { turningNoise: 0 }),
  ];
  const of = (coarse, fine) =>
    rowOf(
      { panels: { 'resolution/coarse': lines(coarse), 'resolution/fine': lines(fine) } },
      'resolution',
    );

  test('holds if all of its parts do, and states the limits', () => {
    const row = of({}, {});
    assert.equal(row.verdict, 'holds');
    assert.match(row.measured, /0\.5°, 0\.5°, 0\.4°, 0° on coarse; .* up to 1° counts as smooth/);
  });

  test('has a reason for each part that fails', () => {
    assert.match(of({ paper: 1.1, heat: 1.1 }, {}).on, /^the mesh: the paper’s curve .* coarse$/);
    assert.match(of({}, { averages: 1.1 }).on, /^the mesh: weighted averages’ is not on fine$/);
    assert.match(of({ heat: 0.2 }, {}).on, /^the mesh: vector heat’s does not turn .* on coarse$/);
    assert.match(
      of({ ms: 1 }, { ms: 1 }).on,
      /vector heat, its log maps kept, is not slow on coarse and fine$/,
    );
    const bad = { paper: 9, averages: 9, heat: 1, ms: 1 };
    assert.equal(of(bad, bad).verdict, 'does not');
    const row = of({ paper: 9, averages: 9, heat: 1 }, {});
    assert.equal(row.on.split(';').length, 3);
  });
});

describe('most stable on fairly regular triangles with exact distances', () => {
  const lines = ([exact, graph], [of, sixth] = [0.1, 0.2]) => [
    line('paper', { lost: exact, ...residual(of) }),
    line('paperGraph6', { lost: graph, ...residual(sixth) }),
    line('karcher', residual(0.01)),
  ];
  const of = (fair, delaunay, anisotropic) =>
    rowOf(
      {
        panels: {
          'plane/fair': fair,
          'plane/delaunay': delaunay,
          'plane/anisotropic': anisotropic,
        },
      },
      'regular',
    );

  test('holds if it does on each mesh, and names the deciding numbers', () => {
    const row = of(lines([0, 1]), lines([2, 3]), lines([4, 5]));
    assert.equal(row.verdict, 'holds');
    assert.match(
      row.measured,
      /0 of 100 \(0\.1 h\) and 1 of 100 \(0\.2 h\) on triangles of fairly/,
    );
  });

  test('a tie of lost samples is settled by residuals, and a tie of both by none', () => {
    assert.equal(of(lines([0, 0]), lines([2, 3]), lines([4, 5])).verdict, 'holds');
    const tie = of(lines([0, 0], [0.1, 0.1]), lines([2, 3]), lines([4, 5]));
    assert.equal(tie.verdict, 'depends');
    assert.match(tie.on, /exact distances are not steadier than k = 6 on triangles of fairly/);
    const same = [0.1, 0.1];
    const all = of(lines([0, 0], same), lines([0, 0], same), lines([0, 0], same));
    assert.equal(all.verdict, 'does not');
  });

  test('exact distances are compared with k = 6 on each mesh', () => {
    const row = of(lines([0, 1]), lines([62, 17]), lines([259, 294]));
    assert.equal(row.verdict, 'depends');
    assert.match(row.on, /not steadier than k = 6 on triangles of random points$/);
  });

  test('a method that failed is not the steadiest', () => {
    const fair = lines([0, 1]);
    fair[0] = failed('paper');
    const row = of(fair, lines([2, 3]), lines([4, 5]));
    assert.equal(row.verdict, 'depends');
    assert.match(
      row.measured,
      /100 of 100 and 1 of 100 .* Failed, so that all .*paper of plane\/fair/,
    );
  });
});

describe('Figure 8', () => {
  const graph = (lost, max, turningNoise) =>
    line('paperGraph6', { lost, ...deviation(max), turningNoise });
  const exact = line('paper', { lost: 0, ...deviation(0), turningNoise: 0 });
  const ours = line('karcher', { ...deviation(0), turningNoise: 0 });
  const of = ({ fair = graph(0, 0.2, 0), grid = 0.02, stretched = graph(50, 1, 0.1) }) =>
    rowOf(
      {
        panels: {
          'plane/fair': [fair, exact, ours],
          'plane/delaunay': [graph(9, 1, 0.1), exact, ours],
          'plane/grid': [graph(0, 0.3, grid), exact, ours],
          'plane/anisotropic': [stretched, exact, ours],
        },
      },
      'plane',
    );

  test('is judged with the graph, as in the paper, and names the deciding numbers', () => {
    const row = of({});
    assert.equal(row.verdict, 'holds');
    assert.match(
      row.measured,
      /k = 6.* grid 0\.3 h and 0\.02 rad .* exact distances: .* wiggles are more than 0\.01 rad/,
    );
    assert.match(of({ grid: 0.01 }).on, /^the part: no wiggles on the grid$/);
    assert.match(of({ fair: graph(0, 0.5, 0) }).on, /not right on the fair mesh$/);
    assert.match(of({ fair: graph(0, 0.2, 0.09) }).on, /^the part: wiggles on the fair mesh, too$/);
    const still = of({ stretched: graph(0, 1, 0) });
    assert.match(still.on, /no wiggles on the anisotropic mesh; no breaks on the anisotropic mesh/);
  });

  test('a method that failed is not right', () => {
    assert.match(of({ fair: failed('paperGraph6') }).on, /not right on the fair mesh/);
    assert.equal(of({ stretched: allLost('paperGraph6') }).verdict, 'holds');
  });
});

test('a failure on bad meshes counts against ours', () => {
  const good = line('karcher', residual(0.01));
  const of = (one) => {
    const panels = { 'plane/anisotropic': [one, line('paper')], 'plane/delaunay': [good] };
    return rowOf({ panels: { ...panels, 'resolution/coarse': [good] } }, 'bad-meshes');
  };
  // The paper leaves the question open, so no claim holds.
  assert.equal(of(good).verdict, 'settled here');
  for (const one of [failed, allLost]) {
    assert.equal(of(one('karcher')).verdict, 'depends');
    assert.match(of(one('karcher')).measured, /100 of 100 on plane\/anisotropic/);
  }
});

test('a circle of arcs: nearer and smoother are judged separately', () => {
  const of = (arcs, linear) =>
    rowOf(
      {
        panels: {
          'circles/circle': [
            line('circleArcs', { ...deviation(arcs[0]), turningNoise: arcs[1] }),
            line('isolineLinear', { ...deviation(linear[0]), turningNoise: linear[1] }),
          ],
        },
        studies: { arcs: [{ arcs: 7, worst: 0.02, byDefault: 0.01 }] },
      },
      'circle',
    );
  assert.equal(of([1, 0.1], [2, 0.3]).verdict, 'holds');
  assert.match(
    of([1, 0.1], [2, 0.3]).measured,
    /Eq\. 4 \(level 0\) and by our default, 2 % and 1 %/,
  );
  assert.equal(of([2, 0.1], [2, 0.3]).on, 'what is asked: smoother, but not nearer to the radius');
  assert.match(of([1, 0.2], [2, 0.3]).on, /smoother, but not much$/);
  assert.equal(of([1, 0.3], [2, 0.3]).verdict, 'does not');
});

test('too far: leaps in a drag are named if they were measured', () => {
  const ids = ['vectorHeat', 'weightedAverages', 'bSurf', 'paper', 'karcher', 'bridged', 'leveled'];
  const of = (drag) => {
    const lines = ids.map((id) => line(id, { breaks: 1, drag }));
    return rowOf({ panels: { 'far/bspline': lines, 'far/bezier': lines } }, 'too-far').measured;
  };
  assert.match(of({ steps: 20, leaps: 3, most: 7.31 }), /drag .* b\/Surf 6 of 40 \(×7\.3\)/);
  assert.doesNotMatch(of(null), /drag/);
});

test('the armadillo needs a mesh of that name', () => {
  const of = (prepareMs, reason = 'folds') => {
    const result = { prepareMs, lost: 1, samples: 9, reason, ruler: null };
    const methods = [{ method: 'weightedAverages', result }];
    return rowOf({ meshes: [{ name: 'armadillo.obj', triangles: 7, methods }] }, 'table').verdict;
  };
  // Another program's success says nothing about that of the authors.
  assert.equal(of(3), 'depends');
  assert.equal(of(null), 'holds');
  assert.equal(of(null, 'stopped after 120 s'), 'not measured here');
  assert.equal(rowOf({ meshes: [] }, 'table').verdict, 'not measured here');
});

describe('resilient to roughness', () => {
  const point = (method, lost) => ({ noise: 0.4, method, lost, samples: 100, residual: 0.2 });
  const of = (lost, onMesh, lostApart = 30) => {
    const method = (name, count) => ({
      method: name,
      result: { ok: true, lost: count, samples: 200, ...residual(0.3) },
    });
    const methods = [method('paper', 0), method('paperExact', onMesh), method('karcher', 0)];
    const meshes = onMesh === null ? null : [{ name: 'armadillo.obj', triangles: 9, methods }];
    const panels = {
      'far/bspline': [line('paper', { lost: 20 })],
      'far/bezier': [line('paper', { lost: 3 })],
    };
    const roughness = [point('paper', lost), point('karcher', 0)];
    const spread = [2, 14].map((apart) => ({
      ...{ apart, noise: 0.4, method: 'paper', breaks: 0, samples: 100 },
      lost: apart > 2 ? lostApart : 0,
    }));
    return rowOf({ panels, studies: { roughness, spread }, meshes }, 'roughness');
  };

  test('the armadillo counts if it is available', () => {
    assert.equal(of(0, null).verdict, 'holds');
    assert.equal(of(0, 0).verdict, 'holds');
    assert.equal(of(0, 1).on, 'how rough: some samples are lost on the armadillo');
    assert.match(
      of(0, 1).measured,
      /armadillo of 9 triangles: .* exact distances 0\.3 h and 1 lost/,
    );
    assert.match(of(1, 1).on, /where the noise is largest and on the armadillo$/);
    assert.equal(of(6, null).on, 'it is not resilient');
    assert.equal(of(6, 11).on, 'it is not resilient');
    assert.equal(of(6, 0).verdict, 'depends');
  });

  test('large distances are measured too', () => {
    assert.match(of(0, null, 0).on, /^how large distances are: .* and not in Fig\. 7$/);
    assert.match(of(0, null).measured, /In Fig\. 7, .* loses 23\.$/);
    assert.equal(of(6, null, 0).verdict, 'does not');
    assert.match(of(0, null).measured, /far apart .* the paper 0 and 0 at 2 h, 30 and 0 at 14 h/);
  });
});

describe('scales better than both', () => {
  const of = (times, load = quiet) => {
    const growth = Object.entries(times).flatMap(([method, all]) =>
      all.map((ms, k) => ({ method, triangles: 1_000 * 4 ** k, ms, reason: 'it gave up' })),
    );
    return rowOf({ studies: { growth }, load }, 'scales');
  };
  const heat = [800, 3_000, 34_000];
  const paper = [800, 3_200, 12_700];
  const averages = [10_000, 18_000, 73_000];
  const karcher = [1, 2, 4];

  test('holds against one and depends against the other', () => {
    const row = of({ vectorHeat: heat, weightedAverages: averages, paper, karcher });
    assert.equal(row.verdict, 'depends');
    assert.equal(
      row.on,
      'the other method: against vector heat it holds; against weighted averages it is quicker at these sizes, but does not grow more slowly',
    );
    const steep = averages.map((ms, k) => ms * 4 ** k);
    const both = { vectorHeat: heat, weightedAverages: steep, paper, karcher };
    assert.equal(of(both).verdict, 'holds');
    const slow = paper.map((ms, k) => ms * 20 ** k);
    const worse = of({ vectorHeat: heat, weightedAverages: averages, paper: slow, karcher });
    assert.equal(worse.verdict, 'does not');
  });

  test('a failed row decides nothing', () => {
    const lost = [...heat.slice(0, 2), null];
    const row = of({ vectorHeat: lost, weightedAverages: averages, paper, karcher });
    // The two available sizes decide.
    assert.match(row.on, /against vector heat it does not; against weighted/);
    assert.match(row.measured, /vector heat 800 ms, 3,000 ms, failed/);
    const never = [800, null, null];
    const one = of({ vectorHeat: never, weightedAverages: averages, paper, karcher });
    assert.equal(one.on.includes('vector heat'), false);
    assert.equal(of({ vectorHeat: never, paper, karcher }).verdict, 'not measured here');
  });

  test('a busy machine leaves it open, and says so', () => {
    const row = of({ vectorHeat: heat, weightedAverages: averages, paper, karcher }, busy);
    assert.equal(row.verdict, 'open');
    assert.match(
      row.measured,
      /not quiet \(load 4\.2 on 2 cores\): what depends on time stays open/,
    );
  });
});

test('on a busy machine claims without times are judged as usual', () => {
  const oneCenter = { fieldsMs: 100, centerMs: 1 };
  assert.equal(rowOf({ studies: { oneCenter } }, 'one-center').verdict, 'holds');
  for (const load of [busy, null]) {
    assert.equal(rowOf({ studies: { oneCenter }, load }, 'one-center').verdict, 'open');
    const large = [{ method: 'paper', triangles: 9, prepareMs: 1, dragMs: 1, reason: null }];
    assert.equal(rowOf({ studies: { large }, load }, 'interactive').verdict, 'open');
  }
  const heat = line('vectorHeat', { lost: 1, lostByOwnRule: 1 });
  const lines = (lost) => ({ 'a/b': [heat, line('paper', { lost })] });
  const cell = (method, traceMs) => ({
    ...{ row: 'torus', method, triangles: 9, segments: 4 },
    result: { ok: true, traceMs, logMaps: { made: 1, asked: 100, ms: traceMs } },
  });
  const table = [cell('paper', 1), cell('vectorHeat', 100)];
  const of = (lost) => rowOf({ panels: lines(lost), table, load: busy }, 'against-vector-heat');
  assert.equal(of(0).verdict, 'open');
  assert.equal(of(1).verdict, 'does not');
  assert.doesNotMatch(of(1).measured, /quiet/);
});

test('a failure on a large mesh says nothing about time', () => {
  const large = [{ method: 'paper', triangles: 9, prepareMs: null, dragMs: null, reason: 'no' }];
  assert.equal(rowOf({ studies: { large } }, 'interactive').verdict, 'not measured here');
});

test('rational curves: leaps are named, and none is a reason', () => {
  const of = (breaks) => {
    const panels = Object.fromEntries(
      ['equal', 'pulled', 'barycentric', 'loose'].map((name) => [
        `rational/${name}`,
        [line('paper', { breaks }), line('bSurf', deviation(0.01))],
      ]),
    );
    const studies = { reweigh: { fieldsMs: 0, updateMs: 1 } };
    return rowOf({ panels, studies }, 'rational');
  };
  assert.equal(of(0).on, 'the part: subdivision can make rational curves');
  assert.match(of(0).measured, /loses 0 samples of the four curves, which leap at 0 places/);
  assert.match(of(1).on, /^the part: the curves leap; subdivision/);
});

test('Karcher’s condition: the multiple of its radius up to which all centers are found and equal', () => {
  const at = (noise, radius, found, same, condition = noise > 0 ? 0.1 : 0.5) => ({
    ...{ surface: 'sphere', noise, condition, radius, cases: 12, found, same },
  });
  const of = (...radius) => rowOf({ studies: { radius } }, 'far-stronger');
  assert.equal(of(at(0, 1.1, 12, 12), at(0.2, 1.1, 12, 12)).verdict, 'holds');
  assert.equal(of(at(0, 0.4, 12, 12), at(0, 1.1, 12, 11)).verdict, 'does not');
  // A radius beyond one that fails decides nothing.
  assert.equal(of(at(0, 0.4, 12, 11), at(0, 1.1, 12, 12)).verdict, 'does not');
  const mixed = of(at(0, 0.6, 12, 12), at(0, 1.1, 12, 9), at(0.2, 0.8, 12, 12), at(0.2, 1, 11, 9));
  assert.equal(mixed.verdict, 'depends');
  assert.equal(
    mixed.on,
    'the surface: the radius is 1.2 times on a smooth sphere, 8 times on a sphere with bumps of 0.2 h',
  );
  assert.match(
    mixed.measured,
    /smooth sphere, where the condition ends at 0\.5, all are found up to 2\.2 and alike up to 1\.2 times that radius; on a sphere with bumps/,
  );
  assert.equal(of().verdict, 'not measured here');
});

describe('Newton’s method', () => {
  const row = (mesh, more) => ({
    ...{ mesh, triangles: 9, distances: 'exact', start: 'warm', searches: 100, converged: 100 },
    ...{ half: 1, nearlyAll: 2, most: 3, traced: 50, shortened: 5, needed: 1, stuck: 0 },
    ...{ inside: 100, order: null },
    ...more,
  });
  const of = (...newton) => rowOf({ studies: { newton } }, 'newton');

  test('holds where steps are few, a joint is always better, and triangles hold all zeros', () => {
    const held = of(row('a torus'), row('a torus', { start: 'cold', nearlyAll: 40, order: 1.2 }));
    assert.equal(held.verdict, 'holds');
    assert.match(
      held.measured,
      /with a warm start half of 100 searches take at most 1 iterations, 99 in 100 2 and all 3, on the worst mesh, and 0 are lost; with a cold start .* order of 1\.2 to 1\.2/,
    );
    assert.match(
      held.measured,
      /Of 100 geodesics 10 are taken to a joint .*, 2 of these .* ends 200 of 200/,
    );
  });

  test('depends on the mesh, and names each part', () => {
    const three = [row('a torus'), row('a sphere'), row('a knot')];
    assert.equal(
      of(...three, row('a plane', { converged: 99, inside: 99, stuck: 4 })).on,
      'the mesh: searches are lost on a plane; no joint has a smaller gradient, now and then, on a plane',
    );
    assert.match(
      of(...three, row('a plane', { inside: 99 })).on,
      /between triangles end some on a/,
    );
    assert.match(of(...three, row('a plane', { nearlyAll: 11 })).on, /take many steps on a plane$/);
    const stuck = { stuck: 1 };
    assert.match(of(row('a torus'), row('b', stuck), row('c', stuck)).on, /on all but a torus$/);
    assert.match(of(row('b', stuck)).on, /on all$/);
  });

  test('does not hold if searches are lost, or take many steps, everywhere', () => {
    const lost = { converged: 60, inside: 60 };
    assert.equal(of(row('a', lost), row('b', lost)).verdict, 'does not');
    assert.equal(of(row('a', { nearlyAll: 30 })).verdict, 'does not');
    // Cold starts decide nothing.
    assert.equal(of(row('a'), row('a', { start: 'cold', nearlyAll: 30 })).verdict, 'holds');
    assert.equal(of(row('a', { start: 'cold' })).verdict, 'not measured here');
  });
});
