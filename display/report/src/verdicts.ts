// Results of one law on one subject, put together; and what verdicts are called and look like.
import type { Counterexample, Result, Run, Verdict } from "./data";
import { ranges } from "./format";

/** Worst first. */
export const verdicts: readonly Verdict[] = ["refuted", "broken", "incomplete", "not_applicable", "checked", "proved"];

export const verdictLook: Record<Verdict, { sign: string; words: string; means: string }> = {
  refuted: { sign: "✗", words: "refuted", means: "a case was found on which the law fails" },
  broken: { sign: "!", words: "broken", means: "the subject crashed, hung, overran or changed its mind" },
  incomplete: { sign: "…", words: "incomplete", means: "stopped before its end" },
  not_applicable: { sign: "–", words: "not applicable", means: "the law is not about this subject or level" },
  checked: { sign: "≈", words: "checked", means: "a sample passed; no proof" },
  proved: { sign: "✓", words: "proved", means: "every case of the named domain was run, or a prover settled it" },
};

export interface Group {
  run: Run;
  law: string;
  topic: string;
  subject: string;
  verdict: Verdict;
  /** With the place of each in its file. */
  results: { result: Result; at: number }[];
  cases: number;
  mismatches: number;
  seconds: number;
}

/** As weak as its weakest level; levels to which a law does not apply do not count beside those to which it does. */
function overall(results: Result[]): Verdict {
  const that = results.filter((r) => r.verdict !== "not_applicable");
  return verdicts.find((v) => (that.length > 0 ? that : results).some((r) => r.verdict === v)) ?? "incomplete";
}

export function groups(runs: readonly Run[]): Group[] {
  const found = new Map<string, Group>();
  for (const run of runs)
    run.content.results.forEach((result, at) => {
      const key = JSON.stringify([run.file, result.law, result.subject]);
      let group = found.get(key);
      if (!group) {
        const { law, topic, subject } = result;
        group = { run, law, topic, subject, verdict: "proved", results: [], cases: 0, mismatches: 0, seconds: 0 };
        found.set(key, group);
      }
      group.results.push({ result, at });
      group.cases += result.cases_run;
      group.mismatches += result.mismatches;
      group.seconds += result.seconds;
    });
  for (const group of found.values()) group.verdict = overall(group.results.map((r) => r.result));
  return [...found.values()];
}

export function levelsOf(group: Group): number[] {
  const levels = group.results.flatMap((r) => (r.result.level === null ? [] : [r.result.level]));
  return [...new Set(levels)].sort((a, b) => a - b);
}

export const levelsText = (group: Group): string =>
  group.results.some((r) => r.result.level === null) ? "many at once" : ranges(levelsOf(group));

export interface Found {
  counterexample: Counterexample;
  level: number | null;
  result: Result;
  /** Its place in the file. */
  at: number;
}

/** The counterexamples of all levels, the lowest level's first. */
export const counterexamplesOf = (group: Group): Found[] =>
  group.results
    .flatMap(({ result, at }) =>
      [result.counterexample, ...(result.more_counterexamples ?? [])].flatMap((c) =>
        c === null ? [] : [{ counterexample: c, level: c.level ?? result.level, result, at }],
      ),
    )
    .sort((a, b) => (a.level ?? 0) - (b.level ?? 0));
