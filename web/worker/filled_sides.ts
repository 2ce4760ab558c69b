/**
 * Fills parts of faces, described by their sides. A sweep from left to right joins each vertex to
 * the vertices of the swept part that it sees (S. Hertel, K. Mehlhorn, "Fast triangulation of
 * simple polygons", 1983). Triangles have corners only at ends of sides. So neighbors have whole
 * edges in common, also across faces, and no pixel between them is missing.
 */

type Place = readonly [x: number, y: number];

/** A side from its left end to its right one; upright sides go up. */
interface Side {
  left: Place;
  right: Place;
}

/**
 * The border of the triangles made so far, between a side and the next side above it: places from
 * the lower to the upper side.
 */
type Front = Place[];

/** Weights are multiples of 1 / `scale`. */
const scale = 2 ** 40;

/**
 * The triangles that fill parts of faces: their faces, and the two weights of each corner. `faces`
 * has the face of each side, in order. `sides` has four numbers for each side: the second and third
 * weights of its two ends.
 */
export function filledSides(
  faces: Int32Array,
  sides: Float64Array,
): { parts: Int32Array; corners: Float64Array } {
  const parts: number[] = [];
  const corners: number[] = [];
  for (let first = 0; first < faces.length; ) {
    let end = first;
    while (end < faces.length && faces[end] === faces[first]) end++;
    fillFace(sides.subarray(4 * first, 4 * end), (a, b, c) => {
      parts.push(faces[first]!);
      corners.push(...a, ...b, ...c);
    });
    first = end;
  }
  return { parts: Int32Array.from(parts), corners: Float64Array.from(corners) };
}

const isBefore = ([ax, ay]: Place, [bx, by]: Place) => ax < bx || (ax === bx && ay < by);
const isSame = ([ax, ay]: Place, [bx, by]: Place) => ax === bx && ay === by;

/** The turn from a and b to c: positive for a left turn, 0 on a line. Its sign is exact. */
function turn([ax, ay]: Place, [bx, by]: Place, [cx, cy]: Place): number {
  const [x, y, u, v] = [bx - ax, by - ay, cx - ax, cy - ay];
  const [over, under] = [x * v, y * u];
  // Rounding keeps the order of products, so that only equal ones need an exact computation.
  if (over !== under || over === 0) return over - under;
  const [p, q, r, s] = [x, y, u, v].map((value) => BigInt(Math.round(value * scale)));
  return Number(p! * s! - q! * r!);
}

type Add = (a: Place, b: Place, c: Place) => void;

function fillFace(sides: Float64Array, add: Add): void {
  const all: Side[] = [];
  for (let i = 0; i < sides.length; i += 4) {
    const [a, b]: Place[] = [
      [sides[i]!, sides[i + 1]!],
      [sides[i + 2]!, sides[i + 3]!],
    ];
    if (!isSame(a!, b!))
      all.push(isBefore(a!, b!) ? { left: a!, right: b! } : { left: b!, right: a! });
  }
  const places = all.flatMap(({ left, right }) => [left, right]);
  places.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  all.sort((a, b) => a.left[0] - b.left[0] || a.left[1] - b.left[1]);
  /**
   * The sides that the sweep meets, from below. The filling lies between the first and the second,
   * between the third and the fourth, and so on.
   */
  let open: Side[] = [];
  const fronts = new Map<Side, Front>();
  let next = 0;
  for (const [i, place] of places.entries()) {
    if (i > 0 && isSame(place, places[i - 1]!)) continue;
    const ended = open.filter(({ right }) => isSame(right, place));
    const below = open.filter(
      (side) => !isSame(side.right, place) && turn(side.left, side.right, place) > 0,
    );
    const above = open.slice(below.length + ended.length);
    const begun: Side[] = [];
    while (next < all.length && isSame(all[next]!.left, place)) begun.push(all[next++]!);
    begun.sort((a, b) => turn(place, b.right, a.right));
    const isFilled = below.length % 2 === 1;
    const under = below.at(-1);
    const before = (under && fronts.get(under)) ?? [];
    const rows = ended.map((side) => fronts.get(side) ?? []);
    for (const side of ended) fronts.delete(side);
    // The fronts between the ended sides end here; the fronts below and above go on from here.
    for (const [k, row] of rows.slice(0, -1).entries())
      if ((k % 2 === 1) === isFilled) close(row, place, add);
    let lower: Front = [];
    let upper: Front = [];
    if (ended.length > 0) {
      lower = isFilled ? joinedAbove(before, place, add) : [];
      upper = (ended.length % 2 === 1) === isFilled ? [] : joinedBelow(rows.at(-1)!, place, add);
    } else if (isFilled) [lower, upper] = parted(before, place, add);
    if (begun.length === 0) {
      if (isFilled) fronts.set(under!, [...lower, ...upper.slice(1)]);
    } else {
      if (isFilled) fronts.set(under!, lower);
      for (const [k, side] of begun.entries()) {
        const last = k === begun.length - 1;
        if ((k % 2 === 0) === isFilled) continue;
        fronts.set(side, last && upper.length > 0 ? upper : [place]);
      }
    }
    open = [...below, ...begun, ...above];
  }
}

/**
 * Adds a place at a front's upper end. Triangles join the place to the last places of the front, as
 * far as it sees them.
 */
function joinedAbove(front: Front, place: Place, add: Add): Front {
  let count = front.length;
  while (count > 1 && turn(front[count - 2]!, place, front[count - 1]!) > 0) {
    add(front[count - 2]!, place, front[count - 1]!);
    count--;
  }
  return [...front.slice(0, count), place];
}

/**
 * Adds a place at a front's lower end. Triangles join the place to the first places of the front,
 * as far as it sees them.
 */
function joinedBelow(front: Front, place: Place, add: Add): Front {
  let first = 0;
  while (first < front.length - 1 && turn(front[first]!, place, front[first + 1]!) > 0) {
    add(front[first]!, place, front[first + 1]!);
    first++;
  }
  return [place, ...front.slice(first)];
}

/**
 * Divides a front at its rightmost place, and adds a place to both parts. Triangles join the added
 * place to the places that it sees.
 */
function parted(front: Front, place: Place, add: Add): [Front, Front] {
  let right = 0;
  for (const [i, other] of front.entries()) if (isBefore(front[right]!, other)) right = i;
  return [
    joinedAbove(front.slice(0, right + 1), place, add),
    joinedBelow(front.slice(right), place, add),
  ];
}

function close(front: Front, place: Place, add: Add): void {
  if (front.length > 1) parted(front, place, add);
}
