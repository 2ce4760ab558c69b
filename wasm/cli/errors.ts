/** A mistake in the use of the command line: the message is a sentence for standard error. */
export class UsageError extends Error {}

const reasons: Record<string, string> = {
  ENOENT: 'there is no such file',
  EISDIR: 'it is a folder',
  EACCES: 'reading it is not allowed',
};

/** Why a file could not be read, as a sentence. */
export function fileError(path: string, cause: unknown): UsageError {
  const { code, message } = cause as NodeJS.ErrnoException;
  return new UsageError(`cannot read ${path}: ${reasons[code ?? ''] ?? message}`, { cause });
}

/** Why a file could not be written, as a sentence. */
export function writeError(path: string, cause: unknown): UsageError {
  return new UsageError(`cannot write to ${path}: ${(cause as Error).message}`, { cause });
}
