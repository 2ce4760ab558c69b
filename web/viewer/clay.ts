import {
  BackSide,
  type BufferGeometry,
  Color,
  DoubleSide,
  FrontSide,
  Mesh,
  MeshBasicMaterial,
  type PerspectiveCamera,
  ShaderMaterial,
  Vector3,
} from 'three';
import type { Bars } from './bars';
import { rampForShader } from './color_ramp';
import type { DrawnGeometry } from './drawn_geometry';
import { hollowRadii } from './hollows';

export interface SurfaceColors {
  front: string;
  back: string;
  sky: string;
  ground: string;
  edges: string;
}

/** The largest fraction of the light that a hollow loses. */
const reliefShown = 0.55;

/** Values from the vertex shader to the fragment shader. */
const varyings = `
    varying vec3 vNormal;
    varying vec3 vEye;
    varying float vValue;
    varying vec3 vTint;
    varying float vHollow;`;

/** The lightening of a ridge, relative to the darkening of a hollow of the same depth. */
const litRidges = 0.25;

/** The uniforms of the light, for the surface and the paint on it. */
const light = {
  sky: { value: new Color() },
  ground: { value: new Color() },
  key: { value: new Vector3(-0.45, 0.7, 0.75) },
  relief: { value: reliefShown },
};

/**
 * The surface's shift away from the camera for each unit of its slope, as a fraction of its
 * distance. Without the shift, a sloped surface would rise beside a line and hide half of the
 * line's width.
 */
const sunk = { value: 0 };
/** The largest slope in this shift. Steeper slopes count as this slope. */
const steepest = 4;

/** The size of a CSS pixel at distance 1 from the camera. */
const pixel = { value: 1 };
/**
 * The width in pixels of the neighborhoods that relief shows best. Relief fades out for
 * neighborhoods four times as wide or as narrow.
 */
const reliefPixels = 16;

/**
 * Adapts the surface to a stage of a given height. A line is then visible in its whole width if it
 * reaches at most `pixels` CSS pixels to each side.
 */
export function fitSurface(pixels: number, camera: PerspectiveCamera, height: number): void {
  pixel.value = (2 * Math.tan((camera.fov * Math.PI) / 360)) / height;
  sunk.value = pixels * pixel.value;
}

/** Clay under a soft sky and a key light that moves with the camera. */
const clay = {
  uniforms: {
    front: { value: new Color() },
    back: { value: new Color() },
    ...light,
    sunk,
    pixel,
    leastSlope: { value: 0 },
    frontIsOutside: { value: true },
    ramp: { value: rampForShader() },
    most: { value: 0 },
    colored: { value: false },
    opacity: { value: 1 },
    bars: { value: new Vector3() },
  },
  vertexShader: `
    attribute float value;
    attribute vec3 tint;
    attribute vec4 hollow;
    uniform float sunk;
    uniform float pixel;
    uniform float leastSlope;
    ${varyings}
    void main() {
      vValue = value;
      // Files have sRGB, and the shader computes with linear light.
      vTint = mix(tint / 12.92, pow((tint + 0.055) / 1.055, vec3(2.4)), step(0.04045, tint));
      vec4 eye = modelViewMatrix * vec4(position, 1.0);
      vEye = -eye.xyz;
      vNormal = normalMatrix * normal;
      vec4 octaves = log2(vec4(${hollowRadii.join(', ')}) / (${reliefPixels.toFixed(1)} * pixel * max(-eye.z, 1e-6))) / 2.0;
      vHollow = dot(hollow, exp(-octaves * octaves)) / ${Math.sqrt(Math.PI)};
      float facing = abs(dot(normalize(vNormal), normalize(vEye)));
      float slope = sqrt(1.0 - facing * facing) / max(facing, 0.01);
      slope = clamp(slope, leastSlope, ${steepest.toFixed(1)});
      // The surface moves back along the ray, so that it is seen where it is.
      gl_Position = projectionMatrix * vec4(eye.xyz * (1.0 + sunk * slope), 1.0);
    }`,
  fragmentShader: `
    uniform vec3 front;
    uniform vec3 back;
    uniform vec3 sky;
    uniform vec3 ground;
    uniform vec3 key;
    uniform float relief;
    uniform bool frontIsOutside;
    uniform vec3 ramp[5];
    uniform float most;
    uniform bool colored;
    uniform float opacity;
    uniform vec3 bars;
    ${varyings}
    // How much is painted from the start up to a number of periods.
    float paintedUpTo(float periods) {
      float part = bars.z - bars.y;
      return floor(periods) * part + clamp(fract(periods) - bars.y, 0.0, part);
    }
    void main() {
      vec3 eye = normalize(vEye);
      vec3 normal = normalize(vNormal);
      if (!gl_FrontFacing) normal = -normal;
      float up = 0.5 + 0.5 * normal.y;
      vec3 from = normalize(key);
      float lit = max(0.0, (dot(normal, from) + 0.2) / 1.2);
      float gloss = pow(max(0.0, dot(normal, normalize(from + eye))), 24.0);
      float rim = pow(1.0 - abs(dot(normal, eye)), 3.0);
      vec3 clay = gl_FrontFacing == frontIsOutside ? front : back;
      if (colored) clay = vTint;
      if (most > 0.0 && vValue > -0.5 * most) {
        float at = 4.0 * clamp(vValue / most, 0.0, 1.0);
        clay = ramp[0];
        for (int i = 0; i < 4; i++) clay = mix(clay, ramp[i + 1], clamp(at - float(i), 0.0, 1.0));
      }
      vec3 light = mix(ground, sky, up) * 0.64 + vec3(0.56) * lit * lit;
      // A hollow of one side is a ridge of the other.
      float sunken = gl_FrontFacing ? vHollow : -vHollow;
      // Ridges are lit as they are: much lighter ones would be white.
      light *= 1.0 - relief * (sunken > 0.0 ? sunken : ${litRidges} * sunken);
      float shown = opacity;
      if (bars.x > 0.0) {
        // Of the periods that a pixel has, the part that is painted.
        float at = vValue / bars.x;
        float wide = max(fwidth(at), 1e-4);
        shown *= (paintedUpTo(at + 0.5 * wide) - paintedUpTo(at - 0.5 * wide)) / wide;
      }
      gl_FragColor = vec4(clay * light + sky * (0.05 * gloss + 0.1 * rim), shown);
      #include <colorspace_fragment>
    }`,
};
const material = new ShaderMaterial(clay);
/**
 * The material of the inner sides, for a surface with both sides visible. The inner sides lie
 * farthest back whatever their slope, so that no specks of them appear in front of the outer sides
 * at the rim.
 */
