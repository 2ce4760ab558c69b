// Values as JSON, options of workers, and workers without calls.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { load } from 'karcher';
import { loadInWorker } from 'karcher/worker';
import { inRoot } from '../../.tools/shell.mjs';

const points = [3, 40, 150, 210].map((vertex) => ({ vertex }));

test('values survive JSON', async () => {
  const karcher = await load();
  const mesh = karcher.shape('torus', 600);
  for (const options of [
    { kind: 'bspline', points, weights: Float64Array.of(1, 2, 1, 3), knots: 'clamped' },
    { kind: 'bspline', points, degree: 2, knots: [0, 0, 0, 1, 2, 2, 2] },
    { kind: 'rational', points, weights: [1, 2, 1, 3] },
    { kind: 'barycentric', points, betas: [1, 2, 1, 3] },
    { kind: 'polyline', points, legs: [null, [{ vertex: 60 }], null] },
  ]) {
    const curve = mesh.curve(options);
    const value = curve.value();
    const again = JSON.parse(JSON.stringify(value));
    assert.deepEqual(again, value);
    assert.deepEqual(mesh.curve(again).polyline(), mesh.curve(value).polyline());
  }
});

test('a worker with an unknown option is not loaded', async () => {
  await assert.rejects(loadInWorker({ wrker: null }), { code: 'badArgument', message: /wrker/ });
});

test('a forgotten worker does not keep Node alive, and a busy one does', () => {
  const script = `
    import('karcher/worker').then(async ({ loadInWorker }) => {
      const karcher = await loadInWorker();
      const mesh = await karcher.shape('torus', 20000);
      const { length } = await mesh.distance({ vertex: 0 });
      console.log(length);
    });
  `;
  const { status, stdout, stderr } = spawnSync(process.execPath, ['-e', script], {
    ...{ encoding: 'utf8', timeout: 600_000, cwd: import.meta.dirname },
  });
  assert.equal(status, 0, stderr);
  assert.ok(Number(stdout) > 1000, stdout);
});

/** Code of a strict user: options that may be undefined, and read-only values. */
const userCode = `
import { type CurveOptions, load, type SurfacePoint } from 'karcher';
import { checkUp } from 'karcher/checkup';
import { meshFromFile } from 'karcher/formats';
import { loadPeers } from 'karcher/peers';
import { loadInWorker } from 'karcher/worker';

const weights: readonly number[] | undefined = [1, 2, 1, 3];
const points: readonly SurfacePoint[] = [{ face: 0, bary: [1, 0, 0] }];
export async function use(signal: AbortSignal | undefined, tolerance: number | undefined) {
  const mesh = (await load()).shape('torus', 600);
  const options: CurveOptions = { kind: 'rational', points, weights, tolerance, levels: undefined };
  const curve = mesh.curve(JSON.parse(JSON.stringify(mesh.curve(options).value())));
  mesh.distance(points[0]!, { solver: undefined });
  mesh.centersOfMass(points, [[1]], { check: undefined });
  const karcher = await loadInWorker({ signal });
  return [curve.length, karcher, meshFromFile, checkUp, loadPeers] as const;
}
`;

test('types suit a strict user', () => {
  const folder = mkdtempSync(inRoot('build/types-'));
  try {
    writeFileSync(join(folder, 'user.ts'), userCode);
    const compilerOptions = {
      ...{ strict: true, skipLibCheck: false, exactOptionalPropertyTypes: true, noEmit: true },
      ...{ noUncheckedIndexedAccess: true, target: 'ES2022', module: 'NodeNext', types: ['node'] },
      lib: ['ES2023', 'DOM', 'DOM.Iterable', 'ESNext.Disposable'],
    };
    const config = { compilerOptions, include: ['user.ts'] };
    writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(config));
    const { status, stdout } = spawnSync(
      process.execPath,
      [inRoot('node_modules/typescript/bin/tsc'), '-p', folder],
      { encoding: 'utf8' },
    );
    assert.equal(status, 0, stdout);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
