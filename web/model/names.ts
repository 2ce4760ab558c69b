/** Names of objects and groups: texts of a bounded length. */

/** In UTF-16 code units, as a text field counts them. */
export const longestName = 200;

/** The beginning of a text, without cutting a letter in two. */
export const shortened = (text: string, most: number) =>
  text.slice(0, most).replace(/\p{Surrogate}/gu, '');
