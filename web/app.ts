import type { SurfacePoint } from 'karcher';
import { Vector3 } from 'three';
import { type Alignment, align } from './editor/engine/aligning';
import type { Beside } from './editor/engine/beside';
import { Comparison } from './editor/engine/comparison';
import { messageOf, polylinesOf } from './editor/engine/compute';
import { CurveEdits } from './editor/engine/curve_edits';
import type { ShownCut } from './editor/engine/cut';
import { Distances } from './editor/engine/distances';
import { Expansion } from './editor/engine/expansion';
import { Measure } from './editor/engine/measure';
import { Session } from './editor/engine/session';
import { Gestures } from './editor/hand/gestures';
import { MirrorTool } from './editor/hand/mirror_tool';
import { Ruler } from './editor/hand/ruler';
import { Editor } from './editor/state/editor';
import type { State } from './editor/state/state';
import { exposeState } from './inspection';
import { type DrawnObject, styleOf } from './model/drawing';
import { isEmpty } from './model/figure';
import { formatLink } from './model/link';
import { meshLabel } from './model/meshes';
import { isMethod, type MethodId } from './model/methods';
import { placesOf } from './model/moving';
import { withSources } from './model/sources';
import { onKeeping, recall, recallInTab, remember, rememberInTab } from './model/storage';
import { workOffline } from './offline';
import { Opening } from './opening';
import { CheckUpPanel } from './panels/checkup_panel';
import { Clipboard } from './panels/clipboard';
import { CombLegend } from './panels/comb_legend';
import { ComparisonPanel, comparedColor } from './panels/comparison_panel';
import { ContextMenu } from './panels/context_menu';
import { CurvePanel } from './panels/curve_panel';
import { CutPanel, partColor } from './panels/cut_panel';
import { DerivedPanel } from './panels/derived_panel';
import { DistanceLegend } from './panels/distance_legend';
import { byId } from './panels/elements';
import { ExamplesMenu } from './panels/examples_menu';
import { FreehandSettings } from './panels/freehand_settings';
import { LostPanel } from './panels/lost_panel';
import { sentenceOf, showError, showNote } from './panels/messages';
import { ObjectPanel } from './panels/object_panel';
import { nameOf } from './panels/object_rows';
import { SaveMenu } from './panels/save_menu';
import { Sheet } from './panels/sheet';
import { SnapToggle } from './panels/snap_toggle';
import { Status } from './panels/status';
import { partActions, SurfacePanel } from './panels/surface_panel';
import { drawingTools, ToolRail } from './panels/tool_list';
import { Tools } from './panels/tools';
import { Tour } from './panels/tour';
import { TransformPanel } from './panels/transform_panel';
import { UnitChoice } from './panels/unit_choice';
import { ViewMenu } from './panels/view_menu';
import { longestLink, saveChanges } from './saving';
import { CombLayer } from './viewer/comb_layer';
import { DistanceLayer } from './viewer/distance_layer';
import { dotAt, type ObjectDrawing } from './viewer/object_lines';
import { holds } from './viewer/regions';
import type { Surface } from './viewer/surface';
import { Viewer } from './viewer/viewer';
import { checkedUp } from './worker/checkup';

/** Lets the browser send its requests before work that blocks the page. */
const breathe = () => new Promise((resolve) => setTimeout(resolve));

/** The drawing, in the scene, of an object in its drawn form. */
function drawingOf(
  { id, style, locked, lines, points, center }: Omit<Beside, 'region' | 'cut'>,
  viewer: Viewer,
): ObjectDrawing {
  const surface = viewer.surface!;
  const single = center ? [...points, center] : points;
  return {
    ...{ id, style, locked },
    lines: lines.map((line) => surface.toScene(line)),
    dots: single.map((point) => dotAt(surface.position(point))),
  };
}

const drawings = new WeakMap<Surface, WeakMap<Beside, ObjectDrawing>>();

