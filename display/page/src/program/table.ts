// An index function that is a table of answers, and keeps the points that it lacks.
import { curveIndex, microAt } from "../../../report/src/curve";
import type { Answered, Points } from "./messages";

export class Table {
  private readonly levels = new Map<number, Map<number, Map<number, number>>>();
  private readonly lacking = new Map<number, { u: number[]; v: number[] }>();

  constructor(given: readonly Answered[]) {
    for (const { level, u, v, index } of given) for (let k = 0; k < index.length; ++k) this.put(level, u[k]!, v[k]!, index[k]!);
  }

  private put(level: number, u: number, v: number, index: number): void {
    const us = this.levels.get(level) ?? new Map<number, Map<number, number>>();
    this.levels.set(level, us);
    const vs = us.get(u) ?? new Map<number, number>();
    us.set(u, vs);
    vs.set(v, index);
  }

  /** A point that is lacking is answered as the reference would, so that the run goes on. */
  answer(level: number, u: number, v: number): number {
    const known = this.levels.get(level)?.get(u)?.get(v);
    if (known !== undefined) return known;
    const some = this.lacking.get(level) ?? { u: [], v: [] };
    this.lacking.set(level, some);
    some.u.push(u);
    some.v.push(v);
    const m = microAt(u, v, level);
    const right = curveIndex(m.i, m.j, m.inverted, level);
    this.put(level, u, v, right);
    return right;
  }

  missing(): Points[] {
    return [...this.lacking].map(([level, { u, v }]) => ({ level, u: Float32Array.from(u), v: Float32Array.from(v) }));
  }
}
