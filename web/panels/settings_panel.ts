import type { Parametrization } from 'karcher';
import type { CurveEdits } from '../editor/curve_edits';
import type { Editor, State } from '../editor/editor';
import { type CurveSettings, isCurve, type Kind } from '../model/figure';
import { type Joint, jointOf } from '../model/pen';
import { byId, make } from './elements';

const degrees = ['1, linear', '2, quadratic', '3, cubic', '4, quartic', '5, quintic'];

/** What a kind of curve has beside its points: closed or open, degree, knots. */
export class SettingsPanel {
  readonly #group = byId('settings');
  readonly #closed = byId<HTMLInputElement>('closed');
  readonly #clamped = byId<HTMLInputElement>('clamped');
  readonly #degree = byId<HTMLSelectElement>('degree');
  readonly #spacing = byId<HTMLSelectElement>('spacing');
  readonly #joint = byId<HTMLSelectElement>('joint');

  constructor(
    private readonly editor: Editor,
    edits: CurveEdits,
    setJoint: (joint: Joint) => void,
  ) {
    for (const [i, label] of degrees.entries()) {
      this.#degree.append(make('option', label, { value: `${i + 1}` }));
    }
    this.#closed.addEventListener('change', () => edits.setClosed(this.#closed.checked));
    this.#clamped.addEventListener('change', () =>
      this.#set({ clamped: this.#clamped.checked, knots: null }),
    );
    // Knots of one's own are for one degree.
    this.#degree.addEventListener('change', () =>
      this.#set({ degree: Number(this.#degree.value), knots: null }),
    );
    this.#joint.addEventListener('change', () => {
      setJoint(this.#joint.value as Joint);
      this.show(editor.state);
    });
    this.#spacing.addEventListener('change', () =>
      this.#set({ parametrization: this.#spacing.value as Parametrization }),
    );
  }

  show({ figure, selection }: State): void {
    const { kind, settings, points } = figure;
    const anchor = points[typeof selection === 'number' ? selection : 0];
    this.#joint.value = jointOf(anchor?.tangents);
    this.#group.hidden = !isCurve(kind);
    this.#closed.checked = settings.closed;
    this.#clamped.checked = settings.clamped && !settings.knots;
    this.#degree.value = `${settings.degree}`;
    this.#spacing.value = settings.parametrization;
    const uses: [HTMLElement, boolean][] = [
      [this.#clamped, kind === 'bspline' && !settings.closed],
      [this.#degree, kind === 'bspline'],
      [this.#spacing, kind === 'catmullrom'],
      [this.#joint, kind === 'pen'],
    ];
    for (const [element, used] of uses) element.closest('label')!.hidden = !used;
  }

  #set(part: Partial<CurveSettings>): void {
    this.editor.setSettings(part);
  }
}

/** A kind as the page calls it. */
export const kindNames: Record<Kind, string> = {
  bspline: 'B-spline',
  bezier: 'Bézier',
  catmullrom: 'Catmull-Rom',
  rational: 'Rational',
  barycentric: 'Barycentric',
  polyline: 'Polyline',
  circle: 'Circle',
  ellipse: 'Ellipse',
  center: 'Center',
  points: 'Points',
  pen: 'Pen',
};

/** What a kind is, in a few words. */
export const kindNotes: Record<Kind, string> = {
  bspline: 'A smooth curve near its control points; with weights, a NURBS curve',
  bezier: 'One segment from the first point to the last',
  catmullrom: 'Smooth, through all points',
  rational: 'A Bézier curve whose weights pull it to its points',
  barycentric: 'One rational segment through all points, shaped by betas',
  polyline: 'Shortest paths from point to point',
  circle: 'All points at one distance from a center',
  ellipse: 'Two radii around a center, at right angles',
  center: 'The center of mass of the points',
  points: 'Single points of the surface',
  pen: 'Bézier curves through anchors with handles: click a corner, drag a smooth anchor (P)',
};
