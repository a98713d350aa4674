// Result files of the native program as a report.
import type { AnyBench, Report, ResultFile } from "../../../report/src/data";

export interface Named {
  name: string;
  text: string;
}

const shown = ["mmverify.result/1", "mmverify.bench/1"];
const takes = "The page shows what prove, scene, attributes, render, views and bench write with --json";

function parsed({ name, text }: Named): Record<string, unknown> {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch (error) {
    throw new Error(`${name}: no JSON: ${error instanceof Error ? error.message : String(error)}. ${takes}.`);
  }
  if (typeof value !== "object" || value === null || typeof (value as { schema?: unknown }).schema !== "string")
    throw new Error(`${name}: it has no "schema", so it is no result of mmverify. ${takes}.`);
  return value as Record<string, unknown>;
}

/** Throws an Error that names the file where one is no result. Its figures are the file's; no law runs again. */
export function reportOfFiles(all: readonly Named[]): Report {
  const values = all.map(parsed);
  const only = values[0]!;
  if (values.length === 1 && only["schema"] === "mmverify.report/1") return only as unknown as Report;
  const files = values.map((value, k) => {
    const { name } = all[k]!;
    if (!shown.includes(value["schema"] as string)) throw new Error(`${name}: its schema is ${String(value["schema"])}. ${takes}: ${shown.join(" and ")}.`);
    if (typeof value["tool"] !== "object" || value["tool"] === null) throw new Error(`${name}: it has no "tool"; is the file cut off?`);
    if (value["schema"] === shown[0] && !Array.isArray(value["results"])) throw new Error(`${name}: it has no "results"; is the file cut off?`);
    return { name, content: value as unknown as ResultFile | AnyBench };
  });
  const { version, compiler, spec_hash, source_hash = "" } = files[0]!.content.tool as ResultFile["tool"];
  return { schema: "mmverify.report/1", tool: { version, compiler, spec_hash, source_hash }, files, asked: [], again: [], pictures: [] };
}
