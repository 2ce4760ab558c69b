// How the engine's sources are compiled: each on its own, and fast or small as src/sources.cmake says.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { filesBelow, inRoot } from '../../.tools/shell.mjs';

describe('src/sources.cmake', () => {
  let folder;
  before(() => {
    folder = mkdtempSync(join(tmpdir(), 'karcher-sources-'));
    cpSync(inRoot('src'), join(folder, 'src'), { recursive: true });
    writeFileSync(
      join(folder, 'CMakeLists.txt'),
      `cmake_minimum_required(VERSION 3.24)
project(sources LANGUAGES NONE)
include(src/sources.cmake)
list(LENGTH KARCHER_FAST_SOURCES fast)
list(LENGTH KARCHER_SMALL_SOURCES small)
message(STATUS "\${fast} fast, \${small} small")
`,
    );
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  const configure = () => {
    const { status, stdout, stderr } = spawnSync(
      'cmake',
      ['-S', folder, '-B', join(folder, 'build'), '-G', 'Ninja'],
      { encoding: 'utf8' },
    );
    return { status, said: `${stdout}${stderr}`.replace(/\s+/g, ' ') };
  };
  const renamed = (from, to, check) => {
    renameSync(join(folder, from), join(folder, to));
    try {
      check(configure());
    } finally {
      renameSync(join(folder, to), join(folder, from));
    }
  };

  test('has every source of the engine in one list', () => {
    const { status, said } = configure();
    assert.equal(status, 0, said);
    const [, fast, small] = /(\d+) fast, (\d+) small/.exec(said).map(Number);
    const engine = filesBelow('src', /\.cpp$/).filter((file) => !file.includes('/src/peers/'));
    assert.equal(fast + small, engine.length);
    assert.ok(fast > 0 && small > 0);
  });

  test('notices when a file that it names is renamed', () => {
    renamed(
      'src/curves/spec/segment_basis.cpp',
      'src/curves/spec/blends.cpp',
      ({ status, said }) => {
        assert.notEqual(status, 0);
        assert.match(said, /names src\/curves\/spec\/segment_basis\.cpp, which is not among/);
      },
    );
  });

  test('notices a room that it does not name, and one that is gone', () => {
    renamed('src/curves/trace', 'src/curves/traced', ({ status, said }) => {
      assert.notEqual(status, 0);
      assert.match(said, /names the room src\/curves\/trace, which has no source/);
    });
    writeFileSync(join(folder, 'src/lost.cpp'), '');
    const { status, said } = configure();
    rmSync(join(folder, 'src/lost.cpp'));
    assert.notEqual(status, 0);
    assert.match(said, /names no room of: lost\.cpp/);
  });
});

describe('a build', () => {
  for (const preset of ['native', 'sanitize']) {
    test(`compiles each file on its own: ${preset}`, () => {
      const commands = JSON.parse(readFileSync(inRoot(`build/${preset}/compile_commands.json`)));
      const compiled = commands.map(({ file }) => file);
      assert.equal(new Set(compiled).size, compiled.length);
      for (const file of [
        ...filesBelow('src', /\.cpp$/),
        ...filesBelow('tests/engine', /\.cpp$/),
      ]) {
        assert.ok(compiled.includes(file), file);
      }
      assert.deepEqual(
        compiled.filter((file) => /unity/i.test(file)),
        [],
      );
    });
  }
});
