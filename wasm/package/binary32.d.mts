/** The values of the names that rewritten text uses without declaring them. */
export const scope: Record<string, unknown>;
export const scopeNames: string[];
/** What a verdict says of the numbers that it is about. */
export const arithmeticWords: { binary32: string; binary64: string };
