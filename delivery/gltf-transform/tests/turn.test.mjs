// Maps fit after each operation that moves, turns or joins triangles; without this package they do not.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";

import { draco, flatten, join, meshopt, prune, quantize, reorder, simplify, unweld, weld } from "@gltf-transform/functions";
import { EXTMeshOpacityMicromap, withMicromaps, write, writeBinary } from "@mmverify/gltf-transform";
import { MeshoptSimplifier } from "meshoptimizer";

import { baked, encoder, inFolder, io, judged, name, native, plainIo, primitivesOf, read, readGlb, warnings, writeGlb } from "./scene.mjs";

const made = baked(4), out = inFolder("out.glb");
const fine = (file, what) => {
  const { validate, check, text } = judged(file);
  assert.deepEqual([validate, check], [0, 0], `${what}: ${text}`);
};
/** How many triangles of a file have maps, by the native program. */
const counted = (file) => Number(/([\d,]+) triangles with maps/.exec(judged(file).text)?.[1] ?? 0);
const arraysOf = (document) => document.createExtension(EXTMeshOpacityMicromap).listMicromaps();
/** The scene with its primitives in meshes and nodes of their own, the last one mirrored. */
async function apart() {
  const document = await read(made), [scene] = document.getRoot().listScenes();
  const mirrored = (k) => (k === 2 ? [-1, 1, 1] : [1, 1, 1]);
  for (const node of scene.listChildren()) node.dispose();
  const [mesh] = document.getRoot().listMeshes();
  mesh.listPrimitives().forEach((primitive, k) => {
    const own = document.createMesh(`leaf ${k}`).addPrimitive(primitive);
    mesh.removePrimitive(primitive);
    scene.addChild(document.createNode().setMesh(own).setTranslation([k, 0, 0]).setScale(mirrored(k)));
  });
  mesh.dispose();
  return document;
}

const operations = {
  reorder: { transforms: [reorder({ encoder })], without: 1 },
  "reorder for speed": { transforms: [reorder({ encoder, target: "performance" })], without: 1 },
  weld: { transforms: [unweld(), weld()], without: 0 },
  prune: { transforms: [prune()], without: 0 },
  quantize: { transforms: [quantize()], without: 0 },
  // The program's 2: the joined primitive has no maps any more.
  join: { transforms: [flatten(), join()], without: 2 },
  "join, weld, reorder": { transforms: [flatten(), join(), weld(), reorder({ encoder })], without: 2 },
};
for (const [what, { transforms, without }] of Object.entries(operations))
  test(what, async () => {
    for (const from of [() => read(made), apart]) {
      const document = await from();
      await document.transform(withMicromaps(transforms));
      await write(io, out, document);
      fine(out, what);
      assert.equal(counted(out), 150);
      assert.equal(arraysOf(document).length, 1);
      assert.ok(document.getRoot().listAccessors().every((accessor) => accessor.listParents().length > 1), "an accessor is left behind");
      const unaware = await from();
      await unaware.transform(...transforms);
      await io.write(out, unaware);
      assert.equal(judged(out).check, without, "without withMicromaps");
    }
  });

for (const [what, transform] of Object.entries({
  meshopt: () => meshopt({ encoder }),
  "meshopt, medium": () => meshopt({ encoder, level: "medium" }),
  draco: () => draco(),
  "draco, fast": () => draco({ encodeSpeed: 10, decodeSpeed: 10 }),
  "draco, sequential": () => draco({ method: "sequential" }),
}))
  test(`${what}: triangles are ordered while the file is written`, async () => {
    const document = await apart();
    await document.transform(withMicromaps([transform()]));
    const before = primitivesOf(document).map((primitive) => [...primitive.getExtension(name).getIndices()]);
    await write(io, out, document);
    const { extensionsRequired } = readGlb(out).json;
    assert.match(String(extensionsRequired), /meshopt|draco/);
    fine(out, what);
    assert.equal(counted(out), 150);
    // The document is what it was: it writes the same bytes again.
    assert.deepEqual(primitivesOf(document).map((primitive) => [...primitive.getExtension(name).getIndices()]), before);
    assert.ok(Buffer.from(await writeBinary(io, document)).equals(readFileSync(out)));
    // Reading and writing it plainly is refused: its maps would be those of another order.
    await assert.rejects(io.writeBinary(document), /orders triangles anew while it writes/);
    const again = await read(out);
    await write(io, out, again);
    fine(out, `${what}, read and written once more`);
  });

test("a compressor's order without turning is found wrong", async () => {
  for (const transform of [meshopt({ encoder }), draco()]) {
    const document = await apart();
    await document.transform(transform);
    // What write() prevents: the maps as they were, beside triangles as the compressor ordered them.
    for (const extension of document.getRoot().listExtensionsUsed()) if (extension.extensionName === name) extension.hidden = new Set();
    await io.write(out, document);
    assert.equal(judged(out).check, 1);
  }
});

test("glTF-Transform without the package: no maps are left", async () => {
  const document = await read(made, plainIo);
  await document.transform(reorder({ encoder }));
  await plainIo.write(out, document);
  assert.deepEqual([judged(out).validate, judged(out).check], [0, 2]);
});

test("a primitive without maps that is joined to others asks the shader", async () => {
  const document = await apart();
  primitivesOf(document)[1].setExtension(name, null);
  await document.transform(withMicromaps([flatten(), join()]));
  const [joined] = primitivesOf(document), codes = joined.getExtension(name).getIndices();
  assert.equal(primitivesOf(document).length, 1);
  assert.deepEqual([...codes.subarray(50, 100)], Array(50).fill(-4));
  await write(io, out, document);
  assert.equal(judged(out).validate, 0);
  assert.match(judged(out).text, /proved +bake\.conservative/);
});

