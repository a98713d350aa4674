// A result as the structure that the parts of mmverify report draw.
import type { Report, ResultFile } from "../../../report/src/data";
import type { WrongCells } from "./messages";

/** `cells`: what the subject answers on the cells of levels, for the triangle of a counterexample. */
export function reportOf(name: string, content: ResultFile, subject = "", cells: WrongCells[] = []): Report {
  const { version, compiler, spec_hash, source_hash = "" } = content.tool;
  const again = content.results.flatMap((result, at) => {
    const c = result.counterexample;
    if (c === null || result.verdict !== "refuted" || cells.length === 0) return [];
    return [{ file: 0, result: at, same_source: true, holds: false, expected: String(c.expected), got: String(c.got), asked: 0 }];
  });
  return {
    schema: "mmverify.report/1",
    tool: { version, compiler, spec_hash, source_hash },
    files: [{ name, content }],
    asked: cells.length > 0 ? [{ subject, order: "curve", levels: cells }] : [],
    again,
    pictures: [],
  };
}
