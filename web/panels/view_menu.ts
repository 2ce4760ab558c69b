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

/** How the surface is looked at: from where, with its triangles, light or dark. */
export class ViewMenu {
  readonly #edges = byId<HTMLButtonElement>('edges');
  readonly #fileColors = byId<HTMLButtonElement>('file-colors');
  readonly #relief = byId<HTMLButtonElement>('relief');
  readonly #hidden = byId<HTMLButtonElement>('hidden-lines');

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
    this.#relief.addEventListener('click', () => {
      viewer.relief = !viewer.relief;
      this.#relief.setAttribute('aria-checked', `${viewer.relief}`);
    });
    this.#hidden.addEventListener('click', () => this.toggleHidden());
    byId('theme').addEventListener('click', toggleTheme);
    onTheme((theme) => byId('theme').setAttribute('aria-checked', `${theme === 'dark'}`));
  }

  toggleHidden(): void {
    this.viewer.hiddenLines = !this.viewer.hiddenLines;
    this.#hidden.setAttribute('aria-checked', `${this.viewer.hiddenLines}`);
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
