// Helpers for the tests of circles and of ellipses.

/** A flat grid of squares with sides of 1, as OBJ text. */
export function flatGrid(cells) {
  const lines = [];
  const at = (i, j) => 1 + i + (cells + 1) * j;
  for (let j = 0; j <= cells; j++) {
    for (let i = 0; i <= cells; i++) lines.push(`v ${i} ${j} 0`);
  }
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** The visible lines: the view's isolines, or its curve. */
export const linesOf = ({ isolines, polyline }) =>
  isolines ? isolines.lines.map((line) => Object.values(line.polyline)) : [polyline];

/** Types a number into a field, and returns the resulting view. */
export async function typeRadius(tab, text, name = 'Radius') {
  const field = tab.page.getByRole('textbox', { name });
  await field.fill(text);
  await field.press('Enter');
  return tab.view();
}
