// Objects with more sources than anyone combines one by one.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, figure, load } from './figures.mjs';
import { pageModule } from './page_module.mjs';
import { fitsDrawing } from './schema.mjs';

test('a union of 201 circles is read again from a file and from a link', async () => {
  const page = await pageModule('./page_parts.ts');
  const { combining } = await load('model/combining.ts');
  const ids = Array.from({ length: 201 }, (_, i) => i + 1);
  const objects = ids.map((id) => page.newObject(id, { ...figure, kind: 'circle', circle }));
  const drawing = page.apply(
    { objects, active: 1 },
    combining({ objects, active: 1 }, ids, 'union'),
  );
  const saved = JSON.parse(JSON.stringify(page.savedDrawing(drawing)));
  assert.ok(fitsDrawing(saved), JSON.stringify(fitsDrawing.errors));
  const read = page.readDrawing(saved).objects.at(-1);
  assert.deepEqual(read.figure.derived.sources, ids);
  const text = page.formatLink('sphere:500', 'karcher-fast', drawing);
  const linked = page.parseLink(text);
  const union = linked.drawing.objects.find((one) => one.figure.kind === 'union');
  assert.equal(union.figure.derived.sources.length, ids.length);
});
