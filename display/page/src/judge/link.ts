// A case of a function as an address of the page: what is after its #.
import type { Language } from "./examples";

export interface Case {
  language: Language;
  code: string;
  numbers: "binary32" | "binary64";
  /** The highest level that is asked. */
  levels: number;
  /** Whether a million floats a level are asked, too. */
  floats: boolean;
  /** The refuted law, the level of its counterexample, and the counterexample's text. */
  law: string;
  level: number;
  case: string;
}

const head = "#case=";
/** More than any function that a person pastes; less than browsers take as an address. */
const mostBytes = 200_000;

async function through(bytes: Uint8Array<ArrayBuffer>, by: CompressionStream | DecompressionStream): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(by).getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  for (let read = await reader.read(); !read.done; read = await reader.read()) {
    parts.push(read.value as Uint8Array<ArrayBuffer>);
    size += read.value.length;
    if (size > mostBytes) throw new Error("it holds more than a function");
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** deflate, then base64 with the letters that an address may have. */
export async function addressOf(of: Case): Promise<string> {
  const packed = await through(new TextEncoder().encode(JSON.stringify(of)), new CompressionStream("deflate"));
  const text = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(""));
  return head + text.replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

const isCase = (value: unknown): value is Case => {
  const c = value as Case;
  return (
    typeof c === "object" && c !== null && ["JavaScript", "WGSL"].includes(c.language) && ["binary32", "binary64"].includes(c.numbers) &&
    [c.code, c.law, c.case].every((text) => typeof text === "string") && typeof c.floats === "boolean" && [c.levels, c.level].every((n) => Number.isInteger(n) && n >= 0 && n <= 16)
  );
};

/** Null where the address has no case. Throws an Error where it has one that cannot be read. */
export async function caseOf(hash: string): Promise<Case | null> {
  if (!hash.startsWith(head)) return null;
  try {
    const text = atob(hash.slice(head.length).replace(/-/g, "+").replace(/_/g, "/"));
    const packed = Uint8Array.from(text, (c) => c.charCodeAt(0));
    const value: unknown = JSON.parse(new TextDecoder().decode(await through(packed, new DecompressionStream("deflate"))));
    if (isCase(value)) return value;
  } catch {
    // A link that was cut off: said below.
  }
  throw new Error("This link's case cannot be read: the address is cut off, or another program wrote it.");
}
