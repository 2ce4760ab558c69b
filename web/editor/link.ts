/**
 * A document as a link's fragment:
 * `mesh=bunny:1&kind=bspline&method=…&points=face,b1,b2,weight;…&circle=face,b1,b2;radius,x,y,z`.
 * A weight of 1 goes without saying.
 */
import type { SurfacePoint } from 'karcher';
import {
  type CircleShape,
  type ControlPoint,
  type CurveDocument,
  type Kind,
  parameterRange,
  type Rim,
  surfacePoint,
  type Vector,
  withParameter,
} from './document';
import { isMethod, type MethodId } from './methods';

export interface Link {
  mesh: string;
  method: MethodId | null;
  document: CurveDocument;
}

const kinds: readonly Kind[] = ['bspline', 'bezier', 'circle', 'center'];

const formatPoint = ({ face, bary }: SurfacePoint) => `${face},${bary[1]},${bary[2]}`;

function formatControlPoint(point: ControlPoint): string {
  const { weight = 1 } = point;
  return weight === 1 ? formatPoint(point) : `${formatPoint(point)},${weight}`;
}

function formatRim(rim: Rim): string {
  if ('face' in rim) return formatPoint(rim);
  return [rim.radius, ...rim.direction].join(',');
}

export function formatLink(mesh: string, method: MethodId, document: CurveDocument): string {
  const parts = [
    `mesh=${encodeURIComponent(mesh).replaceAll('%3A', ':')}`,
    `kind=${document.kind}`,
    `method=${method}`,
    `points=${document.points.map(formatControlPoint).join(';')}`,
  ];
  const { circle } = document;
  if (circle) parts.push(`circle=${formatPoint(circle.center)};${formatRim(circle.rim)}`);
  return parts.join('&');
}

/** Null unless the fragment names a surface; what else it says wrongly is left out. */
export function parseLink(fragment: string): Link | null {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const mesh = fields.get('mesh');
  if (!mesh) return null;
  const kind = kinds.find((one) => one === fields.get('kind')) ?? 'bspline';
  const points = (fields.get('points') ?? '').split(';').map(parseControlPoint);
  const method = fields.get('method');
  return {
    mesh,
    method: isMethod(method) ? method : null,
    document: {
      kind,
      points: points.filter((point) => point !== null),
      circle: parseCircle(fields.get('circle') ?? ''),
    },
  };
}

function parseNumbers(text: string, count: number): number[] | null {
  const fields = text.split(',');
  const values = fields.map(Number);
  const good = fields.length === count && fields.every((field) => field.trim() !== '');
  return good && values.every(Number.isFinite) ? values : null;
}

function parsePoint(text: string): SurfacePoint | null {
  const values = parseNumbers(text, 3);
  if (!values) return null;
  const [face, u, v] = values as Vector;
  const good = Number.isInteger(face) && face >= 0 && u >= 0 && v >= 0 && u + v <= 1;
  return good ? surfacePoint(face, u, v) : null;
}

function parseControlPoint(text: string): ControlPoint | null {
  const [face, u, v, weight = '1'] = text.split(',');
  const point = parsePoint([face, u, v].join(','));
  if (!point) return null;
  const [value] = parseNumbers(weight, 1) ?? [1];
  const { least, most } = parameterRange;
  return withParameter(point, 'weight', Math.min(most, Math.max(least, value!)));
}

function parseCircle(text: string): CircleShape | null {
  const [centerText = '', rimText = ''] = text.split(';');
  const center = parsePoint(centerText);
  if (!center) return null;
  const point = parsePoint(rimText);
  if (point) return { center, rim: point };
  const values = parseNumbers(rimText, 4);
  if (!values || values[0]! <= 0) return null;
  const [radius, ...direction] = values as [number, number, number, number];
  return { center, rim: { radius, direction } };
}

/** A document of which every point is on a surface of that many triangles; null if none is left. */
export function fitting(document: CurveDocument, triangles: number): CurveDocument {
  const fits = (point: SurfacePoint) => point.face < triangles;
  const { circle } = document;
  const circleFits = circle && fits(circle.center) && (!('face' in circle.rim) || fits(circle.rim));
  return {
    ...document,
    points: document.points.filter(fits),
    circle: circleFits ? circle : null,
  };
}
