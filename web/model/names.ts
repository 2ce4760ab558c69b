/** Names of objects and groups: texts of a bounded length. */

/** The longest name in UTF-16 code units, as a text field counts them. */
export const longestName = 200;

/** The beginning of a text, which ends before a character that would be cut in two. */
export const shortened = (text: string, most: number) =>
  text.slice(0, most).replace(/\p{Surrogate}/gu, '');
