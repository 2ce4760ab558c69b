import { circleFigure, rationalFigure } from './controls';
import { farFigure, planeFigure } from './limits';
import { meanFigure, pathFigure } from './means';
import { averagesFigure, galleryFigure, graphFigure, resolutionFigure } from './splines';
import type { Figure, MeshSpec, Panel } from './types';

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

const fewest = 500;

function smallerMesh(spec: MeshSpec, part: number): MeshSpec {
  if (spec.kind === 'bunny') return { ...spec, levels: 0 };
  const triangles = Math.max(fewest, Math.round(spec.triangles * part));
  if (spec.kind === 'simplified') return { ...spec, of: smallerMesh(spec.of, part) };
  return { ...spec, triangles };
}

/** The same figures on meshes of a part of the triangles and with fewer samples: for quick tests. */
export function smallFigures(part: number, samples: number): Figure[] {
  const smaller = (panel: Panel): Panel => ({
    ...panel,
    mesh: smallerMesh(panel.mesh, part),
    samples: Math.min(panel.samples, samples),
  });
  return figures.map((figure) => ({ ...figure, panels: figure.panels.map(smaller) }));
}
