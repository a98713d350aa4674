// Files whose triangles a compressor orders while they are written.
import { reordererOf } from "./extension.mjs";
import { micromapExtensions, memoryFor, memoryOf } from "./transform.mjs";
import { addTags, removeTags, tag, trianglesOf } from "./tags.mjs";
import { turn } from "./turn.mjs";
import { movedWarning, rememberUvs } from "./uvs.mjs";

/** The primitives of a document by their places. */
const places = (document) =>
  document
    .getRoot()
    .listMeshes()
    .flatMap((mesh, m) => mesh.listPrimitives().map((primitive, p) => [`${m}/${p}`, primitive]));

/** Positions and UVs of each corner of each triangle, in order. */
const cornersOf = (document) =>
  trianglesOf(document).map(({ primitive, what, corners }) => {
    const arrays = primitive
      .listSemantics()
      .filter((name) => /^(POSITION|TEXCOORD_)/.test(name))
      .sort()
      .map((name) => [primitive.getAttribute(name).getArray(), primitive.getAttribute(name).getElementSize()]);
    return {
      what,
      values: Array.from(corners, (vertex) =>
        arrays.map(([array, size]) => array.slice(vertex * size, (vertex + 1) * size).join()).join(),
      ),
    };
  });

/** An error unless two readings of a file have the same triangles in the same order. */
function demandSame(tagged, written) {
  const due = cornersOf(tagged),
    found = cornersOf(written);
  due.forEach(({ what, values }, k) => {
    if (values.length !== found[k]?.values.length || values.some((value, c) => value !== found[k].values[c]))
      throw new Error(
        `${what}: the compressor orders its triangles otherwise without ${tag}; nothing was written`,
      );
  });
}

/** Writes the document with tags and reads it again: the order of triangles that a reader sees. */
async function readAgain(io, document, extensions) {
  addTags(document);
  try {
    const memory = memoryOf(document, extensions),
      moved = rememberUvs(document);
    const tagged = await io.readBinary(await io.writeBinary(document));
    return { memory, tagged, greatest: moved(tagged) };
  } finally {
    removeTags(document);
  }
}

/** For the time of `action`, the maps fit the triangles as a reader decodes them. */
async function settled(io, document, action) {
  const extensions = micromapExtensions(document);
  if (!reordererOf(document) || extensions.every((extension) => extension.listMicromaps().length === 0))
    return action();
  const undo = [];
  try {
    for (const extension of extensions) {
      extension.hidden = new Set();
      undo.push(() => (extension.hidden = null));
    }
    const { memory, tagged, greatest } = await readAgain(io, document, extensions);
    if (greatest > 0) document.getLogger().warn(movedWarning(greatest));
    const primitives = new Map(places(document)),
      were = new Map(places(tagged).map(([place, primitive]) => [primitive, primitives.get(place)]));
    for (const extension of extensions) {
      const { links, replaced } = turn(tagged, extension, memoryFor(memory, extension), {
        wasOf: (primitive) => were.get(primitive),
      });
      extension.hidden = replaced;
      for (const [primitive, link] of links) {
        const old = primitive.getExtension(extension.extensionName);
        primitive.setExtension(extension.extensionName, link);
        undo.push(() => {
          primitive.setExtension(extension.extensionName, old);
          link.getMicromap()?.dispose();
          link.dispose();
        });
      }
    }
    demandSame(tagged, await io.readBinary(await io.writeBinary(document)));
    return await action();
  } finally {
    for (const one of undo.reverse()) one();
  }
}

/** io.writeBinary(document), with maps that fit the file's triangles.  `io` needs the compressor's decoder, too. */
export const writeBinary = (io, document) => settled(io, document, () => io.writeBinary(document));

/** io.write(path, document), likewise. */
export const write = (io, path, document) => settled(io, document, () => io.write(path, document));
