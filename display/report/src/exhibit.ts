// What there is to show of one refuted law and subject, gathered from its results and from what was asked again.
import { type Answers, answersOf } from "./answers";
import { type CasePoint, differsAt, indexOfCase, mapOf, pointOf, squareOf } from "./cases";
import { indexOf, microAt, type Order } from "./curve";
import type { Again, Report } from "./data";
import { counterexamplesOf, type Found, type Group } from "./verdicts";

export interface Counter extends Found {
  /** Of the level on which it is shown. */
  shownAt: number;
  point: CasePoint | null;
  /** Micro-triangles, where expected and got are such. */
  right: number | null;
  wrong: number | null;
  /** The micro-triangle that it is about, where it names one. */
  about: number | null;
}

export interface States {
  level: number;
  expected: string;
  /** Null where only the map that was asked about is known. */
  got: string | null;
}

export interface Exhibit {
  group: Group;
  order: Order;
  counters: Counter[];
  answers: Map<number, Answers>;
  /** By level: of that level's simplest counterexample. */
  states: Map<number, States>;
  square: { side: number; letters: string } | null;
  picture: string | null;
  /** What cannot be shown and why, and what asking again said. */
  words: string[];
}

/** The micro-triangle that a text means; null where it means none of this level. */
function microIndex(text: string | number | undefined, level: number): number | null {
  if (text === undefined || !/^\d{1,10}$/.test(String(text))) return null;
  const index = Number(text);
  return index < 4 ** level ? index : null;
}

function counter(found: Found, order: Order): Counter {
  const { counterexample: c } = found;
  const level = found.level ?? 0;
  const point = pointOf(c.case);
  const counter: Counter = { ...found, shownAt: level, point, right: null, wrong: null, about: null };
  const named = indexOfCase(c.case);
  if (named !== null && named < 4 ** level) counter.about = named;
  // Expected is a micro-triangle where it is the one that holds the point.
  if (point && level <= 16 && point.u >= 0 && point.v >= 0 && point.u + point.v <= 1) {
    const own = order === "curve" ? indexOf(microAt(point.u, point.v, level), level, order) : null;
    const expected = microIndex(c.expected, level);
    if (expected !== null && (own === null || own === expected)) {
      counter.right = expected;
      counter.wrong = microIndex(c.got, level);
    }
  }
  return counter;
}

function askedAgain(again: Again | undefined, found: Found, words: string[]): void {
  if (!again) {
    words.push("Its answers were not asked again when this page was made: they are in no result file.");
    return;
  }
  if (again.why) {
    words.push(`Its answers were not asked again: ${again.why}.`);
    return;
  }
  if (!again.same_source) words.push("The program that made this page is of other source than the one that was run; its answers may differ.");
  const { counterexample: c } = found;
  if (again.holds === true) words.push("Asked again, this program's subject of that name is right on the counterexample: it is not the one that was refuted.");
  else if (again.holds === false && (again.expected !== String(c.expected) || again.got !== String(c.got)))
    words.push(`Asked again, it expected ${again.expected} and got ${again.got}, which is not what the file says.`);
}

export function exhibit(report: Report, group: Group): Exhibit {
  const found = counterexamplesOf(group);
  const agains = report.again.filter((a) => a.file === group.run.file && group.results.some((r) => r.at === a.result));
  const asked = agains.map((a) => a.asked).find((k) => k !== undefined);
  const answers = new Map((asked === undefined ? [] : report.asked[asked]!.levels).map((l) => [l.level, answersOf(l)]));
  const order: Order = asked === undefined ? "curve" : report.asked[asked]!.order;
  const words: string[] = [];
  const first = found[0];
  if (first) askedAgain(agains.find((a) => a.result === first.at), first, words);

  const counters = found.filter((f) => f.level !== null && f.level <= 16).map((f) => counter(f, order));
  const states = new Map<number, States>();
  let partly = false;
  for (const c of counters) {
    if (states.has(c.shownAt)) continue;
    const at = differsAt(String(c.counterexample.expected));
    const of = agains.find((a) => a.result === c.at)?.states;
    const map = mapOf(c.counterexample.case, c.shownAt);
    if (of) states.set(of.level, of);
    else if (map) {
      states.set(c.shownAt, { level: c.shownAt, expected: map, got: null });
      partly = true;
    } else continue;
    if (at !== null && at < 4 ** c.shownAt) c.about = at;
  }
  if (partly) words.push("The colours are the states of the map that was asked about; what the subject made of it is known for the counterexample only.");
  if (counters.length > 0 && counters.every((c) => c.point === null && c.about === null) && states.size === 0)
    words.push("The triangle has the order of its micro-triangles alone: nothing of this counterexample lies on it.");
  const square = first ? squareOf(first.counterexample.case) : null;
  return { group, order, counters, answers, states, square, picture: agains.find((a) => a.picture)?.picture ?? null, words };
}
