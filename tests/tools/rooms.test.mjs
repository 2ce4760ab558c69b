// The linter that checks includes and imports against ARCHITECTURE.md.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { namesOfNoFile, readRooms, wrongUses } from '../../.tools/rooms.mjs';
import { inRoot } from '../../.tools/shell.mjs';

const head = '| room | what it holds | may use |\n| --- | --- | --- |\n';
const tables = `A text.

${head}| \`src/mesh\` | meshes | \`Eigen\` |
| \`src/distance\` | distances | all above |
| \`src/curves\` | curves | all above but \`src/mesh\` |

${head}| \`web/model\`, \`web/model/link\` | documents | \`karcher\` (types) |
| \`web/viewer\` | drawing | \`web/model\` (types), \`three\` |
| \`web\` | all of it | \`node\`, \`web/*\` but \`web/viewer\` |
`;
const files = {
  'src/mesh/mesh.h': '#include <Eigen/Core>\n#include <vector>\n',
  'src/distance/exact.h': '#include <algorithm>\n\n#include "mesh/mesh.h"\n',
  'src/curves/curve.h': '#include "distance/exact.h"\n',
  'web/model/figure.ts':
    "import type { Point } from 'karcher';\nimport { read } from './link/read';\n",
  'web/model/link/read.ts': "import {\n  type Curve,\n  type Point,\n} from 'karcher';\n",
  'web/viewer/view.ts': "import { Vector3 } from 'three';\nimport './view.css';\n",
  'web/main.ts':
    "import { readFile } from 'node:fs/promises';\nimport { a } from './model/figure';\n",
};

/** The faults of these files, some of them with another text. */
const wrong = (changed = {}, markdown = tables) =>
  wrongUses(
    readRooms(markdown),
    Object.entries({ ...files, ...changed }).map(([path, text]) => ({ path, text })),
  );

describe('rooms', () => {
  test('allow what their tables say', () => assert.deepEqual(wrong(), []));

  const faults = {
    'an include of a room below': [
      'src/mesh/mesh.h',
      '#include "distance/exact.h"',
      'src/distance',
    ],
    'an include of a room taken out': ['src/curves/curve.h', '#include "mesh/mesh.h"', 'src/mesh'],
    'an include of another package': [
      'src/mesh/mesh.h',
      '#include <emscripten/val.h>',
      'emscripten',
    ],
    'an import of a room': [
      'web/model/figure.ts',
      "import { v } from '../viewer/view';",
      'web/viewer',
    ],
    'an import for its effect': ['web/model/figure.ts', "import '../viewer/view';", 'web/viewer'],
    'an import over several lines': [
      'web/model/figure.ts',
      "import {\n  a,\n  b as c,\n} from '../viewer/view.js';",
      'web/viewer',
    ],
    'an export of what is imported': [
      'web/model/figure.ts',
      "export * from '../viewer/view';",
      'web/viewer',
    ],
    'an import where it is called': [
      'web/main.ts',
      "  await import(\n    './viewer/view'\n  );",
      'web/viewer',
    ],
    'a worker': [
      'web/main.ts',
      "new Worker(new URL('./viewer/view.ts', import.meta.url));",
      'web/viewer',
    ],
    'an import of a package': [
      'web/model/figure.ts',
      "import { Vector3 } from 'three/addons/a.js';",
      'three',
    ],
    'an import of Node': ['web/model/figure.ts', "import { join } from 'node:path';", 'node'],
    'a value where types are allowed': [
      'web/model/figure.ts',
      "import { load } from 'karcher';",
      'karcher',
    ],
    'a value beside a type': [
      'web/model/figure.ts',
      "import { type A, b } from 'karcher';",
      'karcher',
    ],
    'a value of a room for its types': [
      'web/viewer/view.ts',
      "import { a } from '../model/figure';",
      'web/model',
    ],
  };
  for (const [what, [path, text, used]] of Object.entries(faults)) {
    test(`find ${what}`, () => {
      const all = wrong({ [path]: `${files[path]}${text}\n` });
      const [sentence, ...more] = all.filter((one) => !one.includes('leads back to itself'));
      assert.ok(sentence?.startsWith(`${path}: uses `), sentence);
      assert.ok(sentence.includes(used.split('/').at(-1)), sentence);
      assert.deepEqual(more, []);
    });
  }

  test('find cyclic imports', () => {
    const read = 'web/model/link/read.ts';
    const circle = { [read]: `${files[read]}import type { B } from '../figure';\n` };
    const [sentence, ...more] = wrong(circle);
    assert.match(sentence, /leads back to itself: .*figure\.ts -> .*read\.ts -> .*figure\.ts$/);
    assert.deepEqual(more, []);
    const worker = { [read]: `${files[read]}new URL('../figure.ts', import.meta.url);\n` };
    assert.deepEqual(wrong(worker), []);
  });

  test('contain every file, and each at least one file', () => {
    assert.deepEqual(wrong({ 'web/panels/tools.ts': '' }), ['web/panels/tools.ts: in no room']);
    assert.match(wrong({ 'web/main.ts': "import './panels/tools.ts';\n" })[0], /in no room/);
    const more = `${tables}| \`web/panels\` | controls | |\n`;
    assert.deepEqual(wrong({}, more), ['web/panels: a room without a file']);
  });

  test('have no cycles, and are named once', () => {
    const circle = `${head}| \`web/a\` | a | \`web/b\` |\n| \`web/b\` | b | all above |\n`;
    assert.throws(() => readRooms(circle), /rooms use each other: web\/a -> web\/b -> web\/a/);
    assert.throws(() => readRooms(`${tables}| \`src/mesh\` | again | |\n`), /named twice/);
    assert.throws(
      () => readRooms(`${tables}| \`web/a\` | a | \`web/none\` |\n`),
      /no room 'web\/none'/,
    );
  });

  test('come with a text whose files exist', () => {
    const text = 'See `src/mesh/mesh.h`, `exact.h`, `a.b()` and `link/read.ts`, not `mesh/gone.h`.';
    assert.deepEqual(namesOfNoFile(text, Object.keys(files)), ['mesh/gone.h']);
    assert.deepEqual(namesOfNoFile('`esh.h` `src/exact.h`', Object.keys(files)), [
      'esh.h',
      'src/exact.h',
    ]);
  });

  test('of this project keep the engine free of the code that is built on it', () => {
    const rooms = readRooms(readFileSync(inRoot('ARCHITECTURE.md'), 'utf8'));
    const uses = Object.fromEntries(rooms.map(({ name, uses: used }) => [name, [...used.keys()]]));
    for (const [name, used] of Object.entries(uses)) {
      const layers = ['src', 'wasm', 'web'];
      const layer = layers.indexOf(name.split('/')[0]);
      const below = layer === 2 ? ['web'] : layers.slice(0, layer + 1);
      const rest = used.filter((other) => layers.includes(other.split('/')[0]));
      for (const other of rest) assert.ok(below.includes(other.split('/')[0]), `${name}: ${other}`);
    }
    assert.ok(!uses['src/curves/spec'].some((name) => name.startsWith('src/curves')));
    assert.ok(!uses['web/model'].includes('three'));
  });
});
