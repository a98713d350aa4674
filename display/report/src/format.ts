// Numbers and times as people read them.

/** 1234567 as 1,234,567. */
export const grouped = (n: number): string => Math.round(n).toString().replace(/\B(?=(\d{3})+(?!\d))/g, ",");

/** Three significant digits, without an exponent where that is short. */
export function short(x: number): string {
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-3) return x.toExponential(2).replace("e+", "e");
  if (size >= 1000) return grouped(x);
  return Number(x.toPrecision(3)).toString();
}

/** 0.0123 as 12.3 ms. */
export function seconds(s: number): string {
  if (s === 0) return "0 s";
  if (s < 1e-6) return `${short(s * 1e9)} ns`;
  if (s < 1e-3) return `${short(s * 1e6)} µs`;
  if (s < 1) return `${short(s * 1e3)} ms`;
  return s < 600 ? `${short(s)} s` : `${short(s / 60)} min`;
}

/** 1536 as 1.54 kB; powers of ten. */
export function bytes(n: number): string {
  const units = ["B", "kB", "MB", "GB", "TB"];
  let k = 0;
  let x = n;
  while (x >= 1000 && k + 1 < units.length) {
    x /= 1000;
    ++k;
  }
  return `${k === 0 ? x.toString() : short(x)} ${units[k]}`;
}

/** 0.123 as 12.3 %. */
export const percent = (share: number): string => `${short(100 * share)} %`;

/** Sorted numbers as 0..4, 7. */
export function ranges(numbers: number[]): string {
  const parts: string[] = [];
  for (let k = 0; k < numbers.length; ) {
    let end = k;
    while (end + 1 < numbers.length && numbers[end + 1]! <= numbers[end]! + 1) ++end;
    parts.push(numbers[end] === numbers[k] ? `${numbers[k]}` : `${numbers[k]}..${numbers[end]}`);
    k = end + 1;
  }
  return parts.join(", ");
}

export const plural = (n: number, one: string, many = `${one}s`): string => `${grouped(n)} ${n === 1 ? one : many}`;

const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";
/** 10^k in print. */
export const powerOfTen = (k: number): string =>
  k >= 0 && k < 4 ? `${10 ** k}` : `10${k < 0 ? "⁻" : ""}${[...Math.abs(k).toString()].map((d) => superscripts[Number(d)]).join("")}`;
