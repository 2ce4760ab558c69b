import type { Session } from './editor/engine/session';
import type { Editor } from './editor/state/editor';
import type { HowOpened } from './editor/state/state';
import { readJson } from './export/curve_file';
import { type Drawing, emptyDrawing } from './model/drawing';
import { type Example, examples } from './model/examples';
import { fitting } from './model/fitting';
import type { History } from './model/history';
import { formatLink, type Link, parseLink, pointsOf } from './model/link';
import { mostLinkPoints } from './model/link_problems';
import {
  defaultMesh,
  fileKey,
  fileSource,
  keyOfFile,
  type MeshSource,
  madeSource,
  meshLabel,
  parseKey,
  type Reading,
  readAs,
  readingOf,
  sameContent,
  sameSurface,
  sampleSource,
} from './model/meshes';
import { type MethodId, methodOptions } from './model/methods';
import { drawingOnPart, placesOfDrawing } from './model/part_drawing';
import type { SurfacePart } from './model/parts';
import { sameDrawing } from './model/saved_work';
import { keepFile, keptFile, nameFor, recallFor, remember } from './model/storage';
import { carried, unlessBlank, wantedOf } from './opened_drawing';
import { formatBytes, formatCount, formatInteger } from './panels/elements';
import { sentenceOf, showError, showNote } from './panels/messages';
import { showProgress } from './panels/progress';
import { keepUnit, unitOf } from './panels/unit_choice';
import { chooseFile } from './panels/which_file';
import { type FoundLink, startingLink, workOn } from './saving';
import { sentenceOfUnknown, sorted, whole } from './sorted_files';
import { drawnGeometry, type GeometryRequest } from './viewer/drawn_geometry';
import { placesOn } from './viewer/places';
import type { Surface } from './viewer/surface';
import type { Viewer } from './viewer/viewer';
import { EngineClient } from './worker/client';

/** The largest file in bytes, since a larger one would not fit into the engine's memory. */
const largestFile = 1 << 30;

/** The largest number of restarts for one surface, after engines have stopped by themselves. */
const mostRestarts = 2;

/** The drawing for a new surface; null for the drawing that is kept for this surface. */
type Wanted = (surface: Surface, before: Surface | null) => Drawing | null;

/**
 * Opens surfaces, each in an engine of its own. The stage keeps its surface until the new one is
 * complete, so that a bad file or a cancelled wait changes nothing.
 */
