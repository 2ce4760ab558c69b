import type { SurfacePoint } from 'karcher';
import { polylinesOf } from '../editor/engine/compute';
import type { ShownCut } from '../editor/engine/cut';
import type { Session } from '../editor/engine/session';
import type { View } from '../editor/engine/view';
import type { Editor } from '../editor/state/editor';
import { selectedObjects } from '../editor/state/state';
import { jsonOf, longestInside, partsOfObj, partsWithFile } from '../export/curve_file';
import {
  type DrawnFill,
  type DrawnLine,
  partsOfSvg,
  type Drawing as SvgDrawing,
} from '../export/svg';
import { type DrawnObject, defaultStyle, isBlank, type LineStyle } from '../model/drawing';
import type { CurvesFormat, DrawnCurve } from '../model/drawn_curves';
import { isEmpty, isRound, type Vector } from '../model/figure';
import { gathered } from '../model/gathered';
import { madeSource, meshLabel } from '../model/meshes';
import { originsText } from '../model/origins';
import type { ViewerColors } from '../viewer/colors';
import { fineDash } from '../viewer/fat_line';
import { dotStyle, fatStyle } from '../viewer/object_lines';
import type { Vantage } from '../viewer/vantage';
import type { Viewer } from '../viewer/viewer';
import { download } from './download';
import { byId, formatBytes } from './elements';
import { Menu } from './menu';
import { sentenceOf, showError, showNote } from './messages';
import { nameOf } from './object_rows';
import { showProgress } from './progress';
import { sceneColors } from './theme';

export type Format = 'obj' | 'svg' | 'json';

const types: Record<Format, string> = {
  obj: 'model/obj',
  svg: 'image/svg+xml',
  json: 'application/json',
};

const isFormat = (name: string): name is Format => Object.hasOwn(types, name);

/** The menu's items that save curves as paths, each with its file format. */
const curvesFormats: Partial<Record<string, CurvesFormat>> = {
  surface: 'obj',
  glb: 'glb',
  csv: 'csv',
};

const curvesTypes: Record<CurvesFormat, string> = {
  obj: 'model/obj',
  glb: 'model/gltf-binary',
  csv: 'text/csv',
};

/** The number of a picture's pixels for each CSS pixel, along each axis. */
const pictureScale = 2;

