// The build compiles each source of the engine on its own, and each test once.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { filesBelow, inRoot } from '../../.tools/shell.mjs';

describe('a build', () => {
  for (const preset of ['native', 'sanitize']) {
    const commands = () =>
      JSON.parse(readFileSync(inRoot(`build/${preset}/compile_commands.json`))).map(
        ({ file }) => file,
      );

    test(`compiles each file on its own: ${preset}`, () => {
      const compiled = commands();
      assert.equal(new Set(compiled).size, compiled.length);
      for (const file of filesBelow('src', /\.cpp$/)) assert.ok(compiled.includes(file), file);
    });

    test(`compiles each test once: ${preset}`, () => {
      const included = commands()
        .filter((file) => file.includes('karcher_tests.dir/Unity'))
        .flatMap((file) => [...readFileSync(file, 'utf8').matchAll(/^#include "(.*)"$/gm)])
        .map(([, file]) => file);
      const compiled = [...commands(), ...included].filter((file) =>
        file.includes('tests/engine/'),
      );
      assert.deepEqual(compiled.sort(), filesBelow('tests/engine', /\.cpp$/));
    });
  }
});
