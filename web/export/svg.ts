import type { Planar } from '../model/cubic_fit';
import type { SeenLine } from '../viewer/vantage';
import { pathData } from './beziers';

/** A line of an object or of the page; with a single place it is a dot. */
export interface DrawnLine extends SeenLine {
  /** Consecutive lines of one object form a group with its name. */
  object?: { id: number; name: string; opacity: number; description?: string };
  color: string;
  width: number;
  /** The value of `stroke-dasharray`; a line without it is solid. */
  dashes?: string;
  /** Whether the drawing omits the hidden parts of the line, as it does with an outline. */
  visibleOnly?: boolean;
  /** Segments in another color, by the index of their first vertex. */
  lost?: { color: string; dashes: string; has(segment: number): boolean };
}

/**
 * A region in the view. A triangle has six numbers, x and y of its corners; all triangles have the
 * same orientation.
 */
export interface DrawnFill {
  id?: number;
  color: string;
  opacity: number;
  triangles: Float32Array;
}

export interface Drawing {
  width: number;
  height: number;
  /** The fills, which lie below all lines. */
  fills?: DrawnFill[];
  lines: DrawnLine[];
  points: { x: number; y: number; color: string; filled?: boolean; hidden?: boolean }[];
  /**
   * The surface's outline in the view: x, y of each line's points. A drawing with an outline omits
   * the hidden parts of lines.
   */
  outline?: { lines: readonly Float32Array[]; color: string };
}

/**
 * The drawing as it appears, as an SVG file. Parts of lines behind the surface are faint, or
 * missing if they are not to be seen.
 */
export const svgOf = (drawing: Drawing): string => [...partsOfSvg(drawing)].join('');

/** The file's text, in parts. */
export function* partsOfSvg({
  width,
  height,
  fills = [],
  lines,
  points,
  outline,
}: Drawing): Generator<string> {
  const [w, h] = [Math.round(width), Math.round(height)];
  yield `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${w} ${h}" width="${w}" height="${h}">
`;
  for (const fill of fills) yield* fillPath(fill);
  yield `<g fill="none" stroke-linecap="round" stroke-linejoin="round">
`;
  if (outline) for (const path of outlinePaths(outline)) yield `${path}\n`;
  let group: DrawnLine['object'];
  for (const line of lines) {
    if (line.object?.id !== group?.id) {
      if (group) yield '</g>\n';
      group = line.object;
      if (group) {
        // The opacity applies to the group, since its lines overlap.
        const opacity = group.opacity < 1 ? ` opacity="${short(group.opacity)}"` : '';
        const { name, description } = group;
        const words = description ? `<desc>${escaped(description)}</desc>` : '';
        yield `<g id="object-${group.id}"${opacity}><title>${escaped(name)}</title>${words}\n`;
      }
    }
    for (const path of pathsOf(line, outline || line.visibleOnly ? 'left out' : 'faint'))
      yield `${path}\n`;
  }
  if (group) yield '</g>\n';
  yield '</g>\n';
  for (const { x, y, color, filled, hidden } of points) {
    if (outline && hidden) continue;
    const look = filled
      ? `r="4" fill="${color}"`
      : `r="4.5" fill="#fff" stroke="${color}" stroke-width="2.5"`;
    yield `<circle cx="${short(x)}" cy="${short(y)}" ${look}${hidden ? faint : ''}/>\n`;
  }
  yield '</svg>\n';
}

const escaped = (text: string) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

const short = (value: number) => `${Number(value.toFixed(2))}`;

/** A fill as one path, since no seam is visible between triangles of one path. */
function* fillPath({ id, color, opacity, triangles }: DrawnFill): Generator<string> {
  yield `<path fill="${color}" fill-opacity="${short(opacity)}" d="`;
  for (let i = 0; i < triangles.length; i += 6) {
    const at = (corner: number) =>
      `${short(triangles[i + 2 * corner]!)} ${short(triangles[i + 2 * corner + 1]!)}`;
    yield `M${at(0)}L${at(1)}L${at(2)}Z`;
  }
  yield id === undefined ? '"/>\n' : `" id="fill-${id}"/>\n`;
}

/** The look of hidden parts. */
const faint = ' opacity="0.3"';

const outlineWidth = 1.5;

function* outlinePaths({ lines, color }: NonNullable<Drawing['outline']>): Generator<string> {
  yield `<g id="outline" stroke="${color}" stroke-width="${outlineWidth}">`;
  for (const line of lines) {
    const count = line.length / 2;
    const places = Array.from(
      { length: count },
      (_, i): Planar => [line[2 * i]!, line[2 * i + 1]!],
    );
    yield `<path d="${pathData(places)}"/>`;
  }
  yield '</g>';
}

/**
 * A circle for a dot, or a path for each run of segments with the same look. Hidden dots and runs
 * may be left out.
 */
function pathsOf(
  { x, y, hidden, color, width, dashes, lost }: DrawnLine,
  behind: 'faint' | 'left out',
): string[] {
  if (x.length === 1) {
    if (hidden[0] && behind === 'left out') return [];
    const place = `cx="${short(x[0]!)}" cy="${short(y[0]!)}" r="${short(width / 2)}"`;
    return [`<circle ${place} fill="${color}"${hidden[0] ? faint : ''}/>`];
  }
  const lookOf = (segment: number) => {
    const seen = hidden[segment] && hidden[segment + 1] ? faint : '';
    const look = lost?.has(segment) ? lost : { color, dashes };
    // Dashes have no round ends, which would fill the gaps between them.
    const dashed = look.dashes && ` stroke-dasharray="${look.dashes}" stroke-linecap="butt"`;
    return `stroke="${look.color}"${dashed ?? ''} stroke-width="${width}"${seen}`;
  };
  const at = (vertex: number): Planar => [x[vertex]!, y[vertex]!];
  const paths: string[] = [];
  let first = 0;
  for (let segment = 1; segment < x.length; segment++) {
    if (segment < x.length - 1 && lookOf(segment) === lookOf(first)) continue;
    const isLeftOut = behind === 'left out' && hidden[first] && hidden[first + 1];
    const vertices = Array.from({ length: segment - first + 1 }, (_, i) => at(first + i));
    if (!isLeftOut) paths.push(`<path ${lookOf(first)} d="${pathData(vertices)}"/>`);
    first = segment;
  }
  return paths;
}
