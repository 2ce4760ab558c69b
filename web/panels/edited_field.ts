/** The writer and reader of a field's value; null for a text that is none. */
export interface FieldFormat<Value> {
  read(text: string): Value | null;
  write(value: Value): string;
}

/**
 * A field that takes a value when it is left or with Enter; Escape, or what is no such value, brings
 * back the one that was there. While it holds what is typed and not yet taken it has `data-edited`, and
 * the page's keys are its own. What is typed is for the object whose value was shown when that began.
 */
export class EditedField<Value> {
  #shown = '';
  /** The id of the object whose value is shown. */
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

  /** Null where there is nothing to change. */
  show(value: Value | null, of: number | null = null): void {
    this.#shown = value === null ? '' : this.format.write(value);
    this.#of = of;
    this.input.disabled = value === null;
    if (this.input.placeholder === 'mixed') this.input.placeholder = '';
    if (!this.#began || value === null) this.#restore();
  }

  /** Leaves the field open, where several objects have several values; what is typed is for all of them. */
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
