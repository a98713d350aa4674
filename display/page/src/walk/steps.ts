// Steps of somebody who walks on the triangle, by keys. Places are 4N u and 4N v, whole numbers.
import { type Micro, microAt, microOfIndex, indexOf, type Order } from "../../../report/src/curve";

export interface At {
  ku: number;
  kv: number;
}

export const middleOf = (m: Micro): At => (m.inverted ? { ku: 4 * m.i + 3, kv: 4 * m.j + 3 } : { ku: 4 * m.i + 1, kv: 4 * m.j + 1 });

export function microOf(at: At, level: number): Micro {
  const quarters = 4 * 2 ** level;
  return microAt(at.ku / quarters, at.kv / quarters, level);
}

const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** A quarter of a micro-triangle's side along u or v: over vertices, edges and insides. Null where the key is no step. */
export function quarterStep(at: At, key: string, level: number): At | null {
  const arrow = arrows[key];
  if (!arrow) return null;
  const next = { ku: at.ku + arrow[0], kv: at.kv + arrow[1] };
  return next.ku < 0 || next.kv < 0 || next.ku + next.kv > 4 * 2 ** level ? at : next;
}

/** From one micro-triangle to another: left and right across an edge of the row, up and down to the next row. */
export function microStep(at: At, key: string, level: number): At | null {
  const arrow = arrows[key];
  if (!arrow) return null;
  const N = 2 ** level;
  const { i, j, inverted } = microOf(at, level);
  const next: Micro =
    arrow[1] !== 0
      ? { i, j: j + arrow[1], inverted }
      : arrow[0] > 0
        ? { i: inverted ? i + 1 : i, j, inverted: !inverted }
        : { i: inverted ? i : i - 1, j, inverted: !inverted };
  if (arrow[1] > 0 && next.i + next.j + (inverted ? 1 : 0) > N - 1) next.i -= 1;
  const fits = next.i >= 0 && next.j >= 0 && next.i + next.j + (next.inverted ? 1 : 0) <= N - 1;
  return fits ? middleOf(next) : at;
}

/** To the one before or after in the order. */
export function orderStep(at: At, by: number, level: number, order: Order): At {
  const next = indexOf(microOf(at, level), level, order) + by;
  return next < 0 || next >= 4 ** level ? at : middleOf(microOfIndex(next, level, order));
}

/** The same place at another level, as near as that level has it. */
export function atLevel(at: At, from: number, to: number): At {
  const times = 2 ** (to - from);
  const quarters = 4 * 2 ** to;
  const ku = Math.min(Math.round(at.ku * times), quarters);
  return { ku, kv: Math.min(Math.round(at.kv * times), quarters - ku) };
}
