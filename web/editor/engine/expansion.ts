import type { Path, SurfacePoint } from 'karcher';
import { expanding } from '../../model/combining';
import { isDerived } from '../../model/derived';
import { emptyFigure, type Figure, type Vector } from '../../model/figure';
import { anchorsOf } from '../../model/stroke';
import type { Surface } from '../../viewer/surface';
import type { Editor } from '../state/editor';
import type { Session } from './session';

/** The tolerance of a pen curve that replaces lines, as a part of the diagonal. */
const tolerance = 5e-4;

/** Converts derived objects into curves of the pen, which no longer follow their sources. */
export class Expansion {
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly surface: () => Surface | null,
  ) {}

  async expand(): Promise<void> {
    const { editor, session } = this;
    editor.interrupt();
    const surface = this.surface();
    const { state } = editor;
    const paths = session.view.revision === state.revision && session.view.isolines?.outlines;
    const { client } = session;
    if (!paths || !surface || !client || !isDerived(state.figure.kind) || editor.refuses()) return;
    const figures = paths.map((path) => curveAlong(path, surface, client.info.diagonal));
    editor.perform(expanding(state.drawing, figures), { selection: null, chosen: [], none: false });
  }
}

function curveAlong(path: Path, surface: Surface, diagonal: number): Figure {
  const samples = path.points().map((point: SurfacePoint) => {
    const place = surface.fromScene(surface.position(point));
    const normal = surface.directionFromScene(surface.normal(point)) as Vector;
    const most = tolerance * diagonal;
    return { point, place, normal, tolerance: most, pixel: most };
  });
  const points = anchorsOf(samples, path.closed);
  return {
    ...emptyFigure,
    kind: 'pen',
    points,
    settings: { ...emptyFigure.settings, closed: path.closed },
  };
}
