/**
 * The action of the pointer on the stage: to select and move only; to place a point on the surface
 * or in the edited curve; to draw a stroke; to move, turn and scale in a frame; to mirror in a line
 * of two clicks; to cut the curve, join another one to it, take the look of another object, or
 * measure.
 */
export type CurveTool = RestingTool | 'split' | 'join' | 'look' | 'measure' | 'mirror';
/** The tools that stay active: after a tool for one click, the last of these is active again. */
export type RestingTool = 'select' | 'insert' | 'freehand' | 'transform';

export const isResting = (tool: CurveTool): tool is RestingTool =>
  ['select', 'insert', 'freehand', 'transform'].includes(tool);
