import type { Editor } from './editor/state/editor';
import type { State } from './editor/state/state';
import type { History } from './model/history';
import { formatLink, type Link, parseLink, viewFields } from './model/link';
import { drawnKey } from './model/meshes';
import { linkOfWork, readWork, savedLink, savedWork } from './model/saved_work';
import {
  nameFor,
  recall,
  recallFor,
  recallInTab,
  rememberAll,
  rememberInTab,
} from './model/storage';
import { parseView, type ViewPlace } from './model/view_place';

const delayMilliseconds = 200;

/** The longest address that all programs pass on; some cut off longer ones. */
export const longestLink = 16_000;

/** The address of a drawing: its link or, if that is too long, an address for this browser only. */
export function addressOf({ mesh, method, drawing }: State, view: ViewPlace | null): string {
  const link = formatLink(mesh, method, drawing, view);
  if (link.length <= longestLink) return link;
  return [keptAddress(mesh, method), ...viewFields(view)].join('&');
}

/** The address of a drawing that only this browser has. */
function keptAddress(mesh: string, method: string): string {
  const key = encodeURIComponent(mesh).replaceAll('%3A', ':');
  return `mesh=${key}&method=${method}&kept=1`;
}

/**
 * Keeps a drawing and its history in the browser and in the tab, as far as there is room. Returns
 * false if neither these copies nor the address would restore the drawing after a reload.
 */
export function keepDrawing(
  { mesh, method, drawing }: Pick<State, 'mesh' | 'method' | 'drawing'>,
  history: Readonly<History> | null,
): boolean {
  const text = formatLink(mesh, method, drawing);
  const document = nameFor('document', mesh);
  const short = text.length <= longestLink;
  // For a long text, `last` refers to the stored document, so that the text is stored only once.
  const last = short ? text : keptAddress(mesh, method);
  const left = rememberAll({ [document]: text, last, method });
  const inTab =
    history !== null &&
    (rememberInTab('work', savedWork(text, drawing, history)) ||
      rememberInTab('work', savedLink(text)));
  return short || inTab || !left.includes(document);
}

/**
 * Saves the drawing and the view for a reload: both in the address, the drawing also in the
 * browser's storage, and the history in the tab's storage. It waits for a pause, since browsers
 * limit how often an address may change. It does not save a surface that stands in for another,
 * since the user may open the original later. If a reload would lose the drawing, it calls
 * `onLost`, but not again before a successful save. An address to which the user navigates is given
 * to `open`, and stays until its drawing is open. Call the returned function when the view may have
 * changed.
 */
export function saveChanges(
  editor: Editor,
  viewNow: () => ViewPlace | null,
  onLost: () => void,
  open: (found: FoundLink) => Promise<unknown>,
): () => void {
  let timer = 0;
  let viewTimer = 0;
  let viewShown = '';
  let lost = false;
  /** The number of addresses that are being opened. */
  let arriving = 0;
  const saveAddress = (state: State) => {
    if (arriving > 0) return;
    const before = location.hash.slice(1);
    const address = addressOf(state, viewNow());
    if (before === address) return;
    history.replaceState(null, '', `#${address}`);
    // A reload that has begun may still use the former address.
    rememberInTab('overtaken', `${before} ${location.hash.slice(1)}`);
  };
  const save = (state: State) => {
    clearTimeout(timer);
    timer = 0;
    const kept = keepDrawing(state, state.mesh === editor.state.mesh ? editor.history : null);
    if (!kept && !lost) onLost();
    lost = !kept;
    saveAddress(state);
  };
  const saveSoon = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      if (editor.state.dragging) saveSoon();
      else save(editor.state);
    }, delayMilliseconds);
  };
  editor.subscribe((state, before) => {
    if (state.revision === before.revision || state.mesh === '' || state.standIn) return;
    if (timer && state.mesh !== before.mesh) save(before);
    saveSoon();
  });
  const flush = () => {
    if (!timer) return;
    editor.cancelDrag();
    save(editor.state);
  };
  window.addEventListener('pagehide', flush);
  window.addEventListener('hashchange', ({ newURL }) => {
    // An address to which the user navigates is the newest one again.
    rememberInTab('overtaken', '');
    // `location` may differ from `newURL`, if the page has replaced the address in the meantime.
    const { hash } = new URL(newURL);
    const found = linkOf(hash);
    if (!found || hash.slice(1) === addressOf(editor.state, viewNow())) return;
    arriving++;
    void open(found).finally(() => arriving--);
  });
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) flush();
  });
  return () => {
    const [view = ''] = viewFields(viewNow());
    if (view === viewShown) return;
    viewShown = view;
    clearTimeout(viewTimer);
    viewTimer = window.setTimeout(() => {
      const { state } = editor;
      // A save that still waits stores the view as well.
      if (!timer && state.mesh !== '' && !state.standIn) saveAddress(state);
    }, delayMilliseconds);
  };
}

/** A link, and whether this browser kept it; a kept link may have any size. */
export interface FoundLink {
  link: Link;
  own: boolean;
}

function found(text: string | null | undefined, own: boolean): FoundLink | null {
  const link = parseLink(text ?? '');
  return link && { link, own };
}

/**
 * The link in a fragment, or the kept link to which the fragment refers. This tab's own kept link
 * comes first, since all tabs share the browser's storage.
 */
export function linkOf(fragment: string): FoundLink | null {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  if (!fields.get('kept')) return found(fragment, false);
  const mesh = fields.get('mesh') ?? '';
  const kept = keptLink(mesh) ?? found(fragment, false);
  const view = parseView(fields.get('view') ?? '');
  return kept && { ...kept, link: { ...kept.link, mesh, view } };
}

/** The drawing that this browser kept for a surface. */
function keptLink(mesh: string): FoundLink | null {
  const inTab = found(linkOfWork(recallInTab('work') ?? ''), true);
  if (inTab && drawnKey(inTab.link.mesh) === drawnKey(mesh)) return inTab;
  return found(recallFor('document', mesh), true);
}

/** The first drawing of the page: from its address, or the last one made in this browser. */
export function startingLink(): FoundLink | null {
  const fragment = location.hash.slice(1);
  const [before, after] = (recallInTab('overtaken') ?? '').split(' ');
  const reloaded = performance
    .getEntriesByType('navigation')
    .some((entry) => (entry as PerformanceNavigationTiming).type === 'reload');
  const newest = reloaded && after && before === fragment ? after : fragment;
  const last = () => {
    const link = linkOf(recall('last') ?? '');
    return link && { ...link, own: true };
  };
  return linkOf(newest) ?? last();
}

/** This tab's history of a link's drawing, and the drawing at the end of the history. */
export function workOn(link: Link): { link: Link; history: History } | null {
  const { mesh, method, drawing } = link;
  const work = method && readWork(recallInTab('work') ?? '', formatLink(mesh, method, drawing));
  return work && { link: { ...link, drawing: work.drawing }, history: work.history };
}
