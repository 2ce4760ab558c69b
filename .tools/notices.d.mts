/** As text: of the package's engine, or of the page, which has the engine, too. */
export function notices(what: 'package' | 'page'): string;
