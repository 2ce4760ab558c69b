/** The page's theme. It is light or dark like the system's theme until the user chooses. */
import { recall, remember } from '../model/storage';
import type { ViewerColors } from '../viewer/colors';

export type Theme = 'light' | 'dark';

const system = matchMedia('(prefers-color-scheme: dark)');
const listeners: ((theme: Theme) => void)[] = [];

const systemTheme = (): Theme => (system.matches ? 'dark' : 'light');

function chosenTheme(): Theme | null {
  const kept = recall('theme');
  return kept === 'light' || kept === 'dark' ? kept : null;
}

export function applyTheme(): void {
  const theme = chosenTheme() ?? systemTheme();
  document.documentElement.dataset.theme = theme;
  for (const listener of listeners) listener(theme);
}

/** Changes the theme. If the choice agrees with the system, the page follows the system again. */
export function toggleTheme(): void {
  const theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
  remember('theme', theme === systemTheme() ? '' : theme);
  applyTheme();
}

/** Calls the listener now and with every change. */
export function onTheme(listener: (theme: Theme) => void): void {
  listeners.push(listener);
  listener(document.documentElement.dataset.theme === 'dark' ? 'dark' : 'light');
}

/** The style sheet's colors for the scene. */
export function sceneColors(): ViewerColors {
  const probe = document.body.appendChild(document.createElement('i'));
  const read = (name: string) => {
    probe.style.color = `var(--${name})`;
    return getComputedStyle(probe).color;
  };
  const colors: ViewerColors = {
    stage: read('stage-near'),
    front: read('surface-front'),
    back: read('surface-back'),
    sky: read('surface-sky'),
    ground: read('surface-ground'),
    shadow: read('ground-shadow'),
    floor: read('floor'),
    edges: read('surface-edges'),
    curve: read('curve'),
    lost: read('curve-lost'),
    polygon: read('polygon'),
    marks: read('ink'),
    center: read('center'),
    chosen: read('chosen'),
    frame: read('accent'),
  };
  probe.remove();
  return colors;
}

system.addEventListener('change', applyTheme);
