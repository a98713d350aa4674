// Where each triangle of a document comes from.
import { tag, trianglesOf } from "./tags.mjs";

/** The orders of three corners, those that keep the winding first. */
const orders = [
  [0, 1, 2],
  [1, 2, 0],
  [2, 0, 1],
  [0, 2, 1],
  [2, 1, 0],
  [1, 0, 2],
];
const windings = 3;

const tagsOf = ({ primitive, corners }) => {
  const tags = primitive.getAttribute(tag).getArray();
  return Uint32Array.from(corners, (vertex) => tags[vertex]);
};
const keyOf = (tags, t) => [tags[3 * t], tags[3 * t + 1], tags[3 * t + 2]].sort((a, b) => a - b).join();

/** The triangles of a tagged document by their three tags. */
export function remember(document) {
  const byKey = new Map();
  for (const list of trianglesOf(document)) {
    const tags = tagsOf(list);
    for (let t = 0; 3 * t < tags.length; ++t) {
      const key = keyOf(tags, t);
      if (!byKey.has(key)) byKey.set(key, []);
      byKey.get(key).push({ primitive: list.primitive, triangle: t, tags: tags.subarray(3 * t, 3 * t + 3) });
    }
  }
  return byKey;
}

/**
 * For each triangle of a tagged primitive, the remembered triangles that it may be: { primitive, triangle, order },
 * where corner c is corner order[c] of the old one.  The likeliest are listed alone: those of the primitive `before` if
 * there are any, and of these, those wound the same way if there are any.
 */
export function originsOf(list, byKey, before) {
  const tags = tagsOf(list);
  return Array.from({ length: tags.length / 3 }, (_, t) => {
    const now = tags.subarray(3 * t, 3 * t + 3);
    const found = (byKey.get(keyOf(tags, t)) ?? []).map(({ primitive, triangle, tags: old }) => {
      const order = orders.findIndex((one) => one.every((from, c) => old[from] === now[c]));
      return {
        primitive,
        triangle,
        order: orders[order],
        rank: (primitive === before ? 0 : 2) + (order < windings ? 0 : 1),
      };
    });
    const likeliest = Math.min(...found.map(({ rank }) => rank));
    return found.filter(({ rank }) => rank === likeliest);
  });
}

export const isStraight = (order) => order === orders[0];
