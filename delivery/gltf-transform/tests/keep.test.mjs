// What a file has of micromaps is the same after glTF-Transform has read and written it.
import assert from "node:assert/strict";
import { test } from "node:test";

import { dedup, prune, resample, textureCompress, unpartition } from "@gltf-transform/functions";
import { EXTMeshOpacityMicromap } from "@mmverify/gltf-transform";

import { baked, inFolder, io, judged, name, plainIo, primitivesOf, read, readGlb, writeGlb } from "./scene.mjs";

/** What a file says of micromaps, with the bytes in the place of the numbers of views. */
function said(path, extension = name) {
  const { json, bin } = readGlb(path);
  const bytes = (view) => {
    const { byteOffset = 0, byteLength, ...others } = json.bufferViews[view];
    assert.deepEqual(others, { buffer: 0 });
    return bin.subarray(byteOffset, byteOffset + byteLength).toString("hex");
  };
  return {
    micromaps: json.extensions[extension].micromaps.map((m) => ({ ...m, data: bytes(m.data), triangles: bytes(m.triangles) })),
    links: json.meshes.flatMap(({ primitives }) => primitives.map(({ extensions }) => {
      const { micromapIndices, ...link } = extensions[extension];
      if (micromapIndices === undefined) return link;
      const { bufferView, componentType, count, type } = json.accessors[micromapIndices];
      const size = { 5121: 1, 5122: 2, 5123: 2, 5124: 4, 5125: 4 }[componentType];
      return { ...link, indices: { componentType, count, type, bytes: bytes(bufferView).slice(0, 2 * size * count) } };
    })),
  };
}

const copied = inFolder("copied.glb");
async function copy(path, ...transforms) {
  const document = await read(path);
  await document.transform(...transforms);
  await io.write(copied, document);
}

test("all of it, after each operation that leaves triangles alone", async () => {
  const file = baked(4);
  for (const transform of [prune(), dedup(), unpartition(), resample(), textureCompress({ targetFormat: "png" })]) {
    await copy(file, transform);
    assert.deepEqual(said(copied), said(file), transform.name);
    assert.deepEqual([judged(copied).validate, judged(copied).check], [0, 0], transform.name);
  }
  // glTF-Transform by itself drops it.
  await plainIo.write(copied, await read(file, plainIo));
  assert.equal(readGlb(copied).json.extensions, undefined);
});

/** The baked file with other indices: their type, and a base that they are less. */
function withIndices(path, to, componentType, Type, base, change = () => {}) {
  const { json, bin } = readGlb(path);
  const parts = [bin];
  let end = bin.length;
  const view = (bytes) => {
    const padded = Buffer.concat([Buffer.from(bytes), Buffer.alloc(-bytes.length & 3)]);
    json.bufferViews.push({ buffer: 0, byteOffset: end, byteLength: bytes.length });
    parts.push(padded), (end += padded.length);
    return json.bufferViews.length - 1;
  };
  for (const primitive of json.meshes[0].primitives) {
    const link = primitive.extensions[name], accessor = json.accessors[link.micromapIndices];
    const { byteOffset = 0 } = json.bufferViews[accessor.bufferView];
    const Old = { 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array }[accessor.componentType];
    const old = new Old(Uint8Array.from(bin.subarray(byteOffset, byteOffset + accessor.count * Old.BYTES_PER_ELEMENT)).buffer);
    const limit = 2 ** (8 * Old.BYTES_PER_ELEMENT);
    const codes = Array.from(old, (value) => (value >= limit - 4 || value < 0 ? value - (value < 0 ? 0 : limit) : value - base + (link.micromapBaseTriangle ?? 0)));
    accessor.bufferView = view(new Uint8Array(new Type(codes).buffer));
    accessor.componentType = componentType;
    link.micromapBaseTriangle = base;
    change(primitive, json, view, codes);
  }
  json.buffers[0].byteLength = end;
  writeGlb(to, { json, bin: Buffer.concat(parts) });
}

