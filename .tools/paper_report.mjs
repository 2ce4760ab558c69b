// The form of a kept report on the paper's claims (paper.mjs): the conditions of its numbers, and
// its file.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { arch, cpus, type } from 'node:os';
import { inRoot } from './shell.mjs';

/**
 * The place and time of a report, on which its numbers depend. Times also depend on the machine's
 * other work, given by its greatest load. `sources` is the digest of the measured sources
 * (sources.mjs).
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

/**
 * Numbers in the form of a kept report. The page shows at most four digits, so that more would only
 * take space.
 */
export function kept(numbers) {
  const fewDigits = (_, value) =>
    typeof value === 'number' && !Number.isInteger(value) ? Number(value.toPrecision(4)) : value;
  return JSON.parse(JSON.stringify(numbers, fewDigits));
}

/** A report as JSON for keeping, with its long lists of numbers on separate lines. */
export function keptJson(report) {
  const { panels = {}, table = null, studies, meshes, ...rest } = report;
  const whole = jsonOf({ ...rest, numbers: 0 });
  const numbers = Object.entries(kept({ panels, table, studies, meshes }))
    .map(([key, value]) => `${JSON.stringify(key)}:${JSON.stringify(value)}`)
    .join(',\n');
  return whole.replace('"numbers": 0', () => numbers);
}

/** The numbers of a kept report that determine its verdicts. */
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
