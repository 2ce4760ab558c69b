import { byId, make } from './elements';

/** Lets the user choose the file to open among several; null without a choice. */
export function chooseFile(files: readonly File[]): Promise<File | null> {
  const dialog = byId<HTMLDialogElement>('which-dialog');
  // A second question replaces the first.
  dialog.close();
  return new Promise((resolve) => {
    let chosen: File | null = null;
    const items = files.map((file) => {
      const item = make('li', '');
      const button = make('button', file.name, { type: 'button', className: 'button wide' });
      button.title = file.name;
      button.addEventListener('click', () => {
        chosen = file;
        dialog.close();
      });
      item.append(button);
      return item;
    });
    byId('which-files').replaceChildren(...items);
    const end = () => {
      // The event of a first question's close comes after the second has opened the dialog.
      if (dialog.open) return;
      dialog.removeEventListener('close', end);
      resolve(chosen);
    };
    dialog.addEventListener('close', end);
    dialog.showModal();
  });
}
