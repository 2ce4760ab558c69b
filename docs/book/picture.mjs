// A PNG of a surface with lines and points: an orthographic, shaded view without hidden parts.
import { crc32, deflateSync } from 'node:zlib';

const light = [-0.38, 0.62, 0.68];
const grey = [0.83, 0.85, 0.89];
/** The factor of the drawing's size before it is averaged. */
const fine = 2;

const rgbOf = (hex) => [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16) / 255);

export class Picture {
  #width;
  #height;
  #view;
  #positions;
  #triangles;
  #depth;
  #face;
  #weights;
  #pixels;

  /** `turn` has the angles about the vertical and then about the horizontal, in radians. */
  constructor(mesh, { width = 720, height = 480, turn = [0, 0] } = {}) {
    this.#width = fine * width;
    this.#height = fine * height;
    this.#positions = mesh.positions();
    this.#triangles = mesh.triangles();
    const count = this.#width * this.#height;
    this.#depth = new Float64Array(count).fill(-Infinity);
    this.#face = new Int32Array(count).fill(-1);
    this.#weights = new Float64Array(2 * count);
    this.#pixels = new Float64Array(4 * count);
    this.#view = this.#fit(turn);
    this.#findVisible();
  }

  #fit([yaw, pitch]) {
    const [c, s, d, e] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
    const rows = [
      [c, 0, s],
      [s * e, d, -c * e],
      [-s * d, e, c * d],
    ];
    const least = [Infinity, Infinity];
    const most = [-Infinity, -Infinity];
    const turned = (p, row) => row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
    for (let v = 0; v < this.#positions.length; v += 3) {
      const place = this.#positions.subarray(v, v + 3);
      for (const axis of [0, 1]) {
        const value = turned(place, rows[axis]);
        least[axis] = Math.min(least[axis], value);
        most[axis] = Math.max(most[axis], value);
      }
    }
    const room = 0.92;
    const scale =
      room * Math.min(this.#width / (most[0] - least[0]), this.#height / (most[1] - least[1]));
    const middle = [(least[0] + most[0]) / 2, (least[1] + most[1]) / 2];
    return {
      rows,
      place: (p) => [
        this.#width / 2 + scale * (turned(p, rows[0]) - middle[0]),
        this.#height / 2 - scale * (turned(p, rows[1]) - middle[1]),
        scale * turned(p, rows[2]),
      ],
    };
  }

