/** The text of a script or a module with each operation rounded to binary32. Throws CannotRound, with the line. */
export function inBinary32(text: string, sourceType?: "module" | "script"): string;
/** The value of a module's `export const arithmetic = "..."`; undefined where it has none. */
export function declaredArithmetic(text: string): unknown;
/** Names what cannot be rounded, by its line. */
export class CannotRound extends Error {}
