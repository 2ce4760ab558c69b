import { byId, make } from './panels/elements';
import { applyTheme } from './panels/theme';

function showUnsupported(reason: string): void {
  byId('app').hidden = true;
  const box = byId('unsupported');
  box.replaceChildren(
    make('h1', 'Karcher can’t run in this browser'),
    make('p', reason),
    make('p', 'A current Chrome, Edge, Firefox or Safari has what the page needs.'),
  );
  box.hidden = false;
}

async function run(): Promise<void> {
  if (typeof WebAssembly !== 'object') {
    showUnsupported('WebAssembly, which runs the geometry engine, is missing or switched off.');
    return;
  }
  byId('app').hidden = false;
  try {
    const { start } = await import('./app');
    await start();
  } catch (error) {
    showUnsupported(error instanceof Error ? error.message : `${error}`);
  }
}

applyTheme();
await run();
