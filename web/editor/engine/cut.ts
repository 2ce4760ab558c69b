/** The engine's results for a cut: the parts of the surface, and the user's choices for them. */
import type { Path } from 'karcher';
import type { Figure } from '../../model/figure';
import type { SurfacePart } from '../../model/parts';
import { choicesOf } from '../../model/parts';
import type { EngineClient } from '../../worker/client';
import type { OutlinesOf } from './derived';

/** A part of the surface, with the user's choice for it. */
export interface ShownPart extends SurfacePart {
  state: 'kept' | 'hidden' | 'deleted';
}

export interface ShownCut {
  /** The parts, the largest first. */
  parts: readonly ShownPart[];
  /**
   * The lines of the cut, each with the id of its object. The parts end exactly at these lines. The
   * view may have more accurate lines of the same objects, which run slightly beside the parts'
   * borders.
   */
  along: readonly { id: number; path: Path }[];
}

interface Made {
  outlines: readonly Path[];
  thickness: number;
  parts: readonly SurfacePart[];
}

/** The last cut of each worker, so that new choices for its parts need no new cut. */
const lastOf = new WeakMap<EngineClient, Made>();

/** Throws a sentence if no line cuts the surface. */
export async function drawCut(
  client: EngineClient,
  { derived, operands = [] }: Figure,
  outlinesOf: OutlinesOf,
): Promise<ShownCut> {
  const { thickness = 0, parts: choices = [] } = derived!;
  const along: { id: number; path: Path }[] = [];
  for (const operand of operands) {
    for (const path of await outlinesOf(operand)) along.push({ id: operand.id, path });
  }
  const outlines = along.map(({ path }) => path);
  if (outlines.length === 0) throw new Error('what the surface is cut along has no line');
  const last = lastOf.get(client);
  const same =
    last?.thickness === thickness &&
    last.outlines.length === outlines.length &&
    outlines.every((path, i) => path === last.outlines[i]);
  const parts = same ? last!.parts : await client.cut(outlines, thickness);
  lastOf.set(client, { outlines, thickness, parts });
  const states = choicesOf(parts, choices);
  return { parts: parts.map((part, i) => ({ ...part, state: states[i]! })), along };
}
