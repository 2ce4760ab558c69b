import type { CurveSpec, Panel } from './types';

const listed = (numbers: readonly number[]) =>
  new Set(numbers).size === 1 ? `${numbers[0]}` : numbers.join(', ');

/** A panel's title with the numbers of its curve, which sliders may have changed. */
export function panelTitle({ title }: Panel, curve: CurveSpec): string {
  if (curve.kind === 'rational') return `${title}, weights ${listed(curve.weights)}`;
  if (curve.kind === 'barycentric') return `${title}, β = ${listed(curve.betas)}`;
  return title;
}
