// Judges an index function by index.json: put yours in the place of indexOf().
//   mmverify vectors -o DIR && esbuild read.ts --outfile=read.mjs && node read.mjs DIR/index.json
// Prints how many answers are those of each dialect, and the first that is not published; exit code 1 where neither has all.
import { readFileSync } from "node:fs";
import { argv, exit } from "node:process";

interface Point {
  id: number;
  about: string;
  level: number;
  u: string;
  v: string;
  exact: number;
  published: number;
  prose: number | null;
}

const words = new DataView(new ArrayBuffer(4));
function number(hex: string): number {
  words.setUint32(0, parseInt(hex, 16));
  return words.getFloat32(0);
}

const clamped = (x: number): number => Math.min(Math.max(x, 0), 1);

function spread(x: number): number {
  let out = 0;
  for (let k = 0; k < 16; ++k) out |= ((x >>> k) & 1) << (2 * k);
  return out;
}

/** The reference code of VK_EXT_opacity_micromap; Math.fround rounds where floats would. */
function indexOf(level: number, u: number, v: number): number {
  const N = 2 ** level;
  const un = clamped(u) * N;
  const vn = clamped(v) * N;
  const upper = Math.fround(un - Math.floor(un) + (vn - Math.floor(vn))) >= 1;
  let iu = Math.min(Math.floor(un), N - 1);
  const iv = Math.min(Math.floor(vn), N - 1);
  const s = iu + iv;
  if (s >= N) iu -= s - N + 1;
  const iw = ~(iu + iv) - (upper && s < N - 1 ? 1 : 0);
  const b0 = ~(iu ^ iw) & (N - 1);
  const t = (iu ^ iv) & b0;
  let f = t;
  for (const shift of [1, 2, 4, 8]) f ^= f >>> shift;
  return (spread(b0) | (spread(((f ^ iu) & ~b0) | t) << 1)) >>> 0;
}

const points: Point[] = JSON.parse(readFileSync(argv[2] ?? "index.json", "utf8")).tables[0].vectors;
const answers = points.map((p) => indexOf(p.level, number(p.u), number(p.v)));
const exact = points.filter((p, k) => answers[k] === p.exact).length;
const published = points.filter((p, k) => answers[k] === p.published).length;
const inside = points.filter((p) => p.prose !== null).length;
const prose = points.filter((p, k) => answers[k] === p.prose).length;
const first = points.find((p, k) => answers[k] !== p.published);
console.log(
  `published: ${published} of ${points.length}, exact: ${exact} of ${points.length}, prose: ${prose} of ${inside}`,
);
if (first) console.log(`first: level ${first.level}, u ${number(first.u)}, v ${number(first.v)}: ${first.about}`);
exit(exact === points.length || published === points.length ? 0 : 1);
