/** The lines from which the pieces of derived curves come. */
import type { Path } from 'karcher';
import type { ControlPoint, Figure, Origin, Vector } from './figure';
import { dot, minus } from './vectors';

/** A line of an object that is a source of other objects. */
export interface SourceLine {
  id: number;
  path: Path;
}

/** The pieces of one line, by the indices of its points. */
export interface LinePieces {
  /** The indices of the points at which the line passes from one object's line to another's. */
  breaks: number[];
  originOf(from: number, to: number): Origin | undefined;
}

/**
 * Lines count as the same if they are less than this far apart, relative to the surface's diagonal.
 */
const together = 1e-9;

/**
 * The pieces of a line that runs along others. The names of objects come from `nameOf`, and
 * `diagonal` is the surface's diagonal.
 */
export function piecesOf(
  line: Path,
  sources: readonly SourceLine[],
  diagonal: number,
  nameOf: (id: number) => string,
): LinePieces {
  const lines = sources.map(({ id, path }) => ({
    id,
    lengths: path.lengths(),
    places: placesOf(path),
  }));
  const places = placesOf(line);
  /**
   * For the piece after each point: the index of the source along which the piece runs (-1 if
   * none), and the index of the source's segment there.
   */
  const found = places.slice(1).map((end, i) => {
    const middle = end.map((value, k) => (value + places[i]![k]!) / 2) as Vector;
    let best = { off: together * diagonal, line: -1, segment: 0 };
    for (const [number, { places: own }] of lines.entries()) {
      for (let segment = 0; segment + 1 < own.length; segment++) {
        const off = offSegment(middle, own[segment]!, own[segment + 1]!);
        if (off < best.off) best = { off, line: number, segment };
      }
    }
    return best;
  });
  const idAt = (piece: number) => lines[found[piece]!.line]?.id;
  /** The place of a piece's end along its object's line, from 0 at the start to 1 at the end. */
  const along = (piece: number, point: number) => {
    const { line: number, segment } = found[piece]!;
    const { lengths, places: own } = lines[number]!;
    const far = Math.hypot(...minus(places[point]!, own[segment]!));
    return Number(Math.min(1, (lengths[segment]! + far) / lengths.at(-1)!).toFixed(6));
  };
  return {
    breaks: found.map((_, i) => i).filter((i) => i > 0 && idAt(i) !== idAt(i - 1)),
    originOf(from, to) {
      const id = idAt(from);
      if (id === undefined || idAt(to - 1) !== id) return undefined;
      return { of: nameOf(id), from: along(from, from), to: along(to - 1, to) };
    },
  };
}

const placesOf = (path: Path): Vector[] => {
  const polyline = path.polyline({ bits: 64 });
  return Array.from({ length: path.count }, (_, i) => [
    polyline[3 * i]!,
    polyline[3 * i + 1]!,
    polyline[3 * i + 2]!,
  ]);
};

/** The distance of a place from a segment. */
function offSegment(place: Vector, a: Vector, b: Vector): number {
  const [way, there] = [minus(b, a), minus(place, a)];
  const squared = dot(way, way);
  const part = squared > 0 ? Math.min(1, Math.max(0, dot(there, way) / squared)) : 0;
  return Math.hypot(...there.map((value, k) => value - part * way[k]!));
}

/** The point at the start of a piece with the origin of the piece. */
export function withOrigin(point: ControlPoint, origin: Origin | undefined): ControlPoint {
  if (origin === point.origin) return point;
  const { origin: _, ...rest } = point;
  return origin ? { ...rest, origin } : rest;
}

/** The names of the objects that a figure's pieces come from, in their order. */
const namesIn = ({ points }: Figure): string[] => [
  ...new Set(points.flatMap(({ origin }) => (origin ? [origin.of] : []))),
];

/** A text about the origins of a figure's pieces; empty if no piece has an origin. */
export const originsText = (figure: Figure): string =>
  namesIn(figure)
    .map((name) => `from ${name}`)
    .join(', ');

const percent = (part: number) => Math.round(100 * part);

/** Words about the piece after a point; empty if it has no origin. */
export function originText(origin: Origin | undefined): string {
  if (!origin) return '';
  const { of, from, to } = origin;
  return `from ${of}, ${percent(from)} to ${percent(to)} % of its line`;
}
