/**
 * Fills parts of faces given by their sides: vertical lines through the ends of its sides cut a
 * face into strips. Within a strip no two sides cross, and every second piece is filled, from
 * below.
 */

/** The narrowest strip that is visible, in weights. */
const narrowest = 1e-9;

/**
 * `faces` has the face of each side, in order, and `sides` four numbers each: second and third
 * weight of one end and of the other. Returns triangles: their faces, and the two weights of each
 * corner.
 */
export function filledSides(
  faces: Int32Array,
  sides: Float64Array,
): { parts: Int32Array; corners: Float32Array } {
  const parts: number[] = [];
  const corners: number[] = [];
  for (let first = 0; first < faces.length; ) {
    let end = first;
    while (end < faces.length && faces[end] === faces[first]) end++;
    fillFace(sides.subarray(4 * first, 4 * end), (...triangle) => {
      parts.push(faces[first]!);
      corners.push(...triangle);
    });
    first = end;
  }
  return { parts: Int32Array.from(parts), corners: Float32Array.from(corners) };
}

interface Side {
  left: number;
  right: number;
  /** The height of a side at a place between its ends. */
  at(x: number): number;
}

function fillFace(sides: Float64Array, add: (...triangle: number[]) => void): void {
  const all: Side[] = [];
  const ends = new Set<number>();
  for (let i = 0; i < sides.length; i += 4) {
    const [ax, ay, bx, by] = sides.subarray(i, i + 4) as unknown as [
      number,
      number,
      number,
      number,
    ];
    ends.add(ax);
    ends.add(bx);
    // Vertical sides lie on the lines between strips.
    if (ax === bx) continue;
    const [left, right] = [Math.min(ax, bx), Math.max(ax, bx)];
    const at = (x: number) => (x === bx ? by : ay + ((x - ax) / (bx - ax)) * (by - ay));
    all.push({ left, right, at });
  }
  all.sort((a, b) => a.left - b.left);
  const places = [...ends].sort((a, b) => a - b);
  let open: Side[] = [];
  let next = 0;
  for (const [i, to] of places.entries()) {
    const from = places[i - 1];
    if (from === undefined) continue;
    open = open.filter(({ right }) => right > from);
    while (next < all.length && all[next]!.left <= from) open.push(all[next++]!);
    if (to - from < narrowest) continue;
    const middle = (from + to) / 2;
    const across = open.filter(({ right }) => right >= to);
    across.sort((a, b) => a.at(middle) - b.at(middle));
    for (let k = 1; k < across.length; k += 2) {
      const [below, above] = [across[k - 1]!, across[k]!];
      const [a, b, c, d] = [below.at(from), below.at(to), above.at(to), above.at(from)];
      if (b !== c) add(from, a, to, b, to, c);
      if (a !== d) add(from, a, to, c, from, d);
    }
  }
}
