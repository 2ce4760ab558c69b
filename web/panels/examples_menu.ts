import { type Example, examples } from '../model/examples';
import { make } from './elements';
import { Menu } from './menu';

/** The menu of the page's finished drawings. */
export class ExamplesMenu {
  constructor(choose: (example: Example) => void) {
    const menu = new Menu('examples-menu', 'examples');
    for (const example of examples) {
      const item = make('button', example.name, { type: 'button' });
      item.setAttribute('role', 'menuitem');
      item.dataset.example = example.id;
      item.addEventListener('click', () => {
        menu.element.hidePopover();
        choose(example);
      });
      menu.element.append(item);
    }
  }
}
