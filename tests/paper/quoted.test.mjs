// What the README quotes stands in the tables that it quotes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inRoot } from '../../.tools/shell.mjs';

const textOf = (name) => readFileSync(inRoot(name), 'utf8').replaceAll(/\s+/g, ' ');
const readme = textOf('README.md');
const methods = readFileSync(inRoot('docs/methods.md'), 'utf8');

/** A row of the table of methods, by what its mesh begins with: the paper's fields, then the default. */
function rowOf(mesh) {
  const row = methods.split('\n').find((line) => line.startsWith(`| ${mesh}`));
  assert.ok(row, mesh);
  const [, , paper, ours] = row.split('|').map((cell) => cell.trim());
  return { paper, ours };
}

test('the README’s figures of accuracy are those of the table of methods', () => {
  const told =
    /stretched 20:1 are off by (\S+) mean edges, where the paper's fields lose (\d+ of \d+) samples\. On a sphere of relaxed random points the default is off by (\S+) mean edges, the paper's fields by (\d\.\d+)/.exec(
      readme,
    );
  assert.ok(told, 'the sentence is another: this test is to read it');
  const [, plane, lost, sphere, paper] = told;
  assert.equal(rowOf('plane, stretched 20:1').ours, plane);
  assert.ok(rowOf('plane, stretched 20:1').paper.endsWith(`, ${lost} lost`));
  assert.deepEqual(rowOf('sphere, relaxed random points'), { paper, ours: sphere });
});

test('how near the default is to the paper’s curve is the same wherever it is told', () => {
  const told = ['README.md', 'docs/methods.md'].map(
    (name) => /the default is that curve, to (\S+) mean edges/.exec(textOf(name))?.[1],
  );
  assert.equal(told[0], told[1]);
  assert.ok(Number(told[0]) > 0);
});
