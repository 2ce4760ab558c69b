import { checkOneOf, checkOptions, namesOf } from './check.js';
import type { PolylineOptions } from './types.js';

const polylineOptionNames = namesOf<PolylineOptions>({ bits: true });

/** Whether 64 bits are requested. */
export function inDouble(options: PolylineOptions): boolean {
  checkOptions(options, polylineOptionNames);
  return checkOneOf(options.bits ?? 32, [32, 64], 'the bits of a polyline') === 64;
}

/** A copy of positions with the requested bits. */
export const asPolyline = (positions: Float64Array, options: PolylineOptions) =>
  inDouble(options) ? positions.slice() : new Float32Array(positions);
