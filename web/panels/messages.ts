import { byId, closeIcon, make } from './elements';

const noteMilliseconds = 4000;
const mostShown = 4;

const container = byId('messages');

/** Shows a failure as a sentence, until the user dismisses it. */
export function showError(sentence: string): HTMLElement {
  const message = show(sentence, 'error');
  message.setAttribute('role', 'alert');
  return message;
}

/** Shows a short remark that disappears by itself. */
export function showNote(sentence: string): void {
  const message = show(sentence, 'note');
  message.setAttribute('role', 'status');
  setTimeout(() => message.remove(), noteMilliseconds);
}

function show(sentence: string, kind: 'error' | 'note'): HTMLElement {
  const message = make('div', '', { className: `message ${kind}` });
  const button = make('button', '', { type: 'button', className: 'tool' });
  button.setAttribute('aria-label', 'Dismiss');
  button.innerHTML = closeIcon;
  button.addEventListener('click', () => message.remove());
  message.append(make('p', sentence), button);
  container.append(message);
  while (container.childElementCount > mostShown) container.firstElementChild!.remove();
  return message;
}

/** An error as a whole sentence. */
export function sentenceOf(error: unknown): string {
  const text = error instanceof Error ? error.message : `${error}`;
  const sentence = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?]$/.test(sentence) ? sentence : `${sentence}.`;
}
