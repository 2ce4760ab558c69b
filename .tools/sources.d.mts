/** The SHA-256, in hexadecimal, of the sources that decide the Paper page's numbers. */
export function sourcesDigest(): string;
