// A table of answers as text: what `mmverify gen index` writes and `mmverify check index` reads.
import { coordinate } from "../../../report/src/cases";
import { curveIndex, microAt } from "../../../report/src/curve";
import type { WrongCells } from "../program/messages";

/** Lines "k u v" of `gen`. */
export function pointsOf(text: string): Map<number, { u: number; v: number }> {
  const points = new Map<number, { u: number; v: number }>();
  for (const line of text.split("\n")) {
    const [k, u, v] = line.trim().split(/\s+/);
    if (!k || k.startsWith("#") || u === undefined || v === undefined) continue;
    points.set(Number(k), { u: coordinate(u)!, v: coordinate(v)! });
  }
  return points;
}

/** The cells whose answers, lines "k index", are not the reference's. */
export function wrongAnswers(points: string, answers: string, level: number): WrongCells {
  const quarters = 4 * 2 ** level;
  const asked = pointsOf(points);
  const found: WrongCells = { level, cells: asked.size, wrong_cells: 0, wrong: [] };
  for (const line of answers.split("\n")) {
    const [k, answer] = line.trim().split(/\s+/);
    const point = asked.get(Number(k));
    if (!k || k.startsWith("#") || !point || answer === undefined || !/^\d+$/.test(answer)) continue;
    const m = microAt(point.u, point.v, level);
    const right = curveIndex(m.i, m.j, m.inverted, level);
    if (Number(answer) === right) continue;
    ++found.wrong_cells;
    found.wrong.push(point.u * quarters, point.v * quarters, right, Number(answer));
  }
  return found;
}
