import { KarcherError } from '../errors.js';

export const badFile = (message: string) => new KarcherError('badFile', message);

/** Numbers as a person reads them: 1,234,567. */
export const counted = (count: number) => count.toLocaleString('en');
