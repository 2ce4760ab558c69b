/** Numbers in sentences. */

/**
 * Writes a number with two digits; from 10 on as an integer; below 1e-4 with one digit and a power
 * of ten.
 */
export function num(value: number | null): string {
  if (value === null) return 'not measured';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 10) return Math.round(value).toLocaleString('en');
  if (size < 1e-4) return value.toExponential(0).replace('-', '−');
  return `${Number(value.toPrecision(2))}`;
}

export const ms = (value: number | null): string => (value === null ? '–' : `${num(value)} ms`);

/** An angle in radians, written in degrees. */
export const degrees = (angle: number): string => `${num((180 / Math.PI) * angle)}°`;

export const percent = (part: number): string => `${num(100 * part)} %`;

export const sum = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0);

/** The median. Of an even number of values, it is the upper one of the two in the middle. */
export const middle = (values: readonly number[]): number =>
  values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)]!;
