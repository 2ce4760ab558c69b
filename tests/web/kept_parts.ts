/** What the tests of keeping take of the page's parts: of one import, so that they are the same ones. */

export { historyOf } from '../../web/model/history';
export { parseLink, pointsOf } from '../../web/model/link';
export { savedWork } from '../../web/model/saved_work';
export { onKeeping, recall, rememberAll, rememberInTab } from '../../web/model/storage';
export { keepDrawing, linkOf } from '../../web/saving';
