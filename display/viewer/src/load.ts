// A .glb as three.js has it, with the maps of its primitives.
import { type BufferAttribute, type BufferGeometry, Mesh, MeshBasicMaterial, type MeshStandardMaterial, type Object3D } from "three";
import { MeshoptDecoder } from "three/examples/jsm/libs/meshopt_decoder.module.js";
import { GLTFLoader, type GLTF } from "three/examples/jsm/loaders/GLTFLoader.js";

import { type Entry, entryOf, type MapArray, mapArray } from "./maps";

const names = ["EXT_mesh_opacity_micromap", "KHR_mesh_opacity_micromap"];

/** The decoders that the page lacks, as three.js asks for them. */
const missing = [
  ["DRACOLoader", "This page does not decode meshes that Draco compressed (KHR_draco_mesh_compression)."],
  ["KTX2Loader", "This page does not decode textures in KTX2 (KHR_texture_basisu)."],
] as const;

interface Link {
  micromap: number;
  micromapIndices?: number;
  micromapBaseTriangle?: number;
}
interface Json {
  extensions?: Record<string, { micromaps?: { data: number; triangles: number }[] }>;
  accessors?: { componentType: number; count: number }[];
  meshes?: { primitives: { extensions?: Record<string, Link> }[] }[];
}

interface Place {
  meshes?: number;
  primitives?: number;
}

/** A primitive with maps; it may lie in several places of the scene. */
export interface Mapped {
  what: string;
  /** Whether it is the first of its places. */
  first: boolean;
  mesh: Mesh;
  /** For each triangle what it has. */
  entries: Entry[];
  arrays: MapArray;
  material: MeshBasicMaterial;
}

export interface Loaded {
  root: Object3D;
  mapped: Mapped[];
}

/** The texture as it is, without lights: maps are to be compared with it. */
function unlit(of: MeshStandardMaterial): MeshBasicMaterial {
  const basic = new MeshBasicMaterial({ color: of.color, map: of.map, side: of.side, alphaTest: of.alphaTest, opacity: of.opacity, transparent: of.transparent, vertexColors: of.vertexColors });
  basic.name = of.name;
  return basic;
}

async function arraysOf(gltf: GLTF, json: Json, name: string): Promise<MapArray[]> {
  const bytes = async (view: number): Promise<Uint8Array> => new Uint8Array((await gltf.parser.getDependency("bufferView", view)) as ArrayBuffer);
  return Promise.all((json.extensions?.[name]?.micromaps ?? []).map(async ({ data, triangles }) => mapArray(await bytes(data), await bytes(triangles))));
}

async function entriesOf(gltf: GLTF, link: Link, array: MapArray, triangles: number): Promise<Entry[]> {
  const base = link.micromapBaseTriangle ?? 0;
  if (link.micromapIndices === undefined) return Array.from({ length: triangles }, (_, t) => entryOf(array, t, 64, base));
  const codes = (await gltf.parser.getDependency("accessor", link.micromapIndices)) as BufferAttribute;
  const bits = 8 * codes.array.BYTES_PER_ELEMENT;
  return Array.from({ length: triangles }, (_, t) => entryOf(array, codes.array[t] ?? -5, bits, base));
}

/** Geometries of all primitives: instances have one of them, and no place of their own. */
async function placesOf(gltf: GLTF, json: Json): Promise<Map<BufferGeometry, Place>> {
  const places = new Map<BufferGeometry, Place>();
  for (const meshes of (json.meshes ?? []).keys()) {
    const object = (await gltf.parser.getDependency("mesh", meshes)) as Object3D;
    (object instanceof Mesh ? [object] : object.children).forEach((child, primitives) => places.set((child as Mesh).geometry, { meshes, primitives }));
  }
  return places;
}

/** Rejects, and says why, where three.js cannot read the file. */
export async function load(bytes: ArrayBuffer): Promise<Loaded> {
  const gltf = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(bytes, "").catch((error: unknown) => {
    const words = error instanceof Error ? error.message : String(error);
    throw new Error(missing.find(([part]) => words.includes(part))?.[1] ?? `three.js cannot read this file: ${words}`);
  });
  const json = gltf.parser.json as Json;
  const name = names.find((one) => json.extensions?.[one]) ?? names[0]!;
  const arrays = await arraysOf(gltf, json, name);
  const materials = new Map<MeshStandardMaterial, MeshBasicMaterial>();
  const mapped: Mapped[] = [];
  const meshes: Mesh[] = [];
  gltf.scene.traverse((object) => object instanceof Mesh && meshes.push(object));
  const places = await placesOf(gltf, json);
  for (const mesh of meshes) {
    const old = mesh.material as MeshStandardMaterial;
    const material = materials.get(old) ?? unlit(old);
    materials.set(old, material);
    mesh.material = material;
    // Maps lie over the mesh at rest.
    mesh.geometry.morphAttributes = {};
    delete mesh.morphTargetInfluences;
    const own = gltf.parser.associations.get(mesh) as Place | undefined;
    const place = own?.meshes === undefined ? places.get(mesh.geometry) : own;
    const link = json.meshes?.[place?.meshes ?? -1]?.primitives[place?.primitives ?? 0]?.extensions?.[name];
    const array = link && arrays[link.micromap];
    if (!link || !array) continue;
    const corners = mesh.geometry.index?.count ?? mesh.geometry.getAttribute("position").count;
    const entries = await entriesOf(gltf, link, array, Math.floor(corners / 3));
    const what = `mesh ${place!.meshes} primitive ${place!.primitives ?? 0}`;
    mapped.push({ what, first: mapped.every((other) => other.what !== what), mesh, entries, arrays: array, material });
  }
  return { root: gltf.scene, mapped };
}
