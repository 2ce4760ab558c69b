// Karcher in the CMake projects of C++ users: as a folder, fetched and installed. The programs are
// those of docs/cpp.md. The test links and runs them only with the installed library, whose engine
// is already compiled.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { promisify } from 'node:util';
import { inRoot } from '../../.tools/shell.mjs';

const { version } = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));

const programs = [
  ...readFileSync(inRoot('docs/cpp.md'), 'utf8').matchAll(/^```cpp\n([\s\S]*?)^```$/gm),
].map(([, program]) => program);

/** A user's project around Karcher checks that no CMake variable has changed. */
const head = `cmake_minimum_required(VERSION 3.24)
project(user LANGUAGES CXX)
get_cmake_property(names VARIABLES)
foreach(name \${names})
  if(name MATCHES "^(CMAKE|BUILD)_")
    set("before_\${name}" "\${\${name}}")
  endif()
endforeach()
if(NOT before_CMAKE_BUILD_TYPE)
  set(before_CMAKE_BUILD_TYPE "")
endif()
`;
const tail = `get_cmake_property(names VARIABLES)
foreach(name \${names})
  if(name MATCHES "^(CMAKE_(CXX|C|BUILD|UNITY|EXPORT|POSITION|FIND_ROOT|INTERPROCEDURAL|COMPILE)|BUILD)_")
    if(NOT "\${\${name}}" STREQUAL "\${before_\${name}}")
      message(SEND_ERROR "\${name} was '\${before_\${name}}' and is '\${\${name}}'")
    endif()
  endif()
endforeach()
add_executable(app main.cpp)
target_link_libraries(app PRIVATE karcher::karcher)
`;

