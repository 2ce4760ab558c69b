/** An element of index.html. A wrong id is a programming error. */
export function byId<Type extends HTMLElement = HTMLElement>(id: string): Type {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html has no element '${id}'`);
  return element as Type;
}

export const closeIcon =
  '<svg viewBox="0 0 20 20" aria-hidden="true"><path d="m5 5 10 10M15 5 5 15" /></svg>';

export function make<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  text = '',
  properties: Partial<HTMLElementTagNameMap[Name]> = {},
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  if (text) element.textContent = text;
  return Object.assign(element, properties);
}

/** Adds radio buttons for a choice to the element with an id. The id is also the buttons' name. */
export function choices<Choice extends string>(
  id: string,
  all: readonly Choice[],
  names: Readonly<Record<Choice, string>>,
  choose: (choice: Choice) => void,
  notes?: Readonly<Record<Choice, string>>,
): HTMLInputElement[] {
  return all.map((choice) => {
    const label = make('label', '', notes && { title: notes[choice] });
    const input = make('input', '', { type: 'radio', name: id, value: choice });
    input.addEventListener('change', () => choose(choice));
    label.append(input, make('span', names[choice]));
    byId(id).append(label);
    return input;
  });
}

/** Appends an option to a menu for each value and its text. */
export const fill = (menu: HTMLSelectElement, texts: Readonly<Record<string, string>>): void =>
  menu.append(...Object.entries(texts).map(([value, text]) => make('option', text, { value })));

const integers = new Intl.NumberFormat('en');

export const formatCount = (count: number, one: string, many = `${one}s`) =>
  `${integers.format(count)} ${count === 1 ? one : many}`;

export const formatInteger = (value: number) => integers.format(value);

/** A readable size, such as 3.2 MB. */
export function formatBytes(bytes: number): string {
  const power = Math.min(3, Math.max(1, Math.floor(Math.log10(Math.max(1, bytes)) / 3)));
  return `${Number((bytes / 1000 ** power).toPrecision(2))} ${['', 'kB', 'MB', 'GB'][power]}`;
}

/**
 * Writes a text into an element, unless the element has this text already: each write makes the
 * browser lay out the page again.
 */
export function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
