import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const dist = fileURLToPath(new URL('.', import.meta.resolve('karcher')));
/**
 * The largest sizes, gzipped, of the module and of the JavaScript that `karcher` loads. A user of
 * `karcher` alone does not download other entries and their files on demand, such as readers of
 * files and decoders.
 */
const mostBytes = { wasm: 450_000, js: 30_000 };
/**
 * The compiler version of CI. The bounds are for its output: other versions differ in libraries and
 * code size.
 */
const boundCompiler = '3.1.6';

/** The files that `karcher` imports, and their imports, static or on demand. */
function filesOfEntry() {
  const files = new Set(['index.js']);
  for (const file of files) {
    const text = readFileSync(dist + file, 'utf8');
    for (const [, name] of text.matchAll(/(?:from |import\(|new URL\()['"`]\.\/([\w./-]+)['"`]/g))
      files.add(name);
  }
  return [...files];
}

test('bundlers that do not read its exports find the same file', () => {
  const { main, exports } = JSON.parse(
    readFileSync(new URL(import.meta.resolve('karcher/package.json'))),
  );
  assert.equal(main, exports['.'].default);
  assert.equal(
    new URL(main, import.meta.resolve('karcher/package.json')).href,
    import.meta.resolve('karcher'),
  );
});

test('the module and its JavaScript are small enough to load', (t) => {
  const said = spawnSync('emcc', ['--version'], { encoding: 'utf8' }).stdout ?? '';
  const compiler = /\d+\.\d+\.\d+/.exec(said)?.[0];
  const files = filesOfEntry();
  for (const name of ['karcher-engine.wasm', 'karcher-engine.mjs', 'load.js', 'mesh.js']) {
    assert.ok(files.includes(name), name);
  }
  for (const [type, most] of Object.entries(mostBytes)) {
    const size = files
      .filter((name) => name.endsWith('.wasm') === (type === 'wasm'))
      .map((name) => gzipSync(readFileSync(dist + name)).length)
      .reduce((sum, bytes) => sum + bytes, 0);
    const sizes = `${size} bytes of ${type} gzipped, at most ${most}`;
    if (compiler === boundCompiler) assert.ok(size <= most, sizes);
    else t.diagnostic(`${sizes} of Emscripten ${boundCompiler}; this is ${compiler}`);
  }
});
