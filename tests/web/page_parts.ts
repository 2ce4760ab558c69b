/** The page's modules for the tests: a single import, so that they share their state. */

export { Bend } from '../../web/editor/engine/bend';
export { curveValueOf } from '../../web/editor/engine/compute';
export { CurveEdits } from '../../web/editor/engine/curve_edits';
export { Expansion } from '../../web/editor/engine/expansion';
export { mirroredDerived, mirroredFigures, mirrorLine } from '../../web/editor/engine/mirroring';
export { Move } from '../../web/editor/engine/moving';
export { Session } from '../../web/editor/engine/session';
export { PenGestures } from '../../web/editor/hand/pen_gestures';
export { Editor } from '../../web/editor/state/editor';
export { arranging, reordering } from '../../web/model/arranging';
export { apply, applyToFigure, fitted, invert } from '../../web/model/commands';
export { copiedText, pastedObjects } from '../../web/model/copied';
export { cornersOf, cubicAt, fittedCubics } from '../../web/model/cubic_fit';
export { activeObject, emptyDrawing, newObject, othersOf } from '../../web/model/drawing';
export { isEmpty, isSpline, knotsFit, pointsNeeded } from '../../web/model/figure';
export { fitting } from '../../web/model/fitting';
export { gapBetween } from '../../web/model/gap';
export { historyOf } from '../../web/model/history';
export { formatLink, parseLink } from '../../web/model/link';
export { blobsOf } from '../../web/model/mesh_blobs';
export { methodOptions } from '../../web/model/methods';
export {
  asJoint,
  controlPointsOf,
  jointOf,
  penOptions,
  withHandleAt,
} from '../../web/model/pen';
export { penActionAt, penWords } from '../../web/model/pen_hints';
export { readDrawing, savedDrawing } from '../../web/model/saved_drawing';
export { readWork, sameDrawing, savedWork } from '../../web/model/saved_work';
export { curveOptions, splineOf } from '../../web/model/splines';
export { anchorsOf, rolledOut } from '../../web/model/stroke';
export { rowsAfter, rowsOf } from '../../web/panels/object_tree';
export { EngineClient } from '../../web/worker/client';
