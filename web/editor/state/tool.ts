/**
 * The tool of the pointer on the stage. `select` only selects and moves, `insert` places a point on
 * the surface or in the edited curve, `freehand` draws a stroke, `transform` moves, turns and
 * scales in a frame, and `mirror` mirrors. `split` cuts the curve, `join` joins another one to it,
 * `look` copies the look of another object to the selected ones, and `measure` measures.
 */
export type CurveTool = RestingTool | 'split' | 'join' | 'look' | 'measure' | 'mirror';
/** The tools that stay active: after a tool for one click, the last of these is active again. */
export type RestingTool = 'select' | 'insert' | 'freehand' | 'transform';

export const isResting = (tool: CurveTool): tool is RestingTool =>
  ['select', 'insert', 'freehand', 'transform'].includes(tool);
