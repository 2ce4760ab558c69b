import { byId } from './panels/elements';

/** Says while there is no network, and keeps the page's files, so that it can be loaded without one. */
export function workOffline(): void {
  const chip = byId('status-offline');
  const show = () => {
    chip.hidden = navigator.onLine;
  };
  window.addEventListener('online', show);
  window.addEventListener('offline', show);
  show();
  // The sources that are served while the page is developed change under its hand.
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  const address = new URL('./service-worker.js', document.baseURI);
  // If it is refused, such as in private windows of some browsers, the page needs a network.
  navigator.serviceWorker.register(address, { updateViaCache: 'none' }).catch(() => {});
}
