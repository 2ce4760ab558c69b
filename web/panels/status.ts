import type { MeshInfo } from 'karcher';
import { pointsNeeded } from '../editor/document';
import type { Selection, State } from '../editor/editor';
import type { Quality } from '../editor/methods';
import type { View } from '../editor/session';
import { type Shift, unseenShift } from '../editor/shift';
import { lostSamples } from '../worker/lost';
import { byId, formatCount } from './elements';
import { sentenceOf } from './messages';

/** Work this short goes without saying. */
const patienceMilliseconds = 300;

export interface StatusEvents {
  remove(): void;
  /** Shows the next place where samples are not converged. */
  goToLost(): void;
}

/** The line of figures, the hint, and what can be done with the selection. */
export class Status {
  readonly #notice = byId('notice');
  #timer = 0;

  constructor(events: StatusEvents) {
    byId('remove').addEventListener('click', events.remove);
    byId('status-lost').addEventListener('click', events.goToLost);
  }

  show(state: State, view: View, info: MeshInfo | null): void {
    byId('status-triangles').textContent = info ? formatCount(info.triangles, 'triangle') : '';
    const { curve } = view;
    const text = (id: string, value: string) => {
      byId(id).textContent = curve ? value : '';
    };
    text('status-samples', formatCount(curve?.samples.count ?? 0, 'sample'));
    text('status-length', `length ${formatLength(curve?.length ?? 0)}`);
    text('status-time', `${formatMilliseconds(curve?.milliseconds ?? 0)} ms`);
    this.#showLost(view);
    this.#showQuality(view);
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
    const badge = byId('status-lost');
    const count = lostSamples(curve?.lost ?? []);
    badge.hidden = count === 0;
    badge.textContent = `${formatCount(count, 'sample')} not converged`;
    badge.title = 'Show the next place';
  }

  #showQuality({ quality, refining, shift, notRefined }: View): void {
    const mark = byId('status-quality');
    mark.hidden = quality === null;
    if (quality === null) return;
    const jumped = shift !== null && shift.median > unseenShift;
    mark.dataset.quality = quality;
    mark.classList.toggle('refining', refining);
    mark.classList.toggle('jumped', jumped);
    mark.textContent = jumped ? `exact, moved by ${formatShift(shift.median)}` : quality;
    mark.title = qualityText(quality, refining, shift, notRefined);
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

function qualityText(
  quality: Quality,
  refining: boolean,
  shift: Shift | null,
  notRefined: string | null,
): string {
  if (notRefined) return `The exact curve could not be made. ${sentenceOf(notRefined)}`;
  if (refining) return 'By fast distances; the exact curve is on its way.';
  if (quality === 'draft') return 'By fast distances.';
  if (!shift) return 'By exact distances.';
  const [median, largest] = [formatShift(shift.median), formatShift(shift.largest)];
  return `By exact distances: ${median} from the draft (median), ${largest} at most.`;
}

const formatShift = (edges: number) => `${edges.toPrecision(2)} edges`;

const formatLength = (length: number) => length.toPrecision(4);

const formatMilliseconds = (value: number) => (value < 10 ? value.toFixed(1) : value.toFixed(0));
