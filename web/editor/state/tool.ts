/**
 * What the pointer does on the stage. Selects and moves only; or puts a point on the surface or into the
 * edited curve, draws a stroke, moves, turns and scales in a frame, mirrors in a line of two clicks, cuts
 * the curve, joins another one to it, takes the look of another object, or measures.
 */
export type CurveTool = RestingTool | 'split' | 'join' | 'look' | 'measure' | 'mirror';
/** The tools that stay: a tool of one click gives way to the last of these. */
export type RestingTool = 'select' | 'insert' | 'freehand' | 'transform';

export const isResting = (tool: CurveTool): tool is RestingTool =>
  ['select', 'insert', 'freehand', 'transform'].includes(tool);
