#!/usr/bin/env python3
"""Writes the seed corpora of the square maps' harnesses: python3 fuzz/corpus/make_vq.py build/seeds

Below it the folders vq_encode and vq_decode; see the head of each harness for what an input is.
"""
import random

import seeds

VQ2, VQ4 = 0, 1
RUNS, REGIONS, VECTORS, BLOCK = 0, 2, 4, 6  # how the map is drawn, in the first byte
T, C, O = 0, 1, 2


def bits(fields):
    """Fields of (bits, value), from bit 0 of byte 0 on."""
    value = at = 0
    for width, field in fields:
        assert field >> width == 0
        value |= field << at
        at += width
    return value.to_bytes(at // 8, "little")


def block(side, indices, transforms, codes):
    widths = [5] * 11 if side == 2 else [17] * 3 + [18] * 2 + [20] * 8
    codes = [code & (1 << width) - 1 for code, width in zip(codes, widths)]
    return bits([(3 if side == 2 else 4, i) for i in indices] + [(3, t) for t in transforms] + list(zip(widths, codes)))


def regions(size, state):
    packed = bytearray(size * size // 4)
    for k in range(size * size):
        packed[k // 4] |= state(k % size, k // size) << 2 * (k % 4)
    return bytes(packed)


def disc(size, outline):
    def state(x, y):
        inside = (size * 3 // 8) ** 2 - (x - size / 2 + 0.5) ** 2 - (y - size / 3) ** 2
        return O if inside > outline else T if inside < -outline else C

    return regions(size, state)


rng = random.Random(1)
EVERY2, EVERY4 = [k % 8 for k in range(64)], [k % 4 + 4 * (k // 8 % 4) for k in range(64)]
CODES2, CODES4 = [rng.randrange(32) for _ in range(11)], [rng.randrange(1 << 20) for _ in range(13)]

ENCODE = {
    "vq2_runs": bytes([VQ2 | RUNS, 0] + [k % 3 | (5 * k % 64) << 2 for k in range(24)]),
    "vq2_disc": bytes([VQ2 | REGIONS, 0]) + disc(16, 10),
    "vq2_o_beside_t": bytes([VQ2 | REGIONS, 0]) + disc(16, 0),
    "vq2_few_vectors": bytes([VQ2 | VECTORS, 1, 3, 7, 11, 13]) + bytes(37 * k % 256 for k in range(64)),
    "vq2_block": bytes([VQ2 | BLOCK, 1]) + block(2, EVERY2, [1, 6, 4], CODES2),
    # What the fuzzer found of the planted encoder, from nothing: BR comes out rotated by 270.
    "vq2_rotated_by_270": bytes.fromhex("4673010a"),
    "vq2_uniform": bytes([VQ2 | RUNS, 0] + [0b11111110] * 4),
    # Balanced once lost more than fast here: the transforms of symmetric quadrants tie.
    "vq4_busy_and_symmetric": bytes.fromhex(
        "0301555555556a005556555555555a015556555555555a011555555555555601005555555555556a00a555555555aa560155"
        "55555555aa55055555555555aa5515505555555555aaaa565555555555a5a915555555555a55a415555555556a5590055555"
        "55555a001554555555556a95565555555555aaaa5a9555555555aaaa6aa55501aa165555555555166a0555555555055a5a05"
        "55555555006a5601555555555500159555555555550055a555555555564055a9555555555a9056aa55555555559556005555"
        "555555955a40555555556a955a5055555555aa956a9555555555555594015555555555aa94015555555555aaa40155555555"
        "55aaa50155555555"
    ),
    "vq4_runs": bytes([VQ4 | RUNS, 0] + [k % 3 | (7 * k % 64) << 2 for k in range(64)]),
    "vq4_disc": bytes([VQ4 | REGIONS, 13]) + disc(32, 40),
    "vq4_o_beside_t": bytes([VQ4 | REGIONS, 1]) + disc(32, 0),
    "vq4_few_vectors": bytes([VQ4 | VECTORS, 61, 4, 8, 16, 23, 42]) + bytes(53 * k % 256 for k in range(64)),
    "vq4_block": bytes([VQ4 | BLOCK, 13]) + block(4, EVERY4, [2, 5, 3], CODES4),
    "vq4_algorithm_2": bytes([VQ4 | VECTORS, 48, 2, 9, 20, 31]) + bytes(11 * k % 256 for k in range(64)),
}

DECODE = {
    "vq2_zeros": bytes(33),
    "vq2_ones": bytes([0]) + b"\xff" * 32,
    "vq2_every_index": bytes([0]) + block(2, EVERY2, [3, 5, 7], CODES2),
    "vq2_rotated": bytes([1]) + block(2, EVERY2, [1, 6, 7], CODES2[::-1]),
    "vq4_zeros": bytes([3] + [0] * 64),
    "vq4_every_index": bytes([0]) + block(4, EVERY4, [3, 5, 7], CODES4),
    "vq4_rotated": bytes([3]) + block(4, EVERY4, [1, 6, 7], CODES4[::-1]),
    "vq4_thorough": seeds.in_share(bytes([2]) + block(4, EVERY4, [2, 6, 1], CODES4), 8),
    "vq4_cut": bytes([3]) + block(4, EVERY4, [4, 4, 4], CODES4)[:40],
}

# Every encoder that they ask for judges these.  Their maps are whole before their last byte, which no region reads.
for name in ENCODE.keys() - {"vq2_rotated_by_270"}:
    ENCODE[name] = seeds.in_share(ENCODE[name], 64)

seeds.write({"vq_encode": ENCODE, "vq_decode": DECODE})
