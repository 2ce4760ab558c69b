/**
 * Lines of equal value on a triangle mesh, for a function that has values at the corners of
 * triangles and is linear in each triangle. They are straight within triangles, from edge to edge.
 */

/**
 * The end of a segment. Segments meet where their ends have the same number, such as that of an
 * edge.
 */
export interface SegmentEnd {
  /** The number of the edge or corner on which the end lies. */
  edge: number;
}

/** A point where a line of equal value crosses an edge. */
export interface LevelCrossing extends SegmentEnd {
  /** The triangle whose segment ends here: one of the two triangles at the edge. */
  face: number;
  /** The weights of that triangle's corners. */
  bary: [number, number, number];
}

/**
 * The lines of each level, as the points where they cross edges; closed ones end at their start.
 * `valueAt` returns the function's value at corner 3 * triangle + i. The values of two triangles
 * may differ at their common edge; lines may then end there. Levels must ascend. Triangles with a
 * value that is not finite have no lines.
 *
 * @example
 * ```ts
 * const triangles = mesh.triangles();
 * const distances = mesh.distance({ vertex: 12 });
 * const [lines] = levelLines(triangles, (corner) => distances[triangles[corner]!]!, [0.5]);
 * ```
 */
export function levelLines(
  triangles: ArrayLike<number>,
  valueAt: (corner: number) => number,
  levels: readonly number[],
): LevelCrossing[][][] {
  const segments: [LevelCrossing, LevelCrossing][][] = levels.map(() => []);
  let vertices = 1;
  for (let corner = 0; corner < triangles.length; corner++) {
    vertices = Math.max(vertices, triangles[corner]! + 1);
  }
  for (let first = 0; first < triangles.length; first += 3) {
    const [a, b, c] = [valueAt(first), valueAt(first + 1), valueAt(first + 2)];
    const least = Math.min(a, b, c);
    const most = Math.max(a, b, c);
    // The comparison also fails if a value is not finite. Most triangles cross no level.
    if (!(least < most && most - least < Infinity) || !(levels[0]! <= most)) continue;
    const values = [a, b, c];
    for (let level = 0; level < levels.length && levels[level]! <= most; level++) {
      if (levels[level]! <= least) continue;
      const crossings: LevelCrossing[] = [];
      for (let i = 0; i < 3; i++) {
        const j = (i + 1) % 3;
        // A value that equals the level counts as above it, so that a line has two ends in each
        // triangle.
        if (values[i]! < levels[level]! === values[j]! < levels[level]!) continue;
        const [p, q] = [triangles[first + i]!, triangles[first + j]!];
        const part = (levels[level]! - values[i]!) / (values[j]! - values[i]!);
        const bary: [number, number, number] = [0, 0, 0];
        bary[i] = 1 - part;
        bary[j] = part;
        crossings.push({ edge: Math.min(p, q) * vertices + Math.max(p, q), face: first / 3, bary });
      }
      segments[level]!.push([crossings[0]!, crossings[1]!]);
    }
  }
  return segments.map((each) => joinedSegments(each));
}

/**
 * Segments that meet at ends of the same number, joined into lines; loops end at their start.
 *
 * @example
 * ```ts
 * const [line] = joinedSegments([[{ edge: 1 }, { edge: 2 }], [{ edge: 3 }, { edge: 2 }]]);
 * ```
 */
export function joinedSegments<End extends SegmentEnd>(
  segments: readonly (readonly [End, End])[],
): End[][] {
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
  const lineFrom = (start: number, from: 0 | 1): End[] => {
    const line = [segments[start]![from]];
    let [at, end] = [start, segments[start]![from]];
    for (;;) {
      used[at] = 1;
      const [a, b] = segments[at]!;
      end = a.edge === end.edge ? b : a;
      line.push(end);
      const after = next(end.edge);
      if (after === undefined) return line;
      at = after;
    }
  };
  const lines: End[][] = [];
  // Open lines, such as lines that begin at a boundary, come first. Loops follow.
  for (const [i, ends] of segments.entries()) {
    for (const from of [0, 1] as const) {
      if (!used[i] && meeting.get(ends[from].edge)!.length === 1) lines.push(lineFrom(i, from));
    }
  }
  for (const i of segments.keys()) if (!used[i]) lines.push(lineFrom(i, 0));
  return lines;
}
