import type { Document, Extension, ExtensionProperty, PlatformIO, Transform } from "@gltf-transform/core";

/** A record: where its map begins, its level, and its format: 1 for two states, 2 for four. */
export interface MicromapRecord {
  offset: number;
  level: number;
  format: number;
}
/** So many records (`counts`) have this level and this format. */
export interface MicromapUsage {
  counts: number[];
  levels: number[];
  formats: number[];
}

/** An array of maps: an element of the root's `micromaps`. */
export declare class Micromap extends ExtensionProperty {
  readonly extensionName: string;
  readonly propertyType: "Micromap";
  readonly parentTypes: string[];
  init(): void;
  /** The states of all maps, packed. */
  getData(): Uint8Array;
  setData(data: Uint8Array): this;
  /** The records, 8 bytes each. */
  getTriangles(): Uint8Array;
  setTriangles(triangles: Uint8Array): this;
  getUsage(): MicromapUsage;
  setUsage(usage: MicromapUsage): this;
  listRecords(): MicromapRecord[];
  /** The states of one record: 0 T, 1 O, 2 UT, 3 UO, in the order of the curve. */
  getStates(record: number): Uint8Array;
}

/** A primitive's use of an array. */
export declare class MicromapLink extends ExtensionProperty {
  readonly extensionName: string;
  readonly propertyType: "MicromapLink";
  readonly parentTypes: string[];
  init(): void;
  getMicromap(): Micromap | null;
  setMicromap(micromap: Micromap | null): this;
  /** A code for each triangle: a record less the base triangle, or -1 T, -2 O, -3 UT, -4 UO.  Null: triangle t has t. */
  getIndices(): Int32Array | null;
  setIndices(indices: Int32Array | null): this;
  /** The component type that the codes are stored by. */
  getIndexType(): 5121 | 5122 | 5123 | 5124 | 5125;
  setIndexType(type: 5121 | 5122 | 5123 | 5124 | 5125): this;
  getBaseTriangle(): number;
  setBaseTriangle(base: number): this;
  /** What a triangle has: a record of the array, or a special index, which is negative. */
  codeOf(triangle: number): number;
}

declare class MeshOpacityMicromap extends Extension {
  createMicromap(): Micromap;
  createLink(): MicromapLink;
  listMicromaps(): Micromap[];
  read(context: any): this;
  write(context: any): this;
}
export declare class EXTMeshOpacityMicromap extends MeshOpacityMicromap {
  static readonly EXTENSION_NAME: "EXT_mesh_opacity_micromap";
}
export declare class KHRMeshOpacityMicromap extends MeshOpacityMicromap {
  static readonly EXTENSION_NAME: "KHR_mesh_opacity_micromap";
}

/**
 * The operations, as one, after which each triangle has its own map in the order of its corners.
 * `newIsUnknown`: a triangle that was not there before gets the special index UO; without it, it is an error.
 */
export declare function withMicromaps(transforms: Transform | Transform[], options?: { newIsUnknown?: boolean }): Transform;
/** io.write(), with maps in the order that a compressor gives triangles.  `io` needs the compressor's decoder, too. */
export declare function write(io: PlatformIO & { write(uri: string, document: Document): Promise<void> }, path: string, document: Document): Promise<void>;
/** io.writeBinary(), likewise. */
export declare function writeBinary(io: PlatformIO, document: Document): Promise<Uint8Array<ArrayBuffer>>;

/** The index of a micro-triangle by its square of the grid; `upper`: the square's upper half. */
export declare function curveIndex(i: number, j: number, upper: boolean, level: number): number;
/** State k of the turned map is state result[k] of the old one; corner c was corner corners[c]. */
export declare function permutation(level: number, corners: readonly [number, number, number]): Uint32Array;
