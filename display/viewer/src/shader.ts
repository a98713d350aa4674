// The states over a triangle, asked for each pixel: the index of its micro-triangle, then the bits of its state.
import { DataTexture, DoubleSide, GLSL3, LessDepth, NearestFilter, RedIntegerFormat, ShaderMaterial, UnsignedByteType, Vector4 } from "three";

import type { MapArray } from "./maps";

const width = 4096;

const vertex = /* glsl */ `
in vec2 weights;
in uvec3 entry;
out vec2 uvOf;
flat out uvec3 entryOf;
void main() {
  uvOf = weights;
  entryOf = entry;
  vec4 place = vec4(position, 1.0);
#ifdef USE_INSTANCING
  place = instanceMatrix * place;
#endif
  gl_Position = projectionMatrix * modelViewMatrix * place;
}`;

/** entry: offset in bytes, level, bits a state; with 0 bits the first number is the state of all of it.  The index is that
 * of report/src/curve.ts. */
const fragment = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;
in vec2 uvOf;
flat in uvec3 entryOf;
uniform usampler2D data;
uniform vec4 shown;
uniform vec3 tints[4];
uniform float strength;
uniform float lines;
out vec4 colour;

uint spread(uint x) {
  x = (x | (x << 8)) & 0x00ff00ffu;
  x = (x | (x << 4)) & 0x0f0f0f0fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}
uint curve(uint i, uint j, bool upper, uint level) {
  uint low = (1u << level) - 1u;
  uint iw = ~(i + j) - (upper ? 1u : 0u);
  uint b0 = ~(i ^ iw) & low;
  uint t = (i ^ j) & b0;
  uint f = t ^ (t >> 1);
  f ^= f >> 2;
  f ^= f >> 4;
  f ^= f >> 8;
  uint b1 = (((f ^ i) & ~b0) | t) & low;
  return spread(b0) | (spread(b1) << 1);
}
uint stateAt(vec2 grid, uint n) {
  if (entryOf.z == 0u) return entryOf.x;
  uvec2 square = min(uvec2(max(floor(grid), 0.0)), uvec2(n - 1u));
  bool upper = fract(grid.x) + fract(grid.y) > 1.0;
  uint over = square.x + square.y;
  if (over >= n) { square.x -= over - n + 1u; over = n - 1u; }
  uint index = curve(square.x, square.y, upper && over < n - 1u, entryOf.y);
  uint bit = index * entryOf.z;
  uint at = entryOf.x + (bit >> 3);
  uint byte = texelFetch(data, ivec2(int(at % ${width}u), int(at / ${width}u)), 0).r;
  return (byte >> (bit & 7u)) & ((1u << entryOf.z) - 1u);
}
void main() {
  uint n = 1u << entryOf.y;
  vec2 grid = uvOf * float(n);
  uint state = stateAt(grid, n);
  vec3 three = vec3(grid, float(n) - grid.x - grid.y);
  vec3 sharp = fwidth(three);
  // Distance to the nearest line of the grid, in pixels; lines fade where micro-triangles are small.
  vec3 off = abs(three - round(three)) / max(sharp, 1e-6);
  float near = min(off.x, min(off.y, off.z));
  float room = 1.0 / max(sharp.x, max(sharp.y, sharp.z));
  float line = lines * (1.0 - smoothstep(0.4, 1.2, near)) * smoothstep(4.0, 10.0, room);
  vec3 outer = vec3(uvOf, 1.0 - uvOf.x - uvOf.y);
  vec3 far = outer / max(fwidth(outer), 1e-6);
  vec3 wide = fwidth(outer);
  float size = 1.0 / max(wide.x, max(wide.y, wide.z));
  float edge = lines * (1.0 - smoothstep(0.6, 1.4, min(far.x, min(far.y, far.z)))) * smoothstep(6.0, 60.0, size);
  float alpha = strength * shown[state];
  vec3 tint = mix(tints[state], vec3(0.06), 0.45 * line + 0.5 * edge);
  colour = vec4(tint, max(alpha, 0.55 * edge));
  if (colour.a < 0.004) discard;
}`;

/** What an entry is to the shader. */
export type Packed = [number, number, number];

/** The same for triangles that lie flat: of several at one place the first is drawn. */
export function flatMaterial(of: ShaderMaterial): ShaderMaterial {
  const flat = of.clone();
  flat.uniforms = of.uniforms;
  flat.polygonOffset = false;
  flat.depthWrite = true;
  flat.depthFunc = LessDepth;
  return flat;
}

export function mapMaterial(array: MapArray, tints: Vector4[]): ShaderMaterial {
  const rows = Math.max(1, Math.ceil(array.data.length / width));
  const bytes = new Uint8Array(width * rows);
  bytes.set(array.data);
  const data = new DataTexture(bytes, width, rows, RedIntegerFormat, UnsignedByteType);
  data.internalFormat = "R8UI";
  data.minFilter = data.magFilter = NearestFilter;
  data.unpackAlignment = 1;
  data.needsUpdate = true;
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: vertex,
    fragmentShader: fragment,
    uniforms: {
      data: { value: data },
      shown: { value: new Vector4(1, 1, 1, 1) },
      tints: { value: tints.map(({ x, y, z }) => [x, y, z]).flat() },
      strength: { value: 0.5 },
      lines: { value: 1 },
    },
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -2,
  });
}
