// Records and states of a micromap's bytes.
import { permutation } from "./curve.mjs";

/** A record has 8 bytes: offset (32 bits), level and format (16 bits each).  Format f has f bits a state. */
const recordBytes = 8;

const recordCount = (triangles) => Math.floor(triangles.byteLength / recordBytes);

/** Record k; undefined where there is none. */
export function recordAt(triangles, k) {
  if (k >= recordCount(triangles)) return undefined;
  const view = new DataView(triangles.buffer, triangles.byteOffset + recordBytes * k, recordBytes);
  return { offset: view.getUint32(0, true), level: view.getUint16(4, true), format: view.getUint16(6, true) };
}

export const recordsOf = (triangles) =>
  Array.from({ length: recordCount(triangles) }, (_, k) => recordAt(triangles, k));

export function bytesOfRecords(records) {
  const bytes = new Uint8Array(recordBytes * records.length);
  const view = new DataView(bytes.buffer);
  records.forEach(({ offset, level, format }, k) => {
    view.setUint32(recordBytes * k, offset, true);
    view.setUint16(recordBytes * k + 4, level, true);
    view.setUint16(recordBytes * k + 6, format, true);
  });
  return bytes;
}

/** The bytes of one record's map.  Errors: an unknown format or level, bytes that are not there. */
export function mapOf(data, record, what) {
  const { offset, level, format } = record;
  if ((format !== 1 && format !== 2) || level > 12)
    throw new Error(`${what}: format ${format}, level ${level} is no map's`);
  const size = Math.ceil((format * 4 ** level) / 8);
  if (offset + size > data.length) throw new Error(`${what}: bytes ${offset}..${offset + size} of ${data.length}`);
  return data.subarray(offset, offset + size);
}

const stateIn = (map, format, k) => (map[(k * format) >>> 3] >> ((k * format) & 7)) & ((1 << format) - 1);

/** The states of a map as numbers, in the order of the curve. */
export const statesOf = (map, { level, format }) =>
  Uint8Array.from({ length: 4 ** level }, (_, k) => stateIn(map, format, k));

/** The map of the triangle whose corner c was corner `corners[c]`. */
export function turnedMap(map, { level, format }, corners) {
  const turned = new Uint8Array(map.length);
  permutation(level, corners).forEach(
    (from, k) => (turned[(k * format) >>> 3] |= stateIn(map, format, from) << ((k * format) & 7)),
  );
  return turned;
}

/** Usage counts of records: one entry for each level and format that occurs, by level, then format. */
export function usageOf(records) {
  const counts = new Map();
  for (const { level, format } of records) counts.set(4 * level + format, (counts.get(4 * level + format) ?? 0) + 1);
  const keys = [...counts.keys()].sort((a, b) => a - b);
  return {
    counts: keys.map((key) => counts.get(key)),
    levels: keys.map((key) => key >> 2),
    formats: keys.map((key) => key & 3),
  };
}
