// The map that a triangle had, and arrays of such maps.
import { isStraight } from "./origins.mjs";
import { bytesOfRecords, mapOf, recordAt, turnedMap, usageOf } from "./states.mjs";

/** UO: it asks the shader, which is always right. */
export const unknown = { code: -4 };
/** An array of special indices alone has a record, too: the draft has no empty arrays of usage counts. */
const spare = { level: 0, format: 2, bytes: Uint8Array.of(3), key: "spare" };

/** What a triangle had, turned by an order: { code } of a special index, or { level, format, bytes, key } of a map. */
function mapAt(link, { triangle, order }, what) {
  const code = link.codeOf(triangle);
  if (code < 0) return { code };
  const micromap = link.getMicromap();
  const record = recordAt(micromap.getTriangles(), code);
  if (!record) throw new Error(`${what}: it had record ${code}, which its micromap lacks`);
  const map = mapOf(micromap.getData(), record, `${what}: record ${code}`);
  const bytes = isStraight(order) ? map : turnedMap(map, record, order);
  return { level: record.level, format: record.format, bytes, key: `${record.level}:${record.format}:${bytes.join()}` };
}

/**
 * The map of a triangle that comes from one of `origins`.  `linkOf`: the link that a primitive had.
 * Errors: no origin, unless `newIsUnknown`; origins with different maps.
 */
export function mapOfOrigins(origins, linkOf, newIsUnknown, what) {
  if (origins.length === 0) {
    if (newIsUnknown) return unknown;
    throw new Error(
      `${what} is new: no triangle had its corners before. Bake again, or give { newIsUnknown: true }`,
    );
  }
  const [map, ...others] = origins.map((origin) => {
    const link = linkOf(origin.primitive);
    return link ? mapAt(link, origin, what) : unknown;
  });
  if (others.some((other) => other.code !== map.code || other.key !== map.key))
    throw new Error(`${what}: ${origins.length} triangles had these corners before, and their maps differ`);
  return map;
}

/** Maps as records, each once. */
export class Collector {
  records = [];
  parts = [];
  size = 0;
  known = new Map();

  /** The special index, or the number of the record. */
  codeOf(map) {
    if (map.code !== undefined) return map.code;
    if (!this.known.has(map.key)) {
      this.known.set(map.key, this.records.length);
      this.records.push({ offset: this.size, level: map.level, format: map.format });
      this.parts.push(map.bytes);
      this.size += map.bytes.length;
    }
    return this.known.get(map.key);
  }

  fill(micromap) {
    if (this.records.length === 0) this.codeOf(spare);
    const data = new Uint8Array(this.size);
    this.records.forEach(({ offset }, k) => data.set(this.parts[k], offset));
    return micromap.setData(data).setTriangles(bytesOfRecords(this.records)).setUsage(usageOf(this.records));
  }
}
