// Quotations of studies in README and docs equal the output saved in docs/studies (`npm run study
// -- --save NAME`), and quotations of one text in another equal the original.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { quotedRows, quotedTables } from '../../.tools/quoted_tables.mjs';
import { rowsOf, savedLines } from '../../.tools/saved_study.mjs';
import { inRoot } from '../../.tools/shell.mjs';

const linesOf = (name) => readFileSync(inRoot(name), 'utf8').split('\n');
const textOf = (name) => linesOf(name).join(' ').replaceAll(/\s+/g, ' ');
const readme = textOf('README.md');

/** The parts of a text in the groups of the pattern, which must match. */
function told(name, pattern) {
  const found = pattern.exec(textOf(name));
  assert.ok(found, `${name} has another sentence: this test is to read it: ${pattern}`);
  return found.slice(1);
}

describe('tables equal the output of the study', () => {
  for (const table of quotedTables) {
    const { doc, head, at = 0 } = table;
    test(`${doc}: ${head}${at > 0 ? `, ${at + 1}` : ''}`, () => {
      const rows = table.rows();
      assert.ok(rows.length > 3, 'a study that printed next to nothing');
      assert.deepEqual(quotedRows(table), rows, 'npm run study -- --save writes it');
    });
  }
});

describe('accuracy', () => {
  const saved = rowsOf(savedLines('accuracy'));
  const short = (value) => {
    if (value < 1e-4) return value.toExponential(0);
    return `${Number(value.toPrecision(value < 1e-3 ? 1 : 2))}`;
  };
  /** The distance in mean edges and the lost samples on the finest mesh. */
  const at = (surface, fields) => {
    const rows = saved.filter(([one, , other]) => one === surface && other === fields);
    assert.equal(rows.length, 3, `${surface}: ${fields}`);
    const [, , , rms, , , , , , lost] = rows.at(-1);
    return { rms: short(Number(rms)), lost: Number(lost) };
  };
  const columns = ["paper, exact, authors' seeds", 'default', 'log, fast', 'log, exact'];
  const meshes = {
    'plane, Delaunay of random points': 'plane: Delaunay of random points',
    'plane, stretched 20:1': 'plane: stretched 20:1',
    'sphere, relaxed random points': 'sphere: relaxed random points',
    'sphere, random points': 'sphere: random points, convex hull',
    'torus, irregular': 'torus: isotropic irregular',
    'torus, stretched 8:1': 'torus: stretched 8:1',
  };

  test('the table of methods equals the output of the study', () => {
    let samples = ' of 384 samples';
    const expected = Object.entries(meshes).map(([name, surface]) => {
      const cells = columns.map((fields) => {
        const { rms, lost } = at(surface, fields);
        if (lost === 0) return rms;
        const told = `${rms}, ${lost}${samples} lost`;
        samples = ' of 384';
        return told;
      });
      return [name, ...cells];
    });
    assert.deepEqual(quotedRows({ doc: 'docs/methods.md', head: '| mesh | paper' }), expected);
  });

  test('README quotes it correctly', () => {
    const [plane, lost, sphere, paper] = told(
      'README.md',
      /stretched 20:1 are off by (\S+) mean edges, where the paper's fields lose (\d+) of 384 samples\. On a sphere of relaxed random points the default is off by (\S+) mean edges, the paper's fields by (\d\.\d+)/,
    );
    const [byPaper, byDefault] = columns;
    assert.equal(at('plane: stretched 20:1', byDefault).rms, plane);
    assert.equal(at('plane: stretched 20:1', byPaper).lost, Number(lost));
    assert.equal(at('sphere: relaxed random points', byDefault).rms, sphere);
    assert.equal(at('sphere: relaxed random points', byPaper).rms, paper);
  });
});