export class Opening {
  #running: AbortController | null = null;
  #restarts = 0;
  /** The last choice of reading options, with the file's key by it, until it has taken effect. */
  #rereading: { key: string; controller: AbortController } | null = null;
  /** Restarts the engine that stopped while a surface was being opened. */
  #restartLater: (() => void) | null = null;
  #complaint: HTMLElement | null = null;
  /** Links whose files this browser does not have. Each waits until the user opens its file. */
  readonly #awaited = new Map<string, string>();
  /** The last opened file, in case the browser does not keep it. */
  #file: { key: string; file: File | null } = { key: '', file: null };
  /** The first drawing's history from before a reload. */
  #history: { history: History; link: Link } | null = null;
  #viewer: Viewer | null = null;
  readonly #viewerReady = withResolvers<Viewer>();
  /** The listener for the end of each attempt to open, unless a newer attempt has replaced it. */
  onEnd: () => void = () => {};

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
  ) {}

  /** Hands over the viewer, for which complete surfaces wait. */
  show(viewer: Viewer): void {
    this.#viewerReady.resolve(viewer);
    this.#viewer = viewer;
  }

  /** Opens a sample. Another level of detail of the same surface keeps the drawing. */
  async sample(key: string): Promise<boolean> {
    const parsed = parseKey(key);
    if (!parsed || !('sample' in parsed)) {
      showError(`There is no sample surface '${key}'.`);
      return false;
    }
    return this.#open(key, sampleSource(parsed.sample, parsed.detail), (surface, before) => {
      const { mesh, drawing } = this.editor.state;
      const carries = before && mesh !== key && sameSurface(mesh, key);
      return carries ? unlessBlank(carried(drawing, before, surface)) : null;
    });
  }

  /**
   * Opens files that came together: a surface with the files that belong to it, and then a drawing.
   * If there are several surfaces or drawings, the user chooses one file. Reports unknown files.
   */
  async files(files: readonly File[]): Promise<void> {
    const { surfaces, drawings, unknown } = sorted(files);
    if (unknown.length > 0) showNote(sentenceOfUnknown(unknown));
    const known = [...surfaces, ...drawings];
    const one = surfaces.length <= 1 && drawings.length <= 1;
    const opened = one ? known : [await chooseFile(known)];
    for (const file of opened) if (file) await this.file(await whole(file, files));
  }

  /**
   * Opens a surface, or a drawing that the page saved (JSON). If a link waits for the surface, the
   * surface opens with the link's drawing.
   */
  async file(file: File): Promise<void> {
    try {
      if (/\.json$/i.test(file.name)) {
        const { link, file: inside } = await readJson(await file.text());
        if (inside) await this.#keepInside(inside, link);
        await this.link({ link, own: true });
        return;
      }
      if (file.size > largestFile) {
        throw new Error(`it has ${formatBytes(file.size)}; files of up to 1 GB are opened`);
      }
      const key = await fileKey(file);
      const name = nameFor('awaited', key);
      const awaited = parseLink(this.#awaited.get(name) ?? recallFor('awaited', key) ?? '');
      const opened = awaited
        ? await this.#openLink(awaited, fileSource(awaited.mesh, file))
        : await this.#open(key, fileSource(key, file), () => null);
      if (!opened) return;
      if (awaited) this.#forgetWaiting(key);
      await this.#keep(key, file);
    } catch (error) {
      this.#complain(`${file.name} could not be read. ${sentenceOf(error)}`);
    } finally {
      await this.#fallBack();
    }
  }

  /** Keeps a surface's file in this browser; reports files that a reload will lose. */
  async #keep(key: string, file: File, made = false): Promise<void> {
    this.#file = { key, file };
    const removed = await keepFile(key, file, made);
    if (!removed) {
      showNote(`${file.name} is not kept by this browser. After a reload, drop it again.`);
    }
    for (const one of removed ?? []) {
      showNote(`${meshLabel(one)} is no longer kept by this browser, which needs room for others.`);
    }
  }

  /**
   * Keeps the surface's file inside a drawing's file. Throws if it is not the drawing's surface.
   */
  async #keepInside(file: File, { mesh }: Link): Promise<void> {
    const key = await fileKey(file);
    if (!sameContent(key, keyOfFile(mesh))) {
      throw new Error('the file of the surface that is inside is another one than it was drawn on');
    }
    await this.#keep(key, file);
  }

  /** The file of a surface; null if this browser has none, or the page generates the surface. */
  async fileOf(mesh: string): Promise<Blob | null> {
    const key = keyOfFile(mesh);
    return (await keptFile(key)) ?? (sameContent(this.#file.key, key) ? this.#file.file : null);
  }

  /**
   * Shows the present file with other reading options. Options that are not in `part` stay as they
   * are, or as the user has chosen them just before. Another tolerance of welding or another upward
   * axis keeps the drawing; other parts do not.
   */
  async reread(part: Partial<Reading>): Promise<void> {
    const shown = this.editor.state.mesh;
    const key = readAs(this.#rereading?.key ?? shown, part);
    const [before, after] = [readingOf(shown), readingOf(key)];
    this.#stopRereading();
    if (!before || !after || key === shown) return;
    const controller = new AbortController();
    const { signal } = controller;
    this.#rereading = { key, controller };
    const sameParts = `${before.parts}` === `${after.parts}`;
    try {
      if (sameParts && before.weld === after.weld) return await this.#turn(key, signal);
      const content = await this.fileOf(key);
      if (signal.aborted) return;
      if (content) await this.#open(key, fileSource(key, content), () => null, {}, controller);
      else showError(`This browser does not have ${meshLabel(key)} any more. Drop it here again.`);
    } finally {
      if (this.#rereading?.controller === controller) this.#rereading = null;
    }
  }

  #stopRereading(): void {
    this.#rereading?.controller.abort();
    this.#rereading = null;
  }

  /** Shows the present surface with a key's upward axis, unless a later choice replaces it. */
  async #turn(key: string, signal: AbortSignal): Promise<void> {
    const [client, viewer] = [this.session.client, this.#viewer];
    if (!client || !viewer) return;
    const drawn = await drawnGeometry(drawnMesh(client, key));
    if (client !== this.session.client || signal.aborted) return;
    this.editor.cancelDrag();
    const { standIn } = this.editor.state;
    const { triangles } = viewer.showSurface(drawn);
    viewer.resetView({ animated: false });
    this.#showDrawing(key, null, triangles, { standIn });
    this.onEnd();
  }

  /**
   * Opens the drawing of a link; returns false after a message if that is impossible. A link of
   * this browser or from a file may have any number of points.
   */
  async link({ link, own }: FoundLink): Promise<boolean> {
    const { mesh, method, problems } = link;
    const points = pointsOf(link.drawing);
    if (!own && points > mostLinkPoints) {
      this.#complain(
        `The link has ${formatInteger(points)} points; up to ${formatInteger(mostLinkPoints)} are opened.`,
      );
      return false;
    }
    if (problems.length > 0) showError(problems.join(' '));
    const parsed = parseKey(mesh);
    if (!parsed) {
      this.#complain(`The link asks for a surface '${mesh}', which this page does not have.`);
      return false;
    }
    const [{ client }, { mesh: shown }] = [this.session, this.editor.state];
    if (client && sameContent(mesh, shown)) {
      if (method && !(await this.prepare(method))) return false;
      // The user may have opened another surface in the meantime.
      if (client !== this.session.client || shown !== this.editor.state.mesh) return false;
      if (method) this.editor.setMethod(method);
      this.#drawInstead(wantedOf(link)(this.#viewer!.surface!));
      if (link.view) this.#viewer!.showPlace(link.view, { animated: true });
      return true;
    }
    const made = madeSource(mesh);
    if (made) return this.#openLink(link, made);
    const content = await this.fileOf(mesh);
    if (content) return this.#openLink(link, fileSource(mesh, content));
    const waiting = formatLink(mesh, method ?? this.editor.state.method, link.drawing, link.view);
    this.#waitFor(mesh, waiting);
    this.#complain(`The curve is on ${meshLabel(mesh)}. Drop that file here to continue.`);
    return false;
  }

  /** Shows an example: a finished drawing on its own surface. */
  async example({ mesh, draw }: Example): Promise<void> {
    const wanted = (surface: Surface) => draw(placesOn(surface));
    const shown = this.session.client && mesh === this.editor.state.mesh;
    if (shown) this.#drawInstead(wanted(this.#viewer!.surface!));
    else if (!(await this.#open(mesh, madeSource(mesh)!, wanted))) return;
    this.editor.setTool('select');
  }

  /**
   * Opens the drawing of the address, or the last one of this browser; otherwise opens the first
   * example and returns true.
   */
  async first(): Promise<boolean> {
    const found = startingLink();
    const work = found && workOn(found.link);
    if (work) this.#history = work;
    const wanted = work ? { link: work.link, own: true } : found;
    if (wanted) await this.link(wanted);
    else await this.example(examples[0]!);
    await this.#fallBack();
    return !wanted;
  }

  /**
   * Shows the page's default surface if the stage is empty and no surface is being opened. If the
   * page started with a link, this surface stands in for the link's surface.
   */
  async #fallBack(): Promise<void> {
    if (this.#running || this.editor.state.mesh !== '') return;
    const standIn = startingLink() !== null;
    await this.#open(defaultMesh, madeSource(defaultMesh)!, () => null, { standIn });
  }

  /**
   * Opens a part of the cut surface as a surface of its own, with the objects of the drawing that
   * lie on it. The browser's Back leads to the whole surface with its drawing.
   */
  async part(part: SurfacePart, name: string, cut: number): Promise<void> {
    const { client } = this.session;
    const { mesh, drawing } = this.editor.state;
    if (!client) return;
    try {
      // PLY has no parts.
      const format = (client.file?.parts.length ?? 0) > 1 ? 'obj' : 'ply';
      const places = placesOfDrawing(drawing);
      const [bytes, points] = await Promise.all([
        client.partFile({ ...part, thick: null }, format),
        client.pointsOnPart(part, places),
      ]);
      const title = `${name} of ${meshLabel(mesh).replace(/\.\w+$/, '')}`;
      const file = new File([bytes as BlobPart], `${title}.${format}`);
      const key = await fileKey(file);
      const turned = readAs(key, { up: readingOf(mesh)?.up ?? client.up });
      const { came, all, ...own } = drawingOnPart(
        drawing,
        cut,
        new Map(places.map((place, i) => [place, points[i] ?? null])),
      );
      if (client !== this.session.client || drawing !== this.editor.state.drawing) return;
      keepUnit(key, unitOf(mesh));
      const wanted = () => (came > 0 ? own.drawing : null);
      if (!(await this.#open(turned, fileSource(turned, file), wanted))) return;
      // Later edits change only this new entry of the browser's history, not the previous one.
      history.pushState(null, '', location.hash);
      const along = all === 0 ? '' : ` ${came} of ${formatCount(all, 'object')} came along.`;
      showNote(`You work on ${title}.${along} The browser’s Back leads to the whole.`);
      await this.#keep(key, file, true);
    } catch (error) {
      showError(`${name} could not become the surface. ${sentenceOf(error)}`);
    }
  }

  /** Prepares a method; returns false after a failure or a cancellation. */
  async prepare(method: MethodId): Promise<boolean> {
    const client = this.session.client;
    if (!client) return false;
    const controller = new AbortController();
    const progress = showProgress('Preparing', () => controller.abort());
    try {
      await client.mesh.prepare(methodOptions(method), {
        progress: (done, stage) => progress.set(done, stageName(stage)),
        signal: controller.signal,
      });
      return true;
    } catch (error) {
      if (!controller.signal.aborted && !client.closed) showError(sentenceOf(error));
      return false;
    } finally {
      progress.hide();
    }
  }

  async #openLink(link: Link, source: MeshSource): Promise<boolean> {
    const opened = await this.#open(link.mesh, source, wantedOf(link), {
      ...(link.method && { method: link.method }),
    });
    if (opened && link.view) this.#viewer!.showPlace(link.view, { animated: false });
    return opened;
  }

  /** Keeps a link until the user opens its file. */
  #waitFor(mesh: string, link: string): void {
    const name = nameFor('awaited', keyOfFile(mesh));
    this.#awaited.set(name, link);
    remember(name, link);
  }

  #forgetWaiting(mesh: string): void {
    this.#waitFor(mesh, '');
  }

  async #open(
    key: string,
    source: MeshSource,
    wanted: Wanted,
    how: HowOpened = {},
    controller = new AbortController(),
  ): Promise<boolean> {
    this.#running?.abort();
    if (this.#rereading?.controller !== controller) this.#stopRereading();
    this.#running = controller;
    const { signal } = controller;
    const name = meshLabel(key);
    const progress = showProgress(`Opening ${name}`, () => controller.abort());
    let client: EngineClient | null = null;
    try {
      client = await EngineClient.load(source, {
        progress: (done, stage) => progress.set(0.4 * done, stage),
        signal,
      });
      const [drawn, viewer] = await Promise.all([
        drawnGeometry(drawnMesh(client, key), signal),
        this.#viewerReady.promise,
        client.mesh.prepare(methodOptions(how.method ?? this.editor.state.method), {
          progress: (done, stage) => progress.set(0.4 + 0.6 * done, stageName(stage)),
          signal,
        }),
      ]);
      signal.throwIfAborted();
      this.session.use(client);
      const before = viewer.surface;
      const surface = viewer.showSurface(drawn);
      if (key !== this.editor.state.mesh) viewer.resetView({ animated: false });
      if (key !== this.editor.state.mesh) this.#restarts = 0;
      client.onStopped = () => this.#restart(source);
      if (!how.standIn) this.#complaint?.remove();
      const drawing = wanted(surface, before);
      this.#showDrawing(key, drawing, surface.triangles, how);
      return true;
    } catch (error) {
      client?.close();
      if (!signal.aborted) this.#complain(`${name} could not be opened. ${sentenceOf(error)}`);
      return false;
    } finally {
      progress.hide();
      if (this.#running === controller) {
        this.#running = null;
        this.onEnd();
        const restart = this.#restartLater;
        this.#restartLater = null;
        if (this.session.client?.closed) restart?.();
      }
    }
  }

  /** Shows why a surface or link did not open; the message stays until a surface opens. */
  #complain(sentence: string): void {
    this.#complaint?.remove();
    this.#complaint = showError(sentence);
  }

  /** Opens the kept drawing first, so that undo leads back to it. */
  #showDrawing(key: string, wanted: Drawing | null, triangles: number, how: HowOpened): void {
    const kept = parseLink(recallFor('document', key) ?? '')?.drawing ?? emptyDrawing;
    const starting = this.editor.state.mesh === '' && wanted;
    const work = this.#history;
    const history =
      starting && work && sameDrawing(wanted, work.link.drawing) ? work.history : null;
    const drawing = starting || fitting(kept, triangles);
    this.editor.open(key, drawing, { ...how, history });
    if (wanted) this.#drawInstead(wanted);
    // The engine may be new, even if the drawing is not.
    this.session.update(this.editor.state);
  }

  /** Shows another drawing on the present surface; undo restores the previous drawing. */
  #drawInstead(to: Drawing): void {
    const { mesh, method, drawing: from } = this.editor.state;
    if (formatLink(mesh, method, from) === formatLink(mesh, method, to)) return;
    this.editor.draw(to);
  }

  /**
   * Replaces an engine that ended by itself, for example because memory ran out. The drawing stays.
   * After `mostRestarts` restarts, the method only reports the end.
   */
  #restart(source: MeshSource): void {
    if (this.#running) {
      // The surface that is being opened may replace this one.
      this.#restartLater = () => this.#restart(source);
      return;
    }
    if (this.#restarts++ >= mostRestarts) {
      showError(
        'The engine stopped again. Your curve is kept; open the surface again to continue.',
      );
      return;
    }
    showError('The engine stopped and was restarted. Your curve is kept.');
    const { mesh, standIn } = this.editor.state;
    void this.#open(mesh, source, () => null, { standIn });
  }
}

/** A surface to draw, with the upward axis of its key, or the guessed axis if the key has none. */
function drawnMesh(client: EngineClient, key: string): GeometryRequest {
  const { info, arrays } = client;
  return {
    mesh: arrays,
    colors: client.file?.colors ?? null,
    // The page draws triangles in their original orientation, so that the surface has no outside if
    // the engine has turned some triangles over.
    closed: info.boundaryLoops === 0 && info.repairs.every(({ kind }) => kind !== 'turnedOver'),
    up: readingOf(key)?.up ?? client.up,
  };
}

function withResolvers<Value>() {
  let resolve!: (value: Value) => void;
  const promise = new Promise<Value>((resolveIt) => {
    resolve = resolveIt;
  });
  return { promise, resolve };
}

/** The page's name for a stage of the engine's long work. */
const stageName = (stage: string) => (stage === 'graph' ? 'Building the graph' : 'Preparing');
