/**
 * The page's storage in the browser: documents by surface and preferences (localStorage), and the
 * last opened files (IndexedDB). A browser may keep nothing, for example in private windows: the
 * page then starts afresh, without an error.
 */
import { drawnKey, sameContent } from './meshes';

const prefix = 'karcher.';
const longestFile = 128 * 1024 * 1024;

let heardOfKeeping: (kept: boolean) => void = () => {};

/**
 * Sets the listener, which receives whether the browser kept all values that the page stored beyond
 * this tab.
 */
export function onKeeping(listener: (kept: boolean) => void): void {
  heardOfKeeping = listener;
}

function keep(storage: () => Storage, name: string, value: string): boolean {
  try {
    storage().setItem(prefix + name, value);
    return true;
  } catch {
    // The storage is full, or the browser forbids it.
    return false;
  }
}

function find(storage: () => Storage, name: string): string | null {
  try {
    return storage().getItem(prefix + name);
  } catch {
    return null;
  }
}

function forget(storage: () => Storage, name: string): void {
  try {
    storage().removeItem(prefix + name);
  } catch {
    // A browser that forbids storage has stored nothing.
  }
}

/**
 * Keeps values by their names as long as there is room. Returns the names of values that did not
 * fit.
 */
export function rememberAll(values: Readonly<Record<string, string>>): string[] {
  const left = Object.entries(values).filter(
    ([name, value]) => !keep(() => localStorage, name, value),
  );
  heardOfKeeping(left.length === 0);
  return left.map(([name]) => name);
}
export const remember = (name: string, value: string) => rememberAll({ [name]: value });
export const recall = (name: string) => find(() => localStorage, name);

/** The name of a value that belongs to a surface. */
export const nameFor = (what: string, key: string) => `${what}.${drawnKey(key)}`;

/**
 * The value that belongs to a surface. Earlier versions had the whole key in the value's name: names
 * with other options for reading that keep the drawing, or with another file's name, count as well.
 */
export function recallFor(what: string, key: string): string | null {
  const name = nameFor(what, key);
  const kept = recall(name) ?? recall(`${what}.${key}`);
  if (kept !== null || !name.startsWith(`${what}.file:`)) return kept;
  try {
    const names = Array.from({ length: localStorage.length }, (_, i) => localStorage.key(i)!);
    const start = prefix + name;
    const earlier = names.find(
      (one) => one.startsWith(start) && /^[*~:]/.test(one.slice(start.length)),
    );
    return earlier ? localStorage.getItem(earlier) : null;
  } catch {
    return null;
  }
}

/**
 * Keeps a value for this tab only, through reloads; false without room. Without room it also
 * removes the earlier value, since after a reload this value would count as the newest.
 */
export function rememberInTab(name: string, value: string): boolean {
  if (keep(() => sessionStorage, name, value)) return true;
  forget(() => sessionStorage, name);
  return false;
}
export const recallInTab = (name: string) => find(() => sessionStorage, name);

function request<T>(make: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    make.onsuccess = () => resolve(make.result);
    make.onerror = () => reject(make.error);
  });
}

/**
 * Resolves when all is written: a browser reads the content of a Blob after the request to store
 * it.
 */
function completed(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error);
  });
}

/** The time in milliseconds after which a database that does not answer counts as missing. */
const patience = 2000;

/** The answer of a database. Rejects if none comes in time. */
function answered<T>(answer: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error('the database does not answer')), patience);
    answer.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

async function openFiles(mode: IDBTransactionMode): Promise<IDBObjectStore> {
  const opening = indexedDB.open('karcher', 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore('files');
  const database = await answered(request(opening));
  return database.transaction('files', mode).objectStore('files');
}

/** A stored file. Earlier versions stored bytes, which the page still reads. */
type StoredFile = ({ content: Blob } | { bytes: Uint8Array<ArrayBuffer> }) & {
  opened: number;
  /** Whether the page made the file, so that the user has none. */
  made?: boolean;
};

const contentOf = (file: StoredFile) => ('content' in file ? file.content : new Blob([file.bytes]));

/** The name of the time at which the page last opened a file that it had stored before. */
const openedAgain = (key: string) => `opened.${key}`;
const lastOpened = ({ opened }: StoredFile, key: string) =>
  Math.max(opened, Number(recall(openedAgain(key))));

/** The largest total of the kept files in bytes, which is less where the browser has little room. */
async function roomForFiles(): Promise<number> {
  // On plain http the browser does not say.
  const { quota = Number.POSITIVE_INFINITY } = (await navigator.storage?.estimate()) ?? {};
  return Math.min(4 * longestFile, quota / 2);
}

/**
 * Keeps a file, and removes those that were opened longest ago where there is no room for all. Files
 * that the page `made` go last, since the user could not open them again. Returns the keys of the
 * removed files; null if the file is too long, or if the browser keeps no files.
 */
export async function keepFile(
  key: string,
  content: Blob,
  made: boolean,
): Promise<string[] | null> {
  if (content.size > longestFile) return null;
  try {
    const room = await roomForFiles();
    const files = await openFiles('readwrite');
    const kept = completed(files.transaction);
    const keys = (await request(files.getAllKeys())) as string[];
    const stored: StoredFile[] = await request(files.getAll());
    const others = stored
      .map((file, i) => ({
        key: keys[i]!,
        size: contentOf(file).size,
        at: lastOpened(file, keys[i]!),
        made: file.made ?? false,
      }))
      .filter((other) => !sameContent(other.key, key))
      .toSorted((a, b) => Number(b.made) - Number(a.made) || b.at - a.at);
    let bytes = content.size;
    const removed: string[] = [];
    for (const other of others) {
      bytes += other.size;
      if (bytes > room) removed.push(other.key);
    }
    const left = [...removed, ...keys.filter((one) => one !== key && sameContent(one, key))];
    for (const one of left) files.delete(one);
    files.put({ content, opened: Date.now(), made } satisfies StoredFile, key);
    await kept;
    for (const one of left) forget(() => localStorage, openedAgain(one));
    return removed;
  } catch {
    // The storage is full, or the browser forbids it.
    return null;
  }
}

/**
 * The content of a key's file under any name, which counts as opened now; null if the browser does
 * not have it.
 */
export async function keptFile(key: string): Promise<Blob | null> {
  try {
    const files = await openFiles('readonly');
    const keys = (await answered(request(files.getAllKeys()))) as string[];
    const own = keys.find((one) => sameContent(one, key));
    if (own === undefined) return null;
    const file: StoredFile = await answered(request(files.get(own)));
    // To store the time with the file, the browser would have to write the whole file again.
    keep(() => localStorage, openedAgain(own), `${Date.now()}`);
    return contentOf(file);
  } catch {
    return null;
  }
}
