/** What the tests take of the page's parts: of one import, so that they are the same ones. */
export { curveOptions } from '../../web/editor/compute';
export { CurveEdits } from '../../web/editor/curve_edits';
export { emptyDocument, isSpline, pointsNeeded } from '../../web/editor/document';
export { Editor } from '../../web/editor/editor';
export { formatLink, parseLink } from '../../web/editor/link';
export { methodOptions } from '../../web/editor/methods';
export { Session } from '../../web/editor/session';
export { activated, splineOf } from '../../web/editor/splines';
export { EngineClient } from '../../web/worker/client';
