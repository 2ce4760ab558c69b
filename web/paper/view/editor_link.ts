import type { SurfacePoint } from 'karcher';
import { drawingOf } from '../../model/drawing';
import {
  type ControlPoint,
  emptyFigure,
  type Figure,
  type ParameterName,
  parameterRange,
} from '../../model/figure';
import { formatLink } from '../../model/link';
import { madeKey } from '../../model/meshes';
import type { CurveSpec, MeshSpec } from '../figures/types';

/** The reason why `editorLink` may be null. */
export const noSuchWeights = `the editor’s weights differ by no more than ${(parameterRange.most / parameterRange.least).toLocaleString('en')} times`;

/** A link to the same curve in the editor; null if the editor does not allow its weights. */
export function editorLink(
  mesh: MeshSpec,
  curve: CurveSpec,
  points: readonly SurfacePoint[],
): string | null {
  const figure = figureOf(curve, points);
  return figure && `./index.html#${formatLink(madeKey(mesh), 'karcher', drawingOf(figure))}`;
}

function figureOf(curve: CurveSpec, points: readonly SurfacePoint[]): Figure | null {
  const { kind } = curve;
  if (kind === 'circle') {
    const [center, rim] = points;
    const circleForm = { ...emptyFigure.circleForm, arcs: curve.arcs };
    return { ...emptyFigure, kind, circle: { center: center!, rim: rim! }, circleForm };
  }
  const numbered =
    kind === 'center' || kind === 'rational'
      ? withNumbers(points, 'weight', curve.weights)
      : kind === 'barycentric'
        ? withNumbers(points, 'beta', curve.betas)
        : [...points];
  return numbered && { ...emptyFigure, kind, points: numbered };
}

/**
 * The points with their weights or betas. If these exceed the editor's range, the function
 * multiplies all of them by one factor, since only their ratios matter. Null if no factor fits.
 */
function withNumbers(
  points: readonly SurfacePoint[],
  name: ParameterName,
  numbers: readonly number[],
): ControlPoint[] | null {
  const [least, most] = [Math.min(...numbers), Math.max(...numbers)];
  const fits = least >= parameterRange.least && most <= parameterRange.most;
  const factor = fits ? 1 : 1 / Math.sqrt(least * most);
  if (factor * most > parameterRange.most) return null;
  return points.map((point, i) => ({
    ...point,
    [name]: Number((factor * numbers[i]!).toPrecision(6)),
  }));
}
