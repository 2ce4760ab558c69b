// How a report on the paper's claims is kept (paper.mjs): what its numbers depend on, and how it is written.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { arch, cpus, type } from 'node:os';
import { inRoot } from './shell.mjs';

/**
 * Where and when: what the numbers depend on; times also on what else the machine had to do, its greatest
 * load. `sources` is the digest of what was measured (sources.mjs).
 */
export function aboutReport({ seed, sources, load }) {
  const { version } = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));
  const git = spawnSync('git', ['rev-parse', '--short', 'HEAD'], { cwd: inRoot('.') });
  const commit = git.status === 0 ? ` ${git.stdout.toString().trim()}` : '';
  const cores = cpus();
  return {
    date: new Date().toISOString().slice(0, 10),
    machine: `${cores[0].model.trim()}, ${cores.length} cores, ${type()} ${arch()}, Node ${process.version}, load ${load.toFixed(1)}`,
    version: `${version}${commit}`,
    sources,
    seed,
  };
}

export const jsonOf = (value) => `${JSON.stringify(value, null, 2)}\n`;

/** Numbers as they are kept: the page shows no more than four digits, and more would only be long. */
export function kept(numbers) {
  const fewDigits = (_, value) =>
    typeof value === 'number' && !Number.isInteger(value) ? Number(value.toPrecision(4)) : value;
  return JSON.parse(JSON.stringify(numbers, fewDigits));
}

/** A report as it is kept: its long lists of numbers in lines of their own. */
export function keptJson(report) {
  const { panels = {}, table = null, studies, meshes, ...rest } = report;
  const whole = jsonOf({ ...rest, numbers: 0 });
  const numbers = Object.entries(kept({ panels, table, studies, meshes }))
    .map(([key, value]) => `${JSON.stringify(key)}:${JSON.stringify(value)}`)
    .join(',\n');
  return whole.replace('"numbers": 0', () => numbers);
}

/** What the verdicts of a kept report are judged by. */
export function measuredOf({
  panels = {},
  table,
  plots,
  studies = {},
  meshes = null,
  load = null,
}) {
  const { convergence, roughness } = plots ?? {};
  const all = { ...studies, ...(convergence && { convergence }), ...(roughness && { roughness }) };
  return { panels, table: table?.cells ?? [], studies: all, meshes, load };
}