const inner = new ShaderMaterial({
  ...clay,
  uniforms: { ...clay.uniforms, leastSlope: { value: steepest } },
  side: BackSide,
});
const materials = [material, inner];

/** A mesh of the surface's clay, on both sides. */
export function clayMesh(geometry: BufferGeometry): Mesh {
  geometry.clearGroups();
  for (const i of materials.keys()) geometry.addGroup(0, Number.POSITIVE_INFINITY, i);
  return new Mesh(geometry, materials);
}

/**
 * The material of paint: clay in another color, over the surface. With `bars`, it covers only the
 * bars.
 */
export function paint(color: Color, opacity: number, bars: Bars | null = null): ShaderMaterial {
  return new ShaderMaterial({
    ...clay,
    uniforms: {
      ...clay.uniforms,
      ...{ front: { value: color }, back: { value: color } },
      ...{ most: { value: 0 }, colored: { value: false }, opacity: { value: opacity } },
      bars: { value: bars ? new Vector3(bars.period, bars.from, bars.to) : new Vector3() },
    },
    side: inner.visible ? DoubleSide : material.side,
    // Opaque paint counts as transparent, too, so that all paint appears in order.
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -1,
    polygonOffsetUnits: -4,
  });
}

/**
 * The sides that `material` draws for each value of `outside`. It omits inner sides, which would
 * show as specks at the silhouette.
 */
const sides = { front: FrontSide, back: BackSide, both: FrontSide };

const edgeMaterial = new MeshBasicMaterial({
  wireframe: true,
  transparent: true,
  opacity: 0.16,
  depthWrite: false,
});

/** The edges of a geometry's triangles. */
export const edgeMesh = (geometry: BufferGeometry) => new Mesh(geometry, edgeMaterial);

/** Turns the light around the line of sight, by an angle in radians; it moves with the camera. */
export function turnLight(angle: number): void {
  light.key.value.applyAxisAngle(new Vector3(0, 0, 1), angle);
}

/** Sets whether hollows are darker. */
export function showRelief(shown: boolean): void {
  light.relief.value = shown ? reliefShown : 0;
}

export function colorSurface(colors: SurfaceColors): void {
  for (const name of ['front', 'back', 'sky', 'ground'] as const) {
    material.uniforms[name]!.value.set(colors[name]);
  }
  edgeMaterial.color.set(colors.edges);
}

/** Shows a surface as plain clay. `outside` says which sides of its triangles are visible. */
export function showClay(outside: DrawnGeometry['outside']): void {
  material.side = sides[outside];
  inner.visible = outside === 'both';
  material.uniforms.frontIsOutside!.value = outside !== 'back';
  material.uniforms.most!.value = 0;
  material.needsUpdate = true;
}

/** Shows the surface in the colors of its file, or as plain clay. */
export function showTint(shown: boolean): void {
  material.uniforms.colored!.value = shown;
}

/** Shows values from 0 to `most` as colors. With 0 for `most`, they are hidden. */
export function showValues(most: number): void {
  material.uniforms.most!.value = most;
}
