import { byId } from './elements';

/** Where the window is narrow, the panel's facts and lists are shown when they are asked for. */
export function showDetailsOnDemand(): void {
  const button = byId('more');
  button.addEventListener('click', () => {
    const shown = byId('panel').classList.toggle('detailed');
    button.setAttribute('aria-expanded', `${shown}`);
    if (shown) button.scrollIntoView();
  });
}
