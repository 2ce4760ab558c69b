/** A mistake in the use of the command line. The message is a sentence for standard error. */
export class UsageError extends Error {}

const whyNotRead: Record<string, string> = {
  ENOENT: 'there is no such file',
  EISDIR: 'it is a folder',
  EACCES: 'reading it is not allowed',
};

const whyNotWritten: Record<string, string> = {
  ENOENT: 'there is no such folder',
  EISDIR: 'it is a folder',
  EACCES: 'writing it is not allowed',
  ENOSPC: 'the disk is full',
  EPIPE: 'it was closed before everything was written',
};

/** The error for a file that cannot be read, with the reason as a sentence. */
export function fileError(path: string, cause: unknown): UsageError {
  const { code, message } = cause as NodeJS.ErrnoException;
  return new UsageError(`cannot read ${path}: ${whyNotRead[code ?? ''] ?? message}`, { cause });
}

/** The error for a file that cannot be written, with the reason as a sentence. */
export function writeError(path: string, cause: unknown): UsageError {
  const { code, message } = cause as NodeJS.ErrnoException;
  return new UsageError(`cannot write to ${path}: ${whyNotWritten[code ?? ''] ?? message}`, {
    cause,
  });
}
