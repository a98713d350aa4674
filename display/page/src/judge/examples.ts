// Index functions to begin with: a right one and two that are wrong in different ways.

const bits = `  let f = t ^ (t >>> 1);
  f ^= f >>> 2;
  f ^= f >>> 4;
  f ^= f >>> 8;
  const b1 = (((f ^ iu) & ~b0) | t) & low;
  let answer = 0;
  for (let k = 0; k < level; ++k)
    answer |= (((b0 >>> k) & 1) | (((b1 >>> k) & 1) << 1)) << (2 * k);
  return answer >>> 0;
}
`;

const script = (about: string, square: string, upper: string): string => `// ${about}
function index(level, u, v) {
  const N = 1 << level, low = N - 1;
${square}
  if (iu + iv > low) iu = low - iv;
  const iw = ~(iu + iv) - (${upper} ? 1 : 0);
  const b0 = ~(iu ^ iw) & low, t = (iu ^ iv) & b0;
${bits}`;

const down = `  let iu = Math.min(Math.floor(u * N), low), iv = Math.min(Math.floor(v * N), low);
  const uf = u * N - Math.floor(u * N), vf = v * N - Math.floor(v * N);
  const sum = iu + iv;`;
// uf + vf >= 1 without the sum, which would be rounded.
const exactly = "Math.min(uf, vf) >= 1 - Math.max(uf, vf) && sum < low";
const up = `  // A point on a grid line of u goes to the square before it.
  let iu = Math.max(Math.ceil(u * N) - 1, 0), iv = Math.min(Math.floor(v * N), low);
  const uf = u * N - iu, vf = v * N - Math.floor(v * N);
  const sum = iu + iv;`;

const wgsl = `// Vulkan's reference code in binary32. A level is 0..12.
fn index(level: u32, u: f32, v: f32) -> u32 {
  let low = (1u << level) - 1u;
  let x = u * f32(low + 1u);
  let y = v * f32(low + 1u);
  var iu = min(u32(x), low);
  let iv = min(u32(y), low);
  let upper = fract(x) + fract(y) >= 1.0 && iu + iv < low;
  if (iu + iv > low) { iu = low - iv; }
  var iw = ~(iu + iv);
  if (upper) { iw -= 1u; }
  let b0 = ~(iu ^ iw) & low;
  let t = (iu ^ iv) & b0;
  var f = t ^ (t >> 1u);
  f ^= f >> 2u;
  f ^= f >> 4u;
  f ^= f >> 8u;
  let b1 = (((f ^ iu) & ~b0) | t) & low;
  var answer = 0u;
  for (var k = 0u; k < level; k++) {
    answer |= (((b0 >> k) & 1u) | (((b1 >> k) & 1u) << 1u)) << (2u * k);
  }
  return answer;
}
`;

export type Language = "JavaScript" | "WGSL";
export interface Example {
  words: string;
  language: Language;
  code: string;
}

export const examples: Example[] = [
  { words: "right: Vulkan's reference, exact on floats", language: "JavaScript", code: script("Vulkan's reference code, with no sum that floats would round.", down, exactly) },
  { words: "as published: Vulkan's reference, which rounds", language: "JavaScript", code: script("Vulkan's reference code: in binary32 uf + vf may round up to 1.", down, "uf + vf >= 1 && sum < low") },
  { words: "wrong on floats: by w = 1 - u - v", language: "JavaScript", code: script("The upper half by w, which binary32 rounds.", `  const w = 1 - u - v;\n${down}`, "sum + Math.ceil(w * N) < N && sum < low") },
  { words: "wrong: breaks ties otherwise", language: "JavaScript", code: script("As the reference, but a point on an edge goes to the other side.", up, exactly) },
  { words: "wrong: mirrored", language: "JavaScript", code: `${script("As the reference, but somebody swapped u and v.", down, exactly).replace("index(level, u, v)", "index(level, v, u)")}` },
  { words: "wrong: never ends at level 3", language: "JavaScript", code: "// Looks for an index, and at level 3 does not find it.\nfunction index(level, u, v) {\n  let answer = 0;\n  while (level === 3) answer = (answer + 1) % 64;\n  return answer;\n}\n" },
  { words: "right: Vulkan's reference", language: "WGSL", code: wgsl },
  { words: "wrong: mirrored", language: "WGSL", code: wgsl.replace("// Vulkan's reference code in binary32.", "// As the reference, but somebody swapped u and v.").replace("level: u32, u: f32, v: f32", "level: u32, v: f32, u: f32") },
];