test("arrays of joined primitives become one", async () => {
  const document = await apart(), extension = document.createExtension(EXTMeshOpacityMicromap);
  const parts = primitivesOf(document);
  for (const primitive of parts) {
    const link = primitive.getExtension(name);
    link.setMicromap(link.getMicromap().clone());
  }
  assert.equal(extension.listMicromaps().length, 4);
  extension.listMicromaps()[0].dispose();
  // The first and the third become one; the second, whose array they do not have, stays as it is.
  const second = parts[1].getExtension(name);
  await document.transform(withMicromaps([flatten(), join({ filter: (node) => node.getMesh().listPrimitives()[0] !== parts[1] })]));
  assert.equal(primitivesOf(document).length, 2);
  assert.equal(extension.listMicromaps().length, 2);
  assert.ok(primitivesOf(document).some((primitive) => primitive.getExtension(name) === second));
  await write(io, out, document);
  fine(out, "three arrays");
  assert.equal(counted(out), 150);
});

test("indices get a greater type where there are more maps than theirs can name", async () => {
  const document = await apart();
  const copies = document.getRoot().listMeshes().flatMap((mesh) => [0, 1].map((k) => {
    const [primitive] = mesh.listPrimitives(), copy = primitive.clone().setIndices(primitive.getIndices().clone());
    mesh.addPrimitive(copy);
    return { copy, k };
  }));
  for (const primitive of primitivesOf(document)) primitive.getExtension(name).setIndexType(5121);
  // Each map in three orders of its corners: three times as many.
  await document.transform(withMicromaps(() => {
    for (const { copy, k } of copies) {
      const array = copy.getIndices().getArray();
      copy.getIndices().setArray(array.map((_, at) => array[at - (at % 3) + ((at + 1 + k) % 3)]));
    }
  }));
  const [micromap] = arraysOf(document);
  assert.ok(micromap.listRecords().length > 252);
  assert.ok(primitivesOf(document).some((primitive) => primitive.getExtension(name).getIndexType() === 5123));
  await write(io, out, document);
  fine(out, "more maps");
  assert.equal(counted(out), 450);
});

test("UVs that move are told, and the native program judges the maps", async () => {
  for (const transform of [draco({ quantizeTexcoord: 9 }), quantize({ quantizeTexcoord: 9 })]) {
    const document = await read(made);
    warnings.length = 0;
    await document.transform(withMicromaps(transform));
    await write(io, out, document);
    // Half a step of 511.
    const [, moved] = /UVs moved by up to ([\d.e-]+)/.exec(warnings.join()) ?? assert.fail("no warning");
    assert.ok(moved > 1 / 2048 && moved < 1 / 1022 + 1e-6, moved);
    assert.equal(judged(out).check, 1);
  }
  warnings.length = 0;
  await (await read(made)).transform(withMicromaps([unweld(), weld(), reorder({ encoder })]));
  assert.deepEqual(warnings, []);
});

test("new triangles are an error, or ask the shader", async () => {
  const transforms = [weld(), simplify({ simplifier: MeshoptSimplifier, ratio: 0.2, error: 1 })];
  await MeshoptSimplifier.ready;
  await assert.rejects((await read(made)).transform(withMicromaps(transforms)), /mesh 0 primitive 0 triangle \d+ is new: .*Bake again/);
  const document = await read(made);
  await document.transform(withMicromaps(transforms, { newIsUnknown: true }));
  await write(io, out, document);
  // No known state is wrong, as there are none; that they are needlessly unknown, a bake puts right.
  const { validate, check, text } = judged(out);
  assert.deepEqual([validate, check], [0, 1], text);
  assert.deepEqual([...text.matchAll(/^refuted +(\S+) {2}/gm)].map(([, law]) => law), ["bake.tight"]);
  assert.equal(native(["repair", out, "-o", inFolder("again.glb"), "--bake", "--quiet"]).code, 0);
  fine(inFolder("again.glb"), "baked again");
});

test("equal corners with different maps are an error, with equal maps none", async () => {
  const doubled = async (change) => {
    const document = await read(made), [primitive] = primitivesOf(document), link = primitive.getExtension(name);
    const array = primitive.getIndices().getArray(), codes = [...link.getIndices()];
    primitive.getIndices().setArray(Uint16Array.of(...array, ...array.subarray(0, 3)));
    link.setIndices(Int32Array.of(...codes, change(codes[0])));
    return document;
  };
  await assert.rejects((await doubled((code) => (code === -1 ? -2 : -1))).transform(withMicromaps(reorder({ encoder }))), /2 triangles had these corners before, and their maps differ/);
  const document = await doubled((code) => code);
  await document.transform(withMicromaps(reorder({ encoder })));
  await write(io, out, document);
  fine(out, "a triangle twice");
});

test("maps of the older name are turned, too", async () => {
  const khr = name.replace("EXT", "KHR"), given = inFolder("given.glb");
  const renamed = (from, to, old, wanted) => {
    const { json, bin } = readGlb(from);
    writeGlb(to, { json: JSON.parse(JSON.stringify(json).replaceAll(old, wanted)), bin });
  };
  renamed(made, given, name, khr);
  const document = await read(given);
  await document.transform(withMicromaps(draco()));
  await write(io, out, document);
  assert.ok(readGlb(out).json.extensionsUsed.includes(khr));
  renamed(out, given, khr, name);
  fine(given, "under the newer name");
});

test("a .gltf beside its files", async () => {
  const document = await read(made), path = inFolder("written/out.gltf");
  await document.transform(withMicromaps(draco()));
  await write(io, path, document);
  fine(path, "gltf");
});
