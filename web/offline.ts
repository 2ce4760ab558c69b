import { byId } from './panels/elements';

/** Reports a missing network, and keeps the page's files for a start without one. */
export function workOffline(): void {
  const chip = byId('status-offline');
  const show = () => {
    chip.hidden = navigator.onLine;
  };
  window.addEventListener('online', show);
  window.addEventListener('offline', show);
  show();
  // In development the sources change while the page is open.
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  const address = new URL('./service-worker.js', document.baseURI);
  // Some browsers refuse service workers in private windows; the page then needs a network.
  navigator.serviceWorker.register(address, { updateViaCache: 'none' }).catch(() => {});
}
