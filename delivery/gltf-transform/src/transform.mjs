// Operations of glTF-Transform after which maps still fit their triangles.
import { EXTMeshOpacityMicromap, KHRMeshOpacityMicromap } from "./extension.mjs";
import { remember } from "./origins.mjs";
import { addTags, removeTags, tag, trianglesOf } from "./tags.mjs";
import { turn } from "./turn.mjs";
import { movedWarning, rememberUvs } from "./uvs.mjs";

/** The extensions of a document that give its primitives maps. */
export const micromapExtensions = (document) =>
  document
    .getRoot()
    .listExtensionsUsed()
    .filter((used) => used instanceof EXTMeshOpacityMicromap || used instanceof KHRMeshOpacityMicromap);

/** What turn() asks of a tagged document before an operation. */
export function memoryOf(document, extensions) {
  const lists = trianglesOf(document);
  return {
    byKey: remember(document),
    counts: new Map(lists.map(({ primitive, corners }) => [primitive, corners.length / 3])),
    links: new Map(
      extensions.map(({ extensionName }) => [
        extensionName,
        new Map(
          lists.map(({ primitive }) => [primitive, primitive.getExtension(extensionName)]).filter(([, link]) => link),
        ),
      ]),
    ),
  };
}

export const memoryFor = ({ links, ...memory }, extension) => ({
  ...memory,
  links: links.get(extension.extensionName),
});

/** quantize() warns of each attribute that it leaves alone; of the tags nobody has to know. */
function quiet(logger) {
  const unless = (level) => (text) => text.includes(tag) || logger[level](text);
  return { debug: unless("debug"), info: unless("info"), warn: unless("warn"), error: unless("error") };
}

/** Links as turn() gave them; arrays that no link needs any more go. */
function apply({ links, replaced }, extension) {
  for (const [primitive, link] of links) {
    const old = primitive.getExtension(extension.extensionName);
    primitive.setExtension(extension.extensionName, link);
    if (old && isUnused(old)) old.dispose();
  }
  for (const micromap of replaced) {
    for (const link of micromap.listParents())
      if (link.propertyType === "MicromapLink" && isUnused(link)) link.dispose();
    if (isUnused(micromap)) micromap.dispose();
  }
}
const isUnused = (property) => property.listParents().length === 0;

/**
 * The operations, as one, after which each triangle has its own map in the order of its corners.
 *   transforms  one of glTF-Transform's operations, or several in an array
 *   options     newIsUnknown: a triangle that was not there before gets the special index UO instead of an error
 * Errors: a new triangle; two triangles with the same corners and different maps.
 */
export function withMicromaps(transforms, options = {}) {
  return async function withMicromaps(document) {
    const extensions = micromapExtensions(document);
    if (extensions.length === 0) return void (await document.transform(...[transforms].flat()));
    const logger = document.getLogger();
    addTags(document);
    try {
      const memory = memoryOf(document, extensions),
        moved = rememberUvs(document);
      document.setLogger(quiet(logger));
      await document.transform(...[transforms].flat());
      for (const extension of extensions)
        apply(turn(document, extension, memoryFor(memory, extension), options), extension);
      const greatest = moved(document);
      if (greatest > 0) logger.warn(movedWarning(greatest));
    } finally {
      document.setLogger(logger);
      removeTags(document);
    }
  };
}
