import { make } from '../../panels/elements';
import { pyramid, transportInto } from '../figures/transport';
import { Caption, sectionHead } from './section';

const svgNames = 'http://www.w3.org/2000/svg';
const height = 0.7;
/** The length of the star's unit in a drawing of 200 by 160. */
const size = 58;

type Place = readonly [number, number];

const seen = ([x, y]: Place, [cx, cy]: Place): string =>
  `${(cx + size * x).toFixed(2)},${(cy - size * y).toFixed(2)}`;

/** Figure 2: a vector's transport from a vertex into a face. The reader can turn the vector. */
export class TransportSection {
  readonly element = make('section', '', { className: 'figure', id: 'transport' });
  readonly #svg = document.createElementNS(svgNames, 'svg');
  readonly #note = make('p', '', { className: 'panel-note' });
  #angle = 50;
  #face = 1;

  constructor() {
    const head = sectionHead('Figure 2', 'A vector carried from a vertex into a face');
    const caption = new Caption(
      'Gradients are kept in the frames of vertices and read in faces. On the left a vertex v with the faces around it, laid flat so that its angles make a full turn; on the right the face t in its own plane. The vector keeps its angle with the dashed segment from v to the centroid of t, so that it turns by θₜᵥ + π − θᵥₜ. The vertex is the tip of a pyramid, which is ours; turn the vector, or choose another face.',
    );
    const card = make('div', '', { className: 'panel-card' });
    this.#svg.setAttribute('viewBox', '0 0 400 160');
    this.#svg.setAttribute('class', 'transport');
    this.#svg.setAttribute('role', 'img');
    this.#svg.setAttribute('aria-label', 'A vector at a vertex and in a face');
    const controls = make('div', '', { className: 'sliders' });
    controls.append(
      this.#slider('Direction', 0, 359, this.#angle, (value) => {
        this.#angle = value;
        return `${value}°`;
      }),
      this.#slider('Face', 1, pyramid(height).ring.length, this.#face + 1, (value) => {
        this.#face = value - 1;
        return `${value}`;
      }),
    );
    card.append(this.#svg, this.#note, controls);
    this.element.append(head, caption.element, card);
    this.#draw();
  }

  #slider(
    name: string,
    least: number,
    most: number,
    value: number,
    change: (value: number) => string,
  ): HTMLElement {
    const range = make('input', '', { type: 'range', min: `${least}`, max: `${most}`, step: '1' });
    range.value = `${value}`;
    range.setAttribute('aria-label', name);
    const output = make('output', change(value));
    range.addEventListener('input', () => {
      output.textContent = change(Number(range.value));
      this.#draw();
    });
    const label = make('label', '', { className: 'wide' });
    label.append(make('span', name), range, output);
    return label;
  }

  #draw(): void {
    const star = pyramid(height);
    const moved = transportInto(star, this.#face);
    const angle = (this.#angle * Math.PI) / 180;
    const [left, right]: [Place, Place] = [
      [100, 82],
      [258, 122],
    ];
    const polar = (radius: number, at: number): Place => [
      radius * Math.cos(at),
      radius * Math.sin(at),
    ];
    const { ring, face, centroid, thetaVt, distance, rotation, defect } = moved;
    const chosen = [ring[this.#face]!, ring[(this.#face + 1) % ring.length]!];
    const parts = [
      shape('polygon', 'ring', ring.map((place) => seen(place, left)).join(' ')),
      shape('polygon', 'chosen', [[0, 0] as Place, ...chosen].map((p) => seen(p, left)).join(' ')),
      ...ring.map((place) => line('edge', [0, 0], place, left)),
      line('segment', [0, 0], polar(distance, thetaVt), left),
      ...arrow([0, 0], angle, left),
      shape('polygon', 'chosen', face.map((place) => seen(place, right)).join(' ')),
      line('segment', [0, 0], centroid, right),
      ...arrow(centroid, angle + rotation, right),
      text('v', [0, -0.14], left),
      text('v', [-0.1, -0.1], right),
      text('t', polar(1.25 * distance, thetaVt), left),
    ];
    this.#svg.replaceChildren(...parts);
    const degrees = (radians: number) => {
      const turned = ((radians * 180) / Math.PI) % 360;
      return `${Math.round(turned < 0 ? turned + 360 : turned)}°`;
    };
    this.#note.textContent = `θᵥₜ = ${degrees(thetaVt)}, θₜᵥ = ${degrees(moved.thetaTv)}: from ${degrees(angle)} in the frame of v to ${degrees(angle + rotation)} in that of t. The angles at v are ${degrees(defect)} short of a full turn.`;
  }
}

function element(name: string, className: string, attributes: Record<string, string>): SVGElement {
  const made = document.createElementNS(svgNames, name);
  made.setAttribute('class', className);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

const shape = (name: string, className: string, points: string) =>
  element(name, className, { points });

const line = (className: string, from: Place, to: Place, origin: Place) =>
  shape('polyline', className, `${seen(from, origin)} ${seen(to, origin)}`);

/** A vector of length 1/2, with its head. */
function arrow(from: Place, angle: number, origin: Place): SVGElement[] {
  const at = (radius: number, turned: number): Place => [
    from[0] + radius * Math.cos(angle + turned),
    from[1] + radius * Math.sin(angle + turned),
  ];
  const head = [at(0.5, 0), at(0.38, 0.13), at(0.38, -0.13)].map((place) => seen(place, origin));
  return [
    line('vector', from, at(0.44, 0), origin),
    shape('polygon', 'vector-head', head.join(' ')),
  ];
}

function text(label: string, at: Place, origin: Place): SVGElement {
  const [x, y] = seen(at, origin).split(',') as [string, string];
  const made = element('text', 'name', { x, y });
  made.textContent = label;
  return made;
}
