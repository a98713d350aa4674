// What `mmverify list --json` says, and whether a law can be run in a page.

export interface Law {
  law: string;
  topic: string;
  statement: string;
  source: string;
  domain: string;
  method: string;
  subjects: string[];
  companion: string | null;
  tiers: { fast: { levels: string; expected_seconds: number } | null; long: { levels: string } | null };
  mutants: string[];
}
export interface Listed {
  laws: Law[];
  subjects: { subject: string; about: string }[];
}

/** Null where it can be run here, else why not. */
export function whyNotHere({ method, tiers }: Law): string | null {
  if (method === "induction" || method === "bit vectors")
    return "A prover, z3, settles it for every level or every float at once, and z3 is not in this page. The native program has it.";
  if (!tiers.fast) return "Its domain is too large for a page: the long tier of the native program runs it, in minutes or hours.";
  return null;
}

/** The three lowest levels of the fast tier as --levels takes them; null where the law is not run level by level. */
export function smallLevels({ tiers }: Law): string | null {
  const range = /^(\d+)\.\.(\d+)$/.exec(tiers.fast?.levels ?? "");
  if (!range) return null;
  const [low, high] = [Number(range[1]), Number(range[2])];
  return `${low}..${Math.min(high, low + 2)}`;
}
