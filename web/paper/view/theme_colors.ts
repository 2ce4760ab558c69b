import { sceneColors } from '../../panels/theme';
import { colorSurface } from '../../viewer/surface';
import { lineStyles } from '../figures/lines';
import type { LineId } from '../figures/types';

let colors = new Map<string, string>();
let front = '#888';

/** Reads the colors of the theme from the style sheet. The page calls it before it draws. */
export function readColors(): void {
  const scene = sceneColors();
  colorSurface(scene);
  front = scene.front;
  const probe = document.body.appendChild(document.createElement('i'));
  colors = new Map(
    Object.values(lineStyles).map(({ color }) => {
      probe.style.color = `var(${color})`;
      return [color, getComputedStyle(probe).color];
    }),
  );
  probe.remove();
}

export const lineColor = (id: LineId): string => colors.get(lineStyles[id].color)!;
export const surfaceFront = (): string => front;
