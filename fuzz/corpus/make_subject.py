#!/usr/bin/env python3
"""Writes the seed corpus of the harness of other people's libraries: python3 fuzz/corpus/make_subject.py build/seeds

Below it the folder subject; one seed for each thing that subject.cpp asks.
"""
import struct

import seeds

RUNS = bytes([28, 29, 30, 31] * 4)  # T, O, UT, UO (or T, C, O, C), 128 of each

SEEDS = {
    # level 5: multiples of 1/128, moved by ulps; two points
    "index_near_lines": bytes([0, 5, 1]) + bytes([3, 0, 0, 4, 5, 0, 0, 3]) * 2,
    # from 170 on raw floats: 1/4, 1/2 at level 0
    "index_any_floats": bytes([0, 255, 0]) + struct.pack("<ff", 0.25, 0.5),
    "tree_level_2": bytes([1, 2, 1, 16, 5, 10, 15, 1]),
    # the code that docs/TREE.md works out by hand
    "tree_code_by_hand": bytes([2, 2, 1, 0x05, 0x01, 0x90, 0x5F, 0x01]),
    # the same with a bit after the last state, which is no code
    "tree_code_with_padding": bytes([2, 2, 1, 0x05, 0x01, 0x90, 0x5F, 0x81]),
    "vq2_block_zeros": bytes([3]) + bytes(32),
    "vq4_block_counting": bytes([4]) + bytes(range(64)),
    "vq2_map_of_runs": bytes([5]) + RUNS,
    "vq4_map_of_runs": bytes([6]) + RUNS,
    "vq2_held_map": bytes([7]) + bytes(range(32)),
    "vq4_held_map": bytes([8]) + bytes(64),
    "lossy_level_0": bytes([9, 0, 3]),
    "lossy_level_3": bytes([9, 3, 12, 13, 14, 15]),
    "tree_level_9": bytes([1, 251, 1] + [60, 61, 62, 63] * 8),
}

seeds.write({"subject": SEEDS})
