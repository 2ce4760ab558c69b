/**
 * Lines of equal value on a triangle mesh, for a function given at the corners and linear in each
 * triangle. They are straight within triangles, from edge to edge.
 */

/** Steps of 1, 2 or 5 times a power of ten, of which about `count` reach `most`. */
export function roundStep(most: number, count: number): number {
  const power = 10 ** Math.floor(Math.log10(most / count));
  const factor = [1, 2, 5, 10].find((one) => one * power >= (most / count) * 0.999) ?? 10;
  // A division by a whole number rounds only once: 0.2 is 2 / 10.
  return power < 1 ? factor / Math.round(1 / power) : factor * power;
}

/** The end of a segment. */
export interface Crossing {
  /** The key of the edge or corner on which the end lies. */
  edge: number;
  place: readonly [number, number, number];
}

/**
 * The lines of each level, x, y, z of their points; closed ones end at their start. `valueAt`
 * returns the function at corner 3 * triangle + i. It may differ across an edge; lines then end
 * there. Levels ascend. Triangles with a value that is not a number have no lines.
 */
export function levelLines(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  valueAt: (corner: number) => number,
  levels: readonly number[],
): Float32Array[][] {
  const segments: [Crossing, Crossing][][] = levels.map(() => []);
  const vertices = positions.length / 3;
  for (let first = 0; first < triangles.length; first += 3) {
    const [a, b, c] = [valueAt(first), valueAt(first + 1), valueAt(first + 2)];
    const least = Math.min(a, b, c);
    const most = Math.max(a, b, c);
    // The comparison also fails if a value is not a number. Most triangles cross no level.
    if (!(least < most) || !(levels[0]! <= most)) continue;
    const values = [a, b, c];
    for (let level = 0; level < levels.length && levels[level]! <= most; level++) {
      if (levels[level]! <= least) continue;
      const crossings: Crossing[] = [];
      for (let i = 0; i < 3; i++) {
        const j = (i + 1) % 3;
        // A value that equals the level counts as above it, so that a line has two ends in each
        // triangle.
        if (values[i]! < levels[level]! === values[j]! < levels[level]!) continue;
        const [p, q] = [triangles[first + i]!, triangles[first + j]!];
        const part = (levels[level]! - values[i]!) / (values[j]! - values[i]!);
        const at = (axis: number) =>
          positions[3 * p + axis]! + part * (positions[3 * q + axis]! - positions[3 * p + axis]!);
        const edge = Math.min(p, q) * vertices + Math.max(p, q);
        crossings.push({ edge, place: [at(0), at(1), at(2)] });
      }
      segments[level]!.push([crossings[0]!, crossings[1]!]);
    }
  }
  return segments.map(joined);
}

/** Joins segments that meet on an edge into lines; loops end at their start. */
export function joined(segments: readonly (readonly [Crossing, Crossing])[]): Float32Array[] {
  const meeting = new Map<number, number[]>();
  for (const [i, ends] of segments.entries()) {
    for (const { edge } of ends) {
      const there = meeting.get(edge);
      if (there) there.push(i);
      else meeting.set(edge, [i]);
    }
  }
  const used = new Uint8Array(segments.length);
  const next = (edge: number) => meeting.get(edge)!.find((i) => !used[i]);
  const lineFrom = (start: number, from: 0 | 1): Float32Array => {
    const line: number[] = [...segments[start]![from].place];
    let [at, end]: [number, Crossing] = [start, segments[start]![from]];
    for (;;) {
      used[at] = 1;
      const [a, b] = segments[at]!;
      end = a.edge === end.edge ? b : a;
      line.push(...end.place);
      const after = next(end.edge);
      if (after === undefined) return Float32Array.from(line);
      at = after;
    }
  };
  const lines: Float32Array[] = [];
  // Open lines come first, such as those that begin at a boundary, then loops.
  for (const [i, ends] of segments.entries()) {
    for (const from of [0, 1] as const) {
      if (!used[i] && meeting.get(ends[from].edge)!.length === 1) lines.push(lineFrom(i, from));
    }
  }
  for (const i of segments.keys()) if (!used[i]) lines.push(lineFrom(i, 0));
  return lines;
}