describe('the gallery', () => {
  const saved = rowsOf(savedLines('gallery'));
  const heads = {
    mesh: 0,
    worst: 2,
    mean: 3,
    rotated: 6,
    exactRotated: 9,
    fastUs: 10,
    exactUs: 11,
  };
  const most = (key, rows = saved) =>
    rows.toSorted((a, b) => Number(b[heads[key]]) - Number(a[heads[key]]))[0];
  const spread = (key) => {
    const all = saved.map((row) => Number(row[heads[key]])).toSorted((a, b) => a - b);
    return [all[0], all.at(-1), all[Math.floor(all.length / 2)]];
  };

  test('the stated errors of the fast solver are its worst ones', () => {
    const [worst, mesh, mean, ofMean] = told(
      'docs/gallery.md',
      /the worst error is (\S+) % \((.*?)\), the largest mean (\S+) \((.*?)\)/,
    );
    const percent = (100 * Number(most('worst')[2])).toPrecision(2);
    assert.deepEqual([worst, mesh], [percent, most('worst')[0]]);
    assert.deepEqual([Number(mean), ofMean], [Number(most('mean')[3]), most('mean')[0]]);
    const again = told(
      'docs/algorithms/distances.md',
      /the worst relative error of `fast` is (\S+) %, its largest mean (\S+),/,
    );
    assert.deepEqual(again, [worst, mean]);
    const [count, pairs, by] = told(
      'docs/gallery.md',
      /(\d+) have a pair off by more than 2 % \(at most (\S+) % of a sheet's pairs, the worst by (\S+) %\)/,
    );
    assert.match(
      savedLines('gallery', ['--random', '100']).at(-1),
      new RegExp(`: ${count} with a pair .*at most ${pairs} % .*by ${by} %`),
    );
  });

  test('the stated changes by rotations are the worst one, and those of all others', () => {
    const [ofNeedles, ofOthers] = told(
      'docs/gallery.md',
      /Fast distances change by up to (\S+) of the diagonal on rough sheets with needles, by up to (\S+) on other meshes/,
    );
    const needles = /^rough sheet, needles/;
    const others = saved.filter(([mesh]) => !needles.test(mesh));
    assert.match(most('rotated')[0], needles);
    assert.equal(Number(most('rotated')[6]), Number(ofNeedles));
    assert.equal(Number(most('rotated', others)[6]), Number(ofOthers));
    const [exact] = told('docs/gallery.md', /changes exact distances by up to (\S+) of/);
    assert.equal(Number(most('exactRotated')[9]), Number(exact));
  });

  test('the promise of `converged` equals the count of the study of centers', () => {
    const counted =
      /in all: (\d+) converged, (\d+) indefinite, no minimum: unchecked (\d+) \(lower by (\S+) h2 at most\), checked (\d+) .*; moved (\d+), ties (\d+), .*; renumbered: moved (\d+), ties (\d+), farthest (\S+)$/;
    const words = told(
      'docs/gallery.md',
      /(\d+) converged, (\d+) indefinite\. Without the check (\d+) of .* no minima, by (\S+) h2 at most; with it (\d+)\. .* motions moved (\d+) centers and (\d+) ties, and another order (\d+) and (\d+) ties, to other minima, the farthest by (\S+) diagonals/,
    );
    const saved = counted.exec(savedLines('centers').at(-1)).slice(1);
    assert.deepEqual(words.map(Number), saved.map(Number));
  });

  test('microseconds a vertex', () => {
    const numbers = /(\S+) to (\S+) microseconds a vertex .*? (\S+) in the median/;
    for (const name of [
      'docs/which-call.md',
      'docs/algorithms/distances.md',
      'docs/algorithms/fields.md',
    ]) {
      assert.deepEqual(told(name, numbers).map(Number), spread('fastUs'), name);
    }
    const [, , median] = spread('fastUs');
    const [ms] = told('docs/which-call.md', /which is (\d+) ms for 100,000 triangles/);
    assert.equal(Number(ms), Math.round(50 * median));
    const ofExact = [
      ['docs/algorithms/distances.md', /(\S+) to (\S+) for `exact`, (\S+) in the median/],
      ['docs/algorithms/fields.md', /(\S+) to (\S+) by the exact one, (\S+) in the median/],
    ];
    for (const [name, pattern] of ofExact) {
      assert.deepEqual(told(name, pattern).map(Number), spread('exactUs'), name);
    }
  });
});

test('the orders of convergence, and the distances of exact centers, are those of the table', () => {
  const rows = rowsOf(savedLines('convergence'));
  const number = (cell) => Number(cell.split(' ')[0]);
  const families = [...new Set(rows.map(([name]) => name))].filter(
    (name) => !name.includes('stretched'),
  );
  /** A mesh's edges are proportional to the inverse root of its number of triangles. */
  const order = (column) => {
    const orders = families.map((name) => {
      const of = rows.filter(([one]) => one === name);
      const [coarse, fine] = [of[0], of.at(-1)];
      const finer = Math.sqrt(fine[1] / coarse[1]);
      return 1 + Math.log(number(coarse[column]) / number(fine[column])) / Math.log(finer);
    });
    return orders.reduce((a, b) => a + b) / orders.length;
  };
  const orders = told(
    'docs/convergence.md',
    /on average (\S+) for `paper`, (\S+) for `karcher` with fast and (\S+) with exact distances, and (\S+), (\S+) and (\S+) for/,
  );
  for (const [i, text] of orders.entries()) {
    const rounding = text.length > 3 ? 0.005 : 0.05;
    assert.ok(Math.abs(order(i + 2) - Number(text)) <= rounding, `${text}: ${order(i + 2)}`);
  }
  const [nearer, least, most] = told(
    'docs/convergence.md',
    /over \.3 mean edges in all (\d+) rows, and (\S+) to (\S+) times as far as/,
  ).map(Number);
  const ratios = rows.map((row) => number(row[4]) / number(row[6]));
  assert.equal(rows.filter((row) => number(row[4]) < number(row[5])).length, nearer);
  assert.equal(rows.length, nearer);
  assert.ok(Math.min(...ratios) > least - 0.05 && Math.max(...ratios) < most + 0.05);
  const [won] = told('docs/convergence.md', /with exact distances in (\d+) of 24 rows/);
  assert.equal(rows.filter((row) => number(row[7]) < number(row[4])).length, Number(won));
});

test('half of the kinks of refined curves at joints are as stated', () => {
  const saved = rowsOf(savedLines('joints'));
  const [half, most] = told(
    'docs/steady-curves.md',
    /half of the kinks of refined curves are under (\S+) degrees, 95 of 100 under (\.\d+)/,
  );
  for (const [mesh, , kind, spacing, levels, , kinks] of saved) {
    // Level 0 has joints of another kind.
    if (Number(levels) < 1) continue;
    const [median, most95] = kinks.split(' / ').map(Number);
    assert.ok(median < Number(half) && most95 < Number(most), `${mesh} ${kind} ${spacing}`);
  }
});

test('the distance of the default from the paper’s curve is the same in all texts', () => {
  const [first, second] = ['README.md', 'docs/methods.md'].map(
    (name) => told(name, /the default is that curve, to (\S+) mean edges/)[0],
  );
  assert.equal(first, second);
  assert.ok(Number(first) > 0);
  assert.ok(readme.includes(`to ${first} mean edges`));
});
