#!/usr/bin/env python3
"""Writes the seed corpus of index_differential: python3 fuzz/corpus/make_index.py build/seeds

Below it the folder index_differential. A record is u, v (binary32) and a level byte; see index_differential.cpp.
"""
import struct

import seeds

ULP1 = 2.0**-24  # spacing of binary32 just below 1
TINY = 2.0**-149
HUGE = 2.0**127
INF, NAN = float("inf"), float("nan")


def from_bits(bits):
    return struct.unpack("<f", struct.pack("<I", bits))[0]


SEEDS = {
    "corners": [(0, 0, n) for n in (0, 1, 16)] + [(1, 0, n) for n in (0, 1, 16)] + [(0, 1, n) for n in (0, 1, 16)],
    "grid_ties": [(i / 4, j / 4, 2) for i in range(5) for j in range(5 - i)],
    "grid_ties_level_16": [(i / 65536, j / 65536, 16) for i, j in ((1, 65535), (32768, 32768), (21845, 43690), (1, 1))],
    "diagonals_exact": [(3 / 16, 5 / 16, 2), (1 / 8, 7 / 8, 3), (0.5, 0.25, 1), (0.375, 0.375, 1)],
    "diagonals_straddled": [((1 - ULP1) / 2, 2.0**-26, 1), ((1 - ULP1) / 2, 2.0**-25, 1), (0.25, 0.25 - ULP1 / 4, 1)],
    "one_ulp_beyond": [(0.5, 0.5 + ULP1, n) for n in (1, 5, 16)] + [(0.75, 0.25 + ULP1, 4)],
    "one_ulp_within": [(0.5, 0.5 - ULP1 / 2, n) for n in (1, 5, 16)] + [(1 - ULP1, ULP1, 4)],
    "subnormals": [(TINY, 0.5, 3), (0.5, TINY, 3), (TINY, 1 - ULP1, 16), (2.0**-127, 2.0**-140, 16)],
    "small_normals": [(2.0**-76, 0.5, 8), (2.0**-77, 0.5, 8), (2.0**-126, 1.0, 8)],
    "negative_zero": [(-0.0, 0.5, 4), (0.5, -0.0, 4), (-0.0, -0.0, 0)],
    "not_a_number": [(NAN, 0.5, 4), (0.5, NAN, 4), (NAN, NAN, 16)],
    "infinities": [(INF, 0, 4), (0, INF, 4), (-INF, 0.5, 4), (INF, INF, 16), (INF, -INF, 16)],
    "outside": [(2, -1, 5), (-0.25, 0.5, 5), (1, 1, 16), (0.75, 0.75, 7), (HUGE, -HUGE, 9), (-TINY, 1.5, 2)],
    # With v = 0 the bits of u are the index whose corners are asked for: row order's root is tried at its steps.
    "perfect_squares": [
        (from_bits(r * r - below), 0, 16) for r in (2, 3, 4096, 4097, 11585, 30001, 46341, 65535) for below in (0, 1)
    ],
    "levels_beyond": [(0.3, 0.6, n) for n in (15, 16, 17, 31)],
}

seeds.write({
    "index_differential": {
        name: b"".join(struct.pack("<ffB", *record) for record in records) for name, records in SEEDS.items()
    }
})  # fmt: skip