/** The drawing of an object, the same as before if the object has not changed. */
function drawingBeside(one: Beside, viewer: Viewer): ObjectDrawing {
  const surface = viewer.surface!;
  const known = drawings.get(surface) ?? new WeakMap<Beside, ObjectDrawing>();
  const drawing = known.get(one) ?? drawingOf(one, viewer);
  drawings.set(surface, known.set(one, drawing));
  return drawing;
}

/** The dots of the edited object, if it consists of single points; other kinds have lines. */
function ownDots({ active }: Editor, viewer: Viewer): ObjectDrawing[] {
  const { id, visible, locked, figure } = active;
  if (figure.kind !== 'points' || !visible || !viewer.surface) return [];
  const drawn = { id, style: styleOf(active), locked, lines: [], points: figure.points };
  return [drawingOf({ ...drawn, center: null }, viewer)];
}

/** The edited curve as the comparison's method traces it. The user cannot pick this line. */
function comparedDrawing(
  { active, state }: Editor,
  { shown }: Comparison,
  { surface }: Viewer,
): ObjectDrawing[] {
  if (!shown?.polyline || !surface || !active.visible) return [];
  const style = {
    ...styleOf(active),
    color: comparedColor(active.color),
    dash: active.dash === 'dashed' ? 'dotted' : 'dashed',
  } as const;
  const lines = [surface.toScene(shown.polyline)];
  return [{ id: -state.drawing.active - 1, style, locked: true, lines, dots: [] }];
}

/** Shows a selection: halos of several objects, or the handles of a single one. */
function showChosen(viewer: Viewer, { drawing, chosen }: State): void {
  const others = chosen.filter((id) => id !== drawing.active);
  viewer.showChosen(others, others.length > 0 && chosen.includes(drawing.active));
}

/**
 * Builds the page from its parts and opens the first surface. Rejects if the browser cannot draw
 * the surface.
 */
