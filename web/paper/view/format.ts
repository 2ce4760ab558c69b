/** Numbers as people read them. */

/**
 * Writes a number with two decimals, below 0.1 with four, and a tiny one with one digit and a power
 * of ten.
 */
export function formatDeviation(value: number | null): string {
  if (value === null) return '–';
  if (value === 0) return '0';
  if (value < 1e-4) return value.toExponential(0).replace('e-', '·10⁻').replace(/\d+$/, raised);
  return value < 0.1 ? value.toFixed(4) : value.toFixed(2);
}

/** The same as `formatDeviation`, for a number of either sign. */
export function formatDifference(value: number | null): string {
  if (value === null || value >= 0) return formatDeviation(value);
  return `−${formatDeviation(-value)}`;
}

const raised = (digits: string) => [...digits].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]).join('');

export function formatMilliseconds(value: number | null): string {
  if (value === null) return '–';
  if (value < 0.1) return '< 0.1';
  if (value < 10) return value.toFixed(1);
  return Math.round(value).toLocaleString('en');
}

export function formatBytes(value: number): string {
  const megabytes = value / 1e6;
  return `${megabytes < 10 ? megabytes.toFixed(1) : Math.round(megabytes).toLocaleString('en')} MB`;
}
