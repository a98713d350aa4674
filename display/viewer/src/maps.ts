// A triangle has a map of its array, or one state for all of it.
import { curveIndex, microAt } from "../../report/src/curve";
import { type MapRecord, records } from "../../page/src/scene/read_maps";

/** T, O, UT, UO, by their numbers. */
export type State = 0 | 1 | 2 | 3;

export interface MapArray {
  data: Uint8Array;
  records: (MapRecord | null)[];
}

/** A record of an array, or a special index, which is a state; null where the file names none. */
export type Entry = { record: MapRecord; number: number } | { state: State } | null;

export const mapArray = (data: Uint8Array, triangles: Uint8Array): MapArray => ({ data, records: records(data, triangles) });

/** The special indices -1 to -4 are T, O, UT, UO: the four greatest numbers of an unsigned type. */
export function entryOf(array: MapArray, code: number, bits: number, base: number): Entry {
  const signed = code >= 2 ** bits - 4 ? code - 2 ** bits : code;
  if (signed < 0) return signed >= -4 ? { state: (-1 - signed) as State } : null;
  const record = array.records[signed + base];
  return record ? { record, number: signed + base } : null;
}

/** How many states of each kind a triangle has; a special index counts as one. */
export function countsOf(entry: Entry): [number, number, number, number] {
  const counts: [number, number, number, number] = [0, 0, 0, 0];
  if (!entry) return counts;
  if ("state" in entry) counts[entry.state] = 1;
  else for (let k = 0; k < 4 ** entry.record.level; ++k) counts[entry.record.at(k) as State] += 1;
  return counts;
}

/** The micro-triangle at barycentrics u, v, and its state. */
export function microOf(entry: Entry, u: number, v: number): { index: number; level: number; state: State } | null {
  if (!entry) return null;
  if ("state" in entry) return { index: 0, level: 0, state: entry.state };
  const { level } = entry.record;
  const { i, j, inverted } = microAt(u, v, level);
  const index = curveIndex(i, j, inverted, level);
  return { index, level, state: entry.record.at(index) as State };
}
