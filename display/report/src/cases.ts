// What a counterexample's case says, as far as a triangle can show it.

export interface CasePoint {
  u: number;
  v: number;
  /** As written: "3/8". */
  uText: string;
  vText: string;
}

/** Hexadecimal floats, fractions, decimals. */
export function coordinate(text: string): number | null {
  const fraction = /^([+-]?\d+)(?:\/(\d+))?$/.exec(text);
  if (fraction) return Number(fraction[1]) / (fraction[2] === undefined ? 1 : Number(fraction[2]));
  const hex = /^([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)p([+-]?\d+)$/i.exec(text);
  if (hex && hex[2]! + hex[3]! !== "") {
    const digits = Number.parseInt(hex[2]! + hex[3]!, 16);
    return (hex[1] === "-" ? -1 : 1) * digits * 2 ** (Number(hex[4]) - 4 * hex[3]!.length);
  }
  if (/^[+-]?\d*\.?\d+(e[+-]?\d+)?$/i.test(text)) return Number(text);
  return null;
}

/** "e:u=3/8,v=5/16": a point. */
export function pointOf(at: string): CasePoint | null {
  const m = /^(?:[vei]:)?u=([^,\s]+),v=([^,\s]+)$/.exec(at);
  if (!m) return null;
  const u = coordinate(m[1]!);
  const v = coordinate(m[2]!);
  if (u === null || v === null || !Number.isFinite(u) || !Number.isFinite(v)) return null;
  return { u, v, uText: m[1]!, vText: m[2]! };
}

/** "k=22": an index. */
export function indexOfCase(at: string): number | null {
  const m = /^k=(\d{1,10})$/.exec(at);
  return m ? Number(m[1]) : null;
}

/** "4-state:0123...": a map of one level, a digit a micro-triangle. */
export function mapOf(at: string, level: number): string | null {
  const m = /^[24]-state:([0-3]+)$/.exec(at);
  return m && m[1]!.length === 4 ** level ? m[1]! : null;
}

/** A square map of 16 x 16 or 32 x 32 regions in the letters T, C and O. */
export function squareOf(at: string): { side: number; letters: string } | null {
  const side = Math.sqrt(at.length);
  return /^[TCO]+$/.test(at) && (side === 16 || side === 32) ? { side, letters: at } : null;
}

/** "state 3 1" in what a law of maps expected: which micro-triangle. */
export function differsAt(expected: string): number | null {
  const m = /^(?:state|micro-triangle|index) (\d{1,8}) /.exec(expected);
  return m ? Number(m[1]) : null;
}