const given = inFolder("given.glb");
for (const [componentType, Type] of [[5121, Uint8Array], [5122, Int16Array], [5123, Uint16Array], [5124, Int32Array], [5125, Uint32Array]])
  test(`indices of componentType ${componentType}, with special ones; names and extras, too`, async () => {
    withIndices(baked(4), given, componentType, Type, 0, (primitive, json) => {
      Object.assign(primitive.extensions[name], { micromapBaseTriangle: 0, name: "of a leaf", extras: { kept: [1, { deep: true }] } });
      Object.assign(json.extensions[name].micromaps[0], { name: "leaves", extras: { by: "a baker" } });
      delete primitive.extensions[name].micromapBaseTriangle;
    });
    assert.equal(judged(given).check, 0, judged(given).text);
    await copy(given);
    assert.deepEqual(said(copied), said(given));
    assert.deepEqual([judged(copied).validate, judged(copied).check], [0, 0]);
    const [link] = primitivesOf(await read(copied)).map((primitive) => primitive.getExtension(name));
    assert.ok(link.getIndices().some((code) => code < 0 && code >= -4) && link.getIndices().every((code) => code >= -4));
  });

test("sparse indices and a base triangle", async () => {
  withIndices(baked(4), given, 5125, Uint32Array, 0, (primitive, json, view, codes) => {
    const link = primitive.extensions[name], accessor = json.accessors[link.micromapIndices];
    const special = codes.flatMap((code, k) => (code < 0 ? [k] : []));
    const base = Math.min(...codes.filter((code) => code >= 0));
    link.micromapBaseTriangle = base;
    accessor.bufferView = view(new Uint8Array(Uint32Array.from(codes, (code) => (code < 0 ? 0 : code - base)).buffer));
    accessor.sparse = {
      count: special.length,
      indices: { bufferView: view(new Uint8Array(Uint16Array.from(special).buffer)), componentType: 5123 },
      values: { bufferView: view(new Uint8Array(Uint32Array.from(special, (k) => codes[k]).buffer)) },
    };
  });
  await copy(given);
  const { micromapBaseTriangle, indices } = said(copied).links[2], [, , third] = primitivesOf(await read(given));
  assert.ok(micromapBaseTriangle > 0 && indices.count === 50);
  assert.equal(third.getExtension(name).codeOf(0), third.getExtension(name).getIndices()[0] + micromapBaseTriangle);
  assert.deepEqual([judged(copied).validate, judged(copied).check], [0, 0], judged(copied).text);
});

test("the older name", async () => {
  const khr = name.replace("EXT", "KHR"), { json, bin } = readGlb(baked(4));
  writeGlb(given, { json: JSON.parse(JSON.stringify(json).replaceAll(name, khr)), bin });
  await copy(given);
  assert.deepEqual(said(copied, khr), said(given, khr));
  assert.equal(judged(copied).validate, 0);
});

test("a file that is wrong is refused with its place", async () => {
  const wrong = (change) => {
    const { json, bin } = readGlb(baked(4));
    change(json, json.meshes[0].primitives[1].extensions[name]);
    writeGlb(given, { json, bin });
    return read(given);
  };
  await assert.rejects(wrong((_, link) => (link.micromap = 3)), /mesh 0 primitive 1: there is no micromap 3/);
  await assert.rejects(wrong((_, link) => (link.micromapIndices = 99)), /mesh 0 primitive 1: there is no accessor 99/);
  await assert.rejects(wrong((json, link) => (json.accessors[link.micromapIndices].count = 1e6)), /primitive 1: its bytes end beyond its bufferView/);
  await assert.rejects(wrong((json, link) => (json.accessors[link.micromapIndices].componentType = 5126)), /primitive 1: componentType 5126 is not/);
  await assert.rejects(wrong((json) => (json.extensions[name].micromaps[0].data = 99)), /micromap 0: there is no bufferView 99/);
  const document = await read(baked(4)), [link] = document.createExtension(EXTMeshOpacityMicromap).listMicromaps();
  assert.throws(() => link.getStates(999), /there is no record 999/);
  const first = primitivesOf(document)[0].getExtension(name);
  first.setIndices(Int32Array.from(first.getIndices(), () => 300)).setIndexType(5121);
  await assert.rejects(io.writeBinary(document), /componentType 5121 is too small/);
});
