/** The text of a script or a module with each operation rounded to binary32. Throws CannotRound, with the line. */
export function inBinary32(text: string, sourceType?: "module" | "script"): string;
/** What `export const arithmetic = "..."` of a module says; undefined where it says nothing. */
export function declaredArithmetic(text: string): unknown;
/** What of a script cannot be judged in binary32, by its line. */
export class CannotRound extends Error {}
