import { ShaderLib } from 'three';

/** The width of a line on the surface, in the scene, and the surface's unit normals along it. */
export interface Band {
  width: number;
  normals(line: Float32Array): Float32Array;
}

const usual = 'vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;';

/** A band appears nearer to the eye by this fraction of its width. */
const lift = 0.25;

/**
 * The vertex shader of three.js's lines, extended by a width on the surface. It first widens a line
 * within the plane of the surface, so that perspective and slant apply to the line as they do to
 * the surface. It then adds the line's width on the screen.
 */
const bandShader = ShaderLib.line!.vertexShader.replace(
  'void main()',
  `uniform float bandWidth;
    attribute vec3 instanceNormalStart;
    attribute vec3 instanceNormalEnd;
    void main()`,
).replace(
  usual,
  `vec4 eye = position.y < 0.5 ? start : end;
    if (bandWidth > 0.0) {
      vec3 along = normalize(end.xyz - start.xyz);
      vec3 normal = normalMatrix * (position.y < 0.5 ? instanceNormalStart : instanceNormalEnd);
      vec3 aside = normalize(cross(along, normal));
      float end = position.y < 0.0 ? -1.0 : position.y > 1.0 ? 1.0 : 0.0;
      eye.xyz += 0.5 * bandWidth * (sign(position.x) * aside + end * along);
      // The lift is along the ray, since a bent surface would rise above the band's sides.
      eye.xyz *= 1.0 - min(0.5, ${lift} * bandWidth / length(eye.xyz));
    }
    vec4 clip = projectionMatrix * eye;`,
);

/** Gives a line material a width on the surface, initially 0. */
export function withBand<Material extends { vertexShader: string; uniforms: object }>(
  material: Material,
): { material: Material; band: { value: number } } {
  const band = { value: 0 };
  material.vertexShader = bandShader;
  Object.assign(material.uniforms, { bandWidth: band });
  return { material, band };
}
