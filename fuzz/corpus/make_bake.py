#!/usr/bin/env python3
"""Writes the seed corpus of the bakers' harness: python3 fuzz/corpus/make_bake.py build/seeds

Below it the folder bake_differential; see the head of the harness for what an input is.
"""
import random
import struct

import seeds

REPEAT, MIRROR, CLAMP, BORDER, ONCE = range(5)
U8, U16, F32 = 0, 64, 128
NEAREST, BLEND, MIPS, HALF, BITS, MARGIN = 1, 2, 4, 8, 64, 128


def case(width, height, texels, uv, wrap=(REPEAT, REPEAT), how=0, level=2, cutoff=(0, 0), factor=0, away=(0, 0),
         border=0, texel=U8):  # fmt: skip
    head = bytes([width - 1 | height - 1 << 3 | texel, wrap[0] + 5 * wrap[1], how | level << 4, *cutoff, factor,
                  away[0] | away[1] << 4, border])  # fmt: skip
    numbers = struct.pack("<6f", *uv) if how & BITS else struct.pack("<6h", *(round(16384 * x) for x in uv))
    return head + numbers + bytes(texels)


rng = random.Random(1)
HALF_SQUARE = (0, 0, 1, 0, 0, 1)
CROSSING = (0.125, 0.1875, 1, 0.25, 0.375, 0.875)
BEYOND = (1.25, -0.25, -0.5, 0.5, 0.75, 1.5)
NOISE = [rng.randrange(256) for _ in range(64)]
CHECKERS = [255 * ((k + k // 4) % 2) for k in range(16)]

SEEDS = {
    "nothing": b"",
    "half_square": case(2, 2, [0, 255, 255, 0], HALF_SQUARE),
    "crossing_noise": case(8, 8, NOISE, CROSSING, level=3),
    "beyond_every_edge": case(4, 4, CHECKERS, BEYOND, (MIRROR, CLAMP), level=3),
    "border": case(3, 3, NOISE[:9], BEYOND, (BORDER, BORDER), border=200),
    "mirror_once": case(3, 2, NOISE[:6], (-1, -0.5, 0.5, -1, 1.5, 1), (ONCE, ONCE), border=1),
    "planted": case(4, 4, CHECKERS, BEYOND, (ONCE, REPEAT), border=9),
    "at_the_cutoff": case(2, 1, [128, 128], HALF_SQUARE, cutoff=(128, 254)),
    "line": case(4, 4, CHECKERS, (0, 0.25, 0.5, 0.5, 1, 0.75)),
    "point": case(2, 2, [0, 255, 0, 255], (0.25, 0.25) * 3, level=1),
    "sliver": case(5, 5, NOISE[:25], (0, 0, 2, 1, 1, 0.5 + 2**-20), how=BITS),
    "far_away": case(4, 4, CHECKERS, CROSSING, (REPEAT, MIRROR), away=(15, 14)),
    "beside_a_line": case(4, 4, CHECKERS, (0.25 - 2**-26, 0.25, 0.75, 0.25 + 2**-26, 0.25, 0.75), how=BITS),
    "nearest": case(4, 4, CHECKERS, (0.25, 0.25, 0.75, 0.25, 0.25, 0.75), how=NEAREST),
    "nearest_beyond": case(3, 3, NOISE[:9], BEYOND, (ONCE, BORDER), how=NEAREST, level=3, border=255),
    "blend": case(3, 3, [0, 0, 255, 0, 255, 255, 0, 128, 255], CROSSING, how=BLEND, level=3),
    "blend_nearest": case(2, 2, [0, 255, 128, 255], HALF_SQUARE, how=BLEND | NEAREST),
    "words": case(3, 3, NOISE[:9], CROSSING, texel=U16, cutoff=(77, 254)),
    "floats": case(3, 3, NOISE[:9], CROSSING, texel=F32, cutoff=(3, 7), factor=40),
    "floats_below_0": case(2, 2, [0, 10, 255, 128], HALF_SQUARE, texel=F32, how=BLEND | HALF),
    "mips": case(4, 4, NOISE[:20], CROSSING, how=MIPS, cutoff=(1, 4)),
    "margin": case(4, 4, CHECKERS, CROSSING, how=MARGIN, level=3),
    "factors": case(4, 4, NOISE[:16], CROSSING, how=HALF, factor=100, cutoff=(1, 3)),
}

seeds.write({"bake_differential": SEEDS})
