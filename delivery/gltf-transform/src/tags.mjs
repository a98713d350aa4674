// A number for each vertex, as an attribute of its own: it tells where a triangle comes from after any operation.

/** The attribute, for the time of an operation. */
export const tag = "_MICROMAP_VERTEX";
/** Tags lie above 1: glTF-Transform's quantize() leaves an attribute alone that has greater values. */
const firstTag = 2;
const TRIANGLES = 4;

const attributesOf = (primitive) =>
  [primitive, ...primitive.listTargets()].flatMap((of) =>
    of
      .listSemantics()
      .filter((name) => name !== tag)
      .map((name) => of.getAttribute(name)),
  );

/** The bytes of a vertex in all its attributes; vertices of equal bytes are one to weld(), and get one tag. */
function vertexKeys(attributes) {
  const rows = attributes.map((accessor) => {
    const array = accessor.getArray();
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    return { bytes, size: array.BYTES_PER_ELEMENT * accessor.getElementSize() };
  });
  return (vertex) =>
    rows.map(({ bytes, size }) => String.fromCharCode(...bytes.subarray(vertex * size, (vertex + 1) * size))).join("");
}

const primitivesOf = (document) =>
  document
    .getRoot()
    .listMeshes()
    .flatMap((mesh, m) =>
      mesh.listPrimitives().map((primitive, p) => ({ primitive, what: `mesh ${m} primitive ${p}` })),
    );

/** Each list of triangles of a document: { primitive, what, corners }, with the number of a vertex for each corner. */
export function trianglesOf(document) {
  return primitivesOf(document)
    .filter(({ primitive }) => primitive.getMode() === TRIANGLES && primitive.getAttribute("POSITION"))
    .map((found) => ({
      ...found,
      corners:
        found.primitive.getIndices()?.getArray() ??
        Uint32Array.from({ length: found.primitive.getAttribute("POSITION").getCount() }, (_, k) => k),
    }));
}

/** Tags every vertex of every primitive.  Primitives of the same accessors share the accessor of tags, too. */
export function addTags(document) {
  const shared = new Map(),
    numbers = new Map();
  let next = firstTag;
  for (const { primitive, what } of primitivesOf(document)) {
    if (primitive.getAttribute(tag))
      throw new Error(`${what}: it has an attribute ${tag}, which this package needs for itself`);
    const attributes = attributesOf(primitive);
    if (!primitive.getAttribute("POSITION")) continue;
    const set = attributes
      .map((accessor) => (numbers.has(accessor) || numbers.set(accessor, numbers.size), numbers.get(accessor)))
      .join();
    if (!shared.has(set)) {
      const keyOf = vertexKeys(attributes),
        known = new Map();
      const tags = Uint32Array.from({ length: primitive.getAttribute("POSITION").getCount() }, (_, vertex) => {
        const key = keyOf(vertex);
        if (!known.has(key)) known.set(key, next++);
        return known.get(key);
      });
      shared.set(
        set,
        document
          .createAccessor(tag)
          .setType("SCALAR")
          .setArray(tags)
          .setBuffer(primitive.getAttribute("POSITION").getBuffer()),
      );
    }
    primitive.setAttribute(tag, shared.get(set));
  }
}

/** Takes the tags off, also those that an operation copied and left behind. */
export function removeTags(document) {
  for (const { primitive } of primitivesOf(document)) primitive.setAttribute(tag, null);
  for (const accessor of document.getRoot().listAccessors()) if (accessor.getName() === tag) accessor.dispose();
}
