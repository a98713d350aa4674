// What the page is given: the result files as they are, and what was asked again when the page was made.

export type Verdict = "proved" | "refuted" | "checked" | "broken" | "not_applicable" | "incomplete";

export interface Counterexample {
  case: string;
  level?: number | null;
  hex?: string;
  expected?: string | number;
  got?: string | number;
  replay?: string;
}

export interface Result {
  law: string;
  topic: string;
  subject: string;
  level: number | null;
  method: string;
  domain: string;
  verdict: Verdict;
  reason?: string;
  cases_expected: number;
  cases_run: number;
  mismatches: number;
  counterexample: Counterexample | null;
  more_counterexamples?: Counterexample[];
  seconds: number;
}

export interface Tool {
  version: string;
  compiler: string;
  flags: string;
  cpu?: string;
  threads?: number;
  seed: number;
  spec_hash: string;
  source_hash?: string;
  samples?: number;
  rounds?: number;
  maps?: string;
}

export interface FootprintMode {
  states: 2 | 4;
  micromaps: number;
  data_bytes: number;
  tree_bytes: number;
  random_access_tree_bytes: number;
  bitmask_bytes: number;
}

export interface Footprint {
  micromaps: number;
  special_indices: number;
  record_bytes: number;
  index_bytes: number;
  array_data_bytes: number;
  texture_bytes: number;
  vertex_data_bytes: number;
  modes: FootprintMode[];
}

export interface Saved {
  area: number;
  transparent: number;
  opaque: number;
  unknown: number;
}

export interface SquareMaps {
  maps: number;
  uniform: number;
  bytes: number;
  regions: number;
  unknown: number;
  substitutions: number;
}

export interface Scene {
  file: string;
  plan: {
    triangles: number;
    triangles_placed: number;
    baked_triangles: number;
    baked_triangles_placed: number;
    distinct_triangles: number;
    reordered_triangles: number;
    surfaces: { image: string; width: number; height: number; mode: string; cutoff: number; factor: number; filter?: string }[];
    left_out: { mesh: number; primitive: number; triangles: number; why: string }[];
    left_out_laws?: { what: string; why: string }[];
  };
  bake?: {
    micro_triangles: number;
    leaves: number;
    exact: number;
    triangles_by_level: Record<string, number>;
    lowered: number;
    states: { T: number; O: number; UT: number; UO: number };
    load_seconds: number;
    bake_seconds: number;
  };
  saved?: Saved;
  footprint?: Footprint;
  pairs?: { pairs: number; distinct: number; unpaired: number };
  vq2?: SquareMaps;
  vq4?: SquareMaps;
  sizes?: { level: number; footprint: Footprint; saved: Saved }[];
}

export interface ResultFile {
  schema: "mmverify.result/1";
  tool: Tool;
  results: Result[];
  mutants?: { law: string; mutant: string; killed: boolean; level?: number | null; case?: string | null }[];
  diagnoses?: { law: string; subject: string; lines: string[] }[];
  shard?: { number: number; of: number; finished: boolean };
  scene?: Scene;
}

interface Bench {
  schema: "mmverify.bench/1";
}

export interface IndexErrors {
  level: number;
  inputs: string;
  samples: number;
  mismatches: number;
}

export interface IndexBench extends Bench {
  topic: "index";
  tool: Tool;
  rows: { subject: string; level: number; ns_per_index: number }[];
  subjects: { subject: string; numbers: string; order: string; errors: IndexErrors[] }[];
}

export interface TreeBench extends Bench {
  topic: "tree";
  tool: Tool;
  rows: {
    states: number;
    level: number;
    forms: { form: string; bits_per_micro_triangle: number; ns_per_lookup: number }[];
  }[];
}

export interface VqEncoded {
  encoder: string;
  substitutions: number;
  savings: number;
  ms: number;
}

export interface VqRow {
  map: string;
  states_16: number;
  states_32: number;
  savings: { "64x2": number; "8x8": number; "16x16": number; "32x32": number };
  vq2: VqEncoded[];
  vq4: VqEncoded[];
}

export interface VqBench extends Bench {
  topic: "vq";
  tool: Tool;
  rows: VqRow[];
}

export interface BakeBench extends Bench {
  topic: "bake";
  tool: Tool;
  rows: {
    level: number;
    bakers: { baker: string; states: number; wrong: number; needless: number; ns: number }[];
  }[];
}

export interface SweepBench extends Bench {
  topic: "sweep";
  threads: number;
  levels: {
    level: number;
    cells: number;
    plain_per_second?: number;
    step: { seconds: number };
    impl: { seconds: number };
  }[];
}

export interface SubjectBench extends Bench {
  topic: "subject";
  subject: string;
  level: number;
  bare_ns: number;
  isolated_ns: number;
  judged_ns: number;
}

export interface SceneBench extends Bench {
  topic: "scene";
  file: string;
  rows: { level: number; fastest_ns: number; centre_ns: number }[];
}

export type AnyBench = IndexBench | TreeBench | VqBench | BakeBench | SweepBench | SubjectBench | SceneBench;

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

export interface Report {
  schema: "mmverify.report/1";
  tool: { version: string; compiler: string; spec_hash: string; source_hash: string };
  files: { name: string; content: ResultFile | AnyBench }[];
  asked: Asked[];
  again: Again[];
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
): { name: string; content: Extract<AnyBench, { topic: T }> }[] {
  return report.files.flatMap((f) =>
    f.content.schema === "mmverify.bench/1" && f.content.topic === topic
      ? [{ name: f.name, content: f.content as Extract<AnyBench, { topic: T }> }]
      : [],
  );
}

export const scenes = (report: Report): { name: string; scene: Scene }[] =>
  runs(report).flatMap((run) => (run.content.scene ? [{ name: run.name, scene: run.content.scene }] : []));
