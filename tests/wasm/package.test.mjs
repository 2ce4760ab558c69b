import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const dist = fileURLToPath(new URL('.', import.meta.resolve('karcher')));
/**
 * Gzipped, of the module and of the JavaScript around it: what lies in dist itself. Its folders are other
 * entries and what they load when it is needed, as decoders, which a user of `karcher` alone does not download.
 * Modules of types alone are empty, and nothing imports them.
 */
const mostBytes = { wasm: 450_000, js: 30_000 };

const read = (name) => readFileSync(dist + name, 'utf8');

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

test('the module and its JavaScript are small enough to load', () => {
  const files = readdirSync(dist)
    .filter((name) => /\.(wasm|m?js)$/.test(name))
    .filter((name) => name.endsWith('.wasm') || !/^export \{\};\s*$/.test(read(name)));
  assert.ok(files.includes('karcher-engine.wasm') && files.includes('load.js'));
  for (const [type, most] of Object.entries(mostBytes)) {
    const size = files
      .filter((name) => name !== 'cli.js' && name.endsWith('.wasm') === (type === 'wasm'))
      .map((name) => gzipSync(readFileSync(dist + name)).length)
      .reduce((sum, bytes) => sum + bytes, 0);
    assert.ok(size <= most, `${size} bytes of ${type} gzipped, at most ${most}`);
  }
});