// A compiler keeps one core busy.
describe('a C++ project', { concurrency: true }, () => {
  let folder;
  before(() => {
    folder = mkdtempSync(join(tmpdir(), 'karcher users '));
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  const run = async (name, command, ...args) => {
    const options = { cwd: join(folder, name), maxBuffer: Number.POSITIVE_INFINITY };
    try {
      return (await promisify(execFile)(command, args, options)).stdout;
    } catch ({ message, stdout }) {
      // The message has the command and its standard error, but not its output.
      throw new Error(`${message}\n${stdout}`);
    }
  };

  const configure = async (name, middle, end = '', ...args) => {
    mkdirSync(join(folder, name), { recursive: true });
    writeFileSync(join(folder, name, 'CMakeLists.txt'), head + middle + tail + end);
    writeFileSync(join(folder, name, 'main.cpp'), programs[0]);
    const options = ['-DCMAKE_EXPORT_COMPILE_COMMANDS=ON', '-DCMAKE_CXX_FLAGS=-Wall -Werror'];
    await run(name, 'cmake', '-S', '.', '-B', 'build', '-G', 'Ninja', ...options, ...args);
  };

  /** The command that compiles a file. */
  const commandOf = (name, file) =>
    JSON.parse(readFileSync(join(folder, name, 'build/compile_commands.json'), 'utf8')).find(
      (entry) => entry.file.endsWith(file),
    )?.command;

  /**
   * Checks a project that compiles the engine: the flags, the absence of other targets, and that
   * the program compiles.
   */
  const checkWithEngine = async (name) => {
    const engine = commandOf(name, '/src/curves/curve.cpp');
    // CMake may write flags in any order.
    for (const flag of [/ -fPIC /, / -std=c\+\+20 /]) assert.match(engine, flag);
    assert.doesNotMatch(engine, / -(Wextra|Wconversion|Wshadow) /);
    // The user's project names no build type.
    for (const flag of [/ -O3 /, / -DNDEBUG /]) assert.match(engine, flag);
    assert.equal(engine.split('-Werror').length, 2, 'the user’s own, no other');
    const own = commandOf(name, 'main.cpp');
    assert.match(own, / -std=(c|gnu)\+\+20 /);
    assert.doesNotMatch(own, / -(Wextra|Wconversion|Wshadow|O3|DNDEBUG|fPIC) /);
    assert.equal(commandOf(name, '/tests/engine/mesh_test.cpp'), undefined);
    assert.equal(commandOf(name, '/tests/bench/karcher_bench.cpp'), undefined);
    await run(name, 'ninja', '-C', 'build', 'CMakeFiles/app.dir/main.cpp.o');
    const commands = await run(name, 'ninja', '-C', 'build', '-t', 'commands', 'all');
    assert.match(commands, /libkarcher\.a/);
    assert.doesNotMatch(commands, /src\/peers/);
  };

  test('takes it as a folder', async () => {
    const source = inRoot('.').replace(/\/\.$/, '');
    await configure('folder', `add_subdirectory("${source}" karcher)\n`);
    await checkWithEngine('folder');
    await configure(
      'debug',
      `add_subdirectory("${source}" karcher)\n`,
      '',
      '-DCMAKE_BUILD_TYPE=Debug',
    );
    assert.match(commandOf('debug', '/src/curves/curve.cpp'), / -g /);
    assert.doesNotMatch(commandOf('debug', '/src/curves/curve.cpp'), / -(O3|DNDEBUG) /);
    const compiled = await run('folder', 'ninja', '-C', 'build', '-t', 'targets', 'all');
    const object = /^(\S*src\/mesh\/error\.cpp\.o):/m.exec(compiled)[1];
    await run('folder', 'ninja', '-C', 'build', object);
  });

  test('fetches it', async () => {
    await configure(
      'fetched',
      `include(FetchContent)
FetchContent_Declare(karcher SOURCE_DIR "${inRoot('.')}")
FetchContent_MakeAvailable(karcher)
`,
    );
    await checkWithEngine('fetched');
  });

  test('finds it where it is installed, beside a tinyobjloader of its own', async () => {
    const prefix = join(folder, 'prefix');
    await run(
      '.',
      'cmake',
      '--install',
      inRoot('build/native'),
      '--prefix',
      prefix,
      '--component',
      'karcher',
    );
    const headers = join(prefix, 'include');
    assert.deepEqual(readdirSync(headers), ['karcher']);
    assert.ok(existsSync(join(headers, 'karcher/mesh/error.h')));
    assert.ok(!existsSync(join(headers, 'karcher/mesh/seams.h')), 'it is internal');
    mkdirSync(join(folder, 'found'));
    cpSync(
      inRoot('build/native/third_party/tiny_obj_loader.h'),
      join(folder, 'found/tiny_obj_loader.h'),
    );
    writeFileSync(
      join(folder, 'found/reader.cpp'),
      '#define TINYOBJLOADER_IMPLEMENTATION\n#include "tiny_obj_loader.h"\n',
    );
    writeFileSync(join(folder, 'found/cells.cpp'), programs[1]);
    // The plug-in is a shared library: the engine's code must be position-independent.
    await configure(
      'found',
      `find_package(karcher ${version} REQUIRED)\n`,
      `target_sources(app PRIVATE reader.cpp)
add_library(plugin SHARED main.cpp)
target_link_libraries(plugin PRIVATE karcher::karcher)
add_executable(cells cells.cpp)
target_link_libraries(cells PRIVATE karcher::karcher)
`,
      `-DCMAKE_PREFIX_PATH=${prefix}`,
    );
    await run('found', 'ninja', '-C', 'build');
    const said = await run(
      'found',
      join(folder, 'found/build/app'),
      inRoot('build/data/bunny.obj'),
    );
    assert.match(said, /^the center of mass: (-?\d+\.\d+ ?){3}\na curve of length \d+\.\d+\n$/);
    const cells = await run('found', join(folder, 'found/build/cells'));
    assert.match(cells, /^(a cell of area \d+\.\d+ around( -?\d+\.\d+){3}\n){2}$/);
  });
});
