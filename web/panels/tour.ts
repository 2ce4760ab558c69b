import { recall, remember } from '../model/storage';
import { byId, write } from './elements';

interface Step {
  /** The selector of the element that the step describes. */
  about: string;
  title: string;
  text: string;
  /** Whether the step appears only for a drawing that is not empty. */
  isOfDrawing?: boolean;
}

const steps: readonly Step[] = [
  {
    about: '#stage',
    title: 'It all lies on the surface',
    text: 'Drag a line to move it, a point to shape it, and the rest to turn the view. Undo takes everything back.',
    isOfDrawing: true,
  },
  {
    about: '#tool-rail',
    title: 'Draw with a tool',
    text: 'The pen draws shapes with handles, a curve follows its points, a circle keeps its distance along the surface. Enter ends one and begins the next.',
  },
  {
    about: '.objects-group',
    title: 'Objects have a list',
    text: 'Name them, color them, hide or lock them, and drag them up and down in the order.',
  },
  {
    about: '.surface-group',
    title: 'Take your own surface',
    text: 'Choose a sample here, or drop a scan or a model anywhere: OBJ, PLY, STL, OFF or GLB.',
  },
  {
    about: '.tools',
    title: 'Keep what you draw',
    text: 'Save it as a picture or a file, or copy its link. It is still here after a reload.',
  },
];

/**
 * The gap in CSS pixels between the card and its element, and between the card and the window's
 * edge.
 */
const gap = 14;

/** A tour of the page in five steps, for new users, who can skip it. */
export class Tour {
  readonly #card = byId('tour');
  readonly #next = byId<HTMLButtonElement>('tour-next');
  #at = 0;

  /**
   * `reveal` raises the panel if it is down; `isDrawn` returns whether the drawing is not empty.
   */
  constructor(
    private readonly reveal: () => void,
    private readonly isDrawn: () => boolean,
  ) {
    this.#next.addEventListener('click', () => this.#show(this.#at + 1));
    byId('tour-skip').addEventListener('click', () => this.#end());
    // The tour starts when the help closes, since the open help keeps the focus.
    const help = byId<HTMLDialogElement>('help-dialog');
    help.addEventListener('close', () => {
      if (help.returnValue !== 'tour') return;
      help.returnValue = '';
      this.#show(0);
      this.#next.focus();
    });
    this.#card.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      this.#end();
    });
    window.addEventListener('resize', () => {
      if (!this.#card.hidden) this.#place();
    });
  }

  /** Begins the tour, unless the user has seen it before. The focus stays in place. */
  greet(): void {
    if (recall('tour') === null) this.#show(0);
  }

  /** Goes to the next step if the present one no longer fits the drawing. */
  update(): void {
    if (!this.#card.hidden && !this.#fits(this.#at)) this.#show(this.#at + 1);
  }

  #fits(at: number): boolean {
    return !steps[at]?.isOfDrawing || this.isDrawn();
  }

  #show(next: number): void {
    const at = this.#fits(next) ? next : next + 1;
    const step = steps[at];
    if (!step) {
      this.#end();
      return;
    }
    remember('tour', 'shown');
    this.#at = at;
    write(byId('tour-title'), step.title);
    write(byId('tour-text'), step.text);
    write(byId('tour-count'), `${at + 1} of ${steps.length}`);
    write(this.#next, at + 1 < steps.length ? 'Next' : 'Done');
    this.#card.hidden = false;
    this.#mark();
    this.#place();
  }

  #end(): void {
    this.#card.hidden = true;
    document.querySelector('.toured')?.classList.remove('toured');
  }

  get #about(): Element {
    return document.querySelector(steps[this.#at]!.about)!;
  }

  #mark(): void {
    document.querySelector('.toured')?.classList.remove('toured');
    const about = this.#about;
    if (about.closest('.panel')) {
      this.reveal();
      about.scrollIntoView({ block: 'nearest' });
    }
    about.classList.add('toured');
  }

  /**
   * Places the card beside the element that it explains, or in the corner of a wide stage that it
   * explains.
   */
  #place(): void {
    const about = this.#about;
    const { left, right, top, bottom, width } = about.getBoundingClientRect();
    const { offsetWidth, offsetHeight } = this.#card;
    const within = (value: number, most: number) => Math.max(gap, Math.min(value, most - gap));
    const isBeside = right + gap + offsetWidth + gap < innerWidth;
    const isBelow = bottom + gap + offsetHeight + gap < innerHeight;
    let x = isBeside ? right + gap : left + (width - offsetWidth) / 2;
    let y = isBeside ? top : isBelow ? bottom + gap : top - gap - offsetHeight;
    if (about.id === 'stage' && offsetWidth < width / 2) {
      x = right;
      y = top + byId('view').offsetHeight + 3 * gap;
    }
    this.#card.style.left = `${within(x, innerWidth - offsetWidth)}px`;
    this.#card.style.top = `${within(y, innerHeight - offsetHeight)}px`;
  }
}
