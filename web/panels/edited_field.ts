/** Converts a field's value to text and back. `read` returns null for an invalid text. */
export interface FieldFormat<Value> {
  read(text: string): Value | null;
  write(value: Value): string;
}

/**
 * A field whose text takes effect on Enter or when the field loses the focus. Escape or an invalid
 * text restores the previous value. While the text is unfinished, the field has `data-edited`, and
 * the page's shortcuts do not apply. The typed value belongs to the object that the field showed
 * when typing began.
 */
export class EditedField<Value> {
  #shown = '';
  /** The id of the object whose value the field shows. */
  #of: number | null = null;
  #began: { shown: string; of: number | null } | null = null;

  constructor(
    private readonly input: HTMLInputElement,
    take: (value: Value, of: number | null) => void,
    private readonly format: FieldFormat<Value>,
  ) {
    const end = () => {
      const typed = input.value.trim();
      const began = this.#began;
      this.#restore();
      if (!began || typed === began.shown) return;
      const value = format.read(typed);
      if (value !== null) take(value, began.of);
    };
    input.addEventListener('input', () => {
      this.#began ??= { shown: this.#shown, of: this.#of };
      input.dataset.edited = '';
    });
    input.addEventListener('change', end);
    input.addEventListener('blur', end);
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.#began) return;
      event.preventDefault();
      this.#restore();
    });
  }

  /** Shows a value; null disables the field. */
  show(value: Value | null, of: number | null = null): void {
    this.#shown = value === null ? '' : this.format.write(value);
    this.#of = of;
    this.input.disabled = value === null;
    if (this.input.placeholder === 'mixed') this.input.placeholder = '';
    if (!this.#began || value === null) this.#restore();
  }

  /**
   * Empties the field, since the objects have different values. A typed value then applies to all
   * of these objects.
   */
  showOpen(): void {
    this.#shown = '';
    this.#of = null;
    this.input.disabled = false;
    this.input.placeholder = 'mixed';
    if (!this.#began) this.#restore();
  }

  #restore(): void {
    this.#began = null;
    delete this.input.dataset.edited;
    if (this.input.value !== this.#shown) this.input.value = this.#shown;
  }
}