export async function start(): Promise<void> {
  const editor = new Editor();
  const method = recall('method');
  if (isMethod(method)) editor.setMethod(method);
  const session = new Session();
  const opening = new Opening(editor, session);
  // Without a link, the page restores the tool of the last visit; a link opens ready for drawing.
  const usualTool = location.hash === '' ? recall('tool') : null;
  // The engine loads while the graphics start; both take about equally long.
  const first = opening.first();
  await breathe();

  const antialias = new URLSearchParams(location.search).get('antialias') !== 'off';
  const stage = byId('stage');
  const viewer = new Viewer(stage, byId<HTMLCanvasElement>('canvas'), { antialias });
  const edits = new CurveEdits(editor, session);
  const shorten = (index: number) => {
    const shorter = session.view.shorter[index];
    if (shorter) edits.takeShortest(shorter.index);
  };
  const measure = new Measure(session);
  const distances = new Distances(editor, session);
  const distanceLegend = new DistanceLegend(() => distances.off());
  const distanceLayer = new DistanceLayer();
  const combLayer = new CombLayer();
  for (const layer of [distanceLayer, combLayer]) viewer.addLayer(layer);
  const comb = new CombLegend(viewer, combLayer, () => ({
    state: editor.state,
    view: session.view,
    meanEdge: session.client?.info.meanEdge ?? 0,
  }));
  const ruler = new Ruler(editor, session, viewer);
  const mirror = new MirrorTool(editor, session, viewer, showNote);
  const gestures = new Gestures(editor, session, viewer, stage, byId('handles'), {
    surfaceClicked: (point) => edits.append(point),
    curveClicked: (tool, position, within) =>
      edits.atCurve(tool, viewer.surface!.fromScene(position), within),
    curveMeasured: (position) => measure.at(viewer.surface!.fromScene(position)),
    rulerAimed: (point) => ruler.aim(point),
    rulerClicked: (point) => {
      measure.clear();
      ruler.click(point);
    },
    closed: () => edits.close(),
    anchorRemoved: (index) => edits.removeAnchor(index),
    aimed: (words) => status.showAim(words, editor.state, session.view),
    otherClicked: (tool, id) => edits.atOther(tool, id),
    shorterClicked: (index) => shorten(index),
    mirrorAimed: (point) => mirror.aim(point),
    mirrorClicked: (point) => void mirror.click(point),
    stopped: showNote,
    sized: (size) => transformPanel.showSize(size),
  });
  editor.onInterrupt = () => gestures.letGo();
  const remove = () => {
    if (editor.state.selection === null) editor.objects.delete();
    else void gestures.keepFocus(() => edits.removeSelected());
  };
  const lostPanel = new LostPanel(({ position }) => gestures.showPlace(position));
  const status = new Status(editor, {
    remove,
    goToLost: () => lostPanel.goToNext(),
    shorten: () => shorten(0),
    stop: () => session.stop(),
  });
  /** The painted regions, in the drawing's order. */
  const showRegions = () => {
    const painted = session.painted(editor.state).map(({ object, region, pattern }) => {
      const { id, color, locked } = object;
      return { id, region, pattern, style: object, color, locked };
    });
    viewer.showRegions(painted);
  };
  let cutShown: { cut: ShownCut | null; surface: Surface | null; colored: boolean } | null = null;
  /**
   * Shows the parts of the topmost visible cut, in colors while it is edited. During an edit of one
   * of its sources, the whole surface is visible.
   */
  const showCut = () => {
    const { drawing, none } = editor.state;
    const { cut: own, others } = session.view;
    const cuts = drawing.objects.map(({ id, visible }) => {
      const isOwn = id === drawing.active;
      const cut = isOwn ? own : others.find((other) => other.id === id)?.cut;
      const isOpen = !none && !isOwn && withSources(drawing, [id]).includes(drawing.active);
      return { cut: visible && !isOpen ? (cut ?? null) : null, colored: isOwn && !none };
    });
    const { cut, colored } = cuts.findLast((one) => one.cut) ?? { cut: null, colored: false };
    const { surface } = viewer;
    const before = cutShown;
    if (before?.cut === cut && before.surface === surface && before.colored === colored) return;
    cutShown = { cut, surface, colored };
    const parts = cut?.parts.flatMap((part, i) =>
      part.state === 'kept' ? [{ part, color: colored ? partColor(i) : null }] : [],
    );
    viewer.showParts(parts ?? null);
  };
  let besideShown: readonly Beside[] = [];
  let ownShown = editor.active;
  let surfaceShown: Surface | null = null;
  const comparison = new Comparison(session);
  const comparisonPanel = new ComparisonPanel(editor, comparison);
  const showBeside = () => {
    const compared = comparedDrawing(editor, comparison, viewer);
    const beside = besideShown.map((one) => drawingBeside(one, viewer));
    ownShown = editor.active;
    viewer.showObjects([...beside, ...ownDots(editor, viewer), ...compared]);
  };
  const showCompared = () => {
    comparisonPanel.show(editor.state, comparison.method, comparison.shown);
  };
  comparison.onChange = () => {
    showBeside();
    showCompared();
  };
  session.onView = (view) => {
    viewer.showStyle(editor.active);
    if (view.isolines) viewer.showLines(polylinesOf(view));
    else viewer.showCurve(view.curve);
    // Without a selection, no control polygon is visible.
    viewer.aids.showPolygon(editor.state.none ? [] : view.legs, view.polygonOnly);
    distances.update();
    if (viewer.surface !== surfaceShown && distances.shown) distances.onChange(distances.shown);
    const isNew = view.others !== besideShown || viewer.surface !== surfaceShown;
    const isPoints = (object: DrawnObject) => object.figure.kind === 'points';
    const isOwnNew = editor.active !== ownShown && [editor.active, ownShown].some(isPoints);
    // The style of the compared curve may have changed.
    if (isNew || isOwnNew || (comparison.shown && !editor.state.dragging)) {
      [besideShown, surfaceShown] = [view.others, viewer.surface];
      showBeside();
    }
    showRegions();
    showCut();
    cutPanel.show(editor.state, view);
    comparison.update(editor.state, view);
    viewer.aids.showShorter(view.shorter.map(({ polyline }) => polyline));
    viewer.aids.showMarks(view.curve?.marks?.position ?? []);
    comb.show();
    gestures.show();
    curvePanel.show(editor.state, view);
    rail.show(editor.state, view);
    lostPanel.show(view);
    status.show(editor.state, view, session.client?.info ?? null);
  };

  distances.onProblem = showNote;
  distances.onChange = (shown) => {
    distanceLayer.show(viewer.surface, shown?.traced ?? null, shown?.from ?? null);
    viewer.requestFrame();
    distanceLegend.show(shown, distances.on, editor.state);
  };
  measure.onChange = (measured) => {
    viewer.aids.showTangent(measured);
    gestures.showMeasured(measured?.position ?? null);
    status.showMeasured(measured, editor.state, session.view);
  };
  ruler.onChange = (ruled, begun) => status.showRuled(ruled, begun, editor.state, session.view);
  const objectPanel = new ObjectPanel(
    editor,
    () => void edits.afterwards(() => editor.begin()),
    ({ figure }) => {
      const { surface } = viewer;
      const [place] = placesOf(figure);
      // Derived objects have no places of their own, so the scene's middle stands for them.
      return surface ? viewer.reach(place ? surface.position(place) : new Vector3(), 1) : 1;
    },
    (id) => session.centroidOf(id),
  );
  const expansion = new Expansion(editor, session, () => viewer.surface, nameOf);
  const derivedPanel = new DerivedPanel(
    editor,
    expansion,
    () => session.client?.info.diagonal ?? 1,
  );
  const cutPanel = new CutPanel(
    editor,
    async (part, format, withCurves) => {
      const curves = withCurves ? await saveMenu.drawnCurves(session.view.cut) : [];
      return session.client!.partFile(part, format, curves);
    },
    () => meshLabel(editor.state.mesh),
    (part, name) => void opening.part(part, name, editor.state.drawing.active),
  );
  const units = new UnitChoice((unit) => {
    status.showUnit(unit, editor.state, session.view);
    derivedPanel.showUnit(unit);
    cutPanel.showUnit(unit);
    objectPanel.showUnit(unit);
    transformPanel.showUnit(unit);
  });
  editor.onEnded = (figure) => session.ended(figure);
  editor.insideOf = (figure) => session.insideOf(figure);
  editor.onRefusal = showNote;
  editor.begun.onRemoval = () =>
    showNote('The curve had too few points and was removed. Undo brings it back.');
  session.onFailure = (error) => showNote(sentenceOf(messageOf(error)));
  session.onBusy = (busy) => status.setBusy(busy);
  session.onProgress = (done, stage) => status.setProgress(done, stage);

  const surfacePanel = new SurfacePanel({
    choose: (key) => opening.sample(key),
    openFiles: (files) => void opening.files(files),
    reread: (part) => void opening.reread(part),
  });
  const checkUpPanel = new CheckUpPanel(
    checkedUp,
    (places) => viewer.aids.showPlaces(places),
    (weld) => void opening.reread({ weld }),
  );
  opening.onEnd = () => {
    if (!session.client) return;
    surfacePanel.show(editor.state.mesh, session.client);
    units.show(editor.state.mesh);
    checkUpPanel.show(session.client);
  };
  let chosen: MethodId | null = null;
  const curvePanel = new CurvePanel(editor, edits, {
    setJoint: (joint) => gestures.setJoint(joint),
    async chooseMethod(id) {
      chosen = id;
      const isReady = await opening.prepare(id);
      // The user may have chosen another method during a slow preparation.
      if (isReady && chosen === id) editor.setMethod(id);
      else curvePanel.show(editor.state, session.view);
    },
  });
  const saveMenu = new SaveMenu(editor, session, viewer, () => opening.fileOf(editor.state.mesh));
  const rail = new ToolRail(drawingTools(editor, edits));
  const toolEvents = {
    saveJson: () => saveMenu.save('json'),
    toggleSnapping: () => snap.toggle(),
    toggleDistances: () => distances.toggle(),
    toggleComb: () => comb.toggle(),
    removeSelected: remove,
    link() {
      const { mesh, method, drawing } = editor.state;
      const link = formatLink(mesh, method, drawing, viewer.place);
      return {
        address: `${location.href.split('#')[0]}#${link}`,
        complete: !mesh.startsWith('file:'),
        short: link.length <= longestLink,
      };
    },
  };
  new Tools(
    editor,
    viewer,
    edits,
    toolEvents,
    rail,
    new ViewMenu(viewer, { distances: toolEvents.toggleDistances, comb: toolEvents.toggleComb }),
  );
  new ExamplesMenu((example) => void opening.example(example));
  const clipboard = new Clipboard(editor, () => session.client?.info.triangles ?? 0);
  const letGo = () => gestures.letGo();
  const alignChosen = (how: Alignment) => {
    align(editor, session, viewer.surface!, how).catch((error) =>
      showNote(`It is not aligned. ${sentenceOf(messageOf(error))}`),
    );
  };
  const makers = () => derivedPanel.possible;
  const isFilledAt = (id: number, point: SurfacePoint) =>
    session
      .painted(editor.state)
      .some(({ object, region }) => object.id === id && holds(region, point));
  const ofSurface = (point: SurfacePoint | null) => [
    ...cutPanel.actionsAt(point),
    ...partActions(editor.state.mesh, session.client?.file ?? null, point?.face ?? null, (part) => {
      void opening.reread(part);
    }),
  ];
  new ContextMenu(
    editor,
    viewer,
    stage,
    letGo,
    clipboard,
    alignChosen,
    makers,
    ofSurface,
    isFilledAt,
  );
  const snap = new SnapToggle((on) => {
    gestures.snapping.on = on;
  });
  const freehand = new FreehandSettings((tolerance) => {
    gestures.freehand.tolerance = tolerance;
  });
  const transformPanel = new TransformPanel(editor, (numbers) => gestures.place(numbers), mirror);
  mirror.onChange = () => {
    transformPanel.showMirror(mirror);
    status.showMirroring(mirror.hint, editor.state, session.view);
  };

  editor.subscribe((state, before) => {
    const ended = before.dragging && !state.dragging;
    if (state.revision !== before.revision || ended) session.update(state);
    if (state.none !== before.none)
      viewer.aids.showPolygon(state.none ? [] : session.view.legs, session.view.polygonOnly);
    if (state.tool !== before.tool) {
      rememberInTab('tool', state.tool);
      remember('tool', state.tool);
    }
    if (state.tool !== 'measure' || state.revision !== before.revision) measure.clear();
    distances.update();
    gestures.show();
    curvePanel.show(state, session.view);
    showCompared();
    rail.show(state, session.view);
    objectPanel.show(state);
    freehand.show(state);
    transformPanel.show(state);
    derivedPanel.show(state);
    cutPanel.show(state, session.view);
    showCut();
    // The numbers in the status describe the selection.
    if (state.none === before.none) status.showHint(state, session.view);
    else status.show(state, session.view, session.client?.info ?? null);
    showChosen(viewer, state);
  });
  curvePanel.show(editor.state, session.view);
  showCompared();
  rail.show(editor.state, session.view);
  objectPanel.show(editor.state);
  transformPanel.show(editor.state);
  derivedPanel.show(editor.state);
  const sheet = new Sheet();
  const tour = new Tour(
    () => sheet.show(),
    () => editor.state.drawing.objects.some(({ figure }) => !isEmpty(figure)),
  );
  // An example's surface appears before its drawing. The tour waits until both are there.
  editor.subscribe(() => queueMicrotask(() => tour.update()));
  const viewChanged = saveChanges(
    editor,
    () => viewer.place,
    () =>
      showError(
        'This browser has no room for this drawing: a reload would lose it. Save it as a JSON file.',
      ),
    (found) => opening.link(found),
  );
  viewer.onFrame(viewChanged);
  onKeeping((kept) => status.setKept(kept));
  exposeState(editor, session, viewer, distances);
  opening.show(viewer);
  if (await first) tour.greet();
  else if ((recallInTab('tool') ?? usualTool) === 'select') editor.setTool('select');
  workOffline();
}