  #place(vertex) {
    return this.#view.place(this.#positions.subarray(3 * vertex, 3 * vertex + 3));
  }

  #findVisible() {
    for (let f = 0; f < this.#triangles.length / 3; f++) {
      const [a, b, c] = [0, 1, 2].map((k) => this.#place(this.#triangles[3 * f + k]));
      const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
      if (area === 0) continue;
      const ends = (axis, limit) => [
        Math.max(0, Math.floor(Math.min(a[axis], b[axis], c[axis]))),
        Math.min(limit - 1, Math.ceil(Math.max(a[axis], b[axis], c[axis]))),
      ];
      const [left, right] = ends(0, this.#width);
      const [top, bottom] = ends(1, this.#height);
      for (let y = top; y <= bottom; y++) {
        for (let x = left; x <= right; x++) {
          const w1 = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
          const w2 = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
          if (w1 < 0 || w2 < 0 || w1 + w2 > 1) continue;
          const z = a[2] + w1 * (b[2] - a[2]) + w2 * (c[2] - a[2]);
          const at = y * this.#width + x;
          if (z <= this.#depth[at]) continue;
          this.#depth[at] = z;
          this.#face[at] = f;
          this.#weights[2 * at] = w1;
          this.#weights[2 * at + 1] = w2;
        }
      }
    }
  }

  /** The visible point of the surface at a place, in parts of the picture's width and height. */
  pick(x, y) {
    const at = Math.floor(y * this.#height) * this.#width + Math.floor(x * this.#width);
    const face = this.#face[at];
    // Beside the surface the search continues towards the picture's middle.
    if (face < 0) return this.pick(x + 0.02 * (0.5 - x), y + 0.02 * (0.5 - y));
    const [w1, w2] = this.#weights.subarray(2 * at, 2 * at + 2);
    return { face, bary: [1 - w1 - w2, w1, w2] };
  }

  /** Shades the surface; `colorOf` gives a vertex's red, green and blue from 0 to 1. */
  surface(colorOf = () => grey) {
    const normals = this.#normals();
    const vertices = this.#positions.length / 3;
    const colors = Array.from({ length: vertices }, (_, vertex) => colorOf(vertex));
    const toLight = this.#view.rows[0].map(
      (_, k) =>
        light[0] * this.#view.rows[0][k] +
        light[1] * this.#view.rows[1][k] +
        light[2] * this.#view.rows[2][k],
    );
    for (let at = 0; at < this.#face.length; at++) {
      const face = this.#face[at];
      if (face < 0) continue;
      const [w1, w2] = [this.#weights[2 * at], this.#weights[2 * at + 1]];
      const weights = [1 - w1 - w2, w1, w2];
      const normal = [0, 0, 0];
      const color = [0, 0, 0];
      for (let k = 0; k < 3; k++) {
        const vertex = this.#triangles[3 * face + k];
        for (let axis = 0; axis < 3; axis++) {
          normal[axis] += weights[k] * normals[3 * vertex + axis];
          color[axis] += weights[k] * colors[vertex][axis];
        }
      }
      const length = Math.hypot(...normal) || 1;
      const lit = normal.reduce((sum, one, axis) => sum + one * toLight[axis], 0) / length;
      const shade = 0.5 + 0.5 * Math.max(0, lit);
      this.#pixels.set([...color.map((one) => one * shade), 1], 4 * at);
    }
    return this;
  }

  #normals() {
    const normals = new Float64Array(this.#positions.length);
    for (let f = 0; f < this.#triangles.length; f += 3) {
      const corners = [0, 1, 2].map((k) => 3 * this.#triangles[f + k]);
      const side = (k) =>
        [0, 1, 2].map((x) => this.#positions[corners[k] + x] - this.#positions[corners[0] + x]);
      const [u, v] = [side(1), side(2)];
      for (let x = 0; x < 3; x++) {
        const [y, z] = [(x + 1) % 3, (x + 2) % 3];
        for (const corner of corners) normals[corner + x] += u[y] * v[z] - u[z] * v[y];
      }
    }
    return normals;
  }

  #disc(x, y, z, radius, color) {
    const reach = 0.02 * this.#height;
    for (
      let j = Math.max(0, Math.floor(y - radius));
      j <= Math.min(this.#height - 1, y + radius);
      j++
    ) {
      for (
        let i = Math.max(0, Math.floor(x - radius));
        i <= Math.min(this.#width - 1, x + radius);
        i++
      ) {
        const at = j * this.#width + i;
        if (Math.hypot(i - x, j - y) > radius || z + reach < this.#depth[at]) continue;
        this.#pixels.set([...color, 1], 4 * at);
      }
    }
  }

  /** Draws a line on the surface, by its coordinates one after the other. */
  line(coordinates, color, width = 4) {
    const rgb = rgbOf(color);
    for (let k = 0; k + 5 < coordinates.length; k += 3) {
      const a = this.#view.place(coordinates.subarray(k, k + 3));
      const b = this.#view.place(coordinates.subarray(k + 3, k + 6));
      const steps = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1])));
      for (let step = 0; step <= steps; step++) {
        const [x, y, z] = a.map((one, axis) => one + (step / steps) * (b[axis] - one));
        this.#disc(x, y, z, (fine * width) / 2, rgb);
      }
    }
    return this;
  }

  dot(position, color, width = 14) {
    const [x, y, z] = this.#view.place(position);
    this.#disc(x, y, z, (fine * width) / 2, [1, 1, 1]);
    this.#disc(x, y, z, (fine * (width - 4)) / 2, rgbOf(color));
    return this;
  }

  png() {
    const [width, height] = [this.#width / fine, this.#height / fine];
    return png(width, height, (x, y) => {
      const sum = [0, 0, 0, 0];
      for (let k = 0; k < fine * fine; k++) {
        const row = fine * y + Math.floor(k / fine);
        const at = 4 * (row * this.#width + fine * x + (k % fine));
        for (let part = 0; part < 4; part++) sum[part] += this.#pixels[at + part];
      }
      const covered = sum[3] || 1;
      return [...sum.slice(0, 3).map((one) => one / covered), sum[3] / fine ** 2];
    });
  }
}

/** A PNG of red, green, blue and opacity from 0 to 1 at each pixel. */
export function png(width, height, colorAt) {
  const rows = new Uint8Array(height * (4 * width + 1));
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const bytes = colorAt(x, y).map((one) => Math.round(255 * Math.min(1, one)));
      rows.set(bytes, y * (4 * width + 1) + 1 + 4 * x);
    }
  }
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name, 'latin1'), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc32(body), 4);
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 6, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]),
    ...[chunk('IHDR', head), chunk('IDAT', deflateSync(rows)), chunk('IEND', Buffer.alloc(0))],
  ]);
}
