/** How a field's number is written and read; null where a text is none. */
export interface NumberFormat {
  read(text: string): number | null;
  write(value: number): string;
}

/**
 * A field for a number, if not told otherwise a positive one of any size. It takes a number when it is left or with Enter;
 * Escape, or what is no such number, brings back the one that was there. While it holds what is
 * typed and not yet taken it has `data-edited`, and the page's keys are its own.
 */
export class NumberField {
  #shown = '';

  constructor(
    private readonly input: HTMLInputElement,
    take: (value: number) => void,
    private readonly format: NumberFormat = positive,
  ) {
    const end = () => {
      const typed = input.value.trim();
      const edited = 'edited' in input.dataset && typed !== this.#shown;
      this.#restore();
      const value = format.read(typed);
      if (edited && value !== null) take(value);
    };
    input.addEventListener('input', () => {
      input.dataset.edited = '';
    });
    input.addEventListener('change', end);
    input.addEventListener('blur', end);
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !('edited' in input.dataset)) return;
      event.preventDefault();
      this.#restore();
    });
  }

  /** Null where there is no number to change. */
  show(value: number | null): void {
    this.#shown = value === null ? '' : this.format.write(value);
    this.input.disabled = value === null;
    if (!('edited' in this.input.dataset) || value === null) this.#restore();
  }

  #restore(): void {
    delete this.input.dataset.edited;
    if (this.input.value !== this.#shown) this.input.value = this.#shown;
  }
}

const positive: NumberFormat = {
  read: (text) => positiveNumber(text),
  write: (value) => `${Number(value.toPrecision(4))}`,
};

/** Whole numbers; those beyond the range become its nearest. */
export function wholeNumbers({ least, most }: { least: number; most: number }): NumberFormat {
  return {
    read: (text) => {
      const value = text.trim() === '' ? Number.NaN : Number(text);
      return Number.isFinite(value) ? Math.min(most, Math.max(least, Math.round(value))) : null;
    },
    write: (value) => `${value}`,
  };
}

/** Also with a decimal comma. */
export function positiveNumber(text: string): number | null {
  const value = Number(text.trim().replace(',', '.'));
  return text.trim() !== '' && Number.isFinite(value) && value > 0 ? value : null;
}
