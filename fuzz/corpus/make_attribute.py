#!/usr/bin/env python3
"""Writes the seed corpus of attribute_container: python3 fuzz/corpus/make_attribute.py build/seeds

What an input is: the head of fuzz/attribute_container.cpp; a file's bytes: docs/ATTRIBUTE_FORMAT.md.
"""
import random
import struct

import seeds

FILE, MENDED, CODES, PACKED = range(4)
FACES, VERTICES = 0, 1


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


# ---- Packed maps: one channel of one map, small levels


def family(a, b, c, d):
    s, t = (a + b) // 2, (c + d) // 2
    return (s + t + 1) // 2, [a - b, c - d, s - t]


def face_residuals(values):
    """Root, and the residuals of each level, the coarsest first."""
    levels = []
    while len(values) > 1:
        families = [family(*values[k:k + 4]) for k in range(0, len(values), 4)]
        levels.insert(0, [r for _, residuals in families for r in residuals])
        values = [parent for parent, _ in families]
    return values, levels


def folded(residual):
    return 2 * residual if residual >= 0 else -2 * residual - 1


def packed_faces(values, wider=0):
    """Bytes of one map of one channel, level up to 3; `wider` than its last block needs to be."""
    roots, levels = face_residuals(values)
    blocks = []
    if levels:
        blocks.append([r for level in levels[:2] for r in level])
    blocks += levels[2:]
    starts, widths, bits, used = b"", [], 0, 0
    for block in blocks:
        width = max(folded(r).bit_length() for r in block) + (wider if block is blocks[-1] else 0)
        widths.append(width)
        for r in block:
            bits |= folded(r) << used
            used += width
    if blocks:
        starts = struct.pack("<I", 0)
    halves = widths + [0] * (len(widths) % 2)
    return (bytes(roots) + starts + bytes(low | high << 4 for low, high in zip(halves[::2], halves[1::2])) +
            bits.to_bytes((used + 7) // 8, "little"))


def shape(at, level, channels, maps):
    return at | level << 1 | (channels - 1) << 3 | (maps - 1) << 5


def codes(at, level, channels, maps, errors, content):
    return bytes([CODES, shape(at, level, channels, maps)]) + bytes(errors) + bytes(content)


def packed(at, level, channels, maps, errors, content):
    return bytes([PACKED, shape(at, level, channels, maps)]) + bytes(errors) + bytes(content)


# ---- Files


def file(payload, at=FACES, order=0, level=0, components=1, meaning=0, tie=None, decimation=0, mips=0, kind=0,
         errors=(0, 0, 0, 0), maps=1, triangles=(), announced=None, reserved=0, version=1):
    """`triangles`: pairs of a map and its flags."""
    tie = (1 if at == FACES else 0) if tie is None else tie
    head = b"mmat" + bytes([version, at, order, level, components, meaning, tie, decimation, mips, kind, reserved, 0])
    head += bytes(errors) + struct.pack("<IIQI", maps, len(triangles), len(payload) if announced is None else announced, 0)
    table = b"".join(struct.pack("<I", number) for number, _ in triangles)
    if decimation:
        flags = sum(bits << 3 * t for t, (_, bits) in enumerate(triangles))
        table += flags.to_bytes((3 * len(triangles) + 7) // 8, "little")
    return head + struct.pack("<I", crc32c(head + table + bytes(payload))) + table + bytes(payload)


def taken(how, data):
    return bytes([how]) + data


rng = random.Random(1)
NOISE = [rng.randrange(256) for _ in range(512)]
SMOOTH = [100 + k // 4 for k in range(64)]
THREE = [(0, 5), (1, 2), (0, 7)]

FILES = {
    "faces": file(NOISE[:48], level=2, components=7, meaning=1),
    "vertices": file(NOISE[:45], VERTICES, 2, level=2, components=7, meaning=2, maps=1),
    "length": file(NOISE[:24], VERTICES, 1, level=1, components=15, meaning=3),
    "rows": file(NOISE[:16], order=1, level=2, tie=2),
    "mips": file(NOISE[:42], level=2, mips=1, maps=2),
    "snapping": file(NOISE[:12], VERTICES, 0, level=1, decimation=1, maps=2, triangles=THREE),
    "means": file(NOISE[:12], VERTICES, 2, level=1, decimation=2, maps=2, triangles=THREE),
    "shared": file(NOISE[:4], level=1, triangles=[(0, 0)] * 4),
    "no_maps": file([], level=12, maps=0),
    "packed": file(packed_faces(SMOOTH), level=3, kind=1),
    "packed_error": file(packed_faces([k % 20 for k in range(16)]), level=2, kind=1, errors=(6, 0, 0, 0)),
}

# Refused, each for a reason of its own; the checksum is right.
REFUSED = {
    "bad_version": file([1], version=2),
    "bad_kind": file([1], at=2),
    "bad_order": file([1], order=3),
    "bad_level": file([1], level=13),
    "bad_components": file([1], components=0),
    "bad_meaning": file([1], meaning=1),
    "bad_tie": file([1], tie=0),
    "bad_decimation": file([1], decimation=1),
    "bad_mips": file(NOISE[:4], VERTICES, 2, level=0, mips=1),
    "bad_payload": file([1], kind=2),
    "bad_reserved": file([1], reserved=1),
    "bad_error": file([1], errors=(1, 0, 0, 0)),
    "bad_maps": file([1], maps=2**32 - 1, announced=2**32 - 1),
    "bad_map": file([1], triangles=[(1, 0)]),
    "bad_flags": file(NOISE[:12], VERTICES, 2, level=1, decimation=1, maps=2, triangles=THREE)[:-13] + b"\x02" +
                 bytes(NOISE[:12]),
    "bad_means": file(NOISE[:12], VERTICES, 2, level=1, decimation=2, maps=2, triangles=THREE)[:-13] + b"\x83" +
                 bytes(NOISE[:12]),
    "too_short": file(NOISE[:4], level=1)[:-1],
    "too_long": file(NOISE[:4], level=1) + b"\0",
    "no_header": b"mmat",
    "bad_magic": b"mmtr" + file([1])[4:],
    "bad_packed": file(packed_faces(SMOOTH)[:-1], level=3, kind=1),
    "packed_rows": file(packed_faces(SMOOTH), order=1, level=3, kind=1),
}

SEEDS = {
    "attribute_container": {name: taken(FILE, data) for name, data in FILES.items()}
    | {name: taken(MENDED, data) for name, data in REFUSED.items()}
    | {
        "bad_checksum": taken(FILE, file([1])[:40] + b"\0\0\0\0\1"),
        "codes_faces": codes(FACES, 3, 3, 2, [0, 0, 0], NOISE[:384]),
        "codes_vertices": codes(VERTICES, 3, 4, 2, [0, 1, 2, 127], NOISE[:360]),
        "codes_flat": codes(FACES, 3, 1, 4, [0], []),
        "codes_root": codes(VERTICES, 0, 1, 1, [0], [1, 2, 3]),
        "bytes_faces": packed(FACES, 3, 1, 1, [0], packed_faces(SMOOTH)),
        "bytes_wider": packed(FACES, 2, 1, 1, [0], packed_faces(SMOOTH[:16], 1)),
        "bytes_unused": packed(FACES, 1, 1, 1, [0], packed_faces([10, 5, 1, 4])[:-1] + b"\x1a"),
        "bytes_start": packed(FACES, 1, 1, 1, [0], b"\x05\x01\0\0\0\x04\x5a\x0a"),
        "bytes_width": packed(FACES, 1, 1, 1, [0], b"\x05\0\0\0\0\x0f\x5a\x0a"),
        "bytes_half": packed(FACES, 1, 1, 1, [0], b"\x05\0\0\0\0\x14\x5a\x0a"),
        "bytes_beyond": packed(FACES, 1, 1, 1, [0], b"\x01\0\0\0\0\x04\x5a\x0a"),
        "bytes_root": packed(FACES, 0, 1, 1, [127], [2]),
        "bytes_none": packed(VERTICES, 3, 4, 4, [0, 0, 0, 0], []),
    },
}

seeds.write(SEEDS)
