// Where an axis has its marks, and what they say.
import { powerOfTen, short } from "./format";

/** A round step of 1, 2 or 5 times a power of ten, so that about `count` fit into the range. */
export function step(range: number, count: number): number {
  const rough = range / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const times = rough / power;
  return power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
}

export function linearTicks(min: number, max: number, count: number, whole = false): number[] {
  const by = whole ? Math.max(1, Math.round(step(max - min, count))) : step(max - min, count);
  const ticks: number[] = [];
  for (let k = Math.ceil(min / by - 1e-9); k * by <= max + by * 1e-9; ++k) ticks.push(Number((k * by).toPrecision(12)));
  return ticks;
}

/** Powers of ten; where fewer than two lie in the range also 2 and 5 times them; in a narrow one, equal steps. */
export function logTicks(min: number, max: number, count: number): number[] {
  const from = Math.floor(Math.log10(min));
  const to = Math.ceil(Math.log10(max));
  const inside = (t: number) => t >= min * (1 - 1e-9) && t <= max * (1 + 1e-9);
  const every = Math.max(1, Math.ceil((to - from) / Math.max(1, count)));
  const powers: number[] = [];
  for (let k = from; k <= to; ++k) if ((k - from) % every === 0 || every === 1) powers.push(Number(`1e${k}`));
  const decades = powers.filter(inside);
  if (decades.length >= 3 || every > 1) return decades;
  const finer: number[] = [];
  for (let k = from; k <= to; ++k) for (const times of [1, 2, 5]) finer.push(Number(`${times}e${k}`));
  const found = finer.filter(inside);
  return found.length >= 3 ? found : linearTicks(min, max, count);
}

export function tickWords(value: number, log: boolean): string {
  if (!log) return short(value);
  const k = Math.log10(value);
  return Math.abs(k - Math.round(k)) < 1e-9 ? powerOfTen(Math.round(k)) : short(value);
}
