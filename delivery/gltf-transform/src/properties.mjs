// What a document has of micromaps: arrays of maps, and each primitive's link to one.
import { ExtensionProperty, PropertyType } from "@gltf-transform/core";

import { mapOf, recordAt, recordsOf, statesOf } from "./states.mjs";

/** An array of maps: an element of the root's `micromaps`. */
export class Micromap extends ExtensionProperty {
  init() {
    this.propertyType = "Micromap";
    this.parentTypes = ["MicromapLink"];
  }
  getDefaults() {
    return Object.assign(super.getDefaults(), {
      data: new Uint8Array(),
      triangles: new Uint8Array(),
      usageCounts: [],
      usageLevels: [],
      usageFormats: [],
    });
  }
  /** The states of all maps, packed. */
  getData() {
    return this.get("data");
  }
  setData(data) {
    return this.set("data", data);
  }
  /** The records, 8 bytes each. */
  getTriangles() {
    return this.get("triangles");
  }
  setTriangles(triangles) {
    return this.set("triangles", triangles);
  }
  /** The usage counts: so many records have this level and format. */
  getUsage() {
    return { counts: this.get("usageCounts"), levels: this.get("usageLevels"), formats: this.get("usageFormats") };
  }
  setUsage({ counts, levels, formats }) {
    return this.set("usageCounts", counts).set("usageLevels", levels).set("usageFormats", formats);
  }
  listRecords() {
    return recordsOf(this.getTriangles());
  }
  /** The states of one record: 0 T, 1 O, 2 UT, 3 UO. */
  getStates(record) {
    const found = recordAt(this.getTriangles(), record);
    if (!found) throw new Error(`Micromap: there is no record ${record}`);
    return statesOf(mapOf(this.getData(), found, `record ${record}`), found);
  }
}

/** A primitive's use of an array: which record each triangle has. */
export class MicromapLink extends ExtensionProperty {
  init() {
    this.propertyType = "MicromapLink";
    this.parentTypes = [PropertyType.PRIMITIVE];
  }
  getDefaults() {
    return Object.assign(super.getDefaults(), { micromap: null, indices: null, indexType: 5125, baseTriangle: 0 });
  }
  getMicromap() {
    return this.getRef("micromap");
  }
  setMicromap(micromap) {
    return this.setRef("micromap", micromap);
  }
  /** A code for each triangle: a record less the base triangle, or a special index from -1 (T) to -4 (UO).
   *  Null: triangle t has code t. */
  getIndices() {
    return this.get("indices");
  }
  setIndices(indices) {
    return this.set("indices", indices);
  }
  /** The component type that the codes are stored by: 5121, 5122, 5123, 5124 or 5125. */
  getIndexType() {
    return this.get("indexType");
  }
  setIndexType(type) {
    return this.set("indexType", type);
  }
  getBaseTriangle() {
    return this.get("baseTriangle");
  }
  setBaseTriangle(base) {
    return this.set("baseTriangle", base);
  }
  /** What a triangle has: a record of the array, or a special index, which is negative. */
  codeOf(triangle) {
    const indices = this.getIndices();
    const code = indices ? indices[triangle] : triangle;
    return code < 0 ? code : code + this.getBaseTriangle();
  }
}

/** Both classes under the name of an extension. */
export function propertiesOf(extensionName) {
  const named = (Base) =>
    class extends Base {
      static EXTENSION_NAME = extensionName;
      init() {
        super.init();
        this.extensionName = extensionName;
      }
    };
  return { Micromap: named(Micromap), MicromapLink: named(MicromapLink) };
}
