import type { Editor, State } from './editor/editor';
import { formatLink, type Link, parseLink } from './model/link';
import { recall, recallInTab, remember, rememberInTab } from './model/storage';

const delayMilliseconds = 200;

/**
 * Keeps what is made where a reload finds it: in the address and in the browser's storage. Saving
 * waits for a moment's rest, as browsers limit how often an address may change. A surface that
 * stands in for another is not saved: what could not be opened may be opened later.
 */
export function saveChanges(editor: Editor): void {
  let timer = 0;
  const save = (state: State) => {
    clearTimeout(timer);
    timer = 0;
    const text = formatLink(state.mesh, state.method, state.document);
    remember('last', text);
    remember(`document.${state.mesh}`, text);
    remember('method', state.method);
    const before = location.hash.slice(1);
    if (before === text) return;
    history.replaceState(null, '', `#${text}`);
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

/** What the page starts with: its address says it, or else what was last made in this browser. */
export function startingLink(): Link | null {
  const fragment = location.hash.slice(1);
  const [before, after] = (recallInTab('overtaken') ?? '').split(' ');
  const reloaded = performance
    .getEntriesByType('navigation')
    .some((entry) => (entry as PerformanceNavigationTiming).type === 'reload');
  const newest = reloaded && after && before === fragment ? after : fragment;
  return parseLink(newest) ?? parseLink(recall('last') ?? '');
}
