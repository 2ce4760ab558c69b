/** The notices as text: of the package's engine, or of the page, which also contains the engine. */
export function notices(what: 'package' | 'page'): string;
