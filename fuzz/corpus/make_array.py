#!/usr/bin/env python3
"""Writes the seed corpus of array_differential: python3 fuzz/corpus/make_array.py build/seeds

The records are described in array_differential.cpp, the files in docs/ARRAYS.md.
"""
import struct

import seeds

U8, U16, U32, I16, I32 = range(5)
EXT, KHR, DXR, OPTIX, NVAPI, GLTF = range(6)
WIDTH = (1, 2, 4, 2, 4)


def checksum(data):
    value = 0x811C9DC5
    for byte in data:
        value = (value ^ byte) * 0x01000193 % 2**32
    return value


def indices(encoding, codes):
    width = WIDTH[encoding]
    return b"".join((c % (1 << 8 * width)).to_bytes(width, "little") for c in codes)


def record(offset, level, form):
    return struct.pack("<IHH", offset, level, form)


def version_1(records, codes, data, base=0):
    head = b"MMARRAYS" + struct.pack("<5I", 1, len(records), len(data), len(codes), base)
    return bytes([0]) + head + b"".join(records) + indices(U32, codes) + data


def version_2(records, parts, data):
    file = b"MMARRAYS" + struct.pack("<4I", 2, len(records), len(data), len(parts))
    for encoding, base, codes in parts:
        file += struct.pack("<3I", encoding, base, len(codes))
    file += b"".join(records) + b"".join(indices(e, codes) for e, _, codes in parts) + data
    return bytes([0]) + file + struct.pack("<I", checksum(file))


TWO = [record(0, 2, 2), record(4, 1, 1)]
DATA = bytes([0xE4, 0x1B, 0, 0xFF, 0x09])


def whole(level, form, packed):
    return bytes([level | (form - 1) << 2]) + bytes(packed)


def filled(level, form, byte):
    return bytes([level | (form - 1) << 2 | 8, byte])


def built(maps, api=KHR, encoding=U8, base=0, bound=0, before=0, share=1, special=1):
    return bytes([1, special | share << 1 | api << 2, encoding, base, bound, before]) + b"".join(maps)


NEAR = [whole(1, 2, [0x54]), whole(1, 2, [0x55]), whole(1, 2, [0x44]), whole(1, 2, [0xE4]), whole(1, 1, [0x05])]
MAPS = [whole(1, 2, [0xE4]), filled(2, 2, 0x55), whole(1, 1, [0xF4]), whole(1, 2, [0xE4]), filled(3, 1, 0x3C)]

seeds.write({
    "array_differential": {
        "version_1": version_1(TWO, [0, -2, 1, -4], DATA),
        "version_1_base": version_1(TWO, [0, -1], DATA, base=1),
        "version_2": version_2(TWO, [(U8, 0, [0, 1, -3]), (I16, 1, [0, -1])], DATA),
        "no_geometry": version_2(TWO, [], DATA),
        "nothing": version_2([], [], b""),
        "outside": version_2(TWO, [(U16, 0, [2])], DATA),
        "below_minus_4": version_2(TWO, [(I32, 0, [-5])], DATA),
        "no_format": version_2([record(0, 1, 3)], [(U8, 0, [0])], DATA),
        "beyond_the_data": version_2([record(4, 2, 2)], [(U8, 0, [0])], DATA),
        "overlap": version_2([record(0, 2, 2), record(1, 2, 2)], [(U8, 0, [1, 0])], DATA),
        "bad_encoding": version_2([], [(I32, 0, [])], b"")[:25] + bytes([5]) + version_2([], [(I32, 0, [])], b"")[26:],
        "bad_checksum": version_2(TWO, [], DATA)[:-1] + b"\0",
        "version_3": bytes([0]) + b"MMARRAYS" + struct.pack("<I", 3),
        "cut": version_2(TWO, [(U8, 0, [0])], DATA)[:-9],
        "longer": version_1(TWO, [0], DATA) + b"\0",
        "billions": bytes([0]) + b"MMARRAYS" + struct.pack("<4I", 2, 2**32 - 1, 2**32 - 1, 2**32 - 1),
        "no_name": bytes([0]) + b"MMARRAY",
        "shared": built(MAPS),
        "both_histograms": built(MAPS, api=EXT, encoding=U16),
        "unshared": built(MAPS * 3, share=0, special=0, api=OPTIX, encoding=U32),
        "before": built(MAPS, base=1, before=2, api=NVAPI, encoding=U32),
        "signed": built(MAPS, api=GLTF, encoding=I16),
        "merged": built(NEAR, bound=1),
        "merged_more": built(NEAR + MAPS + [filled(3, 2, b) for b in (0x50, 0x51, 0x54, 0x55, 0xA5)], bound=7, special=0),
        "merged_behind": built(NEAR * 2, bound=2, base=1, before=1, share=0),
        "too_many_for_u8": built([filled(0, 1, k % 2) for k in range(255)], share=0, special=0),
    }
})
