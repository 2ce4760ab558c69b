import {
  Color,
  CustomBlending,
  DoubleSide,
  Mesh,
  NoBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  OrthographicCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { FullScreenQuad } from 'three/addons/postprocessing/Pass.js';
import type { ViewerColors } from './colors';
import type { Surface } from './surface';

/**
 * The heights above the ground, an octave apart, each with its own shadow. They are in the scene,
 * where a surface is at most 2 wide. Everything below the first height has a shadow as sharp as
 * that of the first height.
 */
const heights = [0.06, 0.12, 0.24, 0.48] as const;
/**
 * The widths of the bell curves that approximate shadows. Under a wide sky, a unit of area at
 * height h takes h² / (π (h² + d²)²) of the light from a place of the ground at distance d. Half of
 * this shadow lies within the distance h. Half of a bell curve's mass lies within 1.18 of its
 * width.
 */
const bellWidths = heights.map((height) => height / Math.sqrt(2 * Math.log(2)));
const widest = Math.max(...bellWidths);
/**
 * Half the side of the shadow's square on the ground. A surface reaches at most 1 from the middle,
 * and its shadow reaches farther.
 */
const reach = 1 + 2 * widest;
/** The number of points along the square's side: four in the width of the sharpest bell. */
const side = Math.ceil((4 * 2 * reach) / Math.min(...bellWidths));
/**
 * The number of samples of a bell on each side of its middle. The omitted samples are at most about
 * a tenth of a percent of the middle's value.
 */
const bellSteps = Math.ceil((3.7 * widest * side) / (2 * reach));
/**
 * The fraction of the ground's color that the shadow removes where the surface hides the sky
 * completely.
 */
const darkest = 0.7;
/**
 * The largest opacity of the lit ground, over a black background, which without the light would
 * show no shadow. A brighter background needs less light.
 */
const lit = 0.5;

const list = (values: readonly number[]) => values.map((value) => value.toFixed(6)).join(', ');

/**
 * The material that shows, from below, how much surface is above a place at each of the four
 * heights. At most two amounts, of neighboring heights, are above 0.
 */
const castMaterial = () =>
  new ShaderMaterial({
    uniforms: { ground: { value: 0 } },
    vertexShader: `
      uniform float ground;
      varying float vHeight;
      void main() {
        vec4 place = modelMatrix * vec4(position, 1.0);
        vHeight = place.y - ground;
        gl_Position = projectionMatrix * viewMatrix * place;
      }`,
    fragmentShader: `
      varying float vHeight;
      void main() {
        float octave = log2(max(vHeight / ${heights[0].toFixed(6)}, 1.0));
        gl_FragColor = max(vec4(0.0), 1.0 - abs(vec4(0.0, 1.0, 2.0, 3.0) - min(octave, 3.0)));
        // What is still higher hides less and less of the sky.
        gl_FragColor.w *= exp2(-2.0 * max(0.0, octave - 3.0));
      }`,
    side: DoubleSide,
    blending: NoBlending,
  });

/** The material that blurs the shadow of each height along one direction. */
const blurMaterial = () =>
  new ShaderMaterial({
    uniforms: { from: { value: null }, along: { value: new Vector2() } },
    vertexShader: `
      varying vec2 vAt;
      void main() {
        vAt = uv;
        gl_Position = vec4(position.xy, 0.0, 1.0);
      }`,
    fragmentShader: `
      uniform sampler2D from;
      uniform vec2 along;
      varying vec2 vAt;
      const vec4 widths = vec4(${list(bellWidths)});
      void main() {
        vec4 sum = vec4(0.0);
        vec4 weights = vec4(0.0);
        for (int i = -${bellSteps}; i <= ${bellSteps}; i++) {
          vec4 far = float(i) * ${((2 * reach) / side).toFixed(6)} / widths;
          vec4 weight = exp(-0.5 * far * far);
          sum += weight * texture2D(from, vAt + along * float(i));
          weights += weight;
        }
        gl_FragColor = sum / weights;
      }`,
    blending: NoBlending,
  });

/** The soft shadow of a surface on the ground below it, under a wide sky. */
export class GroundShadow {
  readonly object: Mesh;
  readonly #material = new ShaderMaterial({
    uniforms: {
      shadow: { value: null },
      color: { value: new Color() },
      ground: { value: new Color() },
      lit: { value: 0 },
    },
    vertexShader: `
      varying vec2 vAt;
      void main() {
        vec4 place = modelMatrix * vec4(position, 1.0);
        vAt = place.xz / ${reach.toFixed(6)};
        gl_Position = projectionMatrix * viewMatrix * place;
      }`,
    fragmentShader: `
      uniform sampler2D shadow;
      uniform vec3 color;
      uniform vec3 ground;
      uniform float lit;
      varying vec2 vAt;
      vec4 shown(vec3 linear, float part) {
        gl_FragColor = vec4(linear, 1.0);
        #include <colorspace_fragment>
        return part * gl_FragColor;
      }
      void main() {
        // What one height leaves of the sky another one hides a part of.
        vec4 left = 1.0 - texture2D(shadow, 0.5 + 0.5 * vAt);
        float hidden = 1.0 - left.x * left.y * left.z * left.w;
        hidden *= ${darkest.toFixed(2)} * (1.0 - smoothstep(0.8, 1.0, length(vAt)));
        float light = lit * (1.0 - smoothstep(0.0, 1.0, length(vAt)));
        gl_FragColor = shown(color, hidden) + (1.0 - hidden) * shown(ground, light);
      }`,
    // From above, the surface is always in front of the ground, so the ground is drawn first. From
    // below, the ground is invisible.
    depthTest: false,
    depthWrite: false,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
  });
  #target: WebGLRenderTarget | null = null;

  constructor() {
    this.object = new Mesh(new PlaneGeometry(2 * reach, 2 * reach), this.#material);
    this.object.rotation.x = -Math.PI / 2;
    this.object.renderOrder = -1;
    this.object.visible = false;
  }

  setColors({ shadow, floor, stage }: ViewerColors): void {
    const { uniforms } = this.#material;
    uniforms.color!.value.set(shadow);
    uniforms.ground!.value.set(floor);
    const { r, g, b } = new Color(stage);
    const luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    uniforms.lit!.value = lit * (1 - luminance);
  }

  /**
   * Discards the shadow, since the surface has changed or the drawing context is lost. The next
   * display renders it again.
   */
  forget(): void {
    this.#target?.dispose();
    this.#target = null;
  }

  /** Renders the shadow if it is visible and missing. */
  prepare(renderer: WebGLRenderer, surface: Surface): void {
    if (!this.object.visible || this.#target) return;
    const ground = surface.lowest;
    this.object.position.y = ground;

    const [cast, blur] = [castMaterial(), blurMaterial()];
    const [target, aside] = [0, 1].map(
      () => new WebGLRenderTarget(side, side, { depthBuffer: true }),
    ) as [WebGLRenderTarget, WebGLRenderTarget];
    const below = new OrthographicCamera(-reach, reach, reach, -reach, 0, 4);
    below.up = new Vector3(0, 0, 1);
    below.position.y = ground - 1;
    below.lookAt(0, ground, 0);
    const casters = new Scene();
    casters.overrideMaterial = cast;
    cast.uniforms.ground!.value = ground;

    const before = renderer.getClearColor(new Color());
    const [alpha, home] = [renderer.getClearAlpha(), surface.object.parent];
    renderer.setClearColor(0, 0);
    renderer.setRenderTarget(target);
    casters.add(surface.object);
    renderer.render(casters, below);
    home?.add(surface.object);
    const pass = new FullScreenQuad(blur);
    const directions = [
      { from: target, to: aside, along: [1 / side, 0] },
      { from: aside, to: target, along: [0, 1 / side] },
    ] as const;
    for (const { from, to, along } of directions) {
      blur.uniforms.from!.value = from.texture;
      blur.uniforms.along!.value.set(...along);
      renderer.setRenderTarget(to);
      pass.render(renderer);
    }
    renderer.setRenderTarget(null);
    renderer.setClearColor(before, alpha);
    pass.dispose();
    aside.dispose();
    cast.dispose();
    blur.dispose();
    this.#target = target;
    this.#material.uniforms.shadow!.value = target.texture;
  }
}
