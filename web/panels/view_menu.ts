import { recall, remember } from '../model/storage';
import { type ViewName, viewNames } from '../model/view_place';
import type { Viewer } from '../viewer/viewer';
import { byId, make } from './elements';
import { Menu } from './menu';
import { onTheme, toggleTheme } from './theme';

const labels: Record<ViewName, string> = {
  front: 'Front',
  back: 'Back',
  left: 'Left',
  right: 'Right',
  top: 'Top',
  bottom: 'Bottom',
};

/**
 * Looks that are a matter of taste: a choice applies to every surface, and the browser keeps it.
 */
const keptLooks = [
  ['relief', 'relief'],
  ['ground-shadow', 'groundShadow'],
  ['hidden-lines', 'hiddenLines'],
] as const;

/** The menu of the view: the camera's place, the triangles, the overlays, light or dark. */
export class ViewMenu {
  readonly #edges = byId<HTMLButtonElement>('edges');
  readonly #fileColors = byId<HTMLButtonElement>('file-colors');

  constructor(
    private readonly viewer: Viewer,
    overlays: { distances(): void; comb(): void },
  ) {
    const menu = new Menu('view-menu', 'view');
    for (const id of ['distances', 'comb'] as const) {
      byId(id).addEventListener('click', () => {
        menu.element.hidePopover();
        overlays[id]();
      });
    }
    const places = byId('view-places');
    for (const name of viewNames) {
      const item = make('button', labels[name], { type: 'button' });
      item.setAttribute('role', 'menuitem');
      item.addEventListener('click', () => {
        menu.element.hidePopover();
        viewer.showPlace(name, { animated: true });
      });
      places.append(item);
    }
    byId('reset').addEventListener('click', () => {
      menu.element.hidePopover();
      viewer.resetView({ animated: true });
    });
    this.#edges.addEventListener('click', () => this.toggleEdges());
    this.#fileColors.addEventListener('click', () => this.#toggleFileColors());
    menu.element.addEventListener('beforetoggle', () => {
      this.#fileColors.hidden = !viewer.surface?.hasColors;
    });
    byId('light').addEventListener('click', () => viewer.turnLight(Math.PI / 4));
    for (const look of keptLooks) this.#keep(look);
    byId('theme').addEventListener('click', toggleTheme);
    onTheme((theme) => byId('theme').setAttribute('aria-checked', `${theme === 'dark'}`));
  }

  toggleHidden(): void {
    byId('hidden-lines').click();
  }

  #keep([id, look]: (typeof keptLooks)[number]): void {
    const { viewer } = this;
    const item = byId(id);
    const show = (shown: boolean) => {
      viewer[look] = shown;
      item.setAttribute('aria-checked', `${shown}`);
    };
    const kept = recall(id);
    if (kept) show(kept === 'on');
    item.addEventListener('click', () => {
      show(!viewer[look]);
      remember(id, viewer[look] ? 'on' : 'off');
    });
  }

  #toggleFileColors(): void {
    this.viewer.fileColors = !this.viewer.fileColors;
    this.#fileColors.setAttribute('aria-checked', `${this.viewer.fileColors}`);
  }

  toggleEdges(): void {
    this.viewer.edges = !this.viewer.edges;
    this.#edges.setAttribute('aria-checked', `${this.viewer.edges}`);
  }
}