/** The menu that saves the drawing or the view as a file. */
export class SaveMenu {
  readonly #menu = new Menu('save-menu', 'save', () => this.#showWhatThereIs());
  readonly #items = this.#menu.items.filter((item) => item.dataset.save);
  readonly #only = byId<HTMLButtonElement>('only-selected');

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    /** The file of the visible surface; null for a generated surface, or if the file is missing. */
    private readonly surfaceFile: () => Promise<Blob | null>,
  ) {
    this.#only.addEventListener('click', () => {
      this.#only.setAttribute('aria-checked', `${!this.#onlySelected}`);
      this.#showWhatThereIs();
    });
    for (const item of this.#items) {
      item.addEventListener('click', () => {
        this.#menu.element.hidePopover();
        const format = item.dataset.save as Format | 'outline' | 'png' | 'clear' | 'whole';
        const curves = curvesFormats[item.dataset.save!];
        if (curves) void this.#saveCurves(curves);
        else if (format === 'outline') void this.#saveOutline();
        else if (format === 'whole') void this.#saveWhole();
        else if (format === 'png' || format === 'clear') void this.#savePicture(format === 'clear');
        else void this.save(format);
      });
    }
  }

  /** Saves the drawing in a format. If it has nothing for the format, shows a note. */
  async save(format: Format): Promise<void> {
    if (!this.#has(format)) {
      showNote('There is no curve to save yet.');
      return;
    }
    const { state } = this.editor;
    const title = this.#title;
    const parts = {
      obj: () => gathered(partsOfObj(this.#polylines, this.#marks, title)),
      svg: async () => gathered(partsOfSvg(await this.#drawing())),
      json: () => [jsonOf(state, this.session.view, this.viewer.place)],
    };
    download(title, new Blob(await parts[format](), { type: types[format] }), format);
  }

  /**
   * Saves the drawing in one file with its surface, so that it opens where the surface's file is
   * missing.
   */
  async #saveWhole(): Promise<void> {
    const { state } = this.editor;
    const title = this.#title;
    const json = jsonOf(state, this.session.view, this.viewer.place);
    if (madeSource(state.mesh)) {
      download(title, new Blob([json], { type: types.json }), 'json');
      return;
    }
    const name = meshLabel(state.mesh);
    const bytes = await this.surfaceFile();
    if (!bytes) showError(`This browser does not have ${name} any more. Drop it here again.`);
    else if (bytes.size > longestInside) {
      showError(
        `${name} has ${formatBytes(bytes.size)}; files of up to ${formatBytes(longestInside)} go into a drawing’s. Pass it on beside the drawing.`,
      );
    } else {
      const parts = await partsWithFile(json, { name, bytes });
      download(title, new Blob(parts, { type: types.json }), 'json');
    }
  }

  /** Saves the curves as rows of numbers, or as lines or tubes together with the surface. */
  async #saveCurves(format: CurvesFormat): Promise<void> {
    const { client } = this.session;
    if (!client) return;
    const title = this.#title;
    try {
      const bytes = await client.curvesFile(await this.drawnCurves(), format);
      download(title, new Blob([bytes as BlobPart], { type: curvesTypes[format] }), format);
    } catch (error) {
      showError(`The curves were not saved. ${sentenceOf(error)}`);
    }
  }

  /**
   * The visible curves to save, the edited one first, with their colors and their widths in the
   * present view. With `cut`, these are all visible curves, whatever the selection, and the lines
   * of the cut replace the lines of its objects.
   */
  async drawnCurves(cut: ShownCut | null = null): Promise<DrawnCurve[]> {
    const { view } = this.session;
    const { active, objects } = this.editor.state.drawing;
    const others = view.others.filter(({ lines }) => lines.length > 0).map(({ id }) => id);
    const drawn = polylinesOf(view).length > 0 ? [active, ...others] : others;
    const ids = drawn.filter((id) => cut || this.#isMeant(id));
    const found = await this.session.linesOf(ids);
    const vantage = this.viewer.vantage();
    const surface = this.viewer.surface!;
    const { curve: themed } = sceneColors();
    return found.flatMap(({ id, paths: own, samples: sampled }) => {
      const along = cut?.along.filter((one) => one.id === id) ?? [];
      const paths = along.length > 0 ? along.map(({ path }) => path) : own;
      const samples = along.length > 0 ? null : sampled;
      const object = objects.find((one) => one.id === id)!;
      return paths.map((path, i) => {
        const line = path.polyline();
        const middle = 3 * Math.floor(line.length / 6);
        const [x = 0, y = 0, z = 0] = line.subarray(middle, middle + 3);
        const place = surface.inScene([x, y, z]);
        return {
          name: paths.length > 1 ? `${nameOf(object)}, line ${i + 1}` : nameOf(object),
          path,
          samples,
          color: bytesOfColor(object.color ?? themed),
          radius: vantage.reach(place, vantage.seenWidth(object, place)) / 2,
        };
      });
    });
  }

  /** Saves the view, with the surface's outline, as lines. */
  async #saveOutline(): Promise<void> {
    // The drawing starts first, since it shows the present view: the user may turn the view while
    // the outline is computed.
    const drawing = this.#drawing();
    const [title, color] = [this.#title, sceneColors().marks];
    const controller = new AbortController();
    const progress = showProgress('Drawing the outline', () => controller.abort());
    try {
      const outline = { lines: await this.viewer.outline(controller.signal), color };
      const parts = await gathered(partsOfSvg({ ...(await drawing), outline }));
      download(title, new Blob(parts, { type: types.svg }), 'svg');
    } catch (error) {
      if (!controller.signal.aborted)
        showError(`The outline could not be drawn. ${sentenceOf(error)}`);
    } finally {
      progress.hide();
    }
  }

  /** Saves the whole view, with the surface, as a picture of high resolution. */
  async #savePicture(seeThrough: boolean): Promise<void> {
    const background = seeThrough ? null : sceneColors().stage;
    const title = this.#title;
    download(title, await this.viewer.picture(pictureScale, background), 'png');
  }

  get #title(): string {
    const { mesh, drawing } = this.editor.state;
    const drawn = drawing.objects.filter(({ id, figure }) => !isEmpty(figure) && this.#isMeant(id));
    const [one] = drawn;
    const what = drawn.length === 1 ? one!.name || one!.figure.kind : 'drawing';
    return `${what} on ${meshLabel(mesh).replace(/\.obj$/i, '')}`;
  }

  /** The curves to save, the edited one first. */
  get #polylines(): Float32Array[] {
    const { view } = this.session;
    const own = this.#isMeant(this.editor.state.drawing.active) ? polylinesOf(view) : [];
    const others = view.others.filter(({ id }) => this.#isMeant(id));
    return [...own, ...others.flatMap(({ lines }) => lines)];
  }

  /** Whether to save an object: the user chooses all objects, or only the selected ones. */
  #isMeant(id: number): boolean {
    return !this.#onlySelected || selectedObjects(this.editor.state).includes(id);
  }

  get #onlySelected(): boolean {
    return this.#only.getAttribute('aria-checked') === 'true' && !this.#only.disabled;
  }

  /** The marks along the edited curve: x, y, z of each mark. */
  get #marks(): ArrayLike<number> {
    return this.session.view.curve?.marks?.position ?? [];
  }

  /**
   * Whether the drawing has anything for a format. OBJ needs polylines, which points and centers of
   * mass do not have.
   */
  #has(format: Format): boolean {
    if (format === 'obj') return this.#polylines.length > 0;
    if (format === 'json') return !isBlank(this.editor.state.drawing);
    const { view } = this.session;
    const { figure } = this.editor.state;
    const own = view.center || (figure.kind === 'points' && !isEmpty(figure));
    return Boolean(own) || this.#polylines.length > 0 || view.others.length > 0;
  }

  #showWhatThereIs(): void {
    const { state } = this.editor;
    const drawn = state.drawing.objects.filter(({ figure }) => !isEmpty(figure));
    const selected = selectedObjects(state);
    // The choice of the selected objects is disabled if no object is selected, or all are.
    const ofDrawn = drawn.filter(({ id }) => selected.includes(id)).length;
    this.#only.disabled = ofDrawn === 0 || ofDrawn === drawn.length;
    byId('save-none').hidden = this.#has('json');
    for (const item of this.#items) {
      const format = item.dataset.save as string;
      if (format === 'whole') item.disabled = !this.#has('json');
      else if (curvesFormats[format]) item.disabled = !this.#has('obj');
      else if (isFormat(format)) item.disabled = !this.#has(format);
    }
  }

  /** The drawing in the present view. */
  async #drawing(): Promise<SvgDrawing> {
    const { viewer } = this;
    const { view } = this.session;
    const ownToo = this.#isMeant(this.editor.state.drawing.active);
    const others = view.others.filter(({ id }) => this.#isMeant(id));
    const center = ownToo ? view.center : null;
    const vantage = viewer.vantage();
    const colors = sceneColors();
    const { active, isOpen } = this.editor;
    const { kind, points, circle } = this.editor.state.figure;
    const own = isRound(kind) ? (circle ? [circle.center] : []) : points;
    const handles = isOpen && ownToo ? own : [];
    const dot = (place: Parameters<Vantage['project']>[0], color: string, filled = false) => ({
      ...vantage.project(place),
      ...{ color, filled },
    });
    const marks = ownToo ? this.#marks : [];
    const dots = Array.from({ length: marks.length / 3 }, (_, i) => {
      const place: Vector = [marks[3 * i]!, marks[3 * i + 1]!, marks[3 * i + 2]!];
      return dot(viewer.surface!.inScene(place), colors.marks, true);
    });
    const at = (point: SurfacePoint) => viewer.surface!.position(point);
    dots.push(...handles.map((point) => dot(at(point), colors.curve)));
    if (center) dots.push(dot(at(center.point), colors.center));
    // Without handles, single points look like those of other objects.
    const isSingle = kind === 'points' && ownToo && !isOpen && active.visible;
    const { objects } = this.editor.state.drawing;
    const shown = {
      ...{ ...view, others, single: isSingle ? points : [] },
      ...(ownToo ? {} : { curve: null, isolines: null }),
      // Without a selection, the control polygon is not visible.
      legs: ownToo && !this.editor.state.none ? view.legs : [],
    };
    const lines = await gathered(seenLines(shown, active, objects, viewer, vantage, colors));
    const all = await gathered(seenFills(viewer, vantage, colors));
    const fills = all.filter(({ id }) => this.#isMeant(id));
    const inFront = dots.filter(({ height }) => height >= 0);
    return { ...vantage.size, fills, lines, points: inFront };
  }
}

