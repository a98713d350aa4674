// The scene of the tests, glTF-Transform with all that it needs, and the native program.
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { NodeIO } from "@gltf-transform/core";
import { ALL_EXTENSIONS } from "@gltf-transform/extensions";
import { EXTMeshOpacityMicromap, KHRMeshOpacityMicromap } from "@mmverify/gltf-transform";
import draco3d from "draco3dgltf";
import { MeshoptDecoder, MeshoptEncoder } from "meshoptimizer";

export const name = "EXT_mesh_opacity_micromap";
const folder = process.env.MMVERIFY_FOLDER;
export const inFolder = (file) => join(folder, file);

export function native(args, input) {
  const { status, stdout, stderr, error } = spawnSync(process.env.MMVERIFY_PROGRAM, args, { cwd: folder, input, encoding: "utf8", maxBuffer: 1 << 28 });
  if (error) throw error;
  return { code: status, text: stdout + stderr, stdout };
}

/** The leaf scene, baked at a level. */
export function baked(level) {
  const { code, text } = native(["scene", "leaves.gltf", "--level", String(level), "-o", `level${level}.glb`, "--no-laws", "--quiet"]);
  if (code !== 0) throw new Error(text);
  return inFolder(`level${level}.glb`);
}

await MeshoptEncoder.ready;
await MeshoptDecoder.ready;
const dependencies = {
  "meshopt.encoder": MeshoptEncoder,
  "meshopt.decoder": MeshoptDecoder,
  "draco3d.encoder": await draco3d.createEncoderModule(),
  "draco3d.decoder": await draco3d.createDecoderModule(),
};
export const encoder = MeshoptEncoder;

/** Warnings are kept in `warnings`, and nothing is printed. */
export const warnings = [];
const logger = { debug() {}, info() {}, warn: (text) => warnings.push(text), error: (text) => warnings.push(text) };
const ioWith = (extensions) => new NodeIO().setLogger(logger).registerExtensions(extensions).registerDependencies(dependencies);
export const io = ioWith([...ALL_EXTENSIONS, EXTMeshOpacityMicromap, KHRMeshOpacityMicromap]);
/** glTF-Transform as it comes, without this package. */
export const plainIo = ioWith(ALL_EXTENSIONS);
export const read = async (path, by = io) => (await by.read(path)).setLogger(logger);

/** What the native program says of a file: exit codes of validate and of check maps, which is 2 for a file without maps. */
export function judged(file) {
  const validate = native(["validate", file]), check = native(["check", "maps", file, "--quiet"]);
  return { validate: validate.code, check: check.code, text: validate.text + check.text };
}

/** The JSON and the bytes of a .glb. */
export function readGlb(path) {
  const bytes = readFileSync(path), size = bytes.readUInt32LE(12);
  return { json: JSON.parse(bytes.subarray(20, 20 + size)), bin: bytes.subarray(28 + size) };
}
export function writeGlb(path, { json, bin }) {
  const text = Buffer.from(JSON.stringify(json)), padding = -text.length & 3, end = -bin.length & 3;
  const head = Buffer.alloc(20), middle = Buffer.alloc(8);
  const parts = [head, text, Buffer.alloc(padding, " "), middle, bin, Buffer.alloc(end)];
  [0x46546c67, 2, parts.reduce((sum, part) => sum + part.length, 0), text.length + padding, 0x4e4f534a].forEach((x, k) => head.writeUInt32LE(x, 4 * k));
  middle.writeUInt32LE(bin.length + end, 0), middle.writeUInt32LE(0x004e4942, 4);
  writeFileSync(path, Buffer.concat(parts));
}
export const primitivesOf = (document) => document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives());
