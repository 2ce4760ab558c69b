import { make } from '../../panels/elements';
import { Caption, sectionHead } from '../view/section';
import { build } from './build';
import { judge } from './judge';
import { isOlder, olderNote, type SavedClaim, type SavedReport } from './saved';
import { savedReport } from './saved_report';
import type { JudgedClaim, Measured, Verdict } from './types';

const order: readonly Verdict[] = [
  ...(['holds', 'depends', 'does not', 'settled here', 'open', 'not measured here'] as const),
];

/** The words for a verdict on several claims, if they differ from those for one claim. */
const ofSeveral: Partial<Record<Verdict, string>> = {
  ...{ holds: 'hold', depends: 'depend', 'does not': 'do not' },
};

const unmeasured: Pick<JudgedClaim, 'verdict' | 'measured'> = {
  verdict: 'not measured here',
  measured: '',
};

/**
 * The paper's claims, with the measurements of the report or with later measurements of the page.
 */
export class ClaimsSection {
  readonly element = make('section', '', { className: 'figure', id: 'claims' });
  readonly #report: SavedReport | null;
  readonly #caption = new Caption('');
  readonly #card = make('div', '', { className: 'panel-card claims' });

  constructor(report: SavedReport | null = savedReport) {
    this.#report = report;
    const head = sectionHead('Section by section', 'Do its claims hold?');
    this.element.append(head, this.#caption.element, this.#card);
    this.show({});
  }

  /**
   * Judges the claims that the report did not measure, by the panels that the page has measured.
   */
  show(panels: Measured['panels']): void {
    const live = judge({ panels, table: [], studies: {}, meshes: null, load: null });
    const rows = live.map((row): ShownClaim => {
      const saved = this.#report?.claims.find(({ id }) => id === row.id);
      const { id, where, claim, figure } = row;
      if (saved && saved.verdict !== 'not measured here') {
        const older = isOlder(saved.renewed ?? this.#report!, build);
        return { ...saved, where, claim, figure, live: false, older };
      }
      if (row.verdict !== 'not measured here') return { ...row, live: true, older: false };
      return { ...unmeasured, id, where, claim, figure, live: false, older: false };
    });
    this.#card.replaceChildren(table(rows));
    this.#caption.tell(captionOf(rows, this.#report));
  }
}

interface ShownClaim extends SavedClaim {
  /** Whether the measurements of this page decided the verdict. */
  live: boolean;
  /** Whether the code has changed since the verdict. */
  older: boolean;
}

function captionOf(rows: readonly ShownClaim[], report: SavedReport | null): string {
  const counts = order.flatMap((verdict) => {
    const count = rows.filter((row) => row.verdict === verdict).length;
    return count > 0 ? [`${count} ${count > 1 ? (ofSeveral[verdict] ?? verdict) : verdict}`] : [];
  });
  const about = report
    ? `Measured on ${report.date} by version ${report.version} with seed ${report.seed} on ${report.machine}, by “npm run paper”.`
    : 'This build has no report: “npm run paper -- --save” makes one, with meshes that are not at hand here by “--meshes FOLDER”. Until then the claims are judged by the figures below as they are measured in your browser, where those are enough.';
  const older = rows.filter((row) => row.older).length;
  const ageing = older > 0 ? ` ${older} of the rows are ${olderNote}, and say so.` : '';
  return `Each claim of the paper in our words, what was measured of it, and what follows, also where that speaks against us: ${counts.join(', ')}. “Ours” is level 0, the center of mass of all points; the default is named. ${about}${ageing}`;
}

function table(rows: readonly ShownClaim[]): HTMLElement {
  const element = make('table');
  const heads = element.createTHead().insertRow();
  for (const text of ['Where', 'The paper says', 'Measured', 'Verdict']) {
    heads.append(make('th', text, { scope: 'col' }));
  }
  const body = element.createTBody();
  for (const row of rows) body.append(tableRow(row));
  return element;
}

function tableRow(row: ShownClaim): HTMLElement {
  const { id, where, claim, figure, measured, verdict, on, live, older, renewed } = row;
  const element = make('tr');
  element.dataset.claim = id;
  const place = make('th', '', { scope: 'row' });
  if (figure) place.append(make('a', where, { href: `#${figure}` }));
  else place.textContent = where;
  const mark = make('strong', verdict);
  const last = make('td');
  last.dataset.verdict = verdict;
  last.append(mark);
  if (on) last.append(make('span', on));
  if (live) last.append(make('small', 'in your browser'));
  if (renewed) {
    last.append(make('small', `measured on ${renewed.date} by version ${renewed.version}`));
  }
  if (older) last.append(make('small', olderNote));
  element.append(place, make('td', claim), make('td', measured), last);
  return element;
}
