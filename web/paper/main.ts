import { byId, make } from '../panels/elements';
import { applyTheme, onTheme, toggleTheme } from '../panels/theme';
import { build } from './claims/build';
import { ClaimsSection } from './claims/claims_section';
import { savedReport } from './claims/saved_report';
import { figures, smallFigures } from './figures';
import { LabClient } from './lab/client';
import { PlotsSection } from './plots/plots_section';
import { smallRows, tableRows } from './table/rows';
import { TableSection } from './table/table_section';
import { CarriedSection } from './view/carried_section';
import { FigureSection } from './view/figure_section';
import { GeometryMaker } from './view/geometry';
import { SharedRenderer } from './view/shared_renderer';
import { readColors } from './view/theme_colors';
import { TransportSection } from './view/transport_section';
import { Turns } from './view/turns';

/**
 * Options for tests: `?detail=0.05` makes every mesh smaller, `?antialias=off` makes lines rougher.
 */
const parameters = new URLSearchParams(location.search);

declare global {
  interface Window {
    karcherPaper?: {
      sections: readonly FigureSection[];
      carried: CarriedSection;
      plots: PlotsSection;
      table: TableSection;
    };
  }
}

function start(): void {
  const context = {
    client: new LabClient(),
    geometry: new GeometryMaker(),
    turns: new Turns(),
    renderer: new SharedRenderer({ antialias: parameters.get('antialias') !== 'off' }),
  };
  const detail = Number(parameters.get('detail') ?? 1);
  const shown = detail < 1 ? smallFigures(detail, 17) : figures;
  const claims = new ClaimsSection();
  // The claims need the measurements of all sections; a section without any adds none.
  const measured = () => {
    claims.show(Object.assign({}, ...sections.map((section) => section.measured())));
  };
  const sections = shown.map(
    (figure) => new FigureSection(context, figure, measured, detail < 1 ? null : savedReport),
  );
  const table = new TableSection(
    detail < 1 ? smallRows(detail) : tableRows,
    build.version,
    // The report's numbers are for the full meshes, so they do not apply to smaller meshes.
    detail < 1 ? null : savedReport,
  );
  const carried = new CarriedSection(context, detail);
  const plots = new PlotsSection(
    savedReport?.plots ?? null,
    detail < 1 ? { convergence: [500, 1000], roughness: 500 } : undefined,
  );
  const transport = new TransportSection();
  const [means, ...others] = [...sections, carried, plots, table].map(({ element }) => element);
  byId('figures').append(claims.element, means!, transport.element, ...others);
  const first = { id: 'claims', name: 'All of it', title: 'Do its claims hold?' };
  const second = { id: 'transport', name: 'Figure 2', title: 'A vector carried into a face' };
  const open = { id: 'carried', name: 'Section 6', title: 'A drawing carried to another surface' };
  const beyond = { id: 'plots', name: 'Beyond', title: 'Finer and rougher meshes' };
  const last = { id: 'table', name: 'Table 1', title: 'Times' };
  byId('contents').append(
    ...[first, shown[0]!, second, ...shown.slice(1), open, beyond, last].map(
      ({ id, name, title }) => {
        const link = make('a', '', { href: `#${id}` });
        link.append(make('span', name), title);
        const item = make('li');
        item.append(link);
        return item;
      },
    ),
  );
  const theme = byId<HTMLButtonElement>('theme');
  theme.addEventListener('click', toggleTheme);
  onTheme((name) => {
    theme.setAttribute('aria-pressed', `${name === 'dark'}`);
    readColors();
    for (const section of [...sections, carried, plots, table]) section.recolor();
  });
  window.karcherPaper = { sections, carried, plots, table };
}

applyTheme();
try {
  start();
} catch (error) {
  const box = byId('unsupported');
  box.replaceChildren(
    make('h1', 'The figures can’t be drawn in this browser'),
    make('p', error instanceof Error ? error.message : `${error}`),
  );
  box.hidden = false;
  byId('paper').hidden = true;
}
