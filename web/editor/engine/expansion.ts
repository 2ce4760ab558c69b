import type { Path, SurfacePoint } from 'karcher';
import { expanding } from '../../model/combining';
import { isDerived } from '../../model/derived';
import { activeObject, type DrawnObject, objectOf } from '../../model/drawing';
import { emptyFigure, type Figure, type Vector, withInside } from '../../model/figure';
import { longestName, shortened } from '../../model/names';
import { type LinePieces, piecesOf } from '../../model/origins';
import { enclosedBy, resolvedFigure } from '../../model/sources';
import { anchorsOf } from '../../model/stroke';
import type { Surface } from '../../viewer/surface';
import type { Editor } from '../state/editor';
import type { Session } from './session';

/** The tolerance of a pen curve that replaces lines, relative to the surface's diagonal. */
const tolerance = 5e-4;

/** Converts derived objects into curves of the pen, which no longer follow their sources. */
export class Expansion {
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly surface: () => Surface | null,
    private readonly nameOf: (object: DrawnObject) => string,
  ) {}

  async expand(): Promise<void> {
    const { editor, session } = this;
    editor.interrupt();
    const surface = this.surface();
    const { state } = editor;
    const paths = session.view.revision === state.revision && session.view.isolines?.outlines;
    const { client } = session;
    if (!paths || !surface || !client || !isDerived(state.figure.kind) || editor.refuses()) return;
    const { from } = session.view.isolines!;
    const nameOf = (id: number) => {
      const object = objectOf(state.drawing, id);
      return object ? shortened(this.nameOf(object), longestName) : '';
    };
    const { diagonal } = client.info;
    const figures = paths.map((path) =>
      curveAlong(path, surface, diagonal, from && piecesOf(path, from, diagonal, nameOf)),
    );
    // The lines of several curves enclose the region together, and none encloses it alone.
    if (figures.length === 1) {
      const { inside } = enclosedBy(resolvedFigure(state.drawing, activeObject(state.drawing)));
      figures[0] = withInside(figures[0]!, inside);
    }
    editor.perform(expanding(state.drawing, figures), { selection: null, chosen: [], none: false });
  }
}

function curveAlong(path: Path, surface: Surface, diagonal: number, pieces?: LinePieces): Figure {
  const samples = path.points().map((point: SurfacePoint) => {
    const place = surface.fromScene(surface.position(point));
    const normal = surface.directionFromScene(surface.normal(point)) as Vector;
    const most = tolerance * diagonal;
    return { point, place, normal, tolerance: most, pixel: most };
  });
  const points = anchorsOf(samples, path.closed, pieces);
  return {
    ...emptyFigure,
    kind: 'pen',
    points,
    settings: { ...emptyFigure.settings, closed: path.closed },
  };
}
