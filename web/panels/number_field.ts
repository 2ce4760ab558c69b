import { EditedField, type FieldFormat } from './edited_field';

export type NumberFormat = FieldFormat<number>;

/** A field for a number. By default, the field accepts any positive number. */
export class NumberField extends EditedField<number> {
  constructor(
    input: HTMLInputElement,
    take: (value: number) => void,
    format: NumberFormat = positive,
  ) {
    super(input, take, format);
  }
}

const positive: NumberFormat = {
  read: (text) => positiveNumber(text),
  write: (value) => `${Number(value.toPrecision(4))}`,
};

/**
 * Options of a field for whole numbers; a number beyond the range becomes the nearest one in the
 * range.
 */
export function wholeNumbers({ least, most }: { least: number; most: number }): NumberFormat {
  return {
    read: (text) => {
      const value = text.trim() === '' ? Number.NaN : Number(text);
      return Number.isFinite(value) ? Math.min(most, Math.max(least, Math.round(value))) : null;
    },
    write: (value) => `${value}`,
  };
}

/** The positive number in a text, which may have a decimal comma. */
export function positiveNumber(text: string): number | null {
  const value = Number(text.trim().replace(',', '.'));
  return text.trim() !== '' && Number.isFinite(value) && value > 0 ? value : null;
}
