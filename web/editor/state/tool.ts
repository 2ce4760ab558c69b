/**
 * What the pointer does on the stage. Selects and moves only; or puts a point on the surface or into the
 * edited curve, draws a stroke, moves, turns and scales in a frame, mirrors in a line of two clicks, cuts
 * the curve, joins another one to it, takes the look of another object, or measures.
 */
export type CurveTool = RestingTool | 'split' | 'join' | 'look' | 'measure' | 'mirror';
/** What a tool that has done its work gives way to. */
export type RestingTool = 'select' | 'insert' | 'freehand' | 'transform';

export const isResting = (tool: CurveTool): tool is RestingTool =>
  ['select', 'insert', 'freehand', 'transform'].includes(tool);
