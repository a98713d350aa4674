// What the page is given: the result files, and what was asked again when the page was made.
// The types of the files are made of their schemas by display/report/types.mjs.
import type * as bench from "mmverify/bench";
import type { Counterexample, File as ResultFile, Footprint, Result, Saved, Scene } from "mmverify/result";

export type { Counterexample, Footprint, Result, ResultFile, Saved, Scene };
export type Verdict = Result["verdict"];
export type AnyBench = bench.Run;
export type Tool = ResultFile["tool"] | AnyBench["tool"];
export type IndexBench = bench.Index;
export type TreeBench = bench.Tree;
export type VqBench = bench.Vq;
export type BakeBench = bench.Bake;
export type AttributeBench = bench.Attribute;
export type SceneAttributes = bench.SceneAttributes;
export type Rendered = bench.Render;
export type RenderedRow = Rendered["rows"][number];
export type RenderedBlend = NonNullable<Rendered["blends"]>[number];
export type RenderPath = bench.RenderPath;
export type Views = bench.Views;
export type AttributeRow = SceneAttributes["rows"][number];
export type VqRow = VqBench["rows"][number];
export type VqEncoded = VqRow["vq2"][number];

/** What a subject of topic index answered on all cells of a level, where it differs from the right answer. */
export interface AskedLevel {
  level: number;
  cells: number;
  wrong_cells: number;
  /** Where all wrong cells are listed: 4N u from and to, 4N v from and to. Everywhere where it is missing. */
  window?: [number, number, number, number];
  /** Four numbers a wrong cell: 4N u, 4N v, the right index, the subject's. */
  wrong: number[];
}

export interface Asked {
  subject: string;
  order: "curve" | "rows";
  levels: AskedLevel[];
}

/** A refuted result, asked again of the same built-in subject when the page was made. */
export interface Again {
  file: number;
  result: number;
  /** Whether the program that asked again is of the very source that the result was made by. */
  same_source: boolean;
  /** Why nothing was asked. */
  why?: string;
  holds?: boolean;
  expected?: string;
  got?: string;
  asked?: number;
  picture?: string;
  /** The states of all micro-triangles, a digit each, 0 to 3, in the order of the index. */
  states?: { level: number; expected: string; got: string };
}

/** A picture that a run of attributes, rays or views names, as it was found when the page was made. */
export interface Pictured {
  file: number;
  /** Its number among the run's pictures; of views, its row's. */
  picture: number;
  /** In base64. */
  png?: string;
  /** Why it is not there. */
  why?: string;
}

export interface Report {
  schema: "mmverify.report/1";
  tool: { version: string; compiler: string; spec_hash: string; source_hash: string };
  files: { name: string; content: ResultFile | AnyBench }[];
  asked: Asked[];
  again: Again[];
  pictures: Pictured[];
}

export interface Run {
  file: number;
  name: string;
  content: ResultFile;
}

export const runs = (report: Report): Run[] =>
  report.files.flatMap((f, file) =>
    f.content.schema === "mmverify.result/1" ? [{ file, name: f.name, content: f.content }] : [],
  );

export function benches<T extends AnyBench["topic"]>(
  report: Report,
  topic: T,
): { file: number; name: string; content: Extract<AnyBench, { topic: T }> }[] {
  return report.files.flatMap((f, file) =>
    f.content.schema === "mmverify.bench/1" && f.content.topic === topic
      ? [{ file, name: f.name, content: f.content as Extract<AnyBench, { topic: T }> }]
      : [],
  );
}

export const scenes = (report: Report): { name: string; scene: Scene }[] =>
  runs(report).flatMap((run) => (run.content.scene ? [{ name: run.name, scene: run.content.scene }] : []));
