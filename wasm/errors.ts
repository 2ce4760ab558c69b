import type { ErrorCode } from './types.js';

/**
 * A failure of Karcher. `code` names its kind, and `message` is a sentence that names the mistake,
 * and the limit if there is one. After a failure everything is as it was before the call.
 */
export class KarcherError extends Error {
  /** The name of the class, as for all errors. */
  override readonly name = 'KarcherError';
  /** The kind of the failure, for programs. */
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }
}
