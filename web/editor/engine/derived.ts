/** The engine's results for derived figures. */
import type { Path } from 'karcher';
import { isBoolean } from '../../model/derived';
import type { Figure, Operand } from '../../model/figure';
import { enclosedBy, enclosedTogether } from '../../model/sources';
import type { EngineClient, OutlinedShape } from '../../worker/client';
import type { ShownIsolines } from './circle_drawing';

/** The lines of an operand. */
export type OutlinesOf = (operand: Operand) => Promise<readonly Path[]>;

const emptyResults: Partial<Record<Figure['kind'], string>> = {
  intersection: 'they have no part in common',
  difference: 'nothing is left of the first one',
  exclusion: 'each covers the others',
};

/** Draws a derived figure. Throws an error with the reason if the result is empty. */
export async function drawDerived(
  client: EngineClient,
  { kind, derived, operands = [] }: Figure,
  outlinesOf: OutlinesOf,
  fill: boolean,
): Promise<ShownIsolines> {
  if (operands.length === 0) throw new Error('what it was made of is gone');
  const shapes: OutlinedShape[] = [];
  // Operands come one after the other: a worker traces one curve at a time.
  for (const operand of operands) {
    shapes.push({ outlines: await outlinesOf(operand), ...enclosedBy(operand.figure) });
  }
  if (shapes.some(({ outlines }) => outlines.length === 0)) {
    throw new Error('something that it is made of has no line');
  }
  const lines = isBoolean(kind)
    ? await client.combined(shapes, kind, fill)
    : await client.offset(
        shapes.flatMap(({ outlines }) => outlines),
        { ...derived!.offset!, ...enclosedTogether(operands) },
        fill,
      );
  if (lines.lines.length === 0) {
    const { distance = 0, end = distance } = derived?.offset ?? {};
    const reach = [...new Set([distance, end])].map((one) => one.toPrecision(4)).join(' to ');
    const far = `nothing of the surface lies ${reach} away from it on that side`;
    throw new Error(kind === 'offset' ? far : (emptyResults[kind] ?? 'together they have no rim'));
  }
  const from = shapes.flatMap(({ outlines }, i) =>
    outlines.map((path) => ({ id: operands[i]!.id, path })),
  );
  return { ...lines, exact: true, ...(isBoolean(kind) && { from }) };
}
