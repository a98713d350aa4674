// What the colours of micro-triangles mean: the place in the order, right or wrong, states.
import type { Answers } from "./answers";
import { place } from "./answers";
import { curveIndex, type Order, rowIndex } from "./curve";
import type { Exhibit, States } from "./exhibit";
import { ranges } from "./format";
import { gradient, scheme, wordOf } from "./palette";
import type { Fill } from "./raster";

export type Mode = "order" | "answers" | "expected" | "got" | "difference";

export const modeWords: Record<Mode, string> = {
  order: "place in the order",
  answers: "right or wrong",
  expected: "states, as they should be",
  got: "states, as the subject has them",
  difference: "states, right or wrong",
};

export interface Colouring {
  fills: readonly Fill[];
  kind: (i: number, j: number, inverted: boolean) => number;
  legend: { fill: Fill; words: string }[];
  /** Why the colours do not say what was asked for. */
  words: string | null;
}

const plain = (hex: string): Fill => ({ pattern: "plain", paper: wordOf(hex), ink: wordOf(hex) });
const two = (pattern: Fill["pattern"], paper: string, ink: string): Fill => ({ pattern, paper: wordOf(paper), ink: wordOf(ink) });

function looks() {
  return scheme() === "dark"
    ? {
        right: plain("#1d3f56"),
        wrong: two("hatch", "#3a2a20", "#ff8d3f"),
        unknown: two("rows", "#2a2a2a", "#4a4a4a"),
        states: [plain("#26292c"), plain("#56b4e9"), two("dots", "#26292c", "#f0c64a"), two("hatch", "#7a5c14", "#f0c64a")],
      }
    : {
        right: plain("#cfe4f2"),
        wrong: two("hatch", "#fdeee4", "#d55e00"),
        unknown: two("rows", "#f2f2f2", "#c9c9c9"),
        states: [plain("#f6f6f2"), plain("#0072b2"), two("dots", "#fbf3df", "#b07d00"), two("hatch", "#f3dfae", "#b07d00")],
      };
}

const stateWords = ["T transparent", "O opaque", "UT unknown, transparent", "UO unknown, opaque"];

/** The modes that there is anything for. */
export function modesOf(e: Exhibit): Mode[] {
  const modes: Mode[] = [];
  if (e.answers.size > 0) modes.push("answers");
  if (e.states.size > 0) {
    if ([...e.states.values()].some((s) => s.got !== null)) modes.push("difference", "got");
    modes.push("expected");
  }
  modes.push("order");
  return modes;
}

function byOrder(level: number, order: Order): Colouring {
  const words = gradient();
  const fills = [...words].map((w): Fill => ({ pattern: "plain", paper: w, ink: w }));
  const times = 256 / 4 ** level;
  return {
    fills,
    kind:
      order === "curve"
        ? (i, j, inverted) => Math.floor(curveIndex(i, j, inverted, level) * times)
        : (i, j, inverted) => Math.floor(rowIndex(i, j, inverted) * times),
    legend: [
      { fill: fills[0]!, words: "first" },
      { fill: fills[128]!, words: "in the middle" },
      { fill: fills[255]!, words: "last" },
    ],
    words: null,
  };
}

function byAnswers(level: number, answers: Answers | undefined): Colouring {
  const { right, wrong, unknown } = looks();
  const legend = [
    { fill: right, words: "right inside" },
    { fill: wrong, words: "wrong inside" },
  ];
  if (!answers)
    return { fills: [unknown], kind: () => 0, legend: [{ fill: unknown, words: "not asked" }], words: `The subject was not asked on level ${level}.` };
  const { inside, all, known } = answers;
  return {
    fills: [right, wrong, unknown],
    kind: all
      ? (i, j, inverted) => (inside.has(place(i, j, inverted, level)) ? 1 : 0)
      : (i, j, inverted) => (inside.has(place(i, j, inverted, level)) ? 1 : known(i, j) ? 0 : 2),
    legend: all ? legend : [...legend, { fill: unknown, words: "asked, not listed" }],
    words: all ? null : "Of this level the page has the wrong cells around the counterexample only.",
  };
}

function byStates(level: number, mode: Mode, all: Map<number, States>): Colouring {
  const { right, wrong, unknown, states: fills } = looks();
  const states = all.get(level);
  if (!states) return { fills: [unknown], kind: () => 0, legend: [], words: `The states are of level ${ranges([...all.keys()])}.` };
  if (mode === "difference")
    return {
      fills: [right, wrong],
      kind: (i, j, inverted) => {
        const k = curveIndex(i, j, inverted, level);
        return states.expected[k] === states.got?.[k] ? 0 : 1;
      },
      legend: [
        { fill: right, words: "the right state" },
        { fill: wrong, words: "another one" },
      ],
      words: null,
    };
  const digits = (mode === "got" ? states.got : null) ?? states.expected;
  const kinds = Uint8Array.from(digits, Number);
  return {
    fills,
    kind: (i, j, inverted) => kinds[curveIndex(i, j, inverted, level)]!,
    legend: fills.map((fill, k) => ({ fill, words: stateWords[k]! })),
    words: null,
  };
}

export function colouring(e: Exhibit, mode: Mode, level: number): Colouring {
  if (mode === "answers") return byAnswers(level, e.answers.get(level));
  if (mode !== "order" && e.states.size > 0) return byStates(level, mode, e.states);
  return byOrder(level, e.order);
}

export const stateName = (digit: string): string => stateWords[Number(digit)] ?? digit;
export const stateFills = (): Fill[] => looks().states;
