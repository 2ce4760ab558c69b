/**
 * Keeps the built page for use without a network, from the first visit on. Pages come from the
 * network if it answers, so that a new version appears at once. Their files, whose names depend on
 * their content, come from the store. The store has the whole book after a reader has opened one of
 * its pages.
 */

/** The page's files, and a name that depends on their content. The build inserts both. */
declare const __KARCHER_FILES__: { readonly version: string; readonly files: readonly string[] };

/**
 * The parts of a service worker's scope that this file uses. TypeScript's types for pages do not
 * contain those of this scope.
 */
interface Scope {
  readonly registration: { readonly scope: string };
  readonly clients: { claim(): Promise<void> };
  addEventListener(
    type: 'install' | 'activate' | 'fetch' | 'message',
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
const bookPrefix = 'karcher-book-';
const addressOf = (file: string) => new URL(file, scope.registration.scope).href;

async function install(): Promise<void> {
  const store = await caches.open(storeName);
  // Pages have the same name in every version, so that the browser's cache may have an older one.
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
    // A page of an older version, possibly in the browser's cache, would request files that no
    // longer exist.
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

let keeping: Promise<void> | undefined;

/**
 * Stores the files of the book's present version, unless they are stored already, and removes older
 * versions.
 */
async function keepBook(): Promise<void> {
  const list = await fetch(addressOf('book/files.json'), { cache: 'no-cache' });
  const book = (await list.json()) as typeof __KARCHER_FILES__;
  const kept = bookPrefix + book.version;
  const names = (await caches.keys()).filter(
    (name) => name.startsWith(bookPrefix) && name !== kept,
  );
  const store = await caches.open(kept);
  // The browser stores all files or none, so that a store without files was interrupted.
  if ((await store.keys()).length > 0) return;
  try {
    const { files: listed } = book;
    await store.addAll(
      listed.map((file) => new Request(addressOf(`book/${file}`), { cache: 'no-cache' })),
    );
  } catch (error) {
    // Since the store is gone, the next page of the book tries again.
    await caches.delete(kept);
    throw error;
  }
  await Promise.all(names.map((name) => caches.delete(name)));
}

/**
 * A file of the book, from the network if possible: file names are the same in every version, so
 * that a stored file may be outdated.
 */
async function ofBook(request: Request): Promise<Response> {
  try {
    return await fetch(request, { cache: 'no-cache' });
  } catch (error) {
    const { origin, pathname } = new URL(request.url);
    const place = origin + (pathname.endsWith('/') ? `${pathname}index.html` : pathname);
    for (const name of (await caches.keys()).filter((one) => one.startsWith(bookPrefix))) {
      const kept = await (await caches.open(name)).match(place);
      if (kept) return kept;
    }
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
  if (request.url.startsWith(addressOf('book/'))) return event.respondWith(ofBook(request));
  event.respondWith(request.mode === 'navigate' ? page(request) : file(request));
});
// Each page of the book sends a message.
scope.addEventListener('message', (event) => {
  keeping ??= keepBook().finally(() => {
    keeping = undefined;
  });
  // Without a network the stored book stays as it is.
  event.waitUntil(keeping.catch(() => {}));
});
