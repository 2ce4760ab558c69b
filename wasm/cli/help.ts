import type { Command } from './command.js';
import type { Option } from './options.js';

const label = (option: Option) =>
  `--${option.name}${option.value === undefined ? '' : ` ${option.value}`}`;

/** The largest width of the left column. The description of a longer entry starts a new line. */
const mostWidth = 28;

const indented = (rows: readonly (readonly [string, string])[]) => {
  const short = rows.map(([left]) => left.length).filter((length) => length <= mostWidth);
  const width = Math.max(...short);
  return rows
    .map(([left, right]) => {
      const gap = left.length > width ? `\n${' '.repeat(width + 2)}` : '';
      return `  ${left.padEnd(width)}${gap}  ${right}\n`;
    })
    .join('');
};

export function generalHelp(commands: readonly Command[]): string {
  return `karcher COMMAND MESH [options]: centers of mass and splines on triangle meshes

${indented(commands.map((command) => [command.name, command.summary]))}
MESH is an OBJ, PLY, STL, OFF, GLB or glTF file, or '-' for standard input, as is any FILE that is read;
of several meshes there is a line of JSON each. A point is 'face:b1,b2', the weights of the face's second
and third corner, or 'v:vertex', or JSON as commands print it. Faces and vertices are numbered from 0 in the file's order; faces count triangles, after polygons were cut.
Results go to standard output, mistakes to standard error with exit status 1.
'karcher help COMMAND' tells more; 'karcher --version' prints the version.
`;
}

export function commandHelp(command: Command): string {
  const required = command.options.filter((option) => option.required).map(label);
  const usage = ['karcher', command.name, 'MESH', ...required, '[options]'].join(' ');
  const rows = command.options.map((option): [string, string] => [
    label(option),
    option.default === undefined ? option.help : `${option.help} (${option.default})`,
  ]);
  rows.push(['-h, --help', 'this text']);
  return `${usage}: ${command.summary}

${indented(rows)}
Prints ${command.output}
In JavaScript: ${command.call}
`;
}
