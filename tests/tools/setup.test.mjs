// Commands that cannot work print a sentence without a stack, and end with status 1.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  chmodSync,
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'karcher-tools-'));
after(() => rmSync(folder, { recursive: true }));

function run(args, { env = {}, cwd = root } = {}) {
  const options = { cwd, encoding: 'utf8', env: { ...process.env, ...env } };
  const { status, stdout, stderr } = spawnSync(process.execPath, args, options);
  return { status, stdout, stderr };
}

test('an invalid port', () => {
  for (const port of ['99999', 'abc', '-1', '']) {
    const { status, stderr } = run([join(root, '.tools/start.mjs'), `--port=${port}`]);
    assert.equal(status, 1);
    assert.match(stderr, /is not a port/);
    assert.doesNotMatch(stderr, /\n {4}at /);
  }
});

/** A PATH with only these programs, as scripts. */
function pathWith(name, programs) {
  const path = join(folder, name);
  mkdirSync(path);
  for (const [program, script] of Object.entries(programs)) {
    const file = join(path, program);
    writeFileSync(file, `#!/bin/sh\n${script}\n`);
    chmodSync(file, 0o755);
  }
  return path;
}

test('each command requires only what it needs', () => {
  const path = pathWith('bare', { 'apt-get': 'exit 0' });
  const asked = (...purposes) => {
    const env = { PATH: path, KARCHER_NO_INSTALL: '1', CHROMIUM_PATH: '' };
    const { status, stdout, stderr } = run([join(root, '.tools/setup.mjs'), ...purposes], { env });
    assert.equal(status, 1, stderr);
    assert.doesNotMatch(stderr, /\n {4}at /);
    return /^Missing: (.*)\.$/m.exec(stdout)[1];
  };
  assert.equal(asked('format'), 'clang-format');
  assert.equal(asked('fuzz'), 'clang++ with libFuzzer');
  assert.doesNotMatch(asked('build', 'native'), /Chromium|clang/);
  assert.doesNotMatch(asked('build', 'lint'), /Chromium/);
  assert.match(asked('test'), /Chromium/);
  assert.doesNotMatch(asked('build'), /GoogleTest|Chromium|clang/);
});

test('continues without programs that only save time', (t) => {
  const programs = 'emcc emcmake python3 cmake ninja c++ g++ clang++ ld env'.split(' ');
  const found = programs.map((name) => spawnSync('which', [name], { encoding: 'utf8' }).stdout);
  const path = pathWith('slow', { 'apt-get': 'exit 1', chromium: 'exit 0' });
  programs.forEach((name, i) => {
    if (found[i]) symlinkSync(found[i].trim(), join(path, name));
  });
  const env = { PATH: path, CHROMIUM_PATH: '', KARCHER_NO_INSTALL: '' };
  const { status, stdout, stderr } = run([join(root, '.tools/setup.mjs'), 'test'], { env });
  if (!/^Missing: Chromium without windows\.$/m.test(stdout)) return t.skip('more is missing');
  assert.equal(status, 0, stderr);
  assert.match(stdout, /Chromium without windows is not installed: the tests .* take longer/);
});

test('without root and sudo the printed commands are those for root', {
  skip: !process.getuid,
}, () => {
  const path = pathWith('nobody', { 'apt-get': 'exit 0' });
  const code = `process.getuid = () => 1000; process.argv[1] = ''; await (await import(${JSON.stringify(`${root}.tools/setup.mjs`)})).setUp('format');`;
  const { status, stdout, stderr } = run(['--input-type=module', '-e', code], {
    env: { PATH: path },
  });
  assert.equal(status, 1);
  assert.match(stdout, /Missing: clang-format/);
  if (!/Not installing/.test(stderr)) return assert.match(stderr, /brew install clang-format/);
  assert.match(stderr, /there is no sudo\. The commands are, as root:\n {2}env /);
  assert.doesNotMatch(stderr, /\bsudo env/);
});

test('an installation of the package from git installs no system packages', () => {
  const called = join(folder, 'called');
  const path = pathWith('git', { 'apt-get': `touch ${called}`, sudo: `touch ${called}` });
  const env = { PATH: path, KARCHER_NO_INSTALL: '', npm_lifecycle_event: 'prepack' };
  const { status, stderr } = run([join(root, '.tools/setup.mjs'), 'build'], { env });
  assert.equal(status, 1);
  assert.equal(existsSync(called), false);
  if (existsSync('/etc/debian_version')) assert.match(stderr, /as npm is making the package/);
});

test('what CMake downloads has a hash', () => {
  const files = ['CMakeLists.txt', 'wasm/CMakeLists.txt', 'tests/bench/CMakeLists.txt'];
  const texts = files.map((name) => readFileSync(join(root, name), 'utf8')).join('\n');
  const declared = [...texts.matchAll(/FetchContent_Declare\(([^)]*)\)/g)].map(([, text]) => text);
  assert.equal(declared.length, 2);
  for (const text of declared)
    assert.match(text, /\bURL https:.*\n\s*URL_HASH SHA256=[0-9a-f]{64}\n/);
  assert.doesNotMatch(texts, /GIT_REPOSITORY|ExternalProject|file\(DOWNLOAD/);
});

test('a folder without write permission', () => {
  const copy = join(folder, 'copy');
  mkdirSync(join(copy, '.tools'), { recursive: true });
  cpSync(join(root, '.tools'), join(copy, '.tools'), { recursive: true });
  symlinkSync(join(root, 'package.json'), join(copy, 'package.json'));
  // Root may write almost anywhere, so the test refuses the call itself.
  const code = `import fs from 'node:fs'; import { syncBuiltinESMExports } from 'node:module';
    const before = fs.accessSync;
    fs.accessSync = (path, mode) => {
      if (mode === fs.constants.W_OK) throw Object.assign(new Error('read-only'), { code: 'EROFS' });
      return before(path, mode);
    };
    syncBuiltinESMExports();
    process.argv[1] = '';
    await (await import(${JSON.stringify(join(copy, '.tools/setup.mjs'))})).setUp('build');`;
  const { status, stderr } = run(['--input-type=module', '-e', code]);
  assert.equal(status, 1);
  assert.match(stderr, /copy\/ cannot be written to; .* Copy the folder to a place of yours\.\n$/);
});
