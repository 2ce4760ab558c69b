/** Numbers and points in links. */
import type { SurfacePoint } from 'karcher';
import { surfacePoint, type Vector } from './figure';

export const formatPoint = ({ face, bary }: SurfacePoint) => `${face},${bary[1]},${bary[2]}`;

export function parseNumbers(text: string, count: number): number[] | null {
  const fields = text.split(',');
  // The sum turns -0 into 0.
  const values = fields.map((field) => Number(field) + 0);
  const good = fields.length === count && fields.every((field) => field.trim() !== '');
  return good && values.every(Number.isFinite) ? values : null;
}

export function parsePoint(text: string): SurfacePoint | null {
  const values = parseNumbers(text, 3);
  if (!values) return null;
  const [face, u, v] = values as Vector;
  const good = Number.isInteger(face) && face >= 0 && u >= 0 && v >= 0 && u + v <= 1;
  return good ? surfacePoint(face, u, v) : null;
}
