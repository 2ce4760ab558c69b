// A drawing of many objects as a value: its commands, its JSON, and its storage in a tab.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { pageModule } from './page_module.mjs';
import { long, randoms, seed } from './part.mjs';
import { fitsDrawing } from './schema.mjs';

const triangles = 5000;
const kinds = ['bspline', 'pen', 'polyline', 'circle', 'ellipse', 'center', 'points'];
const steps = 200;

describe('a drawing', () => {
  let page;
  before(async () => {
    page = await pageModule('./page_parts.ts');
  });

  const json = ({ state }) => JSON.stringify(state.drawing);

  /** The page's own commands by their names; each of them may have no effect. */
  function commandsOf(editor, random) {
    const below = (count) => Math.floor(random() * count);
    const one = (list) => list[below(list.length)];
    const point = () => {
      const [u, v] = [random() / 2, random() / 2];
      return { face: below(triangles), bary: [1 - u - v, u, v] };
    };
    const ids = () => editor.state.drawing.objects.map(({ id }) => id);
    const some = () => ids().filter(() => random() < 0.3);
    const points = () => editor.state.figure.points;
    const isRound = () => ['circle', 'ellipse'].includes(editor.state.figure.kind);
    const tangents = () => {
      const ahead = { direction: [0, 0.6, 0.8], length: random() };
      const behind = one([{ length: null }, { length: random() }, point(), undefined]);
      return { ...(behind && { before: behind }), after: one([ahead, point()]) };
    };
    const placed = () => {
      const isPen = editor.state.figure.kind === 'pen';
      return isPen && random() < 0.7 ? { ...point(), tangents: tangents() } : point();
    };
    const place = () => {
      if (!isRound()) editor.run({ type: 'insert', index: points().length, point: placed() });
      else {
        const { circle: from } = editor.state.figure;
        const to = { center: point(), rim: { radius: 1 + random(), direction: [1, 0, 0] } };
        editor.run({ type: 'circle', from, to });
      }
    };
    const drag = (end) => {
      const index = below(points().length);
      const from = points()[index];
      if (!from || isRound()) return;
      for (let step = 0; step < 3; step++) {
        editor.preview({ type: 'change', index, from, to: { ...from, ...point() } });
      }
      end();
    };
    return {
      place,
      remove: () => {
        const index = below(points().length);
        if (points()[index]) editor.run({ type: 'remove', index, point: points()[index] });
      },
      drag: () => drag(() => editor.commitDrag()),
      cancel: () => drag(() => editor.cancelDrag()),
      weigh: () => {
        const index = below(points().length);
        const from = points()[index];
        if (from)
          editor.run({ type: 'change', index, from, to: { ...from, weight: 1 + random() } });
      },
      kind: () => editor.setKind(one(kinds)),
      settings: () => editor.setSettings({ closed: random() < 0.5, degree: 1 + below(5) }),
      begin: () => editor.begin(random() < 0.5 ? one(kinds) : undefined),
      activate: () => editor.activate(one(ids())),
      choose: () => editor.choose(some()),
      toggle: () => editor.toggle(one(ids())),
      duplicate: () => ids().length < 30 && editor.objects.duplicate(),
      delete: () => editor.objects.delete(some().slice(0, 2)),
      group: () => editor.objects.group(some()),
      ungroup: () => editor.objects.ungroup(some()),
      raise: () => editor.objects.raise(one(ids()), below(9) - 4),
      name: () => editor.objects.setProperties([one(ids())], { name: `curve ${below(99)}` }),
      style: () =>
        editor.objects.setProperties(some(), {
          color: random() < 0.3 ? null : '#0b8457',
          width: 1 + below(9),
          dash: one(['solid', 'dashed', 'dotted']),
          onSurface: random() < 0.3,
          opacity: one([0.05, 0.5, 1]),
          fill: one([0, 0.3, 1]),
          fillColor: random() < 0.5 ? null : '#d9480f',
          ...one([
            { pattern: 'solid', spacing: null },
            { pattern: 'hatched', spacing: 0.01 },
            { pattern: 'striped', spacing: 0.5 },
          ]),
        }),
      turn: () => editor.objects.turnInside(some()),
      show: () => editor.objects.setProperties(some(), { visible: random() < 0.7 }),
      lock: () => editor.objects.setProperties(some(), { locked: random() < 0.2 }),
      clear: () => random() < 0.3 && editor.clear(),
    };
  }

  /** An editor of a drawing of twenty objects. */
  function editorOfMany(random) {
    const editor = new page.Editor();
    editor.open('sphere:5000', page.emptyDrawing);
    // Every other figure has a known inside.
    editor.insideOf = ({ inside, points }) =>
      inside ?? (points.length % 2 === 0 ? (random() < 0.5 ? 'left' : 'right') : null);
    const { place } = commandsOf(editor, random);
    for (let object = 0; object < 20; object++) {
      editor.begin(kinds[object % kinds.length]);
      if (object === 0) editor.setKind(kinds[0]);
      for (let count = 0; count < 4; count++) place();
    }
    assert.equal(editor.state.drawing.objects.length, 20);
    return editor;
  }

  const assertWhole = ({ state: { drawing, figure } }, told) => {
    const { objects, active } = drawing;
    assert.equal(new Set(objects.map(({ id }) => id)).size, objects.length, told);
    assert.ok(objects.find(({ id }) => id === active)?.figure === figure, told);
    const empty = objects.filter((one) => page.isEmpty(one.figure));
    assert.ok(
      empty.every(({ id }) => id === active),
      `only the edited one may be empty: ${told}`,
    );
    assert.ok(
      objects.every(({ figure: one }) => page.knotsFit(one)),
      told,
    );
  };

  const runs = long ? 40 : 4;
  for (let run = 0; run < runs; run++) {
    test(`is the same byte for byte after undo and redo: KARCHER_SEED=${seed}, run ${run}`, () => {
      const numbers = randoms(1000 * seed + run);
      const random = () => numbers.next().value;
      const editor = editorOfMany(random);
      const commands = commandsOf(editor, random);
      const names = Object.keys(commands);
      const done = [];
      const before = editor.history.done.length;
      const states = [json(editor)];
      while (editor.history.done.length < before + steps) {
        const name = names[Math.floor(random() * names.length)];
        done.push(name);
        const count = editor.history.done.length;
        commands[name]();
        assertWhole(editor, done.slice(-5).join(' '));
        if (editor.history.done.length > count) states.push(json(editor));
        else if (editor.history.activated.length === 0) {
          assert.equal(json(editor), states.at(-1), `${name} did something without a step`);
        }
      }
      assert.equal(states.length, steps + 1);
      for (const state of states.toReversed().slice(1)) {
        editor.undo();
        assertWhole(editor, 'undone');
        assert.equal(json(editor), state);
      }
      for (const state of states.slice(1)) {
        editor.redo();
        assert.equal(json(editor), state);
      }
      // At any step a reload finds the drawing and all steps to undo and redo.
      for (let step = 0; step < steps; step += 1 + Math.floor(random() * 60)) {
        for (let back = 0; back < step; back++) editor.undo();
        const { mesh, method, drawing } = editor.state;
        const link = page.formatLink(mesh, method, drawing);
        const work = page.readWork(page.savedWork(link, drawing, editor.history), link);
        const again = new page.Editor();
        again.open(mesh, work.drawing, { history: work.history });
        assert.equal(json(again), json(editor));
        for (const state of states.slice(0, steps - step).reverse()) {
          again.undo();
          assert.equal(json(again), state);
        }
        for (const state of states.slice(1)) {
          again.redo();
          assert.equal(json(again), state);
        }
        for (let forth = 0; forth < step; forth++) editor.redo();
      }
    });
  }

  test('selects without a step: redo stays possible, and the next step includes the selection', () => {
    const numbers = randoms(seed);
    const editor = editorOfMany(() => numbers.next().value);
    const ids = editor.state.drawing.objects.map(({ id }) => id);
    const [first, second] = ids.filter((id) => id !== editor.state.drawing.active);
    editor.objects.setProperties([first], { color: '#123456' });
    const colored = json(editor);
    editor.undo();
    const whole = json(editor);
    const steps = editor.history.done.length;
    editor.activate(second);
    editor.activate(first);
    assert.equal(editor.state.drawing.active, first);
    assert.equal(editor.history.done.length, steps);
    assert.ok(editor.canRedo, 'selecting takes nothing from what can be done again');
    // A reload restores this text.
    const { mesh, method, drawing } = editor.state;
    const link = page.formatLink(mesh, method, drawing);
    const work = page.readWork(page.savedWork(link, drawing, editor.history), link);
    assert.deepEqual(work.history, editor.history);
    const again = new page.Editor();
    again.open(mesh, work.drawing, { history: work.history });
    for (const one of [editor, again]) {
      one.redo();
      assert.equal(json(one), colored);
      one.undo();
      assert.equal(json(one), whole);
      one.activate(first);
      one.objects.setProperties([first], { color: '#654321' });
      assert.equal(one.history.done.length, steps + 1);
      assert.ok(!one.canRedo);
      one.activate(second);
      const selected = json(one);
      one.undo();
      assert.equal(json(one), whole, 'one step back, the selection with it');
      one.redo();
      assert.equal(json(one), selected);
    }
  });

  test('is read from its JSON unchanged, and anything else gives a sentence', () => {
    const numbers = randoms(seed);
    const { drawing } = editorOfMany(() => numbers.next().value).state;
    const text = JSON.stringify(page.savedDrawing(drawing));
    assert.equal(JSON.stringify(page.readDrawing(JSON.parse(text))), JSON.stringify(drawing));
    // The test replaces each value in turn by another one.
    const wrong = [undefined, null, {}, [], 'text', -1, 1e300, true];
    const pathsOf = (value, path = []) =>
      value !== null && typeof value === 'object'
        ? [path, ...Object.entries(value).flatMap(([key, one]) => pathsOf(one, [...path, key]))]
        : [path];
    const whole = JSON.parse(text);
    whole.objects = whole.objects.slice(0, 7);
    whole.active = whole.objects[0].id;
    let refused = 0;
    let refusedBySchema = 0;
    for (const path of pathsOf(whole)) {
      for (const value of wrong) {
        const changed = structuredClone(whole);
        const holder = path.slice(0, -1).reduce((one, key) => one[key], changed);
        if (path.length > 0) holder[path.at(-1)] = value;
        const isTaken = fitsDrawing(JSON.parse(JSON.stringify(changed)));
        refusedBySchema += isTaken ? 0 : 1;
        try {
          const read = page.readDrawing(path.length > 0 ? changed : value);
          // An accepted value is a drawing, which a second reading leaves unchanged.
          const again = JSON.parse(JSON.stringify(page.savedDrawing(read)));
          assert.deepEqual(page.readDrawing(again), read);
          assert.ok(isTaken, `${path.join('.')} of ${JSON.stringify(value)} is read`);
        } catch (error) {
          if (error instanceof assert.AssertionError) throw error;
          assert.ok(!(error instanceof TypeError), `${path.join('.')}: ${error.stack}`);
          assert.ok(error.message.length > 10, error.message);
          // A schema cannot express relations between several values.
          if (path.length > 0 && isTaken) assert.match(error.message, /sum 1|same id|active|knots/);
          refused++;
        }
      }
    }
    assert.ok(refused > 1000 && refusedBySchema > 1000, `${refused}, ${refusedBySchema}`);
    const straight = structuredClone(whole);
    straight.objects[0].figure.points = [{ face: 1, bary: [0.2, 0.3, 0.5], leg: [] }];
    assert.equal(page.readDrawing(straight).objects[0].figure.points[0].leg, undefined);
    const many = { ...whole, objects: Array.from({ length: 2001 }, () => whole.objects[0]) };
    assert.throws(() => page.readDrawing(many), /more than 2000/);
    const long = structuredClone(whole);
    long.objects[0].figure.points = Array.from(
      { length: 10_001 },
      () => long.objects[0].figure.points[0],
    );
    assert.throws(() => page.readDrawing(long), /more than 10000/);
    assert.throws(() => page.readDrawing({ ...whole, version: 2 }), /version 2/);
  });

  test('of another link, or with a history of another drawing, is not restored', () => {
    const numbers = randoms(seed);
    const editor = editorOfMany(() => numbers.next().value);
    const { mesh, method, drawing } = editor.state;
    const link = page.formatLink(mesh, method, drawing);
    const text = page.savedWork(link, drawing, editor.history);
    assert.equal(page.readWork(text, `${link}&x`), null);
    assert.equal(page.readWork(text.slice(0, -1), link), null);
    const work = JSON.parse(text);
    for (const change of [
      () => work.done.pop(),
      () => work.done.push({ type: 'order', from: 0, to: 1 }),
      () => work.undone.push({ type: 'figure', id: 99, edit: {} }),
      () => work.done.splice(0, 1, null),
    ]) {
      const before = structuredClone([work.done, work.undone]);
      change();
      const read = page.readWork(JSON.stringify(work), link);
      const kept = page.historyOf();
      assert.deepEqual(read.history, kept);
      assert.equal(JSON.stringify(read.drawing), JSON.stringify(drawing));
      [work.done, work.undone] = before;
    }
  });

  test('takes copied objects as new ones, on the same surface only', () => {
    const numbers = randoms(seed);
    const editor = editorOfMany(() => numbers.next().value);
    editor.objects.group(editor.state.drawing.objects.slice(0, 3).map(({ id }) => id));
    const { objects } = editor.state.drawing;
    const grouped = objects.filter(({ group }) => group !== null);
    const text = page.copiedText('sphere:5000', grouped);
    editor.objects.add(page.pastedObjects(text, 'sphere:5000', triangles));
    const added = editor.state.drawing.objects.slice(20);
    assert.deepEqual(
      added.map(({ figure }) => figure),
      grouped.map(({ figure }) => figure),
    );
    assert.deepEqual(new Set(added.map(({ group }) => group)), new Set(['Group 2']));
    assert.deepEqual(
      editor.state.chosen,
      added.map(({ id }) => id),
    );
    editor.undo();
    assert.deepEqual(editor.state.drawing.objects, objects);
    assert.equal(page.pastedObjects('words', 'sphere:5000', triangles), null);
    assert.equal(page.pastedObjects('{"a":1}', 'sphere:5000', triangles), null);
    assert.throws(() => page.pastedObjects(text, 'torus:5000', triangles), /another surface/);
    const ofFile = page.copiedText('file:1abc-9:one.obj', grouped);
    assert.ok(page.pastedObjects(ofFile, 'file:1abc-9:other.obj', triangles).length > 0);
    assert.deepEqual(page.pastedObjects(text, 'sphere:5000', 0), [], 'all lies beyond the surface');
  });

  test('has copies with names of their own, of an allowed length, even in a link', () => {
    const numbers = randoms(seed);
    const editor = editorOfMany(() => numbers.next().value);
    const { id } = editor.state.drawing.objects[0];
    const long = `${'x'.repeat(196)}😀 7`;
    for (const [name, next] of [
      ['Seam', 'Seam 2'],
      ['', ''],
      [long, `${'x'.repeat(196)}😀 2`],
    ]) {
      editor.objects.setProperties([id], { name });
      editor.choose([id]);
      for (let copy = 0; copy < 40; copy++) editor.objects.duplicate();
      const names = editor.state.drawing.objects.slice(-40).map((object) => object.name);
      assert.equal(names[0], next);
      assert.equal(new Set(names).size, name ? 40 : 1);
    }
    const { mesh, method, drawing } = editor.state;
    const saved = JSON.parse(JSON.stringify(page.savedDrawing(drawing)));
    assert.deepEqual(page.readDrawing(saved), drawing);
    const { objects } = page.parseLink(page.formatLink(mesh, method, drawing)).drawing;
    assert.deepEqual(
      objects.map(({ name }) => name).sort(),
      drawing.objects.map(({ name }) => name).sort(),
    );
    // The length limit of a text field can leave half a character, which a link cannot store.
    editor.objects.setProperties([id], { name: 'half \ud83d' });
    const told = page.formatLink(mesh, method, editor.state.drawing);
    assert.ok(page.parseLink(told).drawing.objects.some(({ name }) => name === 'half '));
  });

  test('is equal to one with another order of fields', () => {
    const numbers = randoms(seed);
    const { drawing } = editorOfMany(() => numbers.next().value).state;
    const point = { ...drawing.objects[0].figure.points[0], leg: [{ face: 3, bary: [1, 0, 0] }] };
    const first = (changed) => ({
      ...drawing,
      objects: drawing.objects.with(0, {
        ...drawing.objects[0],
        figure: {
          ...drawing.objects[0].figure,
          points: drawing.objects[0].figure.points.with(0, changed),
        },
      }),
    });
    const legFirst = first({ ...point, weight: 2 });
    const legLast = first({ weight: 2, ...point });
    assert.ok(page.sameDrawing(legFirst, legLast));
    assert.ok(!page.sameDrawing(legFirst, first({ ...point, weight: 3 })));
    // A drawing that lies on its surface as a whole stays the same, to the last byte.
    for (const whole of [legFirst, legLast]) {
      assert.equal(JSON.stringify(page.fitting(whole, triangles)), JSON.stringify(whole));
    }
  });

  test('keeps locked objects, and says so', () => {
    const numbers = randoms(seed);
    const editor = editorOfMany(() => numbers.next().value);
    const said = [];
    editor.onRefusal = (sentence) => said.push(sentence);
    const { id } = editor.state.drawing.objects[1];
    editor.activate(id);
    editor.objects.setProperties([id], { locked: true });
    const before = json(editor);
    const [point] = editor.state.figure.points;
    editor.run({ type: 'remove', index: 0, point });
    editor.preview({ type: 'change', index: 0, from: point, to: { ...point, face: 1 } });
    editor.clear();
    editor.objects.delete([id]);
    assert.equal(json(editor), before);
    assert.equal(said.length, 4);
    assert.ok(said.every((sentence) => /locked/.test(sentence)));
    editor.objects.setProperties([id], { locked: false });
    editor.clear();
    assert.notEqual(json(editor), before);
  });

  test('moves the only member of a group past another group', () => {
    const { activeObject, apply, emptyDrawing, newObject, reordering } = page;
    const { figure } = activeObject(emptyDrawing);
    const drawingOf = (...groups) => ({
      objects: groups.map((group, i) => ({ ...newObject(i + 1, figure), group })),
      active: 1,
    });
    const idsAfter = (drawing, id, steps) =>
      apply(drawing, reordering(drawing, id, steps)).objects.map((one) => one.id);
    assert.deepEqual(idsAfter(drawingOf('A', 'B', 'B', null), 1, 1), [2, 3, 1, 4]);
    assert.deepEqual(idsAfter(drawingOf(null, 'B', 'B', 'A'), 4, -1), [1, 4, 2, 3]);
  });

  test(`keeps the members of a group together in every order, KARCHER_SEED=${seed}`, () => {
    const { activeObject, apply, arranging, emptyDrawing, newObject, reordering } = page;
    const { figure } = activeObject(emptyDrawing);
    const random = randoms(seed);
    const below = (count) => Math.floor(random.next().value * count);
    /** The number of changes of group from object to object, without those outside groups. */
    const runs = ({ objects }) =>
      objects.filter(({ group }, i) => group !== null && group !== objects[i - 1]?.group).length;
    let moves = 0;
    for (let round = 0; round < (long ? 2000 : 100); round++) {
      const names = ['A', null, 'B', null, 'B', 'C'];
      const objects = names.flatMap((group) =>
        Array.from({ length: below(4) }, () => ({ ...newObject(0, figure), group })),
      );
      let drawing = {
        objects: objects.map((object, i) => ({ ...object, id: i + 1 })),
        active: 1,
      };
      if (objects.length < 2) continue;
      const before = runs(drawing);
      for (let step = 0; step < 20; step++) {
        const { id } = drawing.objects[below(objects.length)];
        const command = reordering(drawing, id, below(2 * objects.length) - objects.length);
        if (command) drawing = apply(drawing, command);
        assert.ok(runs(drawing) <= before, drawing.objects.map(({ group }) => group).join());
      }
      // The user drags rows, some of them folded, to the places of others.
      for (let step = 0; step < 20; step++) {
        const isFolded = new Set(['A', 'B', 'C'].filter(() => below(2) === 0));
        const rowsNow = () => page.rowsOf(drawing.objects.toReversed(), isFolded);
        const from = below(rowsNow().length);
        // The user drags a folded group. A group that an older drawing has in several places stays
        // in place.
        const { group: carried } = rowsNow()[from];
        if (rowsNow().filter(({ group }) => carried && group === carried).length === 1) {
          isFolded.add(carried);
        }
        const rows = rowsNow();
        const { ids, moved, group } = page.rowsAfter(rows, from, below(rows.length));
        const wanted = arranging(drawing, ids.toReversed(), { id: moved, group });
        const count = runs(drawing);
        if (wanted) drawing = apply(drawing, wanted);
        moves += wanted ? 1 : 0;
        assert.deepEqual(
          drawing.objects.map(({ id }) => id),
          ids.toReversed(),
        );
        assert.deepEqual(
          drawing.objects.map(({ id }) => id).toSorted((a, b) => a - b),
          objects.map((_, i) => i + 1),
        );
        assert.ok(runs(drawing) <= count, drawing.objects.map((one) => one.group).join());
      }
    }
    assert.ok(moves > 100);
  });
});
