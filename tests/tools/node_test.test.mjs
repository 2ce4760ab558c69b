// The runner of test files and its counts: a file that ends without reporting its count has failed.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { runLongestFirst } from '../../.tools/longest_first.mjs';
import { alone, dealt, runGroups } from '../../.tools/node_test.mjs';

let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'karcher-node-test-'));
});
after(() => rmSync(folder, { recursive: true, force: true }));

describe('a file of node:test', () => {
  const imports = "import { describe, test } from 'node:test';\n";
  const failing = 'test("fails", () => { throw new Error(); });';
  const cases = {
    'that passes': ['test("a", () => {}); test("b", () => {});', { passed: 2, failed: 0 }],
    'with a suite': [
      `describe("s", () => { test("a", () => {}); ${failing} });`,
      { passed: 1, failed: 1 },
    ],
    'with a test that is skipped': [
      'test("a", () => {}); test("b", { skip: true }, () => {});',
      { passed: 1, failed: 0 },
    ],
    'that prints what reports tell': [
      `test("a", (t) => t.diagnostic("fail 0")); ${failing}`,
      { passed: 1, failed: 1 },
    ],
    'whose tests never end': [
      'test("a", () => new Promise(() => {})); test("b", () => {});',
      { passed: 0, failed: 2 },
    ],
    'that fails after its tests': [
      'test("a", () => {}); setTimeout(() => { throw new Error(); });',
      { passed: 1, failed: 1 },
    ],
    'without a test': ['', { passed: 0, failed: 1 }],
    'that cannot be read': ['{', { passed: 0, failed: 1 }],
  };
  const countsOf = (text) => {
    const file = join(folder, 'case.test.mjs');
    writeFileSync(file, imports + text);
    // This file itself may run below `node --test`.
    const env = { NODE_TEST_CONTEXT: undefined };
    return runGroups(alone([file]), { reports: folder, env, minutes: 5 });
  };

  for (const [name, [text, counts]] of Object.entries(cases)) {
    test(name, async () => assert.deepEqual(await countsOf(text), counts));
  }

  test('that ends in a test', async () => {
    const { passed, failed } = await countsOf('test("a", () => process.exit(0));');
    assert.equal(passed, 0);
    assert.ok(failed > 0);
  });
});

test('files that share a process are counted together, also where one of them ends it', async () => {
  const imports = "import { test } from 'node:test';\n";
  const texts = {
    'a.test.mjs': 'test("a", () => {}); globalThis.shared = true;',
    'b.test.mjs':
      'test("b", () => { if (!globalThis.shared) throw new Error(); }); test("c", () => { throw new Error(); });',
    'd.test.mjs': 'test("d", () => process.exit(0));',
  };
  const files = Object.keys(texts).map((name) => join(folder, name));
  for (const file of files) writeFileSync(file, imports + texts[file.slice(folder.length + 1)]);
  const options = { reports: folder, env: { NODE_TEST_CONTEXT: undefined }, minutes: 5 };
  const count = (some, size) => runGroups(dealt(some, size), options);
  assert.deepEqual(await count(files.slice(0, 2), 2), { passed: 2, failed: 1 });
  assert.deepEqual(await count(files.slice(0, 2), 1), { passed: 1, failed: 2 });
  assert.ok((await count(files, 3)).failed > 0);
});

test('files are dealt out to groups, each to one', () => {
  const files = ['a', 'b', 'c', 'd', 'e', 'f', 'g'];
  const groups = dealt(files, 3).map((group) => group.files);
  assert.deepEqual(groups.flat().sort(), files);
  assert.deepEqual(
    groups.map((group) => group.length),
    [3, 2, 2],
  );
});

test('what took long before, and what is new, is begun first', async () => {
  const times = join(folder, 'times.json');
  writeFileSync(times, JSON.stringify({ short: 1, long: 9, middle: 5, gone: 20 }));
  const begun = [];
  const counts = await runLongestFirst(['short', 'middle', 'new', 'long'], times, async (name) => {
    begun.push(name);
    return { passed: 2, failed: name === 'new' ? 1 : 0 };
  });
  assert.deepEqual(begun, ['new', 'long', 'middle', 'short']);
  assert.deepEqual(counts, { passed: 8, failed: 1 });
  assert.deepEqual(Object.keys(JSON.parse(readFileSync(times, 'utf8'))).sort(), [
    ...['long', 'middle', 'new', 'short'],
  ]);
});
