import { KarcherError } from '../errors.js';

export const badFile = (message: string) => new KarcherError('badFile', message);

/** A number in the form that people read: 1,234,567. */
export const counted = (count: number) => count.toLocaleString('en');
