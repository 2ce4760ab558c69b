import { type Editor, selectedObjects } from '../editor/editor';
import { copiedText, pastedObjects } from '../model/copied';
import { isEmpty } from '../model/figure';
import { sentenceOf, showNote } from './messages';

/** What is typed there is copied and pasted by the browser. */
const typing = 'input[type="text"], textarea';

/** Copies, cuts and pastes objects as text on the system's clipboard, so between tabs too. */
export class Clipboard {
  constructor(
    private readonly editor: Editor,
    private readonly triangles: () => number,
  ) {
    document.addEventListener('copy', (event) => this.#copy(event));
    document.addEventListener('cut', (event) => {
      // What is dragged is cut as it was before.
      editor.interrupt();
      if (this.#copy(event)) editor.deleteObjects(this.#ids);
    });
    document.addEventListener('paste', (event) => this.#paste(event));
  }

  get #ids(): readonly number[] {
    return selectedObjects(this.editor.state);
  }

  #copy(event: ClipboardEvent): boolean {
    const words = getSelection()?.toString();
    if (words || isTyping(event)) return false;
    const { mesh, drawing } = this.editor.state;
    const ids = this.#ids;
    const objects = drawing.objects.filter(
      ({ id, figure }) => ids.includes(id) && !isEmpty(figure),
    );
    if (objects.length === 0) return false;
    event.clipboardData?.setData('text/plain', copiedText(mesh, objects));
    event.preventDefault();
    return true;
  }

  #paste(event: ClipboardEvent): void {
    if (isTyping(event)) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    try {
      const objects = pastedObjects(text, this.editor.state.mesh, this.triangles());
      if (!objects) return;
      event.preventDefault();
      this.editor.addObjects(objects);
    } catch (error) {
      showNote(
        `Nothing was pasted: ${sentenceOf(error).replace(/^./, (letter) => letter.toLowerCase())}`,
      );
    }
  }
}

const isTyping = ({ target }: Event) =>
  target instanceof Element && target.closest(typing) !== null;
