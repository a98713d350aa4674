/** The values of the names that rewritten text uses without declaring them. */
export const scope: Record<string, unknown>;
export const scopeNames: string[];
/** The words of a verdict about the numbers that it is about. */
export const arithmeticWords: { binary32: string; binary64: string };
