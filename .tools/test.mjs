// `npm test`: sets up, builds everything and runs every test. With --long none is left to the draw, and
// tests take the large numbers of random cases that they keep for KARCHER_LONG=1, but not those of the
// engine with the sanitizers, which would take hours.
import { mkdirSync } from 'node:fs';
import { part } from '../tests/web/part.mjs';
import { buildFacade, buildNative, buildPage, buildWasm, writeBunny } from './build.mjs';
import { runGoogleTest } from './gtest.mjs';
import { runNodeTests } from './node_test.mjs';
import { chromiumPath, setUp } from './setup.mjs';
import { closeWith, filesBelow, inRoot, runStages } from './shell.mjs';

const long = process.argv.includes('--long');
const longCases = long ? { KARCHER_LONG: '1' } : {};
// A stage that takes longer hangs, on a busy machine too.
const minutes = long ? 120 : 40;
const reports = inRoot('build/reports');

const runNative = (preset, more) =>
  runGoogleTest(inRoot(`build/${preset}/karcher_tests`), {
    ...{ reports: `${reports}/${preset}`, minutes },
    ...more,
  });

/** Tests of numbers in many like cases, with the sanitizers two fifths of the time. */
const longestSanitized = [
  'Bridge.OverAPointThatTheCurveInterpolatesPassesIt',
  'CurveInvariance.OfRefinedCurvesToRounding',
  'CurveInvariance.WithTheFastSolverAndTiesWithinAPartOfAnEdge',
  'CurveJoints.OfAutomaticLevelsAreSmoothOnASphere',
  'CurveJoints.OfAutomaticLevelsAreSmoothOnATorus',
  'CurveLevels.OfClosedCurvesMeetAtTheirEnds',
  'CurveLevels.OfThePlaneAreTheSameCurve',
  'CurveMeasure.TangentsAreContinuousUpToTheMesh',
  'CurveNearest.NoOtherPointOfTheCurveIsNearer',
  'CurveNearest.OfAPlaceOnTheCurveIsThatPlace',
  'CurveTolerance.TheCurveKeepsToTheLineThatIsDrawnForIt',
  'FindPath.isTheSameWhereverTheSurfaceLies',
  'Levels.OfEveryTessellationOfThePlaneGiveTheEuclideanCurve',
  'Mean.OfACapOfTheSphereComesNearerTheTruthUnderRefinement',
  'Mean.ThatConvergedIsAMinimumByShortestPaths',
  'MeanOfMany.IsAsLowAsThatOfFields',
  'MeanOfMany.ThatConvergedIsAMinimumByShortestPaths',
  'MeanWeights.MakeThePointTheCenterOfMassWhereTheHessianIsPositiveDefinite',
  'PhongProjection.OfAPointOfTheSurfaceIsThePoint',
  'PolygonFuzz.CurvesOfAutomaticLevelsHoldTogether',
  'RepairMesh.MendsDefectsInPairs',
  'Uniqueness.WhatIsCertainHoldsForAThousandStarts',
];

/** Of the longest tests the sanitizers watch three, which the commit draws; g++ runs all of them. */
function runSanitized() {
  const watched = long ? longestSanitized : part(longestSanitized, 3);
  return runNative('sanitize', {
    env: { UBSAN_OPTIONS: 'print_stacktrace=1' },
    without: longestSanitized.filter((test) => !watched.includes(test)),
  });
}

/** Runs the node:test files of a folder and returns what they counted. */
function runNode(folder, env = {}) {
  const files = filesBelow(folder, /\.test\.m?js$/);
  if (files.length === 0) throw new Error(`there are no tests in ${folder}`);
  return runNodeTests(files, {
    reports: `${reports}/${folder.replaceAll('/', '-')}`,
    env,
    minutes,
  });
}

const build = (what, work, more) => ({
  name: `build of ${what}`,
  run: work,
  isBuild: true,
  ...more,
});
const tests = (what, work, more) => ({ name: `tests of ${what}`, run: work, ...more });
async function buildNativeTests(preset) {
  await writeBunny();
  await buildNative(preset, 'karcher_tests');
}

mkdirSync(reports, { recursive: true });
const stages = [
  { name: 'set-up', run: () => setUp('build', 'test'), isBuild: true },
  build('the engine’s tests, g++', () => buildNativeTests('native')),
  build('the engine’s tests, clang++ with sanitizers', () => buildNativeTests('sanitize')),
  build('the WebAssembly module', buildWasm),
  build('the facade', buildFacade),
  build('the page', buildPage),
  tests('the tools', () => runNode('tests/tools')),
  tests('the engine, g++', () => runNative('native', { env: longCases })),
  tests('the engine, clang++ with sanitizers', runSanitized),
  tests('the module and the command line', () => runNode('tests/wasm', longCases)),
  tests('the figures', () => runNode('tests/paper')),
  tests('the page', () => runNode('tests/web', { CHROMIUM_PATH: chromiumPath(), ...longCases })),
];
closeWith(await runStages(stages));
