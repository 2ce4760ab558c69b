import { type DrawnLine, svgOf } from '../../export/svg';
import { fineDash } from '../../viewer/fat_line';
import type { Vantage } from '../../viewer/vantage';
import { lineStyles } from '../figures/lines';
import type { LineId, LineResult, Vector } from '../figures/types';

export interface PanelDrawing {
  vantage: Vantage;
  lines: readonly LineResult[];
  /** The control points. */
  places: readonly Vector[];
  /** The place on the stage at which a place of the mesh appears. */
  seen(place: Vector): ReturnType<Vantage['project']>;
  colorOf(line: LineId): string;
  /** The surface alone, as the address of an image. */
  picture: string;
  /** The panel's numbers as JSON. */
  numbers: string;
}

/** A panel as it appears, as an SVG file with its numbers as metadata. */
export function panelSvg(panel: PanelDrawing): string {
  const { vantage, places, seen, colorOf, picture, numbers } = panel;
  const { width, height } = vantage.size;
  const markers = panel.lines.flatMap(({ id, marker }) =>
    marker ? [{ ...seen(marker), color: colorOf(id) }] : [],
  );
  const points = places.map((place) => ({ ...seen(place), color: colorOf('exactPath') }));
  const dots = [...points, ...markers].filter(({ height }) => height >= 0);
  const lines = panel.lines.flatMap((line) => drawnLines(line, colorOf(line.id), vantage));
  const text = numbers.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
  const image = `<image href="${picture}" width="${width}" height="${height}"/>`;
  return svgOf({ width, height, lines, points: dots }).replace(
    '<g ',
    () => `<metadata>${text}</metadata>\n${image}\n<g `,
  );
}

function drawnLines(
  { id, polylines, status }: LineResult,
  color: string,
  vantage: Vantage,
): DrawnLine[] {
  const { width } = lineStyles[id];
  return polylines.flatMap((polyline, k) => {
    const parts = [...vantage.seenParts(polyline, { width, onSurface: false })];
    return parts.map(({ segments, middle, ...part }) => {
      const has = (segment: number) => status[k]?.[segments[segment]! + 1] === 1;
      const lost = { color, dashes: vantage.dashesOf(fineDash, middle), has };
      return { ...part, color, width, lost };
    });
  });
}
