import type { CurveGeometry, CurveOptions } from '../types.js';
import type { Arguments } from './arguments.js';
import { UsageError } from './errors.js';
import { levelsOption, type Option } from './options.js';

/** The options for tracing a curve. */
export const samplingOptions: readonly Option[] = [
  {
    name: 'samples',
    value: 'N|adaptive',
    help: 'the number of samples for each segment, at t = i / (N - 1), or as many as the tolerance needs',
    default: '128',
  },
  {
    name: 'tolerance',
    value: 'T',
    help: 'of adaptive samples: the largest distance of the curve from the geodesics between them, as a part of the diagonal',
    default: '1e-4',
  },
  {
    name: 'geometry',
    value: 'geodesic|exact',
    help: 'the curve between the samples: geodesics, or its own crossings of edges',
    default: 'geodesic',
  },
  levelsOption,
];

export function samplingOf(
  args: Arguments,
): Pick<CurveOptions, 'samples' | 'tolerance' | 'geometry' | 'levels'> {
  const adaptive = args.given('tolerance') || args.text('samples') === 'adaptive';
  if (args.given('tolerance') && args.given('samples') && args.text('samples') !== 'adaptive') {
    throw new UsageError(`${args.command} takes --samples or --tolerance, not both`);
  }
  return {
    geometry: args.choice<CurveGeometry>('geometry'),
    levels: args.levels(),
    ...(adaptive
      ? { samples: 'adaptive' as const, tolerance: args.number('tolerance') }
      : { samples: args.integer('samples') }),
  };
}
