import type { CurveOptions, SurfacePoint } from '../types.js';
import { UsageError } from './errors.js';

/** Drawings of the page as input. Their figures are points or curves. */

interface ControlPoint extends SurfacePoint {
  weight?: number;
  beta?: number;
  leg?: SurfacePoint[];
}

interface Figure {
  kind: string;
  settings: {
    closed: boolean;
    degree: number;
    clamped: boolean;
    knots: number[] | null;
    parametrization: 'centripetal' | 'uniform';
  };
  points: ControlPoint[];
}

const splines = ['bspline', 'bezier', 'rational', 'barycentric', 'catmullrom', 'polyline'];

/** The figures of a drawing as the page saves it; null if the value is no drawing. */
export function figuresOf(value: unknown): Figure[] | null {
  const { drawing = value } = Object(value) as { drawing?: unknown };
  const { format, objects } = Object(drawing) as { format?: unknown; objects?: unknown };
  if (format !== 'karcher-drawing' || !Array.isArray(objects)) return null;
  return objects.map(({ figure }) => figure as Figure);
}

/**
 * The splines of a drawing, in its order; null if the value is no drawing. The result omits other
 * figures, such as circles, for which `karcher circle` exists. It also omits curves of the pen tool
 * whose points the page has not found yet.
 */
export function curvesOfDrawing(value: unknown, path: string): CurveOptions[] | null {
  const figures = figuresOf(value);
  if (!figures) return null;
  const curves = figures.filter(({ kind, points }) => splines.includes(kind) && points.length > 0);
  if (curves.length > 0) return curves.map(curveOf);
  const kinds = [...new Set(figures.map(({ kind }) => kind))].join(', ');
  throw new UsageError(`the drawing ${path} has no spline: ${kinds} only`);
}

function curveOf({ kind, settings, points }: Figure): CurveOptions {
  const { closed, degree, clamped, knots, parametrization } = settings;
  const legs = points.slice(0, closed ? undefined : -1).map(({ leg }) => leg ?? null);
  const numbers = (name: 'weight' | 'beta') => {
    const values = points.map((point) => point[name] ?? 1);
    return values.some((value) => value !== 1) && { [`${name}s`]: values };
  };
  return {
    kind: kind as CurveOptions['kind'],
    closed,
    points: points.map(({ face, bary }) => ({ face, bary })),
    ...(kind !== 'barycentric' && legs.some((leg) => leg !== null) && { legs }),
    ...(kind === 'bspline' && {
      degree,
      knots: knots ?? (clamped && !closed ? 'clamped' : 'uniform'),
    }),
    ...((kind === 'bspline' || kind === 'rational') && numbers('weight')),
    ...(kind === 'barycentric' && numbers('beta')),
    ...(kind === 'catmullrom' && { parametrization }),
  } as CurveOptions;
}
