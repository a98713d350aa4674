// The index in row order of a point, ties included, and in words.
import type { At } from "../walk/steps";

export interface RowPlace {
  row: number;
  column: number;
  index: number;
}

/** row = min(N-1, floor((u+v)N)), col = min(row, floor(vN)), dia = min(N-1, floor((1-u)N)); along = col + dia - (N-1-row).
 * At u = ku/4N, v = kv/4N. Source: Color and Attribute Micromaps, figure 4. */
export function rowPlace({ ku, kv }: At, level: number): RowPlace {
  const N = 2 ** level;
  const row = Math.min(N - 1, Math.floor((ku + kv) / 4));
  const column = Math.min(row, Math.floor(kv / 4)) + Math.min(N - 1, Math.floor((4 * N - ku) / 4)) - (N - 1 - row);
  return { row, column, index: row * row + column };
}

export function rowWords(at: At, level: number): string {
  const { row, column, index } = rowPlace(at, level);
  return `Row ${row} begins at ${row} x ${row} = ${row * row}; this is number ${column} in it, counted from 0: ${row * row} + ${column} = ${index}.`;
}
