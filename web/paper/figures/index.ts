import { circleFigure, rationalFigure } from './controls';
import { farFigure, planeFigure } from './limits';
import { meanFigure, pathFigure } from './means';
import { smallerMesh } from './small';
import { averagesFigure, galleryFigure, graphFigure, resolutionFigure } from './splines';
import type { Figure, Panel } from './types';

/** The figures, in the order of the page. */
export const figures: readonly Figure[] = [
  meanFigure,
  pathFigure,
  resolutionFigure,
  galleryFigure,
  graphFigure,
  averagesFigure,
  rationalFigure,
  circleFigure,
  farFigure,
  planeFigure,
];

/** The same figures with a fraction of the triangles and fewer samples, for quick tests. */
export function smallFigures(part: number, samples: number): Figure[] {
  const smaller = (panel: Panel): Panel => ({
    ...panel,
    mesh: smallerMesh(panel.mesh, part),
    samples: Math.min(panel.samples, samples),
  });
  return figures.map((figure) => ({ ...figure, panels: figure.panels.map(smaller) }));
}
