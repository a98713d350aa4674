#!/usr/bin/env bash
# A scene with micromaps that glTF-Transform has compressed, by meshoptimizer and by Draco, with its micromaps copied as
# they were: the file is valid, the cause of its wrong maps is named, and a repair makes them right without baking.
# usage: tests/outside/gltf_transform_test.sh MMVERIFY        exit code 77: skipped, and why
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1")
root=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")
packages=${MMVERIFY_GLTF_TRANSFORM:-$root/build/gltf-transform}
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }
"$root/scripts/npm-packages" "$root/scripts/gltf-transform" "$packages" "glTF-Transform"
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { printf 'FAILED: %s\n' "$*"; exit 1; }

# Meshes of shared vertices.  Their UVs are fifteenths, from 0 to 1, which 12 bits hold: compression leaves them as they
# are.  No alpha between two texels' is at a vertex of a micro-triangle what the cutoff is.
python3 - "$folder" <<'PYTHON'
import json, math, pathlib, random, struct, sys, zlib

folder, draw = pathlib.Path(sys.argv[1]), random.Random(48)
side, cells = 48, 5
chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
spots = [(draw.random() * side, draw.random() * side, draw.uniform(4, 10)) for _ in range(7)]
alpha = lambda x, y: max(0, min(255, int(127 + 60 * max(r - math.hypot(x - u, y - v) for u, v, r in spots))))
rows = b"".join(b"\0" + b"".join(bytes((90, 140, 60, alpha(x, y))) for x in range(side)) for y in range(side))
png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 6, 0, 0, 0))
(folder / "leaf.png").write_bytes(png + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))

binary, views, accessors, primitives = b"", [], [], []


def accessor(kind, component, form, values):
    global binary
    data = b"".join(struct.pack(form, *value) for value in values)
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
    binary += data + bytes(-len(data) % 4)
    accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind})
    if kind == "VEC3":
        accessors[-1] |= {"min": [min(axis) for axis in zip(*values)], "max": [max(axis) for axis in zip(*values)]}
    return len(accessors) - 1


for k in range(3):
    inner = lambda at: 3 * at + (draw.randrange(-1, 2) if 0 < at < cells else 0)
    uvs = [(inner(i) / 15, inner(j) / 15) for j in range(cells + 1) for i in range(cells + 1)]
    indices = []
    for j in range(cells):
        for i in range(cells):
            a, b = j * (cells + 1) + i, (j + 1) * (cells + 1) + i
            for corners in [(a, a + 1, b), (a + 1, b + 1, b)] if draw.random() < 0.5 else [(a, a + 1, b + 1), (a, b + 1, b)]:
                first = draw.randrange(3)
                indices += [(corner,) for corner in corners[first:] + corners[:first]]
    attributes = {
        "POSITION": accessor("VEC3", 5126, "<3f", [(u + 2 * k, v, 0.1 * u * v) for u, v in uvs]),
        "TEXCOORD_0": accessor("VEC2", 5126, "<2f", uvs),
    }
    primitives.append(
        {"attributes": attributes, "indices": accessor("SCALAR", 5123, "<H", indices), "material": 0, "mode": 4}
    )
(folder / "leaves.bin").write_bytes(binary)
document = {
    "asset": {"version": "2.0"},
    "buffers": [{"uri": "leaves.bin", "byteLength": len(binary)}],
    "bufferViews": views,
    "accessors": accessors,
    "images": [{"uri": "leaf.png"}],
    "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9729, "minFilter": 9729}],
    "textures": [{"source": 0, "sampler": 0}],
    "materials": [
        {"alphaMode": "MASK", "alphaCutoff": 0.43, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    ],
    "meshes": [{"primitives": primitives}],
    "nodes": [{"mesh": 0}],
    "scenes": [{"nodes": [0]}],
    "scene": 0,
}
(folder / "leaves.gltf").write_text(json.dumps(document))
PYTHON

# ended CODE WHAT ARGUMENTS...: runs mmverify; its words are in `out`.
ended() {
  local wanted=$1 code=0
  shift
  "$mmverify" "$@" >"$folder/out" 2>&1 || code=$?
  ((code == wanted)) || { cat "$folder/out"; fail "$*: exit code $code, not $wanted"; }
}
cd "$folder"
ended 0 scene leaves.gltf --level 4 -o maps.glb --no-laws --quiet
ended 0 check maps maps.glb --quiet
for how in meshopt draco; do
  node "$root/scripts/gltf-transform/compressed.mjs" "$packages" "$how" maps.glb "$how.glb"
  code=0
  "$mmverify" scene "$how.glb" --level 0 --no-laws --quiet >out 2>&1 || code=$?
  if ((code == 4)) && grep -q 'built without' out; then
    echo "$how: not decoded: $(grep -m 1 'built without' out)"
    continue
  fi
  ended 0 validate "$how.glb"
  grep -q 'bake\.stale' out || { cat out; fail "$how: the record of the bake does not tell"; }
  ended 1 check maps "$how.glb" --quiet --json found.json
  python3 - found.json <<'PYTHON'
import json, sys

cause = json.load(open(sys.argv[1]))["cause"]
print(cause["says"])
assert cause["code"] == "corners+other_triangles", cause
assert cause["explained"] == cause["wrong"] > 50, cause
PYTHON
  grep -q "^next: mmverify repair $how.glb -o OUT.glb\$" out || { cat out; fail "$how: another advice"; }
  ended 0 repair "$how.glb" -o "repaired_$how.glb" --quiet
  ended 0 validate "repaired_$how.glb"
  ended 0 check maps "repaired_$how.glb" --quiet
  echo "$how: valid, diagnosed and repaired"
done
