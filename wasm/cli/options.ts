/** An option of a command. Without `value` it is a flag. */
export interface Option {
  name: string;
  /** The name of the value in the help text, such as FILE. */
  value?: string;
  help: string;
  default?: string;
  required?: boolean;
}

/** The arguments and options that a command takes. */
export interface Described {
  name: string;
  options: readonly Option[];
}

/** The format of commands with a drawable result. */
export const formatOption: Option = {
  name: 'format',
  value: 'json|csv|obj|ply|glb|stl',
  help: 'JSON, a row of CSV for each point of the curves, or a file of lines or tubes; by default the ending of --out determines it',
  default: 'json',
};

/** The options of commands with a drawable result. */
export const drawnOptions: readonly Option[] = [
  formatOption,
  { name: 'surface', help: 'with --format obj, ply, glb or stl: the mesh in the same file' },
  {
    name: 'tube',
    value: 'RADIUS',
    help: 'with --format obj, ply, glb or stl: the curves as closed tubes; STL has no lines',
    // The default is a description for the help; no such value exists.
    default: 'lines',
  },
];

export const pointsOption: Option = {
  name: 'points',
  value: 'FILE',
  help: "a line 'face b1 b2', 'face:b1,b2' or 'v:vertex' for each point, '#' starts a comment; or the JSON output of a command, or a drawing of the page",
  required: true,
};

/** Vertices get a value if their distance is at most this radius. */
export const radiusOption: Option = {
  name: 'radius',
  value: 'R',
  help: 'the greatest distance: vertices beyond it are null, and take no time',
  // The default is a description for the help; no such value exists.
  default: 'the whole surface',
};

/** The destination of the result, for every command without its own `out`. */
export const outOption: Option = {
  name: 'out',
  value: 'FILE',
  help: 'the file for the result',
  // The default is a description for the help; no such value exists.
  default: 'standard output',
};

/** The options for reading the mesh, of every command. */
export const meshOptions: readonly Option[] = [
  {
    name: 'parts',
    value: 'NUMBERS',
    help: 'the parts of the file to read, such as 0,2; karcher info lists them',
    default: 'all',
  },
  {
    name: 'repair',
    value: 'safe|none',
    help: 'mend a mesh that is no surface where that is safe, or refuse it',
    default: 'safe',
  },
  {
    name: 'weld',
    value: 'LENGTH',
    help: 'the distance up to which boundaries are welded; 0 for none',
    // The default is a description for the help; no such value exists.
    default: '1e-6 of the diagonal',
  },
];

export const levelsOption: Option = {
  name: 'levels',
  value: '0…8|auto|limit',
  help: 'the number of subdivisions of the control polygon before its points are averaged; 0 takes the center of mass of all points of a segment',
  default: 'auto',
};

/** The options of fields, for the commands that need fields. */
export const fieldOptions: readonly Option[] = [
  { name: 'method', value: 'karcher|paper', help: 'the method of fields', default: 'karcher' },
  {
    name: 'solver',
    value: 'fast|exact|graph',
    help: 'the solver of distances; with --method paper exact (the default) or graph',
    default: 'fast',
  },
  {
    name: 'rings',
    value: 'K',
    help: 'rings of the graph solver, 1 to 10; it joins vertices that a straight line connects',
    default: '6',
  },
  {
    name: 'star',
    value: 'wide|ring',
    help: "of --method paper: Eq. 3 as in its authors' program (wide) or as printed, the 1-ring",
    default: 'wide',
  },
];
