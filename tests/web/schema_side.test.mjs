// Drawings that are made from the published schema, which the page must read.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { pageModule } from './page_module.mjs';
import { long, randoms, seed } from './part.mjs';
import { drawingSchema, fitsDrawing, fitsPart } from './schema.mjs';

const merged = (schema, other) => {
  const both = { ...schema, ...other };
  if (schema.required && other.required) both.required = [...schema.required, ...other.required];
  if (schema.properties && other.properties) {
    both.properties = { ...schema.properties };
    for (const [name, property] of Object.entries(other.properties)) {
      both.properties[name] = merged(schema.properties[name] ?? {}, property);
    }
  }
  return both;
};

/** Makes random values of a schema's parts. */
class Maker {
  constructor(numbers) {
    this.random = () => numbers.next().value;
  }

  some(values) {
    return values[Math.floor(this.random() * values.length)];
  }

  of(schema) {
    const { $ref, allOf = [], anyOf, ...own } = schema;
    const rules = allOf.filter((one) => one.if);
    const parts = allOf.filter((one) => !one.if);
    if ($ref) return this.of(merged(drawingSchema($ref), own));
    if (anyOf) return this.of(this.some(anyOf));
    if (parts.length > 0) return Object.assign({}, ...parts.map((part) => this.of(part)));
    if ('const' in own) return own.const;
    if (own.enum) return this.some(own.enum);
    const type = this.some([own.type].flat());
    if (type === 'null') return null;
    if (type === 'boolean') return this.random() < 0.5;
    if (type === 'string') return this.text(own);
    if (type === 'array') {
      const { minItems = 0, maxItems = Infinity, items } = own;
      const length = Math.min(maxItems, minItems + Math.floor(this.random() * 4));
      return Array.from({ length }, () => this.of(items));
    }
    return type === 'object' || own.properties ? this.object(own, rules) : this.number(own, type);
  }

  text({ pattern, maxLength }) {
    if (pattern)
      return `#${Array.from({ length: 6 }, () => this.some('0123456789abcdef')).join('')}`;
    const length = this.some([0, 5, maxLength]);
    return Array.from({ length }, () => this.some(['a', 'ü', '界', ' ', '"', '😀'])).join('');
  }

  number({ minimum, maximum, exclusiveMinimum }, type) {
    const least = minimum ?? (exclusiveMinimum === 0 ? Number.MIN_VALUE : -1e6);
    const most = maximum ?? Number.MAX_VALUE;
    const between = least + this.random() * (Math.min(most, 1e3) - least);
    const value = this.some([least, most, between, between]);
    return type === 'integer' ? Math.round(value) : value;
  }

  object(schema, rules) {
    const { if: asks, then, else: otherwise, dependentSchemas = {} } = schema;
    // Such a rule chooses between two forms of the object.
    if (asks) return this.of(merged({ type: 'object' }, this.random() < 0.5 ? then : otherwise));
    const value = {};
    const add = ({ properties = {}, required = [] }, names) => {
      for (const [name, property] of Object.entries(properties)) {
        const isWanted = required.includes(name) || this.random() < 0.5;
        if (names(name) && isWanted) value[name] = this.of(property);
      }
    };
    // Rules ask for these properties, and decide about the others.
    const decisive = rules.flatMap((rule) => Object.keys(rule.if.properties));
    add(schema, (name) => decisive.includes(name));
    const whole = rules.reduce((all, rule) => {
      const consequence = fitsPart(rule.if, value) ? rule.then : rule.else;
      return merged(all, consequence ?? {});
    }, schema);
    add(whole, (name) => !decisive.includes(name));
    for (const dependent of Object.values(dependentSchemas)) {
      if (this.random() < 0.5) {
        Object.assign(
          value,
          this.of({ ...dependent, required: Object.keys(dependent.properties) }),
        );
      }
    }
    return value;
  }
}

/** Makes the relations between values hold that no schema can express. */
function related(drawing, isEmpty) {
  const bary = (value) => {
    if (value === null || typeof value !== 'object') return;
    if (value.bary) {
      const sum = value.bary.reduce((total, weight) => total + weight, 0);
      value.bary = sum > 0 ? value.bary.map((weight) => weight / sum) : [1, 0, 0];
    }
    for (const one of Object.values(value)) bary(one);
  };
  bary(drawing);
  const objects = drawing.objects.filter(({ figure }, i) => i === 0 || !isEmpty(figure));
  for (const [i, object] of objects.entries()) {
    const { settings, points } = object.figure;
    if (i > 0) object.id = i;
    else object.id = 2 ** 53 - 1;
    if (settings.knots) {
      const count = points.length + 1 + (settings.closed ? 0 : settings.degree);
      settings.knots = Array.from({ length: count }, (_, knot) => knot);
    }
  }
  return { ...drawing, objects, active: objects[0].id };
}

describe('a drawing by the schema', () => {
  let page;
  before(async () => {
    page = await pageModule('./page_parts.ts');
  });

  test(`is read, and stays as it was read: KARCHER_SEED=${seed}`, () => {
    for (let run = 0; run < (long ? 20_000 : 1000); run++) {
      const maker = new Maker(randoms(100_000 * seed + run));
      const made = related(maker.of(drawingSchema('#/$defs/drawing')), page.isEmpty);
      const text = JSON.stringify(made);
      const words = () => `run ${run}: ${text.slice(0, 2000)}`;
      const given = JSON.parse(text);
      assert.ok(fitsDrawing(given), `${JSON.stringify(fitsDrawing.errors)}, ${words()}`);
      let read;
      try {
        read = page.readDrawing(given);
      } catch (error) {
        assert.fail(`${error.message}, ${words()}`);
      }
      const again = JSON.parse(JSON.stringify(page.savedDrawing(read)));
      assert.ok(fitsDrawing(again), `${JSON.stringify(fitsDrawing.errors)}, ${words()}`);
      assert.deepEqual(page.readDrawing(again), read, words());
    }
  });
});
