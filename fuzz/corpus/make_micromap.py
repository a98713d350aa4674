#!/usr/bin/env python3
"""Writes the seed corpora of micromap_codec and micromap_array: python3 fuzz/corpus/make_micromap.py build/seeds

The records are described in micromap_codec.cpp and micromap_array.cpp.
"""
import struct

import seeds

U8, U16, U32, I16, I32 = range(5)
EXT, KHR, DXR, GLTF = 1, 2, 4, 8


def number(value):
    return bytes([value]) if value < 255 else b"\xff" + struct.pack("<Q", value)


# ---- micromap_codec: format and kind of size, size, packed bytes


def level(form, n, packed):
    return bytes([(form - 1) | 2, n]) + bytes(packed)


def states(form, count, packed):
    return bytes([form - 1, count]) + bytes(packed)


CODEC = {
    "all_states": level(2, 1, [0xE4]),
    "level_0_padding": level(2, 0, [0xFE]),
    "level_0_two_state": level(1, 0, [0xFF]),
    "level_2_two_state": level(1, 2, [0x01, 0x80]),
    "ties": level(2, 3, [0x14, 0x05, 0x50, 0x41, 0xBE, 0xF5, 0x0A, 0xA0] * 2),
    "uniform_opaque": level(2, 4, [0x55] * 64),
    "last_differs": level(2, 5, [0xAA] * 255 + [0xEA]),
    "uniform_two_state": level(1, 6, [0xFF] * 512),
    "word_and_one": states(2, 33, range(9)),
    "two_words_less_one": states(1, 127, [0x6C] * 16),
    "nothing": states(2, 0, []),
    "three_states": states(1, 3, [0xFD]),
}

# ---- micromap_array


def record(offset, n, form):
    return struct.pack("<IHH", offset, n, form)


def raw(sets, encoding, records, data_bytes, indices, triangles, *, count=None, stride=8, index_stride=None, base=0,
        lossy=0, indexed=1, array=(), geometry=(), limits=None):
    flags = lossy | indexed << 1 | (limits is not None) << 2 | bool(array) << 4 | bool(geometry) << 5
    width = (1, 2, 4, 2, 4)[encoding]
    buffer = b"".join(records)
    out = bytes([0, sets, flags, encoding])
    for limit in limits or ():
        out += number(limit)
    for value in (len(records) if count is None else count, stride, triangles,
                  width if index_stride is None else index_stride, base):
        out += number(value)
    for entries in (array, geometry):
        out += bytes([len(entries)]) + b"".join(number(value) for entry in entries for value in entry)
    return out + bytes([data_bytes, len(buffer)]) + buffer + b"".join(
        (i % (1 << 8 * width)).to_bytes(width, "little") for i in indices)


TWO = [record(0, 2, 2), record(4, 1, 1)]
COUNTS = [(1, 1, 1), (1, 2, 2)]
MANY = 2**64 - 1

RAW = {
    "clean": raw(GLTF, I16, TWO, 5, [0, -2, 1, -4], 4, array=COUNTS),
    "overlap": raw(GLTF, U16, [record(8, 2, 2), record(0, 3, 2), record(4, 2, 2), record(0, 3, 2)], 16, [0], 1),
    "region": raw(DXR, U32, [record(0xFFFFFFFF, 12, 2), record(2, 30, 2), record(2, 65535, 1)], 3, [0, 1, 2], 3),
    "levels": raw(EXT | KHR, U16, TWO, 5, [0], 1, limits=(0, 1, 1, 1), array=COUNTS),
    "lossy": raw(KHR, U32, TWO, 5, [0], 1, lossy=1, limits=(12, 12, 1, 9)),
    "below_minus_4": raw(GLTF, I32, TWO, 5, [-5, -2**31, 0], 3),
    "strictly_less": raw(EXT | KHR | DXR | GLTF, U16, TWO, 5, [2, 1, 65531], 3),
    "base": raw(KHR, U8, TWO, 5, [0, 1, 251, 252], 4, base=1),
    "exchanged": raw(EXT, U16, TWO, 5, [0, 0, 1], 3, array=[(1, 1, 1), (2, 2, 2)], geometry=COUNTS),
    "no_indices": raw(EXT, U16, TWO, 5, [], 3, indexed=0, array=COUNTS, geometry=COUNTS),
    "absurd": raw(15, U32, TWO, 5, [0], MANY, count=MANY, stride=MANY, index_stride=MANY, base=2**32 - 1),
    "stride_0": raw(15, U16, TWO, 5, [1], 2**60, stride=0, index_stride=0, geometry=[(255, 1, 1)]),
    "empty": raw(15, U8, [], 0, [], 0),
}


def built(breach, where, encoding, maps, share=1, special=1):
    return bytes([1, breach, where, share | special << 1, encoding, len(maps)]) + b"".join(maps)


def whole(n, form, packed):
    return bytes([n | (form - 1) << 2]) + bytes(packed)


def filled(n, form, byte):
    return bytes([n | (form - 1) << 2 | 8, byte])


MAPS = [whole(1, 2, [0xE4]), filled(2, 2, 0x55), whole(1, 1, [0xF4]), whole(1, 2, [0xE4]), filled(3, 1, 0x3C)]

SEEDS = {
    "micromap_codec": CODEC,
    "micromap_array": RAW
    | {f"breach_{k}": built(k, k, I16 if k in (3, 6) else U16, MAPS) for k in range(12)}
    | {
        "unshared": built(5, 1, U8, MAPS * 3, share=0, special=0),
        "too_many_for_u8": built(5, 0, U8, [filled(0, 1, k % 2) for k in range(255)], share=0, special=0),
        "all_special": built(4, 0, I32, [filled(2, 2, b) for b in (0, 0x55, 0xAA, 0xFF)]),
    },
}

seeds.write(SEEDS)
