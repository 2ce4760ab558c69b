import { make } from './elements';

/** Passes a file to the browser's downloads. The file's name comes from the title. */
export function download(title: string, file: Blob, extension: string): void {
  const name = `${title.replaceAll(/[^\p{L}\p{N}]+/gu, '-').toLowerCase()}.${extension}`;
  const address = URL.createObjectURL(file);
  make('a', '', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
