import type { MeshInfo } from 'karcher';
import { pointsNeeded } from '../editor/document';
import type { Selection, State } from '../editor/editor';
import type { View } from '../editor/session';
import { byId, formatCount } from './elements';
import { sentenceOf } from './messages';

/** Work this short goes without saying. */
const patienceMilliseconds = 300;

const statusNames: Record<string, string> = {
  indefinite: 'more than one center',
  boundary: 'the surface ends',
  noProgress: 'the search got stuck',
  limit: 'the search took too long',
  unreachable: 'no path to a control point',
};

/** The line of figures, the hint, and what can be done with the selection. */
export class Status {
  readonly #notice = byId('notice');
  #timer = 0;

  constructor(remove: () => void) {
    byId('remove').addEventListener('click', remove);
  }

  show(state: State, view: View, info: MeshInfo | null): void {
    byId('status-triangles').textContent = info ? formatCount(info.triangles, 'triangle') : '';
    const { curve } = view;
    const text = (id: string, value: string) => {
      byId(id).textContent = curve ? value : '';
    };
    text('status-samples', formatCount(curve?.sampleCount ?? 0, 'sample'));
    text('status-length', `length ${formatLength(curve?.length ?? 0)}`);
    text('status-time', `${formatMilliseconds(curve?.milliseconds ?? 0)} ms`);
    this.#showLost(view);
    const arcs = byId('status-arcs');
    const bent = curve?.arcsNotShortest ?? 0;
    arcs.hidden = bent === 0;
    arcs.textContent = formatCount(bent, 'arc not shortest', 'arcs not shortest');
    this.showHint(state, view);
  }

  /** Says that the engine is at work, once it has been for a while. */
  setBusy(busy: boolean): void {
    clearTimeout(this.#timer);
    const element = byId('status-busy');
    if (busy) this.#timer = window.setTimeout(() => (element.hidden = false), patienceMilliseconds);
    else element.hidden = true;
  }

  #showLost({ curve }: View): void {
    const lost = byId('status-lost');
    const entries = Object.entries(curve?.notConverged ?? {});
    const count = entries.reduce((sum, [, samples]) => sum + samples, 0);
    lost.hidden = count === 0;
    lost.textContent = `${formatCount(count, 'sample')} not converged`;
    lost.title = entries
      .map(([status, samples]) => `${samples}: ${statusNames[status] ?? status}`)
      .join('\n');
  }

  showHint(state: State, view: View): void {
    const { selection } = state;
    const hint = hintOf(state, view);
    this.#notice.hidden = selection === null && hint === '';
    byId('remove').hidden = selection === null;
    byId('selected').textContent = nameOf(selection);
    const element = byId('hint');
    if (element.textContent !== hint) element.textContent = hint;
  }
}

function nameOf(selection: Selection): string {
  if (selection === null) return '';
  return typeof selection === 'number' ? `Point ${selection + 1}` : 'Circle';
}

function hintOf({ mesh, document }: State, view: View): string {
  if (!mesh) return '';
  if (view.problem) return sentenceOf(view.problem);
  const { kind, points, circle } = document;
  if (kind === 'circle') return circle ? '' : 'Click the surface to place the center';
  if (points.length === 0) return 'Click the surface to place a control point';
  const missing = pointsNeeded[kind] - points.length;
  if (missing <= 0) return '';
  return formatCount(missing, 'more point makes a curve', 'more points make a curve');
}

const formatLength = (length: number) => length.toPrecision(4);

const formatMilliseconds = (value: number) => (value < 10 ? value.toFixed(1) : value.toFixed(0));
