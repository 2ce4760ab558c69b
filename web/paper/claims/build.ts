import type { Build } from './saved';

// vite.config.ts replaces these names by their values.
declare const __KARCHER_BUILD__: string;
declare const __KARCHER_SOURCES__: string;

/** The build of this page. */
export const build: Build = { version: __KARCHER_BUILD__, sources: __KARCHER_SOURCES__ };
