// `npm run dev`: sets up, builds the engine, and serves the page from its sources, reloading it
// when they change. It takes the options of Vite's server, such as --port.
import { buildFacade, buildWasm } from './build.mjs';
import { setUp } from './setup.mjs';
import { inRoot, run } from './shell.mjs';

await setUp('build');
try {
  await buildWasm();
  await buildFacade();
  const vite = [inRoot('node_modules/vite/bin/vite.js'), ...process.argv.slice(2)];
  await run(process.execPath, vite, { minutes: Infinity });
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
