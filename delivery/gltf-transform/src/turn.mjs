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
function groupsOf(lists, linkOf) {
  let groups = [];
  for (const list of lists) {
    const arrays = new Set(list.origins.flat().map(({ primitive }) => linkOf(primitive)?.getMicromap()).filter(Boolean));
    if (arrays.size === 0) continue;
    const joined = { lists: [list], arrays };
    groups = groups.filter((group) => {
      const apart = [...group.arrays].every((array) => !joined.arrays.has(array));
      if (!apart) {
        joined.lists.unshift(...group.lists);
        for (const array of group.arrays) joined.arrays.add(array);
      }
      return apart;
    });
    groups.push(joined);
  }
  return groups;
}

function newLink(extension, list, linkOf, micromap, codes) {
  const old = list.origins.flat().map(({ primitive }) => linkOf(primitive)).find(Boolean);
  const { [bakeRecord]: record, ...extras } = old.getExtras();
  return extension.createLink().setName(old.getName()).setMicromap(micromap).setIndices(Int32Array.from(codes))
    .setIndexType(roomyType(old.getIndexType(), codes))
    .setExtras(record !== undefined && unmoved(list) ? { ...extras, [bakeRecord]: record } : extras);
}

/**
 * The links that fit the triangles of `tagged`, a document with tags: a map from the place of a primitive in its list of
 * triangles to its link, and the arrays that they replace.
 *   memory    { byKey, links, counts }: remember() of the document as it was; its links and numbers of triangles
 *   wasOf     the primitive of that document which a primitive of `tagged` is
 */
export function turn(tagged, extension, memory, { newIsUnknown = false, wasOf = (primitive) => primitive } = {}) {
  const linkOf = (primitive) => memory.links.get(primitive);
  const lists = trianglesOf(tagged).map((list) => {
    const primitive = wasOf(list.primitive);
    return { primitive, what: list.what, origins: originsOf(list, memory.byKey, primitive), count: memory.counts.get(primitive) };
  });
  const links = new Map(), replaced = new Set();
  for (const group of groupsOf(lists, linkOf)) {
    if (group.lists.every(unmoved)) continue;
    const collector = new Collector(), micromap = extension.createMicromap();
    for (const list of group.lists) {
      const codes = list.origins.map((of, t) =>
        collector.codeOf(mapOfOrigins(of, linkOf, newIsUnknown, `${list.what} triangle ${t}`)));
      links.set(list.primitive, newLink(extension, list, linkOf, micromap, codes));
    }
    const [first] = group.arrays;
    collector.fill(micromap).setName(first.getName()).setExtras(first.getExtras());
    for (const array of group.arrays) replaced.add(array);
  }
  return { links, replaced };
}
