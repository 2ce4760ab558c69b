import type { ConvergencePoint } from '../claims/convergence';
import type { RoughnessPoint } from '../claims/roughness';
import type { LineId } from '../figures/types';

/** The numbers of a plot. For each place on the x axis, each method has a value or a gap (null). */
export interface Plot {
  x: number[];
  lines: { method: LineId; values: (number | null)[] }[];
}

function plotOf<Point extends { method: LineId }>(
  points: readonly Point[],
  at: (point: Point) => number,
  value: (point: Point) => number | null,
): Plot {
  const x = [...new Set(points.map(at))].toSorted((a, b) => a - b);
  const methods = [...new Set(points.map(({ method }) => method))];
  const lines = methods.map((method) => {
    const own = points.filter((point) => point.method === method);
    const values = x.map((place) => {
      const point = own.find((one) => at(one) === place);
      // A logarithmic scale cannot show zero.
      return (point && value(point)) || null;
    });
    return { method, values };
  });
  return { x, lines };
}

/** Error against mean edge, both in units of the surface. */
export const convergencePlot = (
  points: readonly ConvergencePoint[],
  surface: ConvergencePoint['surface'],
): Plot =>
  plotOf(
    points.filter((point) => point.surface === surface),
    ({ meanEdge }) => meanEdge,
    ({ error }) => error,
  );

/** Residual against noise, both in mean edges. */
export const roughnessPlot = (points: readonly RoughnessPoint[]): Plot =>
  plotOf(
    points,
    ({ noise }) => noise,
    ({ residual }) => residual,
  );

/**
 * The order of convergence: the least-squares slope of the logarithm of the error over the
 * logarithm of the edge length. Null for fewer than two errors.
 */
export function orderOf({ x }: Plot, values: readonly (number | null)[]): number | null {
  const logs = x.flatMap((edge, i) => {
    const value = values[i];
    return value ? [[Math.log(edge), Math.log(value)] as const] : [];
  });
  if (logs.length < 2) return null;
  const mean = (k: 0 | 1) => logs.reduce((sum, one) => sum + one[k], 0) / logs.length;
  const [mx, my] = [mean(0), mean(1)];
  const above = logs.reduce((sum, [a, b]) => sum + (a - mx) * (b - my), 0);
  return above / logs.reduce((sum, [a]) => sum + (a - mx) ** 2, 0);
}
