// What the page and its worker say to each other.

/** One run of the program. */
export interface Run {
  kind: "run";
  args: readonly string[];
  /** By their absolute names. */
  files?: Record<string, Uint8Array>;
  wanted?: readonly string[];
  stdin?: string;
}

/** Laws asked of the function under test, and its answers on every cell of levels 0..highest. */
export interface Judge {
  kind: "judge";
  args: readonly string[];
  highest: number;
  /** The verdict's words about the numbers that the function computes in. */
  arithmetic: string;
  /** In the place of a function: answers that were had elsewhere. */
  table?: Answered[];
}

/** Points of one level and the indices that were answered for them. */
export interface Points {
  level: number;
  u: Float32Array;
  v: Float32Array;
}
export interface Answered extends Points {
  index: Uint32Array;
}

export type Ask = (Run | Judge) & { module: WebAssembly.Module };

export interface Ended {
  code: number;
  stdout: string;
  stderr: string;
  files: Record<string, Uint8Array>;
}

/** The wrong cells of a level: four numbers each, 4N u, 4N v, the right index, the one that was answered. */
export interface WrongCells {
  level: number;
  cells: number;
  wrong_cells: number;
  wrong: number[];
}

export interface Judged extends Ended {
  cells: WrongCells[];
  /** Points that the table lacks; the verdict stands where there are none. */
  missing: Points[];
}

export type Reply = { ended: Ended | Judged } | { failed: string };
