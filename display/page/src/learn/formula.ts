// The index of a point, step by step, with the numbers in it.
import { curveIndex } from "../../../report/src/curve";
import type { At } from "../walk/steps";
import { microOf } from "../walk/steps";

export interface Step {
  name: string;
  value: string;
  says: string;
}

const binary = (x: number, n: number): string => (n === 0 ? "0" : (x & (2 ** n - 1)).toString(2).padStart(n, "0"));

/** The base-4 digits of the index: the child taken at each cut, from the whole triangle down. */
export function digits(at: At, level: number): number[] {
  const m = microOf(at, level);
  const index = curveIndex(m.i, m.j, m.inverted, level);
  return Array.from({ length: level }, (_, k) => Math.floor(index / 4 ** (level - 1 - k)) % 4);
}

/** Vulkan's reference code at u = ku/4N, v = kv/4N. Source: VK_EXT_opacity_micromap, appendix "Reference Code". */
export function formula(at: At, level: number): Step[] {
  const N = 2 ** level;
  const quarter = (k: number): string => ["0", "1/4", "1/2", "3/4"][k]!;
  let [iu, iv] = [Math.min(Math.floor(at.ku / 4), N - 1), Math.min(Math.floor(at.kv / 4), N - 1)];
  const [uf, vf] = [at.ku % 4, at.kv % 4];
  const steps: Step[] = [
    { name: "iu, iv", value: `${iu}, ${iv}`, says: `the square of the grid: u N and v N rounded down, N = ${N}, and ${N - 1} at most` },
    { name: "uf, vf", value: `${quarter(uf)}, ${quarter(vf)}`, says: "how far into the square: what rounding took off" },
  ];
  const upper = uf + vf >= 4 && iu + iv < N - 1;
  if (iu + iv > N - 1) {
    iu = N - 1 - iv;
    steps.push({ name: "iu", value: String(iu), says: "lowered: the point is on the long edge, whose squares are cut in half" });
  }
  const iw = ~(iu + iv) - (upper ? 1 : 0);
  steps.push({ name: "iw", value: binary(iw, level), says: `NOT(iu + iv)${upper ? ", and one less: uf + vf is 1 or more, the upper half of the square" : ""}` });
  const low = N - 1;
  const b0 = ~(iu ^ iw) & low;
  const t = (iu ^ iv) & b0;
  let f = t;
  for (const by of [1, 2, 4, 8]) f ^= f >>> by;
  const b1 = (((f ^ iu) & ~b0) | t) & low;
  steps.push(
    { name: "b0", value: binary(b0, level), says: "NOT(iu XOR iw): a 1 where the child is 1 or 3" },
    { name: "t", value: binary(t, level), says: "(iu XOR iv) AND b0: a 1 where the child is 3" },
    { name: "f", value: binary(f, level), says: "XOR of t from above: a 1 where the 3s so far are odd in number; there iu is read the other way round" },
    { name: "b1", value: binary(b1, level), says: "((f XOR iu) AND NOT b0) OR t: a 1 where the child is 2 or 3" },
  );
  const m = microOf(at, level);
  steps.push({ name: "index", value: String(curveIndex(m.i, m.j, m.inverted, level)), says: "b1 and b0 in turn, bit by bit: two bits a child" });
  return steps;
}
