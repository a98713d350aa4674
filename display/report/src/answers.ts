// A subject's answers on all cells of a level, against the right ones.
import type { AskedLevel } from "./data";

export interface Edge {
  /** Ends, on the grid of the level. */
  i0: number;
  j0: number;
  i1: number;
  j1: number;
  right: number;
  got: number;
}

export interface Vertex {
  i: number;
  j: number;
  right: number;
  got: number;
}

export interface Answers {
  level: number;
  cells: number;
  wrongCells: number;
  /** Whether all that is wrong in a grid square is known. */
  known: (i: number, j: number) => boolean;
  /** Whether that is so of all of them. */
  all: boolean;
  /** By place(): the answer inside a micro-triangle that should have given its own index. */
  inside: Map<number, { right: number; got: number }>;
  edges: Edge[];
  vertices: Vertex[];
}

/** A number for a micro-triangle of level n. */
export const place = (i: number, j: number, inverted: boolean, n: number): number => (j * 2 ** n + i) * 2 + (inverted ? 1 : 0);

/** Cells are given by 4N u and 4N v of their representative: a vertex has both divisible by 4, an upright micro-triangle
 * leaves 1 and 1, an inverted one 3 and 3, an edge 2 in one or in both. */
export function answersOf(asked: AskedLevel): Answers {
  const { level, cells, wrong, window } = asked;
  const answers: Answers = {
    level,
    cells,
    wrongCells: asked.wrong_cells,
    known: window ? (i, j) => 4 * i >= window[0] && 4 * i + 4 <= window[1] && 4 * j >= window[2] && 4 * j + 4 <= window[3] : () => true,
    all: !window,
    inside: new Map(),
    edges: [],
    vertices: [],
  };
  for (let k = 0; k + 3 < wrong.length; k += 4) {
    const ku = wrong[k]!, kv = wrong[k + 1]!, right = wrong[k + 2]!, got = wrong[k + 3]!;
    const i = Math.floor(ku / 4), j = Math.floor(kv / 4);
    const a = ku % 4, b = kv % 4;
    if (a % 2 === 1) answers.inside.set(place(i, j, a === 3, level), { right, got });
    else if (a === 0 && b === 0) answers.vertices.push({ i, j, right, got });
    else if (a === 2 && b === 2) answers.edges.push({ i0: i + 1, j0: j, i1: i, j1: j + 1, right, got });
    else answers.edges.push(a === 2 ? { i0: i, j0: j, i1: i + 1, j1: j, right, got } : { i0: i, j0: j, i1: i, j1: j + 1, right, got });
  }
  return answers;
}
