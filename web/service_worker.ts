/**
 * Keeps the built page for when there is no network: its files are stored with the first visit. Pages
 * come from the network where it answers, so that a new version is seen at once; the files that they
 * are made of have names of their own content, and come from the store.
 */

/** Put in by the build: the page's files, and a name for all they hold. */
declare const __KARCHER_FILES__: { readonly version: string; readonly files: readonly string[] };

/** What is used of a service worker's scope; its types exclude those of a page. */
interface Scope {
  readonly registration: { readonly scope: string };
  readonly clients: { claim(): Promise<void> };
  addEventListener(
    type: 'install' | 'activate' | 'fetch',
    hear: (event: {
      readonly request: Request;
      waitUntil(work: Promise<unknown>): void;
      respondWith(answer: Promise<Response>): void;
    }) => void,
  ): void;
}

const scope = globalThis as unknown as Scope;
const prefix = 'karcher-page-';
const { version, files } = __KARCHER_FILES__;
const storeName = prefix + version;
const addressOf = (file: string) => new URL(file, scope.registration.scope).href;

async function install(): Promise<void> {
  const store = await caches.open(storeName);
  // Pages have the same name in every version.
  await store.addAll(
    files.map(
      (file) =>
        new Request(addressOf(file), { cache: file.endsWith('.html') ? 'no-cache' : 'default' }),
    ),
  );
}

async function activate(): Promise<void> {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(prefix) && name !== storeName);
  await Promise.all(old.map((name) => caches.delete(name)));
  await scope.clients.claim();
}

async function page(request: Request): Promise<Response> {
  try {
    // One of an older version, which the browser may have kept, would ask for files that are gone.
    return await fetch(request, { cache: 'no-cache' });
  } catch (error) {
    const { pathname } = new URL(request.url);
    const name = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
    const store = await caches.open(storeName);
    const kept = await store.match(new URL(name, request.url).href);
    if (kept) return kept;
    throw error;
  }
}

async function file(request: Request): Promise<Response> {
  const store = await caches.open(storeName);
  return (await store.match(request, { ignoreSearch: true })) ?? fetch(request);
}

scope.addEventListener('install', (event) => event.waitUntil(install()));
scope.addEventListener('activate', (event) => event.waitUntil(activate()));
scope.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || !request.url.startsWith(scope.registration.scope)) return;
  event.respondWith(request.mode === 'navigate' ? page(request) : file(request));
});
