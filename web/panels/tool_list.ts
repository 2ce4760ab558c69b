import type { CurveEdits } from '../editor/engine/curve_edits';
import type { View } from '../editor/engine/view';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import { isEmpty, type Kind } from '../model/figure';
import { byId, make } from './elements';
import { kindGroups } from './kind_names';

/** A button of the rail beside the surface. It chooses what the pointer does next. */
export interface DrawingTool {
  /** The part of the button's id after `tool-`. */
  id: string;
  name: string;
  /** The letter of its key. */
  key: string;
  /** The content of its icon, an SVG of 20 by 20. */
  icon: string;
  isActive(state: State): boolean;
  /** Whether the tool is available; by default always. */
  isPossible?(state: State, view: View): boolean;
  choose(): void;
}

/** The tools in the rail's order. A new tool is a new entry here. */
export function drawingTools(editor: Editor, edits: CurveEdits): DrawingTool[] {
  const latest = new Map<readonly Kind[], Kind>();
  editor.subscribe(({ figure }) => {
    const group = kindGroups.find(({ kinds }) => kinds.includes(figure.kind))!.kinds;
    latest.set(group, figure.kind);
  });
  /**
   * A tool that draws objects of some kinds. It begins with the kind of `group` that was edited
   * last, if `kinds` contains it, and otherwise with the first of `kinds`.
   */
  const draws = (kinds: readonly Kind[], group = kinds) => ({
    isActive: ({ tool, figure }: State) => tool === 'insert' && kinds.includes(figure.kind),
    choose: () =>
      void edits.afterwards(() => {
        const { tool, figure } = editor.state;
        if (tool !== 'select' && kinds.includes(figure.kind)) {
          editor.setTool('insert');
          return;
        }
        const recent = latest.get(group);
        const kind = recent && kinds.includes(recent) ? recent : kinds[0]!;
        if (isEmpty(figure)) editor.setKind(kind);
        else editor.begin(kind);
      }),
  });
  const [pen, curves, round, points] = kindGroups.map(({ kinds }) => kinds);
  return [
    {
      ...{ id: 'select', name: 'Select and move', key: 'v' },
      icon: '<path d="M5.500 3.500v12l3.100-2.800 2 4.300 2-.9-2-4.200h4.200z" />',
      isActive: ({ tool }) => tool === 'select',
      choose: () => editor.setTool('select'),
    },
    {
      ...{ id: 'pen', name: 'Pen', key: 'p' },
      icon: '<path d="m3.500 16.500 1.300-5.800L12 3.500l4.500 4.500-7.200 7.200zM3.500 16.500l5.200-5.200" /><circle class="fill" cx="9.200" cy="10.800" r="1.300" />',
      ...draws(pen!),
    },
    {
      ...{ id: 'freehand', name: 'Freehand', key: 'f' },
      icon: '<path d="M3 15.500c2.500 1.500 3.500-1 2.500-3.500s1-6.500 3-5.500-1.500 6 .5 6.500 3-4.500 4.500-4 .5 4.500 3.500 3" />',
      isActive: ({ tool }) => tool === 'freehand',
      choose: () => editor.setTool('freehand'),
    },
    {
      ...{ id: 'curve', name: 'Curve', key: 'b' },
      icon: '<path d="M4.500 14C5.500 5 9 4.500 10 10s4.500 5 5.500-4" /><circle class="fill" cx="4.300" cy="15.500" r="1.800" /><circle class="fill" cx="15.700" cy="4.500" r="1.800" />',
      ...draws(curves!),
    },
    {
      ...{ id: 'circle', name: 'Circle', key: 'o' },
      icon: '<circle cx="10" cy="10" r="6.500" /><circle class="fill" cx="10" cy="10" r="1.200" />',
      ...draws(['circle'], round!),
    },
    {
      ...{ id: 'ellipse', name: 'Ellipse', key: 'e' },
      icon: '<ellipse cx="10" cy="10" rx="7.500" ry="4.500" /><circle class="fill" cx="10" cy="10" r="1.200" />',
      ...draws(['ellipse'], round!),
    },
    {
      ...{ id: 'center', name: 'Center or points', key: 'w' },
      icon: '<path d="m10 10-5-5M10 10l6-3.500M10 10l-2 6" /><circle cx="4.500" cy="4.500" r="1.500" /><circle cx="16" cy="6" r="1.500" /><circle cx="7.800" cy="16" r="1.500" /><circle class="fill" cx="10" cy="10" r="2.200" />',
      ...draws(points!),
    },
    {
      ...{ id: 'measure', name: 'Measure', key: 'm' },
      icon: '<path d="M2.800 13.200 13.200 2.800l4 4L6.800 17.200zM6 10l1.800 1.800M8.700 7.300l1.800 1.800M11.400 4.600l1.800 1.800" />',
      isActive: ({ tool }) => tool === 'measure',
      choose: () => edits.chooseMeasure(),
    },
  ];
}

/** The rail's buttons. */
export class ToolRail {
  readonly #buttons: readonly HTMLButtonElement[];

  constructor(private readonly tools: readonly DrawingTool[]) {
    this.#buttons = tools.map(makeButton);
    byId('tool-rail').append(...this.#buttons);
  }

  show(state: State, view: View): void {
    for (const [i, tool] of this.tools.entries()) {
      const button = this.#buttons[i]!;
      button.setAttribute('aria-pressed', `${tool.isActive(state)}`);
      button.disabled = tool.isPossible?.(state, view) === false;
    }
  }

  /** Chooses the tool of a letter; false if no tool has it. */
  key(letter: string): boolean {
    const tool = this.tools.find(({ key }) => key === letter);
    tool?.choose();
    return tool !== undefined;
  }
}

function makeButton({ id, name, key, icon, choose }: DrawingTool): HTMLButtonElement {
  const button = make('button', '', { type: 'button', id: `tool-${id}`, className: 'tool' });
  button.setAttribute('aria-label', name);
  button.setAttribute('aria-keyshortcuts', key.toUpperCase());
  button.dataset.tip = `${name} (${key.toUpperCase()})`;
  button.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true">${icon}</svg>`;
  button.addEventListener('click', choose);
  return button;
}
