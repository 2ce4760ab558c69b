/** Lines derived from other lines: their offsets, and booleans of their regions. */
import { KarcherError, type Mesh, type Path, type Region, type SurfacePoint } from 'karcher';
import type { BooleanKind, Offset } from '../model/derived';
import type { Enclosing } from '../model/figure';
import type { Fill } from '../model/traced';
import { painted, regionOf } from './fills';

/** Paths arrive as their points. */
type Outline = SurfacePoint[];

export interface DerivedLines {
  paths: Path[];
  fill: Fill | null;
}

/** The region that lines enclose; null if they enclose none. */
function enclosed(mesh: Mesh, outlines: Outline[], enclosing: Enclosing): Region | null {
  try {
    return regionOf(mesh, { outlines, ...enclosing });
  } catch (error) {
    if (error instanceof KarcherError) return null;
    throw error;
  }
}

/**
 * The offset of lines. If all lines are closed and enclose a region, `inwards` means the region's
 * side; otherwise it means the left side. The region of the offset then lies on the left of its
 * lines.
 */
export function offsetOf(
  mesh: Mesh,
  outlines: Outline[],
  {
    distance,
    end,
    side,
    corners = 'round',
    closed,
    ...enclosing
  }: Offset & Enclosing & { closed: boolean },
  fill: boolean,
): DerivedLines {
  const sides = { inwards: 'left', outwards: 'right', both: 'both' } as const;
  const region = closed && side !== 'both' ? enclosed(mesh, outlines, enclosing) : null;
  let from: (Outline | Path)[] = outlines;
  // With two distances the given lines stay, since the distances count from the lines' start, and
  // the boundary may start elsewhere.
  if (region && end === undefined) from = region.boundary();
  else if (region?.data().isLeft === false) from = outlines.map((line) => line.toReversed());
  const paths = mesh.offset(from, {
    distance: end === undefined ? distance : [distance, end],
    side: sides[side],
    corners,
  });
  // The line itself lies in the band around it, and in the region of an outer offset.
  const isLeft = region !== null || side !== 'inwards';
  const shape = { outlines: paths, ...(isLeft && ({ inside: 'left' } as const)) };
  return { paths, fill: fill ? painted(mesh, () => regionOf(mesh, shape)) : null };
}

export function combined(
  mesh: Mesh,
  shapes: (Enclosing & { outlines: Outline[] })[],
  combine: BooleanKind,
  fill: boolean,
): DerivedLines {
  // The boundary of its region replaces a shape with the nonzero rule. The region lies on the left
  // of this boundary.
  const plain = shapes.map(({ rule, ...shape }) =>
    rule
      ? { outlines: regionOf(mesh, { ...shape, rule }).boundary(), inside: 'left' as const }
      : shape,
  );
  const region = mesh.regions(plain, { combine })[0]!;
  return { paths: region.boundary(), fill: fill ? painted(mesh, () => region) : null };
}
