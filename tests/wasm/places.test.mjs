// The table of vertices by their places, which readers of files and `karcher/three` share.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Places } from '../../dist/places.js';

test('equal places have one number, in the order of their first occurrence', () => {
  const places = new Places();
  const given = [
    [1, 2, 3],
    [0, 0, 0],
    [1, 2, 3],
    [-0, 0, -0],
    [3, 2, 1],
  ];
  assert.deepEqual(
    given.map((place) => places.number(...place)),
    [0, 1, 0, 1, 2],
  );
  assert.deepEqual(Array.from(places.positions), [1, 2, 3, 0, 0, 0, 3, 2, 1]);
  assert.equal(places.find(3, 2, 1), 2);
  assert.equal(places.find(3, 2, 0), -1);
  assert.equal(places.count, 3, 'a search adds no place');
});

test('repeated places without a coordinate have one number', () => {
  const places = new Places();
  const { NaN: none } = Number;
  for (let k = 0; k < 100; k++) {
    assert.equal(places.number(none, none, none), 0);
    assert.equal(places.number(1, none, 2), 1);
  }
  assert.equal(places.count, 2);
});

test('numbers stay the same while the table grows', () => {
  const places = new Places();
  const count = 100_000;
  const placeOf = (k) => [k % 100, Math.floor(k / 100), k / 7];
  for (let k = 0; k < count; k++) assert.equal(places.number(...placeOf(k)), k);
  for (let k = 0; k < count; k++) assert.equal(places.find(...placeOf(k)), k);
  const { positions } = places;
  assert.deepEqual(Array.from(positions.subarray(-3)), placeOf(count - 1));
});
