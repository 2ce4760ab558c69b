/** What the tests take of the page's parts: of one import, so that they are the same ones. */
export { CurveEdits } from '../../web/editor/curve_edits';
export { Editor } from '../../web/editor/editor';
export { Session } from '../../web/editor/session';
export { emptyDocument, isSpline, pointsNeeded } from '../../web/model/document';
export { formatLink, parseLink } from '../../web/model/link';
export { methodOptions } from '../../web/model/methods';
export { activated, curveOptions, splineOf } from '../../web/model/splines';
export { EngineClient } from '../../web/worker/client';
