// The sources of the engine's WebAssembly, and the errors if it is missing.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { KarcherError, load } from 'karcher';
import { loadPeers } from 'karcher/peers';
import { loadInWorker } from 'karcher/worker';

const exported = import.meta.resolve('karcher/karcher-engine.wasm');
const file = fileURLToPath(exported);
const bytes = await readFile(file);

let server;
let address;
before(async () => {
  server = createServer((request, response) => {
    if (request.url === '/engine.wasm') response.end(bytes);
    else if (request.url === '/typed.wasm') {
      response.writeHead(200, { 'content-type': 'application/wasm' }).end(bytes);
    } else if (request.url === '/charset.wasm') {
      const type = 'application/wasm; charset=utf-8';
      response.writeHead(200, { 'content-type': type }).end(bytes);
    } else if (request.url === '/spelled.wasm') {
      response.writeHead(200, { 'content-type': 'Application/Wasm' }).end(bytes);
    } else if (request.url === '/wrong.wasm') {
      response.writeHead(200, { 'content-type': 'application/wasm' }).end('no wasm');
    } else if (request.url === '/page.wasm') response.end('<!doctype html>');
    else response.writeHead(404).end();
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  address = `http://127.0.0.1:${server.address().port}`;
});
after(() => server.close());

/** The bytes in shared memory, after `before` others. */
function shared(before) {
  const copy = new Uint8Array(new SharedArrayBuffer(before + bytes.length));
  copy.set(bytes, before);
  return copy;
}

const works = (karcher) => karcher.shape('sphere', 500).info.components === 1;

test('it is an address, bytes, an answer or a compiled module', async () => {
  const sources = {
    'a file: address': exported,
    'a URL': new URL(exported),
    'a path': file,
    'an address of the network': `${address}/engine.wasm`,
    'an address that says what it has': `${address}/typed.wasm`,
    'an address that says it with a charset': `${address}/charset.wasm`,
    'an address that says it in capitals': `${address}/spelled.wasm`,
    'an answer with a charset': await fetch(`${address}/charset.wasm`),
    bytes: bytes,
    'bytes in shared memory': shared(3).subarray(3),
    'shared memory': shared(0).buffer,
    'a view of it': new DataView(shared(3).buffer, 3),
    'an array buffer': bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length),
    'an answer': await fetch(`${address}/engine.wasm`),
    'a module': await WebAssembly.compile(bytes),
  };
  for (const [what, wasm] of Object.entries(sources)) {
    assert.ok(works(await load({ wasm })), what);
  }
  assert.ok(
    works((await loadPeers({ wasm: import.meta.resolve('karcher/karcher-peers.wasm') })).karcher),
  );
});

test('a worker takes the same sources', async () => {
  for (const wasm of [
    exported,
    `${address}/charset.wasm`,
    shared(0),
    await WebAssembly.compile(bytes),
  ]) {
    const karcher = await loadInWorker({ wasm });
    const sphere = await karcher.shape('sphere', 500);
    assert.equal(sphere.info.components, 1);
    karcher.dispose();
  }
  await assert.rejects(loadInWorker({ wasm: `${address}/missing.wasm` }), {
    code: 'notLoaded',
    message: /missing\.wasm: the answer is 404/,
  });
  await assert.rejects(loadInWorker({ wasm: 5 }), { code: 'badArgument' });
  const empty = await WebAssembly.compile(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));
  await assert.rejects(loadInWorker({ wasm: empty }), {
    code: 'notLoaded',
    message: /does not start/,
  });
});

test('an invalid source is reported, with its address', async () => {
  const notLoaded = (message) => (error) => {
    assert.ok(error instanceof KarcherError);
    assert.equal(error.code, 'notLoaded');
    assert.match(error.message, message);
    return true;
  };
  const missing = `${address}/missing.wasm`;
  await assert.rejects(load({ wasm: missing }), notLoaded(/missing\.wasm: the answer is 404/));
  await assert.rejects(load({ wasm: `${address}/page.wasm` }), notLoaded(/page\.wasm is not/));
  await assert.rejects(load({ wasm: `${address}/wrong.wasm` }), notLoaded(/wrong\.wasm is not/));
  await assert.rejects(load({ wasm: `${exported}x` }), notLoaded(/karcher-engine\.wasmx: ENOENT/));
  await assert.rejects(load({ wasm: 'http://127.0.0.1:9/x.wasm' }), notLoaded(/127\.0\.0\.1:9/));
  await assert.rejects(load({ wasm: new Uint8Array(8) }), notLoaded(/array of bytes is not/));
  const empty = await WebAssembly.compile(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));
  await assert.rejects(load({ wasm: empty }), notLoaded(/does not start/));
  await assert.rejects(load({ wasm: 5 }), { name: 'KarcherError', code: 'badArgument' });
  await assert.rejects(load({ url: exported }), { name: 'KarcherError', code: 'badArgument' });
});
