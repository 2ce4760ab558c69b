import type { MeshInfo, Uniqueness } from 'karcher';
import { type Shift, type ShownCenter, unseenShift } from '../editor/engine/compute';
import type { View } from '../editor/engine/view';
import type { Ruled } from '../editor/hand/ruler';
import type { Editor } from '../editor/state/editor';
import type { Selection, State } from '../editor/state/state';
import { isDerived } from '../model/derived';
import { activeObject, type Drawing } from '../model/drawing';
import {
  type Figure,
  isEmpty,
  isRound,
  type Kind,
  parameterOf,
  pointsNeeded,
} from '../model/figure';
import type { LostReason } from '../model/lost';
import type { Quality } from '../model/methods';
import { penWords } from '../model/pen_hints';
import { isTooFine, type Measured, mostLines } from '../model/traced';
import { formatArea, formatLength, type Unit } from '../model/units';
import { byId, formatCount, formatInteger, write } from './elements';
import { kindNames } from './kind_names';
import { countLost, reasons } from './lost_panel';
import { sentenceOf } from './messages';
import { makeSlider, showOnSlider } from './point_rows';

/**
 * The times in milliseconds after which a busy engine shows words (`saying`) and a button that
 * stops the work (`stopping`).
 */
const patienceMilliseconds = { saying: 300, stopping: 1000 };

export interface StatusEvents {
  remove(): void;
  /** Shows the next place where the curve's points are not centers of mass. */
  goToLost(): void;
  /** Replaces the first leg that is not a shortest path by the shortest path. */
  shorten(): void;
  /** Stops the engine's work. */
  stop(): void;
}

/** The status line: figures, a hint, and actions for the selection. */
export class Status {
  readonly #notice = byId('notice');
  #timers: number[] = [];
  #measured: Measured | null = null;
  #mirroring = '';
  #ruled: Ruled | null = null;
  #begun = false;
  #unit: Unit = '';
  #aim = '';

  readonly #slider: HTMLInputElement;

