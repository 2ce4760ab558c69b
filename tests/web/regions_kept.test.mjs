// The rule of a region and the origins of pieces are kept in links, files and copies.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { pageModule } from './page_module.mjs';

describe('regions in links and files', () => {
  let model;
  before(async () => {
    const [link, saved, drawing, copied] = await Promise.all(
      ['link', 'saved_drawing', 'drawing', 'copied'].map((name) =>
        pageModule(`../../web/model/${name}.ts`),
      ),
    );
    model = { ...link, ...saved, ...drawing, ...copied };
  });
  const point = (face, origin) => ({ face, bary: [0.25, 0.25, 0.5], ...(origin && { origin }) });

  test('the rule and the origins of pieces come back as they were', () => {
    const points = [
      point(3, { of: 'Heart; of, 7 % “x:y”', from: 0.25, to: 1 }),
      point(5),
      point(8, { of: 'Ring', from: 0.75, to: 0.125 }),
      point(9, { of: 'Heart; of, 7 % “x:y”', from: 0, to: 0.25 }),
    ];
    const { emptyFigure: _, ...rest } = model.emptyDrawing.objects[0];
    const figure = { ...rest.figure, kind: 'pen', points, rule: 'nonZero' };
    const drawing = { objects: [{ ...rest, fill: 0.5, figure }], active: 1 };
    const again = model.parseLink(model.formatLink('sphere:500', 'karcher', drawing));
    assert.deepEqual(again.problems, []);
    assert.deepEqual(again.drawing, drawing);
    const saved = JSON.parse(JSON.stringify(model.savedDrawing(drawing)));
    assert.deepEqual(model.readDrawing(saved), drawing);
    const text = model.copiedText('sphere:500', drawing.objects);
    assert.deepEqual(model.pastedObjects(text, 'sphere:500', 500), drawing.objects);
  });

  test('faulty rules and origins are refused in files and left out of links', () => {
    const [object] = model.emptyDrawing.objects;
    const drawn = (more, of) => {
      const figure = { ...object.figure, points: [point(3, of)], ...more };
      return JSON.parse(
        JSON.stringify({
          ...model.savedDrawing(model.emptyDrawing),
          objects: [{ ...object, figure }],
        }),
      );
    };
    assert.throws(() => model.readDrawing(drawn({ rule: 'odd' })), /the rule by which/);
    const origin = { of: 'Heart', from: 0, to: 2 };
    assert.throws(() => model.readDrawing(drawn({}, origin)), /the end of the origin of point 1/);
    const link =
      'mesh=sphere:500&kind=pen&points=3,0.25,0.5;4,0.25,0.5&origins=Heart;0,0,0,2;1,5,0,1;x';
    const { drawing } = model.parseLink(link);
    assert.ok(drawing.objects[0].figure.points.every((one) => one.origin === undefined));
  });
});
