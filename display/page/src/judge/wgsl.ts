// A verdict on WGSL: the laws' points are collected, asked on the GPU, and the laws are run on the table of answers, until
// no law asks a point that is not in it.
import { judgeFunction, type Task } from "../program/client";
import type { Answered, Judge, Judged } from "../program/messages";
import { Shader } from "./gpu";

/** Laws look for a simpler counterexample once they have one, so a second round has points of its own. */
const mostRounds = 12;

export function judgeWgsl(ask: Omit<Judge, "kind" | "table">, code: string, seconds: number): Task<Judged> {
  let stop: (why: string) => void = () => undefined;
  const stopped = new Promise<never>((_, reject) => (stop = (why) => reject(new Error(why))));
  let now: Task<Judged> | undefined;
  const rounds = async (): Promise<Judged> => {
    const shader = await Shader.compile(code);
    try {
      const table: Answered[] = [];
      for (let round = 0; round < mostRounds; ++round) {
        now = judgeFunction({ ...ask, table }, null, "binary32", seconds);
        const judged = await now.done;
        if (judged.missing.length === 0) return judged;
        for (const points of judged.missing) table.push(await shader.ask(points));
      }
      throw new Error(`after ${mostRounds} rounds the laws still ask points that were not answered`);
    } finally {
      shader.end();
    }
  };
  const timer = window.setTimeout(() => stop(`stopped after ${seconds} s, which is the time limit`), 1000 * seconds);
  const done = Promise.race([rounds(), stopped]).finally(() => {
    clearTimeout(timer);
    now?.stop("stopped");
  });
  return { done, stop };
}
