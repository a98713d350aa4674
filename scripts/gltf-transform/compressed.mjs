// What a tool that does not know micromaps makes of a file that has them: glTF-Transform compresses it, and the
// extension's objects, views and accessors are copied to the result as they were.
// usage: node scripts/gltf-transform/compressed.mjs PACKAGES meshopt|draco FROM.glb TO.glb
//   PACKAGES  the folder whose node_modules has the packages of package.json
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [packages, how, from, to] = process.argv.slice(2);
const require = createRequire(path.join(path.resolve(packages), "package.json"));
const load = async (name) => import(pathToFileURL(require.resolve(name)).href);
const { NodeIO, Verbosity, Logger } = await load("@gltf-transform/core");
const { ALL_EXTENSIONS } = await load("@gltf-transform/extensions");
const { draco, meshopt } = await load("@gltf-transform/functions");
const { MeshoptDecoder, MeshoptEncoder } = await load("meshoptimizer");
const draco3d = require("draco3dgltf");

const EXTENSION = "EXT_mesh_opacity_micromap";
const JSON_CHUNK = 0x4e4f534a, BIN_CHUNK = 0x004e4942, GLB = 0x46546c67;

function readGlb(file) {
  const bytes = fs.readFileSync(file), size = bytes.readUInt32LE(12);
  return { json: JSON.parse(bytes.subarray(20, 20 + size)), bin: bytes.subarray(28 + size) };
}

function writeGlb(file, json, bin) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = (bytes, fill) => Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3, fill)]);
  const chunk = (type, bytes) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(bytes.length, 0), head.writeUInt32LE(type, 4);
    return Buffer.concat([head, bytes]);
  };
  const body = Buffer.concat([chunk(JSON_CHUNK, padded(text, " ")), chunk(BIN_CHUNK, padded(bin, 0))]);
  const head = Buffer.alloc(12);
  head.writeUInt32LE(GLB, 0), head.writeUInt32LE(2, 4), head.writeUInt32LE(12 + body.length, 8);
  fs.writeFileSync(file, Buffer.concat([head, body]));
}

function copyMicromaps(source, target) {
  const json = target.json;
  let bin = target.bin.subarray(0, json.buffers[0].byteLength);
  const view = (number) => {
    const { byteOffset = 0, byteLength } = source.json.bufferViews[number];
    bin = Buffer.concat([bin, Buffer.alloc(-bin.length & 3)]);
    json.bufferViews.push({ buffer: 0, byteOffset: bin.length, byteLength });
    bin = Buffer.concat([bin, source.bin.subarray(byteOffset, byteOffset + byteLength)]);
    return json.bufferViews.length - 1;
  };
  const root = structuredClone(source.json.extensions[EXTENSION]);
  for (const micromap of root.micromaps)
    (micromap.data = view(micromap.data)), (micromap.triangles = view(micromap.triangles));
  json.extensions = { ...json.extensions, [EXTENSION]: root };
  json.extensionsUsed = [...(json.extensionsUsed ?? []), EXTENSION];
  source.json.meshes.forEach((mesh, m) =>
    mesh.primitives.forEach((primitive, p) => {
      if (!primitive.extensions?.[EXTENSION]) return;
      const link = structuredClone(primitive.extensions[EXTENSION]);
      if (link.micromapIndices !== undefined) {
        const accessor = structuredClone(source.json.accessors[link.micromapIndices]);
        json.accessors.push({ ...accessor, bufferView: view(accessor.bufferView) });
        link.micromapIndices = json.accessors.length - 1;
      }
      const of = json.meshes[m].primitives[p];
      of.extensions = { ...of.extensions, [EXTENSION]: link };
    })
  );
  json.buffers[0].byteLength = bin.length;
  return bin;
}

await MeshoptEncoder.ready;
await MeshoptDecoder.ready;
const io = new NodeIO().setLogger(new Logger(Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS).registerDependencies({
  "meshopt.encoder": MeshoptEncoder,
  "meshopt.decoder": MeshoptDecoder,
  "draco3d.encoder": await draco3d.createEncoderModule(),
  "draco3d.decoder": await draco3d.createDecoderModule(),
});
const document = await io.read(from);
document.setLogger(new Logger(Verbosity.SILENT));
await document.transform(how === "draco" ? draco() : meshopt({ encoder: MeshoptEncoder }));
const target = `${to}.compressed.glb`;
await io.write(target, document);
const compressed = readGlb(target);
fs.unlinkSync(target);
const extension = how === "draco" ? "KHR_draco_mesh_compression" : "EXT_meshopt_compression";
if (!compressed.json.extensionsUsed?.includes(extension)) throw new Error(`${to}: nothing was compressed by ${extension}`);
writeGlb(to, compressed.json, copyMicromaps(readGlb(from), compressed));
