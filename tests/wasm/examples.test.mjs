// Tests of the examples. Those for Node run, and Vite bundles those for a page. Each is short and
// appears in the list.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { build } from 'vite';
import { inRoot } from '../../.tools/shell.mjs';

const folder = inRoot('examples');
const files = readdirSync(folder).filter((name) => /\.(mjs|tsx?)$/.test(name));
const textOf = (name) => readFileSync(join(folder, name), 'utf8');

test('are listed, and have less than 60 lines', () => {
  const list = textOf('README.md');
  for (const name of files) {
    assert.ok(list.includes(`[${name}](${name})`), name);
    assert.ok(textOf(name).split('\n').length < 60, name);
  }
});

test('the first dragged curve takes at most 15 lines', () => {
  const [, lines] = /Karcher from here\n([\s\S]*?)\/\/ to here/.exec(textOf('drag_on_glb.ts'));
  assert.ok(lines.trim().split('\n').length <= 15);
});

test('with React it takes at most 20 lines, besides imports', () => {
  const lines = textOf('drag_with_react.tsx')
    .split('\n')
    .filter((line) => line.trim() !== '' && !/^(import|\/\/)/.test(line));
  assert.ok(lines.length <= 20, `${lines.length}`);
});

for (const name of files.filter((name) => name.endsWith('.mjs'))) {
  test(`${name} runs`, () => {
    const { status, stdout, stderr } = spawnSync(process.execPath, [join(folder, name)], {
      encoding: 'utf8',
    });
    assert.equal(status, 0, stderr);
    assert.ok(stdout.length > 0 && !/NaN|undefined/.test(stdout), stdout);
  });
}

for (const name of files.filter((name) => /\.tsx?$/.test(name))) {
  test(`${name} is bundled`, async () => {
    const { output } = await build({
      configFile: false,
      root: folder,
      logLevel: 'error',
      build: {
        write: false,
        target: 'es2022',
        minify: false,
        rolldownOptions: { input: join(folder, name) },
      },
    });
    assert.ok(output.some(({ fileName }) => /\.wasm$/.test(fileName)));
  });
}
