// Whether an operation changed the UVs that maps were baked by.
import { tag, trianglesOf } from "./tags.mjs";

/** The UV of each tag, by the base colour's set. */
function uvsOf(document) {
  const uvs = new Map();
  for (const { primitive } of trianglesOf(document)) {
    const set = primitive.getMaterial()?.getBaseColorTextureInfo()?.getTexCoord() ?? 0;
    const accessor = primitive.getAttribute(`TEXCOORD_${set}`),
      tags = primitive.getAttribute(tag).getArray();
    if (accessor) tags.forEach((number, vertex) => uvs.set(number, accessor.getElement(vertex, [])));
  }
  return uvs;
}

/** Remembers the UVs of a tagged document; the answer tells by how much they are others in a later one. */
export function rememberUvs(document) {
  const before = uvsOf(document);
  return (later) => {
    let greatest = 0;
    for (const [number, uv] of uvsOf(later)) {
      const old = before.get(number);
      if (old) greatest = Math.max(greatest, ...uv.map((x, axis) => Math.abs(x - old[axis])));
    }
    return greatest;
  };
}

/** What a user has to know of UVs that moved. */
export const movedWarning = (greatest) =>
  `UVs moved by up to ${greatest.toPrecision(2)}: maps may not fit them; mmverify check maps judges`;
