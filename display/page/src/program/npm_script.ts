// A script for npm, judged in the page.

/** A script for npm as a script without exports, line by line as it was. */
export function withoutExports(code: string): string {
  const lines = (text: string): string => text.replace(/[^\n]/g, "");
  return code
    .replace(/^([ \t]*)export[ \t]+(?:default[ \t]+)?(?=(?:async\s+)?function\b|const\b|let\b|var\b|class\b)/gm, "$1")
    .replace(/^[ \t]*export\s*\{[^}]*\}[ \t]*;?|^[ \t]*export[ \t]+default[ \t]+\w+[ \t]*;?[ \t]*$/gm, lines);
}
