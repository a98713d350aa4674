#!/usr/bin/python3
"""Writes leaves.gltf, leaves.bin and leaf.png: three alpha-tested meshes of shared vertices in one glTF mesh.

usage: leaves.py FOLDER

Their UVs are fifteenths, from 0 to 1, which 12 bits hold: compression leaves them as they are.  No alpha between two
texels' is at a vertex of a micro-triangle what the cutoff is.
"""
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
