// Comparisons of new measurements with saved ones.

/** Fields that depend on a clock or the machine, and texts that contain the numbers. */
const apart =
  /ms$|memory|^(date|machine|version|sources|load|seconds|measured|on|reason|most|renewed)$/i;

/**
 * Whether two numbers agree up to two per cent, or three per cent of a count, and rounding. Other
 * compilers round differently, so that searches that nearly fail may succeed, and values near 0
 * change.
 */
export function isNear(a, b) {
  if (typeof a !== 'number' || typeof b !== 'number') return a === b;
  const most = 0.02 * Math.max(Math.abs(a), Math.abs(b));
  const isCount = Number.isInteger(a) && Number.isInteger(b);
  return Math.abs(a - b) <= Math.max(most, isCount ? 3 : 1e-6);
}

/**
 * The paths at which two values of numbers, lists and objects differ, except times and similar
 * fields.
 */
export function differences(now, saved, path = '') {
  if (now === null || saved === null || typeof now !== 'object' || typeof saved !== 'object') {
    return isNear(now, saved) ? [] : [`${path}: ${saved} was saved, now ${now}`];
  }
  const keys = new Set([...Object.keys(now), ...Object.keys(saved)]);
  return [...keys].flatMap((key) =>
    apart.test(key) ? [] : differences(now[key] ?? null, saved[key] ?? null, `${path}/${key}`),
  );
}

const number = /-?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?/g;
const numbersOf = (text) =>
  (text.match(number) ?? []).map((one) => Number(one.replaceAll(',', '')));

/** Columns that consist of rounding errors or times. */
const ofRounding = /^(rotated|both ways|exact, in these|time)$|\b[mun]s\b/;
/** Times anywhere in a line. */
const times = /\d[\d,.]* [mun]?s\b/g;

/** The differences between the lines of a study and the saved ones, except times. */
export function lineDifferences(now, saved) {
  if (now.length !== saved.length) return [`${saved.length} lines were saved, now ${now.length}`];
  let heads = [];
  return now.flatMap((line, i) => {
    const [cells, before] = [line, saved[i]].map((one) =>
      one.split('|').map((cell) => cell.trim()),
    );
    if (/^\|[\s|:-]+$/.test(now[i + 1] ?? '')) heads = cells;
    const isRow = line.startsWith('|');
    return cells.flatMap((cell, k) => {
      if (isRow && ofRounding.test(heads[k] ?? '')) return [];
      const [here, there] = [cell, before[k] ?? ''].map((one) => one.replaceAll(times, 'a time'));
      const [a, b] = [here, there].map(numbersOf);
      const same = a.length === b.length && a.every((value, j) => isNear(value, b[j]));
      const words = here.replaceAll(number, '#') === there.replaceAll(number, '#');
      return same && words ? [] : [`'${before[k]}' was saved, now '${cell}': ${line}`];
    });
  });
}
