import type { Editor } from '../editor/state/editor';
import { selectedObjects } from '../editor/state/state';
import { copiedText, pastedObjects } from '../model/copied';
import { isEmpty } from '../model/figure';
import { withSources } from '../model/sources';
import { sentenceOf, showNote } from './messages';

/** Fields in which the browser's own copy and paste apply. */
const typing = 'input[type="text"], textarea';

/** Copies, cuts and pastes objects as text on the system's clipboard, thus also between tabs. */
export class Clipboard {
  constructor(
    private readonly editor: Editor,
    private readonly triangles: () => number,
  ) {
    document.addEventListener('copy', (event) => this.#copy(event));
    document.addEventListener('cut', (event) => {
      // A drag under way ends without effect, so that the clipboard receives the objects as they
      // were before the drag.
      editor.interrupt();
      if (this.#copy(event)) editor.objects.delete(this.#ids);
    });
    document.addEventListener('paste', (event) => this.#paste(event));
  }

  get #ids(): readonly number[] {
    return selectedObjects(this.editor.state);
  }

  /**
   * Copies the selection for a menu. Returns false if nothing is selected or the browser forbids
   * it.
   */
  async copy(): Promise<boolean> {
    const text = this.#text;
    if (text === null) return false;
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      showNote('This browser lets no menu copy. Press Ctrl C instead.');
      return false;
    }
  }

  async cut(): Promise<void> {
    this.editor.interrupt();
    const ids = this.#ids;
    if (await this.copy()) this.editor.objects.delete(ids);
  }

  /** Pastes the clipboard's objects for a menu. */
  async paste(): Promise<void> {
    const text = await navigator.clipboard?.readText().catch(() => null);
    if (typeof text !== 'string')
      showNote('This browser lets no menu paste. Press Ctrl V instead.');
    else if (!this.#add(text)) showNote('Nothing of a drawing was copied.');
  }

  /** The selection as text; null without a selection. */
  get #text(): string | null {
    const { mesh, drawing } = this.editor.state;
    // The text includes the sources of derived objects, since another drawing does not have them.
    const ids = withSources(drawing, this.#ids);
    const objects = drawing.objects.filter(
      ({ id, figure }) => ids.includes(id) && !isEmpty(figure),
    );
    return objects.length > 0 ? copiedText(mesh, objects) : null;
  }

  #copy(event: ClipboardEvent): boolean {
    const words = getSelection()?.toString();
    const text = this.#text;
    if (words || isTyping(event) || text === null) return false;
    event.clipboardData?.setData('text/plain', text);
    event.preventDefault();
    return true;
  }

  #paste(event: ClipboardEvent): void {
    if (isTyping(event)) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (this.#add(text)) event.preventDefault();
  }

  /**
   * Adds the objects of a copied text; returns false if the page did not write the text. If the
   * objects do not fit, shows a note and returns true.
   */
  #add(text: string): boolean {
    try {
      const objects = pastedObjects(text, this.editor.state.mesh, this.triangles());
      if (objects) this.editor.objects.add(objects);
      return objects !== null;
    } catch (error) {
      showNote(
        `Nothing was pasted: ${sentenceOf(error).replace(/^./, (letter) => letter.toLowerCase())}`,
      );
      return true;
    }
  }
}

const isTyping = ({ target }: Event) =>
  target instanceof Element && target.closest(typing) !== null;
