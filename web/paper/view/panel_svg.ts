import { svgOf } from '../../export/svg';
import { lineStyles } from '../figures/lines';
import type { LineResult, Vector } from '../figures/types';
import { lineColor } from './theme_colors';

/** A place on the stage, in CSS pixels. */
interface Seen {
  x: number;
  y: number;
  hidden: boolean;
}

export interface PanelDrawing {
  width: number;
  height: number;
  lines: readonly LineResult[];
  /** The control points. */
  places: readonly Vector[];
  /** The place on the stage at which a place of the mesh appears. */
  seen(place: Vector): Seen;
  /** The surface alone, as the address of an image. */
  picture: string;
  /** The panel's numbers as JSON. */
  numbers: string;
}

/** A panel as it appears, as an SVG file with its numbers as metadata. */
export function panelSvg(panel: PanelDrawing): string {
  const { width, height, places, seen, picture, numbers } = panel;
  const markers = panel.lines.flatMap(({ id, marker }) =>
    marker ? [{ ...seen(marker), color: lineColor(id) }] : [],
  );
  const points = places.map((place) => ({ ...seen(place), color: lineColor('exactPath') }));
  const lines = panel.lines.flatMap((line) => drawnLines(line, seen));
  const text = numbers.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
  const image = `<image href="${picture}" width="${width}" height="${height}"/>`;
  return svgOf({ width, height, lines, points: [...points, ...markers] }).replace(
    '<g ',
    () => `<metadata>${text}</metadata>\n${image}\n<g `,
  );
}

function drawnLines({ id, polylines, status }: LineResult, seen: PanelDrawing['seen']) {
  const color = lineColor(id);
  return polylines.map((polyline, k) => {
    const places = Array.from({ length: polyline.length / 3 }, (_, i) =>
      seen([...polyline.subarray(3 * i, 3 * i + 3)] as Vector),
    );
    return {
      x: places.map(({ x }) => x),
      y: places.map(({ y }) => y),
      hidden: places.map(({ hidden }) => hidden),
      color,
      width: lineStyles[id].width,
      lost: { color, dashes: '4 5', has: (segment: number) => status[k]?.[segment + 1] === 1 },
    };
  });
}
