#!/usr/bin/env bash
# KTX2 against another decoder: the texels of 110 pictures, 38 of them of random UASTC blocks of each mode, and the maps
# of a glTF whose texture is a KTX2 against those of a glTF with the same texels as a PNG. A changed texel is found.
# usage: tests/outside/ktx2_test.sh SCENE_TEST MMVERIFY        exit code 77: skipped, and why
set -euo pipefail

(($# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
scene_test=$1 mmverify=$2
root=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../..
packages=${MMVERIFY_KTX2:-$root/build/ktx2}
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
"$root/scripts/npm-packages" "$root/scripts/ktx2" "$packages" "Basis Universal's encoder"
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

mkdir "$folder/pictures"
node "$root/scripts/ktx2/pictures.mjs" "$packages" "$folder/pictures" >"$folder/digests"
compare() {
  MMVERIFY_KTX2_PICTURES=$folder/pictures "$scene_test" --gtest_filter=SceneKtx2.PicturesAreThoseOfAnotherDecoder
}
compare | tee "$folder/out"
grep -q '\[  PASSED  \] 1 test' "$folder/out"
grep 'no astcenc' "$folder/digests" || true

# The encoder writes the files of tests/scene/files.
for file in "$root"/tests/scene/files/etc1s_*.ktx2; do
  cmp "$file" "$folder/pictures/$(basename "$file")"
done

python3 - "$folder" <<'PYTHON'
import json, pathlib, struct, sys, zlib

folder = pathlib.Path(sys.argv[1])


def png(width, height, rgba):
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + rgba[4 * width * y : 4 * width * (y + 1)] for y in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


square = struct.pack("<12f8f6H", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 2, 3, 2, 1)
views = [(0, 48), (48, 32), (80, 12)]
accessors = [(5126, 4, "VEC3"), (5126, 4, "VEC2"), (5123, 6, "SCALAR")]
for name, width, height in [("etc1s_leaf", 64, 64), ("more_uastc_64x64_leaf", 64, 64)]:
    ktx2 = (folder / "pictures" / (name + ".ktx2")).read_bytes()
    rgba = (folder / "pictures" / (name + ".rgba")).read_bytes()
    for kind, picture, texture in [
        ("ktx2", ktx2, {"extensions": {"KHR_texture_basisu": {"source": 0}}}),
        ("png", png(width, height, rgba), {"source": 0}),
    ]:
        (folder / f"{name}.{kind}").write_bytes(picture)
        document = {
            "asset": {"version": "2.0"},
            "buffers": [{"uri": "square.bin", "byteLength": len(square)}],
            "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
            "accessors": [
                {"bufferView": k, "componentType": c, "count": n, "type": t} for k, (c, n, t) in enumerate(accessors)
            ],
            "images": [{"uri": f"{name}.{kind}", "mimeType": "image/" + kind}],
            "textures": [texture],
            "materials": [{"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
            "nodes": [{"mesh": 0}],
            "scenes": [{"nodes": [0]}],
        }
        if kind == "ktx2":
            document |= {"extensionsUsed": ["KHR_texture_basisu"], "extensionsRequired": ["KHR_texture_basisu"]}
        (folder / f"{name}_{kind}.gltf").write_text(json.dumps(document))
(folder / "square.bin").write_bytes(square)
PYTHON

maps() {
  python3 - "$1" <<'PYTHON'
import json, struct, sys

glb = open(sys.argv[1], "rb").read()
size = struct.unpack_from("<I", glb, 12)[0]
document, binary = json.loads(glb[20 : 20 + size]), glb[28 + size :]
extension = "EXT_mesh_opacity_micromap"
for micromap in document["extensions"][extension]["micromaps"]:
    for key in ("data", "triangles"):
        view = document["bufferViews"][micromap[key]]
        print(key, binary[view.get("byteOffset", 0) :][: view["byteLength"]].hex())
    print([micromap[key] for key in ("usageCounts", "usageLevels", "usageFormats")])
PYTHON
}
for name in etc1s_leaf more_uastc_64x64_leaf; do
  for kind in ktx2 png; do
    file=$folder/${name}_$kind
    "$mmverify" scene "$file.gltf" --level 5 -o "$file.glb" --quiet >"$folder/out" || { cat "$folder/out"; exit 1; }
    "$mmverify" check maps "$file.glb" --quiet
    maps "$file.glb" >"$file.maps"
  done
  cmp "$folder/${name}_ktx2.maps" "$folder/${name}_png.maps"
  # 2 triangles of level 5 have 2 x 1024 states; uniform maps would need no data.
  (($(wc -c <"$folder/${name}_ktx2.maps") > 500)) || { echo "FAILED: the maps have no data"; exit 1; }
  echo "$name: the maps of the KTX2 are those of the PNG"
done

printf '\1' | dd of="$folder/pictures/etc1s_grey.rgba" bs=1 seek=99 conv=notrunc status=none
if compare >"$folder/out"; then
  echo "FAILED: a changed texel is not found"
  exit 1
fi
grep -q 'etc1s_grey.ktx2' "$folder/out"
echo "ok"
