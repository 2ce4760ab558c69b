import type { PointLike, SurfacePoint } from '../types.js';
import { UsageError } from './errors.js';

/** How points and numbers are written on the command line and in files. */

const decimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const whole = /^\d+$/;

/** NaN where a text is none. */
export const decimalOf = (text: string) => (decimal.test(text.trim()) ? Number(text) : Number.NaN);

export function parseNumber(text: string, what: string): number {
  const value = decimalOf(text);
  if (Number.isFinite(value)) return value;
  throw new UsageError(`${what} must be a number, not '${text}'`);
}

/** `face:b1,b2`, the weights of the face's second and third corner, or `v:vertex`. */
export function parsePoint(text: string, what: string): PointLike {
  const [head, tail, ...rest] = text.split(':');
  if (tail !== undefined && rest.length === 0) {
    if (head === 'v' && whole.test(tail)) return { vertex: Number(tail) };
    const weights = tail.split(',');
    if (whole.test(head!) && weights.length === 2) {
      return surfacePoint(head!, weights[0]!, weights[1]!, what);
    }
  }
  throw new UsageError(`${what} must be a point, 'face:b1,b2' or 'v:vertex', not '${text}'`);
}

/** A points file: a line `face b1 b2` each; blank lines and comments after `#` are skipped. */
export function parsePoints(text: string, path: string): SurfacePoint[] {
  return text.split(/\r\n|\n|\r/).flatMap((line, i) => {
    const words = line.replace(/#.*/, '').trim().split(/\s+/);
    if (words[0] === '') return [];
    const [face, b1, b2] = words;
    if (words.length !== 3 || !whole.test(face!)) {
      throw new UsageError(`line ${i + 1} of ${path} must be 'face b1 b2', not '${line.trim()}'`);
    }
    return [surfacePoint(face!, b1!, b2!, `line ${i + 1} of ${path}`)];
  });
}

function surfacePoint(face: string, b1: string, b2: string, what: string): SurfacePoint {
  const second = parseNumber(b1, `the weight b1 of ${what}`);
  const third = parseNumber(b2, `the weight b2 of ${what}`);
  return { face: Number(face), bary: [1 - second - third, second, third] };
}
