import { messageOf, polylinesOf } from './editor/compute';
import { CurveEdits } from './editor/curve_edits';
import { Editor } from './editor/editor';
import { Gestures } from './editor/gestures';
import { Measure } from './editor/measure';
import { Session } from './editor/session';
import { exposeState } from './inspection';
import { formatLink, parseLink } from './model/link';
import { isMethod } from './model/methods';
import { onKeeping, recall } from './model/storage';
import { workOffline } from './offline';
import { Opening } from './opening';
import { CheckUpPanel } from './panels/checkup_panel';
import { CurvePanel } from './panels/curve_panel';
import { showDetailsOnDemand } from './panels/details';
import { byId } from './panels/elements';
import { LostPanel } from './panels/lost_panel';
import { sentenceOf, showNote } from './panels/messages';
import { SaveMenu } from './panels/save_menu';
import { Status } from './panels/status';
import { SurfacePanel } from './panels/surface_panel';
import { Tools } from './panels/tools';
import { saveChanges } from './saving';
import { Viewer } from './viewer/viewer';
import { checkedUp } from './worker/checkup';

/** Lets the browser start what was asked for, before work that holds the page up. */
const breathe = () => new Promise((resolve) => setTimeout(resolve));

/**
 * Builds the page from its parts and opens the first surface; rejects where the browser cannot draw
 * it.
 */
export async function start(): Promise<void> {
  const editor = new Editor();
  const method = recall('method');
  if (isMethod(method)) editor.setMethod(method);
  const session = new Session();
  const opening = new Opening(editor, session);
  // The engine loads while the graphics start, which takes as long.
  const first = opening.first();
  await breathe();

  const antialias = new URLSearchParams(location.search).get('antialias') !== 'off';
  const stage = byId('stage');
  const viewer = new Viewer(stage, byId<HTMLCanvasElement>('canvas'), { antialias });
  const edits = new CurveEdits(editor, session);
  const shorten = (index: number) => {
    const shorter = session.view.shorter[index];
    if (shorter) editor.takeShortest(shorter.index);
  };
  const measure = new Measure(session);
  const gestures = new Gestures(editor, session, viewer, stage, byId('handles'), {
    surfaceClicked: (point) => edits.append(point),
    curveClicked: (tool, position, within) =>
      edits.atCurve(tool, viewer.surface!.fromScene(position), within),
    curveMeasured: (position) => measure.at(viewer.surface!.fromScene(position)),
    otherClicked: (tool, index) => edits.atOther(tool, index),
    shorterClicked: (index) => shorten(index),
  });
  const remove = () => gestures.keepFocus(() => edits.removeSelected());
  const lostPanel = new LostPanel(({ position }) => gestures.showPlace(position));
  const status = new Status(editor, {
    remove,
    goToLost: () => lostPanel.goToNext(),
    shorten: () => shorten(0),
  });
  session.onView = (view) => {
    if (view.isolines) viewer.showLines(polylinesOf(view));
    else viewer.showCurve(view.curve);
    viewer.showPolygon(view.legs, view.polygonOnly);
    viewer.showOthers(view.others);
    viewer.showShorter(view.shorter.map(({ polyline }) => polyline));
    viewer.showMarks(view.curve?.marks?.position ?? []);
    gestures.show();
    curvePanel.show(editor.state, view);
    lostPanel.show(view);
    status.show(editor.state, view, session.client?.info ?? null);
  };

  measure.onChange = (measured) => {
    viewer.showTangent(measured);
    gestures.showMeasured(measured?.position ?? null);
    status.showMeasured(measured, editor.state, session.view);
  };
  session.onLegs = (document, dragged, legs) => editor.keepLegs(document, dragged, legs);
  session.onFailure = (error) => showNote(sentenceOf(messageOf(error)));
  session.onBusy = (busy) => status.setBusy(busy);

  const surfacePanel = new SurfacePanel({
    choose: (key) => opening.sample(key),
    openFile: (file) => opening.file(file),
    reread: (key) => opening.reread(key),
  });
  const checkUpPanel = new CheckUpPanel(checkedUp, (places) => viewer.showPlaces(places));
  opening.onEnd = () => {
    if (!session.client) return;
    surfacePanel.show(editor.state.mesh, session.client);
    checkUpPanel.show(session.client);
  };
  const curvePanel = new CurvePanel(editor, edits, {
    async chooseMethod(id) {
      if (await opening.prepare(id)) editor.setMethod(id);
      else curvePanel.show(editor.state, session.view);
    },
  });
  const fragment = () => formatLink(editor.state.mesh, editor.state.method, editor.state.document);
  const saveMenu = new SaveMenu(editor, session, viewer);
  new Tools(editor, viewer, edits, {
    saveJson: () => saveMenu.save('json'),
    removeSelected: remove,
    link: () => ({
      address: `${location.href.split('#')[0]}#${fragment()}`,
      complete: !editor.state.mesh.startsWith('file:'),
    }),
  });

  editor.subscribe((state, before) => {
    const ended = before.dragging && !state.dragging;
    if (state.revision !== before.revision || ended) session.update(state);
    if (state.tool !== 'measure' || state.revision !== before.revision) measure.clear();
    gestures.show();
    curvePanel.show(state, session.view);
    status.showHint(state, session.view);
  });
  curvePanel.show(editor.state, session.view);
  showDetailsOnDemand();
  saveChanges(editor);
  onKeeping((kept) => status.setKept(kept));
  window.addEventListener('hashchange', () => {
    const link = parseLink(location.hash);
    if (link && location.hash.slice(1) !== fragment()) void opening.link(link);
  });
  exposeState(editor, session, viewer);
  opening.show(viewer);
  await first;
  workOffline();
}
