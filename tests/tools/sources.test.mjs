// The build compiles each source of the engine on its own.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { filesBelow, inRoot } from '../../.tools/shell.mjs';

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
