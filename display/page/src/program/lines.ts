// The line of the function under test at which an error was thrown.

/** The error, its words beginning with the line of the function; `linesBefore` of the worker's lines stand above it. */
export function withLine(error: unknown, linesBefore: number): Error {
  const words = error instanceof Error ? `${error.name}: ${error.message}` : `thrown: ${String(error)}`;
  const stack = error instanceof Error ? (error.stack ?? "") : "";
  // The topmost call that is the function's: operations that round are above it, in the worker's own lines.
  for (const [, line] of stack.matchAll(/:(\d+):\d+\)?$/gm)) if (Number(line) > linesBefore) return new Error(`line ${Number(line) - linesBefore}: ${words}`);
  return new Error(words);
}
