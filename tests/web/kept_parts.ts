/** The page's modules for the tests of keeping: a single import, so that they share their state. */

export { historyOf } from '../../web/model/history';
export { parseLink, pointsOf } from '../../web/model/link';
export { savedWork } from '../../web/model/saved_work';
export { onKeeping, recall, rememberAll, rememberInTab } from '../../web/model/storage';
export { keepDrawing, linkOf } from '../../web/saving';
