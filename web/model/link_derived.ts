/** Derived figures, as fields of links. */
import {
  cornerShapes,
  type Derived,
  mostParts,
  offsetSides,
  type PartChoice,
  plainOffset,
} from './derived';
import type { Kind } from './figure';
import { formatPoint, parsePoint } from './link_numbers';
import { mostObjects } from './saved_drawing';

/**
 * The fields of a figure's sources and settings. `numberOf` returns the position of the object with
 * an id among all objects, counted from 1.
 */
export function derivedFields(
  { sources, offset, parts = [], thickness = 0 }: Derived,
  numberOf: (id: number) => number,
): string[] {
  const choices = parts.map(({ point, state }) => `${formatPoint(point)},${state}`);
  return [
    `of=${sources.map(numberOf)}`,
    ...(offset ? [`distance=${offset.distance}`, `side=${offset.side}`] : []),
    ...(offset?.end === undefined ? [] : [`end=${offset.end}`]),
    ...(offset?.corners ? [`corners=${offset.corners}`] : []),
    ...(choices.length > 0 ? [`parts=${choices.join(';')}`] : []),
    ...(thickness > 0 ? [`thickness=${thickness}`] : []),
  ];
}

/**
 * The derivation of a figure in a fragment. The ids of objects are their positions, counted from 1.
 */
export function parseDerived(kind: Kind, fields: URLSearchParams): Derived {
  const texts = (fields.get('of') ?? '').split(',').slice(0, mostObjects);
  const sources = texts.filter((text) => /^[1-9]\d{0,8}$/.test(text)).map(Number);
  const positive = (name: string) => {
    const value = Number(fields.get(name) ?? NaN);
    return value > 0 && Number.isFinite(value) ? value : null;
  };
  if (kind === 'offset') {
    const side = offsetSides.find((one) => one === fields.get('side')) ?? 'outwards';
    // An offset needs a distance.
    const distance = positive('distance');
    const corners = cornerShapes.find((one) => one === fields.get('corners')) ?? 'round';
    const end = fields.get('end') === '0' ? 0 : (positive('end') ?? undefined);
    return distance
      ? { sources, offset: plainOffset({ distance, end, side, corners }) }
      : { sources: [] };
  }
  if (kind !== 'cut') return { sources };
  const told = (fields.get('parts') ?? '').split(';').slice(0, mostParts);
  const parts = told.flatMap((text): PartChoice[] => {
    const [face, u, v, state] = text.split(',');
    const point = parsePoint([face, u, v].join(','));
    return point && (state === 'hidden' || state === 'deleted') ? [{ point, state }] : [];
  });
  return { sources, parts, thickness: positive('thickness') ?? 0 };
}
