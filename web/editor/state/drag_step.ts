import type { Command } from '../../model/commands';
import type { Drawing } from '../../model/drawing';

/** A drag under way, which becomes one step. */
export class DragStep {
  /** The whole drag as one command. */
  command: Command | null = null;
  /** Whether the user has let go, so that only the last step is still under way. */
  released = false;

  /** `base` is the drawing before the drag; `inside` stores a side that the drag keeps. */
  constructor(
    readonly base: Drawing,
    readonly inside: Command | null = null,
  ) {}

  withInside(command: Command): Command {
    return this.inside ? { type: 'steps', steps: [command, this.inside] } : command;
  }
}