  constructor(editor: Editor, events: StatusEvents) {
    // If the list of points has no room, the selected point has its slider here.
    this.#slider = makeSlider(editor, () => Number(editor.state.selection));
    byId('selected-slider').append(this.#slider);
    byId('remove').addEventListener('click', events.remove);
    byId('shorten').addEventListener('click', events.shorten);
    byId('status-lost').addEventListener('click', events.goToLost);
    byId('stop').addEventListener('click', events.stop);
  }

  show(state: State, view: View, info: MeshInfo | null): void {
    write(byId('status-triangles'), info ? formatCount(info.triangles, 'triangle') : '');
    const { curve, isolines, center } = view;
    // The numbers belong to the last edited object, so they disappear when the selection is
    // cleared.
    write(byId('status-samples'), state.none ? '' : countOf(view));
    write(byId('status-length'), state.none ? '' : measureOf(view, this.#unit));
    const time = (curve ?? isolines ?? center)?.milliseconds;
    write(
      byId('status-time'),
      time === undefined || state.none ? '' : `${formatMilliseconds(time)} ms`,
    );
    this.#showLost(view);
    this.#showQuality(view);
    const arcs = byId('status-arcs');
    const bent = curve?.arcsNotShortest ?? 0;
    arcs.hidden = bent === 0;
    write(arcs, formatCount(bent, 'arc not shortest', 'arcs not shortest'));
    this.showHint(state, view);
  }

  /** Shows that the engine is busy, if it stays busy for a while. */
  setBusy(busy: boolean): void {
    for (const timer of this.#timers) clearTimeout(timer);
    const { saying, stopping } = patienceMilliseconds;
    const shown = [
      [byId('status-busy'), saying],
      [byId('stop'), stopping],
    ] as const;
    this.#timers = [];
    write(byId('status-busy'), 'computing…');
    for (const [element, patience] of shown) {
      if (busy) this.#timers.push(window.setTimeout(() => (element.hidden = false), patience));
      else element.hidden = true;
    }
  }

  /** Shows the stage and the progress of the engine's work. */
  setProgress(done: number, stage: string): void {
    write(byId('status-busy'), `${stage}… ${Math.round(100 * done)} %`);
  }

  /**
   * Shows a warning if the browser does not keep the drawing, since its storage is full or blocked.
   */
  setKept(kept: boolean): void {
    byId('status-kept').hidden = kept;
  }

  #showLost({ curve }: View): void {
    const badge = byId('status-lost');
    const count = countLost(curve?.lost ?? []);
    badge.hidden = count === '';
    write(badge, count);
    badge.title = 'The curve may not be as it should there. Click to go to the next place.';
  }

  #showQuality({ quality, refining, shift, notRefined }: View): void {
    const mark = byId('status-quality');
    mark.hidden = quality === null;
    if (quality === null) return;
    const jumped = shift !== null && shift.median > unseenShift;
    mark.dataset.quality = quality;
    mark.classList.toggle('refining', refining);
    mark.classList.toggle('jumped', jumped);
    write(mark, jumped ? `exact, moved by ${formatShift(shift.median)}` : quality);
    mark.title = qualityText(quality, refining, shift, notRefined);
  }

  /** Shows the measurement instead of the hint. */
  showMeasured(measured: Measured | null, state: State, view: View): void {
    this.#measured = measured;
    this.showHint(state, view);
  }

  /**
   * Shows the distance between two points of the surface, or says that the first point is placed.
   */
  showRuled(ruled: Ruled | null, begun: boolean, state: State, view: View): void {
    [this.#ruled, this.#begun] = [ruled, begun];
    this.showHint(state, view);
  }

  /** Sets the unit of visible lengths. */
  showUnit(unit: Unit, state: State, view: View): void {
    this.#unit = unit;
    write(byId('status-length'), state.none ? '' : measureOf(view, unit));
    this.showHint(state, view);
  }

  /** Shows what the next click does for a mirror image of the selection. */
  showMirroring(hint: string, state: State, view: View): void {
    this.#mirroring = hint;
    this.showHint(state, view);
  }

  /** Shows what the pointer would do at its place, unless a message is more important. */
  showAim(words: string, state: State, view: View): void {
    if (words === this.#aim) return;
    this.#aim = words;
    this.showHint(state, view);
  }

  #ruling({ tool }: State): string {
    if (tool !== 'measure' || !this.#begun) return '';
    return this.#ruled ? ruledText(this.#ruled, this.#unit) : 'Click where to measure to';
  }

  showHint(state: State, view: View): void {
    // The measurement takes the place of the hint.
    const selection = state.tool === 'measure' ? null : state.selection;
    const hint =
      this.#ruling(state) ||
      hintOf(state, view, this.#measured, this.#mirroring, this.#unit) ||
      this.#aim;
    this.#notice.hidden = selection === null && hint === '';
    byId('remove').hidden = selection === null;
    byId('shorten').hidden = hint === '' || hint !== shorterHint(state.figure, view);
    const { kind, points } = state.figure;
    write(byId('selected'), nameOf(kind, selection, state.more.length));
    const name = parameterOf(kind);
    const point = typeof selection === 'number' ? points[selection] : undefined;
    this.#slider.hidden = !name || !point || state.more.length > 0;
    if (name && point) showOnSlider(this.#slider, Number(selection), point, name);
    write(byId('hint'), hint);
  }
}

function ruledText({ along, straight }: Ruled, unit: Unit): string {
  const way =
    along === null
      ? 'No path along the surface: different components'
      : `${formatLength(along, unit)} along the surface`;
  return `${way} · ${formatLength(straight, unit)} straight`;
}

function nameOf(kind: Kind, selection: Selection, more: number): string {
  if (selection === null) return '';
  if (more > 0) return `${more + 1} ${kind === 'pen' ? 'anchors' : 'points'}`;
  if (kind === 'pen') return `Anchor ${Number(selection) + 1}`;
  return typeof selection === 'number' ? `Point ${selection + 1}` : kindNames[kind];
}

function hintOf(
  { mesh, drawing, figure, tool, chosen, selection, none }: State,
  view: View,
  measured: Measured | null,
  mirroring: string,
  unit: Unit,
): string {
  if (!mesh) return '';
  if (tool === 'freehand') return penWords.draw;
  if (tool === 'split') return 'Click the curve where you want to cut it';
  if (tool === 'join') return 'Click the curve to join with this one';
  if (tool === 'look') return 'Click the object whose look it takes';
  if (tool === 'mirror') return mirroring;
  if (tool === 'transform' && chosen.length === 0)
    return 'Click an object to move, turn or scale it';
  if (tool === 'transform')
    return 'Drag a corner to scale, the round handle to turn; Shift keeps steps';
  if (tool === 'measure') {
    return measured
      ? measuredText(measured, unit, document.documentElement.hasAttribute('data-advanced'))
      : 'Point at the curve to measure it there, or click two points of the surface';
  }
  if (view.problem) return sentenceOf(view.problem);
  if (view.fill?.problem) return `Nothing is filled: ${view.fill.problem}`;
  const fine = fineHint(drawing, view);
  if (fine) return fine;
  const { kind, points, circle } = figure;
  if (tool === 'select' && chosen.length === 0 && selection === null) {
    const blank = isEmpty(figure) && view.others.length === 0;
    return blank ? drawHint : dragHint;
  }
  if (view.center) return centerHint(view.center);
  // Without a selection a click begins another object.
  const begins = points.length === 0 || none;
  if (isRound(kind)) return circle && !none ? '' : 'Click the surface to place the center';
  if (isDerived(kind)) return '';
  if (begins && kind === 'pen') return penWords.begin;
  if (begins) {
    return `Click the surface to place a ${kind === 'center' || kind === 'points' ? '' : 'control '}point`;
  }
  const missing = pointsNeeded(figure) - points.length;
  if (missing <= 0) return shorterHint(figure, view);
  // The curve has ended: a click begins another one.
  if (kind === 'pen' && tool === 'insert' && selection === null) return penWords.begin;
  return formatCount(missing, 'more point makes a curve', 'more points make a curve');
}

const dragHint = 'Drag a line or a point, or pick a tool';
const drawHint = 'Choose a tool to draw';

/** Words about a pattern that is too fine to draw. */
function fineHint(drawing: Drawing, { fill }: View): string {
  const { pattern, spacing } = activeObject(drawing);
  if (pattern === 'solid' || spacing === null || !fill?.region) return '';
  const most = formatInteger(mostLines);
  return isTooFine(spacing, fill.region)
    ? `The fill stays solid: with this spacing it would have more than ${most} lines`
    : '';
}

/** Words about legs that are longer than the shortest paths. */
function shorterHint({ kind }: Figure, { shorter }: View): string {
  const [first] = shorter;
  if (!first) return '';
  const longer = `${formatInteger(Math.round(100 * (1 / first.part - 1)))} %`;
  const others = shorter.length - 1;
  const more = others > 0 ? `; ${formatCount(others, 'more is', 'more are')} longer, too` : '';
  const from = kind === 'pen' ? 'anchor' : 'point';
  return `The way on from ${from} ${first.index + 1} is ${longer} longer than the shortest${more}`;
}

function qualityText(
  quality: Quality,
  refining: boolean,
  shift: Shift | null,
  notRefined: string | null,
): string {
  if (notRefined) return `The exact curve could not be made. ${sentenceOf(notRefined)}`;
  if (refining) return 'Computed with fast distances; the exact curve follows.';
  if (quality === 'draft') return 'Computed with fast distances.';
  if (!shift) return 'Computed with exact distances.';
  const [median, largest] = [formatShift(shift.median), formatShift(shift.largest)];
  return `Computed with exact distances: ${median} from the draft (median), at most ${largest}.`;
}

const formatShift = (edges: number) => `${edges.toPrecision(2)} edges`;

/** A remark if a center is missing or is not the only one; otherwise empty. */
function centerHint({ status, uniqueness, otherMinima }: ShownCenter): string {
  if (status !== 'converged') return `No center was found: ${reasons[status as LostReason]}`;
  if (uniqueness !== 'notUnique' || otherMinima === 'notLooked') return '';
  const energies = otherMinima.map(({ energy }) => formatLength(energy));
  const shown = energies.slice(0, mostEnergies).join(', ');
  const more = energies.length > mostEnergies ? ' and more' : '';
  const are = formatCount(energies.length, 'other minimum', 'other minima');
  return `Not the only center: ${are}, of energy ${shown}${more}`;
}

/** The largest number of other minima whose energies appear. */
const mostEnergies = 3;

/** Words about whether the center is the only one. */
const uniquenessWords: Record<Uniqueness, string> = {
  certain: ' · certainly the only center',
  likely: ' · likely the only center',
  notUnique: ' · not the only center',
  notLooked: '',
};

/** The number of a curve's samples, or of isolines, in words. */
function countOf({ curve, isolines }: View): string {
  if (curve) return formatCount(curve.samples.count, 'sample');
  if (!isolines) return '';
  const { lines } = isolines;
  return formatCount(lines.length, lines.every(({ closed }) => closed) ? 'loop' : 'line');
}

function measureOf({ curve, isolines, center, fill }: View, unit: Unit): string {
  if (center) {
    const { status, certificate, uniqueness } = center;
    const only = status === 'converged' ? uniquenessWords[uniqueness] : '';
    // Once the answer is refined, its energy and residual are measured by exact shortest paths.
    const exact = certificate ? ` · residual ${certificate.residual.toPrecision(2)}` : '';
    const { energy } = certificate ?? center;
    return `energy ${formatLength(energy)}${exact}${only}`;
  }
  const drawn = curve ?? isolines;
  const { region } = fill ?? {};
  const around = region?.boundary.reduce((sum, { length }) => sum + length, 0) ?? 0;
  const area = region
    ? ` · area ${formatArea(region.area, unit)} · perimeter ${formatLength(around, unit)}`
    : '';
  return drawn ? `length ${formatLength(drawn.length, unit)}${area}` : '';
}

/**
 * The words for a measurement. The parameter and the tangent appear only while the advanced
 * settings are open.
 */
function measuredText(
  { parameter, length, wholeLength, tangent }: Measured,
  unit: Unit,
  advanced: boolean,
): string {
  const speed = Math.hypot(...tangent);
  const direction = tangent.map((value) => (speed > 0 ? value / speed : 0).toFixed(2)).join(', ');
  const along = `length ${formatLength(length, unit)} of ${formatLength(wholeLength, unit)}`;
  if (!advanced) return capitalized(along);
  return `Parameter ${parameter.toFixed(3)} · ${along} · tangent ${direction.replaceAll('-', '−')}`;
}

const capitalized = (words: string) => words[0]!.toUpperCase() + words.slice(1);

const formatMilliseconds = (value: number) => (value < 10 ? value.toFixed(1) : value.toFixed(0));
