// Makes the book in build/page/book: the pages of docs/, and the reference of the package's types
// by TypeDoc. All addresses in it are relative, so that it works in any folder of any host.
import { createHash } from 'node:crypto';
import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, relative, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Application, Converter, ReflectionKind } from 'typedoc';
import { filesBelow, inRoot } from '../../.tools/shell.mjs';
import { contents, drawn, entries, live } from './contents.mjs';
import { buildLive, examplesPage, withLive } from './live.mjs';
import { pictures } from './pictures.mjs';
import { addExamples, reportOf } from './reference.mjs';

const source = inRoot('build/book/source');
const made = inRoot('build/page/book');
/** The stand-in for the page's folder in TypeDoc's links, which are the same at every depth. */
const pageFolder = 'https://page.invalid/';

/** The permissions of the book's scripts; live examples have pages of their own. */
const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self' data:",
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "frame-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** Writes the pages, with titles at their start, where their links to each other work. */
async function writeSource() {
  rmSync(source, { recursive: true, force: true });
  mkdirSync(source, { recursive: true });
  for (const folder of ['docs', 'examples']) {
    cpSync(inRoot(folder), `${source}/${folder}`, { recursive: true });
  }
  const others = Object.values(contents)
    .flat()
    .map(([path]) => path)
    .filter((path) => !path.includes('/'));
  for (const name of ['LICENSE', 'README.md', ...others])
    copyFileSync(inRoot(name), `${source}/${name}`);
  mkdirSync(`${source}/docs/algorithms/pictures`);
  for (const [name, bytes] of await pictures()) {
    writeFileSync(`${source}/docs/algorithms/pictures/${name}.png`, bytes);
  }
  writeFileSync(`${source}/docs/examples.md`, examplesPage());
  const pages = [];
  for (const [group, listed] of Object.entries(contents)) {
    for (const [path, title] of listed) {
      const words = withPicture(path, readFileSync(`${source}/${path}`, 'utf8'));
      const text = path in live ? withLive(words, live[path]) : words;
      writeFileSync(
        `${source}/${path}`,
        `---\ntitle: ${JSON.stringify(title)}\ngroup: ${group}\n---\n\n${text}`,
      );
      pages.push(`${source}/${path}`);
    }
  }
  return pages;
}

function withPicture(path, text) {
  if (!(path in drawn)) return text;
  const [name, words] = drawn[path];
  const end = text.indexOf('\n') + 1;
  return `${text.slice(0, end)}\n![${words}](pictures/${name}.png)\n${text.slice(end)}`;
}

async function convert(pages) {
  const app = await Application.bootstrapWithPlugins({
    entryPoints: Object.keys(entries).map((path) => inRoot(path)),
    tsconfig: inRoot('docs/book/tsconfig.json'),
    projectDocuments: pages,
    readme: `${source}/docs/index.md`,
    name: 'Karcher',
    out: made,
    titleLink: `${pageFolder}book/index.html`,
    navigationLinks: { Editor: `${pageFolder}index.html`, Paper: `${pageFolder}paper.html` },
    customCss: inRoot('docs/book/style.css'),
    favicon: inRoot('web/public/icon.svg'),
    headings: { readme: false },
    navigation: { includeGroups: true },
    groupOrder: [...Object.keys(contents), 'Modules', '*'],
    sort: ['documents-first', 'source-order'],
    ...{ sortEntryPoints: false, searchInDocuments: true, hideGenerator: true },
    ...{ disableGit: true, disableSources: true, excludeExternals: true, excludeInternal: true },
    ...{ excludePrivate: true, includeHierarchySummary: false, skipErrorChecking: true },
    ...{ logLevel: 'Warn', githubPages: false },
    highlightLanguages: ['typescript', 'javascript', 'sh', 'cpp', 'json', 'cmake', 'html', 'tsx'],
    validation: { notExported: false, invalidLink: true, invalidPath: true },
    suppressCommentWarningsInDeclarationFiles: true,
  });
  app.converter.on(Converter.EVENT_RESOLVE_BEGIN, (context) => {
    const named = Object.values(entries);
    for (const [at, module] of context.project.getChildrenByKind(ReflectionKind.Module).entries()) {
      module.name = named[at];
    }
  });
  const project = await app.convert();
  if (!project) throw new Error('TypeDoc read no types: see above.');
  addExamples(project);
  await app.generateOutputs(project);
  if (app.logger.hasErrors()) throw new Error('TypeDoc made no book: see above.');
  return project;
}

/** A script in the text of a page; a policy for it would permit any script. */
const inlineScript = /<script>(document\.documentElement\.dataset\.theme[\s\S]*?)<\/script>/;

/** Stores the book for use without a network. */
const offline = `if (navigator.serviceWorker && location.protocol !== 'file:') {
  const address = new URL('../../service-worker.js', document.currentScript.src);
  navigator.serviceWorker.register(address, { updateViaCache: 'none' }).catch(() => {});
  navigator.serviceWorker.ready.then(({ active }) => active.postMessage('keep the book'));
}
`;

/** Unfolds the side bar at the first visit; parts that the reader folds stay folded. */
const opened = `try {
  for (const group of ${JSON.stringify(['Start', 'Guides', 'Algorithms'])}) localStorage['tsd-accordion-' + group] ??= 'true';
} catch {}
`;

function finish(path) {
  const up = relative(dirname(path), made).replaceAll(sep, '/');
  const book = up === '' ? '.' : up;
  const text = readFileSync(path, 'utf8');
  const [, script] = inlineScript.exec(text) ?? [];
  if (!script) throw new Error(`${path} has another script than before.`);
  writeFileSync(`${made}/assets/theme.js`, `${script}\n${opened}${offline}`);
  writeFileSync(
    path,
    text
      .replace(inlineScript, `<script src="${book}/assets/theme.js"></script>`)
      .replace('<head>', `<head><meta http-equiv="Content-Security-Policy" content="${policy}">`)
      .replaceAll(`${pageFolder}book/`, `${book}/`)
      .replaceAll(pageFolder, `${book}/../`)
      // TypeDoc opens other hosts in another window, but the editor is on the same host.
      .replaceAll(/(<a href="(?:\.\.?\/)+(?:index|paper)\.html"[^>]*?) target="_blank"/g, '$1'),
  );
}

/** Lists the book's files for the service worker. */
function listFiles() {
  const hash = createHash('sha256');
  const files = filesBelow('build/page/book', /./).map((path) => {
    hash.update(readFileSync(path));
    return relative(made, path).replaceAll(sep, '/');
  });
  const version = hash.digest('hex').slice(0, 16);
  writeFileSync(`${made}/files.json`, JSON.stringify({ version, files }));
}

export async function makeBook() {
  rmSync(made, { recursive: true, force: true });
  const project = await convert(await writeSource());
  await buildLive(made);
  for (const path of filesBelow('build/page/book', /\.html$/)) {
    if (!path.includes(`${sep}live${sep}`)) finish(path);
  }
  listFiles();
  writeFileSync(inRoot('build/book/reference.json'), JSON.stringify(reportOf(project), null, 2));
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await makeBook();
