#!/usr/bin/python3
"""Counts again what the examples print, from the printed records and indices, the UVs and the disc alone, in rationals.

usage: check.py leaf < OUTPUT      that of leaf_cpp or leaf_c
       check.py gltf FILE.glb < OUTPUT
"""
import collections
import json
import struct
import sys
from fractions import Fraction

WIDTH, HEIGHT = 64, 32
TRIANGLES = [[(0, 0), (1, 0), (0, 1)], [(1, 0), (1, 1), (0, 1)], [(0, 0), (1, 0), (0, 1)],
             [(30 / 64, 14 / 32), (34 / 64, 14 / 32), (30 / 64, 18 / 32)], [(0, 0), (8 / 64, 0), (0, 8 / 32)],
             [(46 / 64, 14 / 32), (50 / 64, 14 / 32), (46 / 64, 18 / 32)]]  # fmt: skip


def numbers(lines, start):
    return [tuple(int(word) for word in line.split() if word.lstrip("-").isdigit()) for line in lines if line.startswith(start)]


def need(holds, what):
    if not holds:
        sys.exit(f"check.py: {what}")


def check_array(lines):
    """The records lie in the data one after another; the array's usage counts them."""
    records = numbers(lines, "record")
    sizes = [max(1, 4**level * form // 8) for _, level, form in records]
    need([r[0] for r in records] == [sum(sizes[:k]) for k in range(len(sizes))], "records overlap or leave gaps")
    need(numbers(lines, "data") == [(sum(sizes),)], "the data has another size than the records")
    counted = collections.Counter((level, form) for _, level, form in records)
    right = sorted((count, *key) for key, count in counted.items())
    need(sorted(numbers(lines, "array usage")) == right, f"array usage is not {right}")
    return records


def check_geometry(lines, records):
    """The geometry's usage counts the triangles that refer to records."""
    (base,) = numbers(lines, "base")[0]
    indices = [i for (i,) in numbers(lines, "index")]
    need(all(-4 <= i and i + base < len(records) for i in indices), "an index names no record")
    counted = collections.Counter(records[i + base][1:] for i in indices if i >= 0)
    right = sorted((count, *key) for key, count in counted.items())
    need(sorted(numbers(lines, "geometry usage")) == right, f"geometry usage is not {right}")
    return indices


def alpha(x, y):
    """Whether texel (x, y) is in the disc; beyond the edge the picture repeats."""
    return int((2 * (x % WIDTH) + 1 - 64) ** 2 + (2 * (y % HEIGHT) + 1 - 32) ** 2 < 32**2)


def sampled(u, v):
    """Bilinear alpha, exactly."""
    x, y = u * WIDTH - Fraction(1, 2), v * HEIGHT - Fraction(1, 2)
    i, j = x // 1, y // 1
    f, g = x - i, y - j
    return sum(
        alpha(int(i) + a, int(j) + b) * (f if a else 1 - f) * (g if b else 1 - g) for a in (0, 1) for b in (0, 1)
    )


def useful_level(corners):
    at = [(Fraction(u) * WIDTH, Fraction(v) * HEIGHT) for u, v in corners]
    longest = max((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 for p in at for q in at)
    return next(n for n in range(13) if 4**n >= longest)


def check_leaf(lines):
    records = check_array(lines)
    indices = check_geometry(lines, records)
    need(len(indices) == len(TRIANGLES), "an index for each triangle")
    need(indices[0] == indices[2] and len({indices[0], indices[1], indices[5]}) == 3, "equal triangles share, others do not")
    need(indices[3] == -2 and indices[4] == -1, "within the disc -2, opaque; outside it -1, transparent")
    for corners, index in zip(TRIANGLES, indices):
        need(index < 0 or records[index][1] == useful_level(corners), f"level of {corners}")
    known = 0
    for corners, (state,) in zip(TRIANGLES, numbers(lines, "centre state")):
        u, v = Fraction(5, 16), Fraction(11, 32)
        at = [sum(w * Fraction(c[k]) for w, c in zip((1 - u - v, u, v), corners)) for k in (0, 1)]
        known += state < 2
        need(state > 1 or state == (sampled(*at) >= Fraction(1, 2)), f"state {state} of {corners} at its centre")
    need(known >= 5, "the states of at least five centres are known")
    if khr := numbers(lines, "KHR usage"):
        need(sorted(khr) == sorted(numbers(lines, "array usage")), "KHR usage")
        need(numbers(lines, "KHR record") == records, "KHR records")
        need(numbers(lines, "KHR index") == [(0, 2)], "KHR indices of 16 bits")


def check_gltf(lines, path):
    records = check_array(lines)
    parts, part = [], []
    for line in lines:
        if line.startswith(("index", "base", "geometry")):
            if line.startswith("index") and part and part[-1].startswith(("base", "geometry")):
                parts, part = [*parts, part], []
            part.append(line)
    got = [check_geometry(p, records) for p in [*parts, part]]
    # The same indices, read from the file here.
    data = open(path, "rb").read()
    length = struct.unpack_from("<I", data, 12)[0]
    document, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    right = []
    for primitive in (p for mesh in document["meshes"] for p in mesh["primitives"]):
        own = primitive.get("extensions", {}).get("EXT_mesh_opacity_micromap", {})
        if "micromapIndices" in own:
            accessor = document["accessors"][own["micromapIndices"]]
            at = document["bufferViews"][accessor["bufferView"]].get("byteOffset", 0) + accessor.get("byteOffset", 0)
            size, letter = {5123: (16, "H"), 5125: (32, "I")}[accessor["componentType"]]
            codes = struct.unpack_from(f"<{accessor['count']}{letter}", binary, at)
            right.append([c - (1 << size) if c >= (1 << size) - 4 else c for c in codes])
    need(got == right and right, "the indices are not the file's")


if __name__ == "__main__":
    printed = sys.stdin.read().splitlines()
    if sys.argv[1:2] == ["leaf"]:
        check_leaf(printed)
    elif sys.argv[1:2] == ["gltf"] and len(sys.argv) == 3:
        check_gltf(printed, sys.argv[2])
    else:
        sys.exit(__doc__)
