// EXT_mesh_opacity_micromap and its older name, as extensions of glTF-Transform.
import { Extension, PropertyType } from "@gltf-transform/core";

import { readCodes, writeCodes } from "./index_codes.mjs";
import { propertiesOf } from "./properties.mjs";

/** 32 bits signed, which glTF 2.0 and glTF-Transform lack. */
const INT = 5124;
const UNSIGNED_INT = 5125;
/** Extensions that order a primitive's triangles while they write it. */
const reordering = ["EXT_meshopt_compression", "KHR_draco_mesh_compression", "KHR_meshopt_compression"];
/** The first of them that a document uses. */
export const reordererOf = (document) =>
  document
    .getRoot()
    .listExtensionsUsed()
    .map((used) => used.extensionName)
    .find((name) => reordering.includes(name));

const setUp = (property, def) => property.setName(def.name ?? "").setExtras(def.extras ?? {});

/** A copy whose size is a multiple of four, so that what follows it stays aligned. */
function padded(bytes) {
  const copy = new Uint8Array(Math.ceil(bytes.length / 4) * 4);
  copy.set(bytes);
  return copy;
}

/** The extension of a name; `Micromap` and `MicromapLink` are its properties. */
function extensionOf(name) {
  const { Micromap, MicromapLink } = propertiesOf(name);

  return class extends Extension {
    static EXTENSION_NAME = name;
    extensionName = name;
    prereadTypes = [PropertyType.BUFFER];
    prewriteTypes = [PropertyType.BUFFER];
    /** While write() orders maps as a compressor orders triangles: the arrays that others stand for.  Null else. */
    hidden = null;

    createMicromap() {
      return new Micromap(this.document.getGraph());
    }
    createLink() {
      return new MicromapLink(this.document.getGraph());
    }
    listMicromaps() {
      return this.listProperties().filter((property) => property instanceof Micromap);
    }

    written() {
      return this.listMicromaps().filter((micromap) => !this.hidden?.has(micromap));
    }

    /** [primitive of the document, its definition, a name for messages] of each primitive. */
    *primitives(json, meshes) {
      for (const [m, mesh] of meshes.entries())
        for (const [p, primitive] of mesh.listPrimitives().entries())
          yield [primitive, json.meshes[m].primitives[p], `mesh ${m} primitive ${p}`];
    }

    /** glTF-Transform cannot read accessors of type 5124: they become 5125, with the same bits, in a copy. */
    preread({ jsonDoc: { json } }) {
      const links = (json.meshes ?? []).flatMap((mesh) =>
        mesh.primitives.map((primitive) => primitive.extensions?.[name]),
      );
      this.signed = new Set(
        links.map((link) => link?.micromapIndices).filter((k) => json.accessors?.[k]?.componentType === INT),
      );
      if (this.signed.size > 0)
        json.accessors = json.accessors.map((def, k) =>
          this.signed.has(k) ? { ...def, componentType: UNSIGNED_INT } : def,
        );
      return this;
    }

    read(context) {
      const { json } = context.jsonDoc;
      const micromaps = (json.extensions?.[name]?.micromaps ?? []).map((def, k) => {
        for (const view of [def.data, def.triangles])
          if (!context.bufferViews[view]) throw new Error(`${name}: micromap ${k}: there is no bufferView ${view}`);
        return setUp(this.createMicromap(), def)
          .setData(context.bufferViews[def.data].slice())
          .setTriangles(context.bufferViews[def.triangles].slice())
          .setUsage({ counts: def.usageCounts, levels: def.usageLevels, formats: def.usageFormats });
      });
      const stored = new Set();
      for (const [primitive, primitiveDef, what] of this.primitives(json, context.meshes)) {
        const def = primitiveDef.extensions?.[name];
        if (!def) continue;
        if (!micromaps[def.micromap]) throw new Error(`${name}: ${what}: there is no micromap ${def.micromap}`);
        const link = setUp(this.createLink(), def)
          .setMicromap(micromaps[def.micromap])
          .setBaseTriangle(def.micromapBaseTriangle ?? 0);
        if (def.micromapIndices !== undefined)
          this.readIndices(link, context, def.micromapIndices, stored, `${name}: ${what}`);
        primitive.setExtension(name, link);
      }
      // The codes are the link's now: an accessor beside it would be written again.
      for (const accessor of stored)
        if (
          accessor
            .listParents()
            .every((parent) => parent.propertyType === PropertyType.ROOT || parent.propertyType === PropertyType.BUFFER)
        )
          accessor.dispose();
      return this;
    }

    readIndices(link, context, number, stored, what) {
      const { json } = context.jsonDoc;
      const def = json.accessors?.[number];
      if (!def) throw new Error(`${what}: there is no accessor ${number}`);
      const view = (k) => {
        if (!context.bufferViews[k]) throw new Error(`${what}: there is no bufferView ${k}`);
        return context.bufferViews[k];
      };
      link.setIndices(readCodes(def, view, (k) => json.bufferViews[k].byteStride, what));
      link.setIndexType(this.signed.has(number) ? INT : def.componentType);
      stored.add(context.accessors[number]);
    }

    /** The bytes of arrays and indices, as bufferViews of their own. */
    prewrite(context) {
      const root = this.document.getRoot();
      const micromaps = this.written();
      const links = root
        .listMeshes()
        .flatMap((mesh) => mesh.listPrimitives())
        .map((primitive) => primitive.getExtension(name))
        .filter(Boolean);
      const order = reordererOf(this.document);
      if (order && !this.hidden && links.length > 0)
        throw new Error(
          `${name}: ${order} orders triangles anew while it writes, and maps would not fit; ` +
            "use write(io, path, document) or writeBinary(io, document) of @mmverify/gltf-transform",
        );
      if (micromaps.length === 0) return this;
      const buffer = root.listBuffers()[0] ?? this.document.createBuffer();
      const views = [];
      this.sizes = new Map();
      const view = (bytes) => {
        const copy = padded(bytes);
        this.sizes.set(copy, bytes.length);
        views.push(copy);
        return copy;
      };
      this.parts = new Map(
        micromaps.map((micromap) => [
          micromap,
          { data: view(micromap.getData()), triangles: view(micromap.getTriangles()) },
        ]),
      );
      for (const link of new Set(links))
        if (link.getIndices())
          this.parts.set(link, { indices: view(writeCodes(link.getIndexType(), link.getIndices(), name)) });
      // They come first: Draco's data, which other extensions put there, have any size, and indices are aligned.
      context.otherBufferViews.set(buffer, [...views, ...(context.otherBufferViews.get(buffer) ?? [])]);
      return this;
    }

    write(context) {
      const { json } = context.jsonDoc;
      const micromaps = this.written();
      if (micromaps.length === 0) return this;
      const viewOf = (bytes) => {
        const number = context.otherBufferViewsIndexMap.get(bytes);
        json.bufferViews[number].byteLength = this.sizes.get(bytes);
        return number;
      };
      json.extensions = {
        ...json.extensions,
        [name]: {
          micromaps: micromaps.map((micromap) => {
            const { data, triangles } = this.parts.get(micromap);
            const { counts, levels, formats } = micromap.getUsage();
            return {
              ...context.createPropertyDef(micromap),
              data: viewOf(data),
              triangles: viewOf(triangles),
              usageCounts: counts,
              usageLevels: levels,
              usageFormats: formats,
            };
          }),
        },
      };
      const accessors = new Map();
      const accessorOf = (link) => {
        if (!accessors.has(link)) {
          accessors.set(link, json.accessors.length);
          json.accessors.push({
            type: "SCALAR",
            componentType: link.getIndexType(),
            count: link.getIndices().length,
            bufferView: viewOf(this.parts.get(link).indices),
          });
        }
        return accessors.get(link);
      };
      for (const [primitive, def] of this.primitives(json, this.document.getRoot().listMeshes())) {
        const link = primitive.getExtension(name);
        if (!link) continue;
        def.extensions = {
          ...def.extensions,
          [name]: {
            ...context.createPropertyDef(link),
            micromap: micromaps.indexOf(link.getMicromap()),
            ...(link.getIndices() ? { micromapIndices: accessorOf(link) } : {}),
            ...(link.getBaseTriangle() !== 0 ? { micromapBaseTriangle: link.getBaseTriangle() } : {}),
          },
        };
      }
      return this;
    }
  };
}

export const EXTMeshOpacityMicromap = extensionOf("EXT_mesh_opacity_micromap");
export const KHRMeshOpacityMicromap = extensionOf("KHR_mesh_opacity_micromap");
