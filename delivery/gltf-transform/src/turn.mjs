// New links and arrays for primitives whose triangles were moved, turned or joined.
import { roomyType } from "./index_codes.mjs";
import { Collector, mapOfOrigins } from "./maps.mjs";
import { isStraight, originsOf } from "./origins.mjs";
import { trianglesOf } from "./tags.mjs";

/** mmverify's record of a bake: it holds a hash of the triangles' UVs in their order. */
const bakeRecord = "mmverify_bake";

/** Whether a primitive's triangles are where they were. */
const unmoved = ({ primitive, origins, count }) =>
  origins.length === count &&
  origins.every((of, t) => of.some((o) => o.primitive === primitive && o.triangle === t && isStraight(o.order)));

/** Lists of triangles in groups that share arrays of maps, directly or over others. */
function groupsOf(lists) {
  let groups = [];
  for (const list of lists) {
    const group = { lists: [list], arrays: new Set(list.links.map((link) => link.getMicromap())) };
    if (group.arrays.size === 0) continue;
    groups = groups.filter(({ lists: others, arrays }) => {
      const apart = [...arrays].every((array) => !group.arrays.has(array));
      if (!apart) {
        group.lists.unshift(...others);
        for (const array of arrays) group.arrays.add(array);
      }
      return apart;
    });
    groups.push(group);
  }
  return groups;
}

function newLink(extension, list, micromap, codes) {
  const [old] = list.links;
  const { [bakeRecord]: record, ...extras } = old.getExtras();
  return extension
    .createLink()
    .setName(old.getName())
    .setMicromap(micromap)
    .setIndices(Int32Array.from(codes))
    .setIndexType(roomyType(old.getIndexType(), codes))
    .setExtras(record !== undefined && unmoved(list) ? { ...extras, [bakeRecord]: record } : extras);
}

/**
 * The links that fit the triangles of `tagged`, a document with tags: a map from primitives to links, and the arrays
 * that they replace.
 *   memory    { byKey, links, counts }: remember() of the document as it was; its links and numbers of triangles
 *   wasOf     the primitive of that document which a primitive of `tagged` is
 */
export function turn(tagged, extension, memory, { newIsUnknown = false, wasOf = (primitive) => primitive } = {}) {
  const linkOf = (primitive) => memory.links.get(primitive);
  const lists = trianglesOf(tagged).map((list) => {
    const primitive = wasOf(list.primitive);
    const origins = originsOf(list, memory.byKey, primitive);
    const sources = new Set([primitive, ...origins.flat().map((origin) => origin.primitive)]);
    const links = [...sources].map(linkOf).filter(Boolean);
    return { primitive, what: list.what, origins, links, count: memory.counts.get(primitive) };
  });
  const links = new Map();
  const replaced = new Set();
  for (const group of groupsOf(lists)) {
    if (group.lists.every(unmoved)) continue;
    const collector = new Collector();
    const codes = group.lists.map(({ origins, what }) =>
      origins.map((of, t) => collector.codeOf(mapOfOrigins(of, linkOf, newIsUnknown, `${what} triangle ${t}`))),
    );
    const [first] = group.arrays;
    const micromap = collector.fill(extension.createMicromap()).setName(first.getName()).setExtras(first.getExtras());
    group.lists.forEach((list, k) => links.set(list.primitive, newLink(extension, list, micromap, codes[k])));
    for (const array of group.arrays) replaced.add(array);
  }
  return { links, replaced };
}
