// Finds and installs the packages that the machine lacks to build and test Karcher: system packages
// by apt on Debian and Ubuntu, npm packages by `npm ci`. Elsewhere it prints the missing packages and
// their installation. With KARCHER_NO_INSTALL=1, and where npm installs the package from git, it only
// prints the commands.
//
//   node .tools/setup.mjs [build] [native] [test] [format] [lint]     (all without arguments)
import { spawnSync } from 'node:child_process';
import { accessSync, constants, existsSync, readFileSync, statSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { inRoot, root, run, which } from './shell.mjs';

const kOldestCmake = [3, 24];

function cmakeIsNewEnough() {
  const output = which('cmake') && spawnSync('cmake', ['--version'], { encoding: 'utf8' }).stdout;
  const [, major, minor] = /version (\d+)\.(\d+)/.exec(output || '') ?? [];
  return major > kOldestCmake[0] || (+major === kOldestCmake[0] && minor >= kOldestCmake[1]);
}

/**
 * Whether clang++ can link a program with these sanitizers. Their runtime is a separate package.
 */
function clangHas(sanitizers, program) {
  const args = ['-x', 'c++', `-fsanitize=${sanitizers}`, '-', '-o', '/dev/null'];
  return !!which('clang++') && spawnSync('clang++', args, { input: program }).status === 0;
}
const clangHasSanitizers = () => clangHas('address,undefined', 'int main() {}');
/** Apple's clang has no libFuzzer. */
const clangHasFuzzer = () =>
  clangHas(
    'fuzzer,address,undefined',
    'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }',
  );

const includeFolders = ['/usr/include', '/usr/local/include', '/opt/homebrew/include'];
const hasHeader = (name) => includeFolders.some((folder) => existsSync(`${folder}/${name}`));

/** Chromium without windows, which takes less work to open pages. */
const headless = 'chromium-headless-shell';

/** The browser that the page's tests drive, or undefined. */
export function chromiumPath() {
  const named = process.env.CHROMIUM_PATH;
  if (named) return existsSync(named) ? named : undefined;
  const mac = '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome';
  return (
    [headless, 'chromium', 'chromium-browser', 'google-chrome'].map(which).find(Boolean) ??
    (existsSync(mac) ? mac : undefined)
  );
}

// The required programs and libraries. `for` is their purpose: `native` stands for the native library,
// its benchmarks and studies, `test` for all tests. `optional` describes the consequence of their
// absence. Ubuntu has Chromium only as a snap.
const needs = [
  {
    what: 'Emscripten (emcc)',
    for: 'build',
    found: () => which('emcc') && which('emcmake'),
    apt: ['emscripten'],
    how: 'brew install emscripten, or emsdk: https://emscripten.org/docs/getting_started/downloads.html',
  },
  {
    what: `CMake ${kOldestCmake.join('.')} or newer`,
    for: 'build',
    found: cmakeIsNewEnough,
    apt: ['cmake'],
    how: 'brew install cmake, or https://cmake.org/download',
  },
  {
    what: 'Ninja',
    for: 'build',
    found: () => which('ninja'),
    apt: ['ninja-build'],
    how: 'brew install ninja',
  },
  {
    what: 'Eigen',
    for: 'build',
    optional: 'CMake downloads it',
    found: () => hasHeader('eigen3/Eigen/Core'),
    apt: ['libeigen3-dev'],
  },
  {
    what: 'tinyobjloader',
    for: 'build',
    optional: 'CMake downloads it',
    found: () => hasHeader('tiny_obj_loader.h'),
    apt: ['libtinyobjloader-dev'],
  },
  {
    what: 'a C++ compiler (c++)',
    for: ['native', 'test', 'lint'],
    found: () => which('c++') && which('g++'),
    apt: ['g++'],
    how: 'xcode-select --install, or your system’s g++',
  },
  {
    what: 'clang++ with its sanitizers',
    for: ['test', 'lint'],
    found: clangHasSanitizers,
    apt: ['clang', 'libclang-rt-dev'],
    how: 'xcode-select --install, or your system’s clang and compiler-rt',
  },
  {
    what: 'clang++ with libFuzzer',
    for: 'fuzz',
    found: clangHasFuzzer,
    apt: ['clang', 'libclang-rt-dev'],
    how: 'brew install llvm, and put its bin folder on PATH',
  },
  {
    what: 'GoogleTest',
    for: ['native', 'test', 'lint'],
    found: () => hasHeader('gtest/gtest.h'),
    apt: ['libgtest-dev'],
    how: 'brew install googletest',
  },
  {
    what: 'Chromium',
    for: 'test',
    found: chromiumPath,
    apt: [headless],
    how: 'install Chromium or Chrome (Ubuntu: snap install chromium) and set CHROMIUM_PATH to its program',
    ubuntuHasIt: false,
  },
  {
    what: 'Chromium without windows',
    for: 'test',
    optional: 'the tests of the page take longer with another one',
    found: () => !!process.env.CHROMIUM_PATH || which(headless),
    apt: [headless],
    ubuntuHasIt: false,
  },
  {
    what: 'clang-format',
    for: ['format', 'lint'],
    found: () => which('clang-format'),
    apt: ['clang-format'],
    how: 'brew install clang-format',
  },
  {
    what: 'clang-tidy',
    for: 'lint',
    found: () => which('clang-tidy'),
    apt: ['clang-tidy'],
    how: 'brew install llvm, and put its bin folder on PATH',
  },
];

/** 'debian', 'ubuntu' (or a system derived from it), or undefined without apt. */
function aptSystem() {
  if (!which('apt-get') || !existsSync('/etc/os-release')) return undefined;
  const release = readFileSync('/etc/os-release', 'utf8');
  if (/^(ID|ID_LIKE)=.*ubuntu/m.test(release)) return 'ubuntu';
  return /^(ID|ID_LIKE)=.*debian/m.test(release) ? 'debian' : undefined;
}

/**
 * The prefix that runs a command as root: empty for root, sudo without a prompt if nobody could
 * answer, and undefined without sudo.
 */
function rootPrefix() {
  if (process.getuid?.() === 0) return [];
  if (!which('sudo')) return undefined;
  return process.stdin.isTTY ? ['sudo'] : ['sudo', '-n'];
}

async function installByApt(packages, noInstall) {
  const prefix = rootPrefix();
  const apt = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', '-o', 'DPkg::Lock::Timeout=300'];
  const update = [...(prefix ?? []), ...apt, 'update'];
  const install = [
    ...(prefix ?? []),
    ...apt,
    'install',
    '-y',
    '--no-install-recommends',
    ...packages,
  ];
  const script = `  ${update.join(' ')}\n  ${install.join(' ')}`;
  if (noInstall || !prefix) {
    const why = noInstall ? notWanted() : 'only root may, and there is no sudo';
    const who = prefix?.length === 0 ? '' : ', as root';
    throw new SetupError(`Not installing, as ${why}. The commands are${who}:\n${script}`);
  }
  console.log(`Installing system packages (up to 600 MB to download, some minutes):\n${script}`);
  for (const [program, ...args] of [update, install]) {
    const { status } = spawnSync(program, args, { stdio: ['ignore', 'inherit', 'inherit'] });
    // Without a fresh list the packages may still be found, but the installation itself must work.
    if (status !== 0 && args.includes('install')) {
      throw new SetupError(
        `apt-get could not install the packages: see its message above. The commands are, as root:\n${script.replaceAll(/sudo (-n )?/g, '')}`,
      );
    }
  }
}

class SetupError extends Error {}

async function installSystemPackages(purposes, noInstall) {
  const wanted = needs.filter((need) => [need.for].flat().some((one) => purposes.includes(one)));
  let missing = wanted.filter((need) => !need.found());
  if (missing.length === 0) return;
  console.log(`Missing: ${missing.map((need) => need.what).join(', ')}.`);
  const system = aptSystem();
  const byApt = missing.filter(
    (need) => system === 'debian' || (system && need.ubuntuHasIt !== false),
  );
  if (byApt.length > 0) {
    try {
      await installByApt(
        byApt.flatMap((need) => need.apt),
        noInstall,
      );
    } catch (error) {
      if (byApt.some((need) => !need.optional)) throw error;
      console.error(error.message);
    }
    missing = missing.filter((need) => !need.found());
  }
  for (const need of missing.filter((need) => need.optional)) {
    console.log(`${need.what} is not installed: ${need.optional}.`);
  }
  const required = missing.filter((need) => !need.optional);
  if (required.length === 0) return;
  const list = required.map((need) => `  ${need.what}: ${need.how}`);
  throw new SetupError(`Still missing; install these and run this again:\n${list.join('\n')}`);
}

/** Whether all packages that package.json names are installed, in the versions of the lock file. */
function npmPackagesAreThere() {
  const installed = inRoot('node_modules/.package-lock.json');
  const lock = inRoot('package-lock.json');
  if (!existsSync(installed) || statSync(installed).mtimeMs < statSync(lock).mtimeMs) return false;
  const { dependencies, devDependencies } = JSON.parse(
    readFileSync(inRoot('package.json'), 'utf8'),
  );
  const names = Object.keys({ ...dependencies, ...devDependencies });
  return [...names, 'karcher-book'].every((name) =>
    existsSync(inRoot(`node_modules/${name}/package.json`)),
  );
}

async function installNpmPackages(noInstall) {
  if (npmPackagesAreThere()) return;
  // With NODE_ENV=production npm would omit the packages of the build.
  const args = ['ci', '--include=dev'];
  const command = `npm ${args.join(' ')}`;
  if (noInstall) {
    throw new SetupError(`Not installing, as ${notWanted()}. The command is:\n  ${command}`);
  }
  console.log(`Installing npm packages into node_modules (about 150 MB): ${command}`);
  const npm = process.env.npm_execpath;
  if (npm?.endsWith('.js')) await run(process.execPath, [npm, ...args]);
  else await run('npm', args);
}

const notWanted = () =>
  process.env.npm_lifecycle_event === 'prepack'
    ? 'npm is making the package'
    : 'KARCHER_NO_INSTALL is set';

/** Ends the process with a sentence if the project's folder is not writable. */
function checkWritable() {
  try {
    accessSync(root, constants.W_OK);
  } catch {
    console.error(
      `${root} cannot be written to; build/, dist/ and node_modules/ are made there. Copy the folder to a place of yours.`,
    );
    process.exit(1);
  }
}

/**
 * Prepares the machine for `purposes` ('build', 'native', 'test', 'fuzz', 'format', 'lint'), or
 * returns at once if it is ready. After a failure it prints the reason and ends the process.
 */
export async function setUp(...purposes) {
  checkWritable();
  const { KARCHER_NO_INSTALL, npm_lifecycle_event } = process.env;
  // A user who installs a package did not request system packages.
  const installsPackage = npm_lifecycle_event === 'prepack';
  const noInstall = installsPackage || (!!KARCHER_NO_INSTALL && KARCHER_NO_INSTALL !== '0');
  let ready = true;
  for (const step of [
    () => installSystemPackages(purposes, noInstall),
    () => installNpmPackages(noInstall),
  ]) {
    try {
      await step();
    } catch (error) {
      console.error(error.message);
      ready = false;
    }
    // If setup only prints commands, it prints all of them.
    if (!ready && !noInstall) break;
  }
  if (!ready) process.exit(1);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const purposes = process.argv.slice(2);
  await setUp(
    ...(purposes.length > 0 ? purposes : ['build', 'native', 'test', 'fuzz', 'format', 'lint']),
  );
  console.log('All required packages are installed.');
}
