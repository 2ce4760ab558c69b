/** The SHA-256, in hexadecimal, of the sources that determine the Paper page's numbers. */
export function sourcesDigest(): string;
