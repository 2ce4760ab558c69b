import type { Editor, State } from './editor/editor';
import { formatLink, type Link, parseLink } from './model/link';
import { type History, readWork, savedWork } from './model/saved_work';
import { recall, recallInTab, remember, rememberInTab } from './model/storage';

const delayMilliseconds = 200;

/** Longer addresses are cut off by some programs that pass them on. */
export const longestLink = 16_000;

/**
 * The address of a drawing: its link; of one that is too long only where this browser keeps it.
 */
export function addressOf({ mesh, method, drawing }: State): string {
  const link = formatLink(mesh, method, drawing);
  if (link.length <= longestLink) return link;
  return `mesh=${encodeURIComponent(mesh).replaceAll('%3A', ':')}&method=${method}&kept=1`;
}

/**
 * Keeps what is made where a reload finds it: in the address and in the browser's storage, with what
 * was done in that of the tab. Saving waits for a moment's rest, as browsers limit how often an
 * address may change. A surface that stands in for another is not saved: what could not be opened may
 * be opened later.
 */
export function saveChanges(editor: Editor): void {
  let timer = 0;
  const save = (state: State) => {
    clearTimeout(timer);
    timer = 0;
    const { mesh, method, drawing } = state;
    const text = formatLink(mesh, method, drawing);
    remember('last', text);
    remember(`document.${mesh}`, text);
    remember('method', method);
    if (mesh === editor.state.mesh) {
      rememberInTab('work', savedWork(text, drawing, editor.history));
    }
    const before = location.hash.slice(1);
    const address = addressOf(state);
    if (before === address) return;
    history.replaceState(null, '', `#${address}`);
    // A reload that is under way may still go to the address as it was.
    rememberInTab('overtaken', `${before} ${location.hash.slice(1)}`);
  };
  const saveSoon = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      if (editor.dragging) saveSoon();
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
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) flush();
  });
}

/** The link that a fragment is, or that it finds in this browser. */
export function linkOf(fragment: string): Link | null {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const kept = fields.get('kept') && recall(`document.${fields.get('mesh')}`);
  return parseLink(kept || fragment);
}

/** What the page starts with: its address says it, or else what was last made in this browser. */
export function startingLink(): Link | null {
  const fragment = location.hash.slice(1);
  const [before, after] = (recallInTab('overtaken') ?? '').split(' ');
  const reloaded = performance
    .getEntriesByType('navigation')
    .some((entry) => (entry as PerformanceNavigationTiming).type === 'reload');
  const newest = reloaded && after && before === fragment ? after : fragment;
  return linkOf(newest) ?? parseLink(recall('last') ?? '');
}

/** What this tab did to the drawing of a link, with the drawing as it was left. */
export function workOn(link: Link): { link: Link; history: History } | null {
  const { mesh, method, drawing } = link;
  const work = method && readWork(recallInTab('work') ?? '', formatLink(mesh, method, drawing));
  return work && { link: { ...link, drawing: work.drawing }, history: work.history };
}
