import type { PointLike, SurfacePoint } from '../types.js';
import { figuresOf } from './drawing.js';
import { UsageError } from './errors.js';

/** The syntax of points and numbers on the command line and in files. */

const decimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const whole = /^\d+$/;

/** The number in a text; NaN if it is none. */
export const decimalOf = (text: string) => (decimal.test(text.trim()) ? Number(text) : Number.NaN);

export function parseNumber(text: string, what: string): number {
  const value = decimalOf(text);
  if (Number.isFinite(value)) return value;
  throw new UsageError(`${what} must be a number, not '${text}'`);
}

/** Whether a text is JSON rather than lines of points. */
export const isJson = (text: string) => /^\s*[{[]/.test(text);

/** The value of a JSON text. `path` is its source, for errors. */
export function parseJson(text: string, path: string): unknown {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new UsageError(`${path} is no JSON: ${(cause as Error).message}`, { cause });
  }
}

/**
 * A point in one of the forms `face:b1,b2` (with the weights of the face's second and third
 * corner), `v:vertex`, or JSON.
 */
export function parsePoint(text: string, what: string): PointLike {
  if (isJson(text)) return pointOfJson(parseJson(text, what), what);
  const point = shortPoint(text, what);
  if (point) return point;
  throw new UsageError(`${what} must be a point, 'face:b1,b2' or 'v:vertex', not '${text}'`);
}

function shortPoint(text: string, what: string): PointLike | null {
  const [head, tail, ...rest] = text.split(':');
  if (tail === undefined || rest.length > 0) return null;
  if (head === 'v' && whole.test(tail)) return { vertex: Number(tail) };
  const weights = tail.split(',');
  if (!whole.test(head!) || weights.length !== 2) return null;
  return surfacePoint(head!, weights[0]!, weights[1]!, what);
}

/**
 * The points of a file. The file is JSON, or has a line `face b1 b2`, `face:b1,b2` or `v:vertex`
 * for each point. Blank lines and comments after `#` are skipped.
 */
export function parsePoints(text: string, path: string): PointLike[] {
  if (isJson(text)) return pointsOfJson(parseJson(text, path), path);
  return text.split(/\r\n|\n|\r/).flatMap((line, i) => {
    const words = line.replace(/#.*/, '').trim().split(/\s+/);
    if (words[0] === '') return [];
    const what = `line ${i + 1} of ${path}`;
    const [face, b1, b2] = words;
    const short = words.length === 1 ? shortPoint(face!, what) : null;
    if (short) return [short];
    if (words.length !== 3 || !whole.test(face!)) {
      throw new UsageError(
        `${what} must be 'face b1 b2', 'face:b1,b2' or 'v:vertex', not '${line.trim()}'`,
      );
    }
    return [surfacePoint(face!, b1!, b2!, what)];
  });
}

/**
 * The point of a JSON value. The value is a point as commands print it, or the whole output of a
 * command for one point. The engine checks the point's numbers.
 */
function pointOfJson(value: unknown, what: string): PointLike {
  if (typeof value === 'object' && value !== null) {
    const { point, end, face, bary, vertex } = value as Record<string, unknown>;
    if (typeof vertex === 'number') return { vertex };
    if (typeof face === 'number' && Array.isArray(bary)) return { face, bary } as SurfacePoint;
    const inner = point ?? end;
    if (inner !== undefined) return pointOfJson(inner, what);
  }
  throw new UsageError(`${what} must be a point as JSON, {face, bary} or {vertex}`);
}

/**
 * The points of a JSON value: of a list, of the only object with points in a drawing, or of the
 * output of a command, which has `points`, `samples` or one point.
 */
function pointsOfJson(value: unknown, path: string): PointLike[] {
  const figures = figuresOf(value);
  if (figures) {
    const lists = figures.flatMap(({ points }) => (points.length > 0 ? [points] : []));
    if (lists.length === 1) return lists[0]!.map(({ face, bary }) => ({ face, bary }));
    throw new UsageError(`${path} must have one object with points: it has ${lists.length}`);
  }
  const { points, samples } = Object(value) as { points?: unknown; samples?: unknown };
  const list = Array.isArray(value) ? value : (points ?? samples);
  if (!Array.isArray(list)) return [pointOfJson(value, path)];
  return list.map((entry, i) => pointOfJson(entry, `point ${i} of ${path}`));
}

/**
 * Lists of numbers: a line for each list, or JSON. The JSON is a list of lists, or an object that
 * has such a list under `name`.
 */
export function parseRows(text: string, path: string, name: string): number[][] {
  const rows = isJson(text)
    ? listOfJson(parseJson(text, path), path, name)
    : text.split(/\r\n|\n|\r/).flatMap((line, i) => {
        const words = line
          .replace(/#.*/, '')
          .trim()
          .split(/[\s,]+/);
        if (words[0] === '') return [];
        return [words.map((word) => parseNumber(word, `a number of line ${i + 1} of ${path}`))];
      });
  return rows.map((row, i) => {
    if (Array.isArray(row)) return row as number[];
    throw new UsageError(`entry ${i} of the ${name} in ${path} must be a list of numbers`);
  });
}

/**
 * The numbers of a file: on lines, with spaces or commas between the numbers of a line, or JSON.
 * The JSON is a list, or an object with a list `values` or, as in the output of `karcher distance`,
 * `distance`. Null stands for NaN.
 */
export function parseNumbers(text: string, path: string): number[] {
  if (!isJson(text)) return parseRows(text, path, 'values').flat();
  const value = parseJson(text, path);
  const { values, distance } = Object(value) as { values?: unknown; distance?: unknown };
  const list = Array.isArray(value) ? value : (values ?? distance);
  if (!Array.isArray(list)) throw new UsageError(`${path} must hold values: a list of numbers`);
  return list.map((entry, i) => {
    if (entry === null) return Number.NaN;
    if (typeof entry === 'number') return entry;
    throw new UsageError(`value ${i} of ${path} must be a number or null`);
  });
}

function listOfJson(value: unknown, path: string, name: string): unknown[] {
  const list = Array.isArray(value) ? value : Object(value)[name];
  if (Array.isArray(list)) return list;
  throw new UsageError(`${path} must hold ${name}: lists of numbers`);
}

function surfacePoint(face: string, b1: string, b2: string, what: string): SurfacePoint {
  const second = parseNumber(b1, `the weight b1 of ${what}`);
  const third = parseNumber(b2, `the weight b2 of ${what}`);
  return { face: Number(face), bary: [1 - second - third, second, third] };
}