function* seenFills(
  viewer: Viewer,
  vantage: Vantage,
  colors: ViewerColors,
): Generator<DrawnFill & { id: number }> {
  for (const { painted, triangles } of viewer.seenRegions(vantage)) {
    const { style, color } = painted;
    const { id } = painted;
    yield { id, color: style.fillColor ?? color ?? colors.curve, opacity: style.fill, triangles };
  }
}

function* seenLines(
  { curve, isolines, legs, others, single }: View & { single: readonly SurfacePoint[] },
  active: DrawnObject,
  objects: readonly DrawnObject[],
  viewer: Viewer,
  vantage: Vantage,
  colors: ViewerColors,
): Generator<DrawnLine> {
  const colorOf = ({ color }: LineStyle) => color ?? colors.curve;
  /** The parts of a line, each as wide and with such dashes as it is near. */
  function* drawn(
    line: Float32Array,
    style: LineStyle,
    named: Pick<DrawnLine, 'object' | 'visibleOnly'>,
    isLost?: (segment: number) => boolean,
  ): Generator<DrawnLine> {
    const { dash } = fatStyle(style, viewer.surface);
    // The round ends of a part lie outside the stage.
    for (const { segments, middle, ...part } of vantage.seenParts(line, style)) {
      const has = (segment: number) => isLost!(segments[segment]!);
      const lost = { color: colors.lost, dashes: vantage.dashesOf(fineDash, middle), has };
      yield {
        ...{ ...part, ...named, color: colorOf(style), width: vantage.widthOf(style, middle) },
        ...(dash && { dashes: vantage.dashesOf(dash, middle) }),
        ...(isLost && { lost }),
      };
    }
  }
  const visibleOnly = !viewer.hiddenLines;
  const named = (object: DrawnObject) => ({ visibleOnly, object: titled(object) });
  function* dots(points: readonly SurfacePoint[], style: LineStyle): Generator<DrawnLine> {
    const wide = dotStyle(style);
    for (const point of points) {
      const place = viewer.surface!.position(point);
      const { x, y, hidden, height } = vantage.project(place);
      const look = { color: colorOf(style), width: vantage.seenWidth(wide, place) };
      if (height >= 0) yield { x: [x], y: [y], hidden: [hidden], ...look };
    }
  }
  for (const { id, style, lines, points, center } of others) {
    const object = objects.find((one) => one.id === id);
    for (const line of lines) yield* drawn(line, style, object ? named(object) : {});
    for (const dot of dots(center ? [...points, center] : points, style)) {
      yield { ...dot, ...(object && named(object)) };
    }
  }
  const polygon = { ...defaultStyle, color: colors.polygon, width: 1.2 };
  for (const leg of legs) yield* drawn(leg, polygon, {});
  if (curve) {
    const { polyline, polylineStatus } = curve;
    yield* drawn(polyline, active, named(active), (at) => polylineStatus[at + 1] === 1);
  }
  for (const { polyline } of isolines?.lines ?? []) {
    yield* drawn(polyline, active, named(active));
  }
  for (const dot of dots(single, active)) yield { ...dot, ...named(active) };
}

/** Red, green and blue of `#rrggbb` or `rgb(r, g, b)`, 0 to 255. */
function bytesOfColor(color: string): [number, number, number] {
  const [r = 0, g = 0, b = 0] = color.startsWith('#')
    ? [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16))
    : (color.match(/[\d.]+/g) ?? []).map((value) => Math.round(Number(value)));
  return [r, g, b];
}

const titled = (object: DrawnObject) => ({
  ...{ id: object.id, name: nameOf(object), opacity: object.opacity },
  description: originsText(object.figure),
});
