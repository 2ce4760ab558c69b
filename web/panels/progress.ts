import { byId, write } from './elements';

/** The bar appears when the work takes longer than this time, in milliseconds. */
const patienceMilliseconds = 200;

const box = byId('progress');
const stageText = byId('progress-stage');
const bar = byId<HTMLProgressElement>('progress-bar');
const cancel = byId<HTMLButtonElement>('cancel');

let shown: object | null = null;

export interface ShownProgress {
  /**
   * Sets the stage of the work and its completed fraction: from 0 to 1, or null if it is unknown.
   */
  set(done: number | null, stage: string): void;
  hide(): void;
}

/** Shows the progress of long work, in place of the progress of earlier work. */
export function showProgress(stage: string, onCancel: () => void): ShownProgress {
  const own = {};
  shown = own;
  const timer = setTimeout(() => {
    if (shown === own) box.hidden = false;
  }, patienceMilliseconds);
  const set = (done: number | null, text: string) => {
    if (shown !== own) return;
    write(stageText, text);
    if (done === null) bar.removeAttribute('value');
    else bar.value = done;
  };
  cancel.onclick = onCancel;
  set(null, stage);
  return {
    set,
    hide() {
      clearTimeout(timer);
      if (shown !== own) return;
      shown = null;
      box.hidden = true;
    },
  };
}
