#!/usr/bin/env python3
"""Writes the seed corpora of the tree's harnesses: python3 fuzz/make_tree_corpus.py fuzz/corpus

Below it the folders tree_round_trip and tree_decoder; see the head of each harness for what an input is.
"""
import pathlib
import struct
import sys


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def container(level, bits, kind, internal, payload):
    head = b"mmtr" + bytes([1, level, bits, kind]) + struct.pack("<I", internal)
    return head + struct.pack("<I", crc32c(head + payload)) + payload


def stream(level, bits, nodes, tree, data):
    return bytes([level, (nodes - 1) // 4 * 2 + (bits - 1)]) + bytes(tree) + bytes(data)


def run(state, exponent):
    return state | exponent << 2


# The worked example of tests/impl_tree_test.cpp: 13 nodes, 10 leaves.
TREE, DATA = [0b00000101, 0b00000001], [0b00000001, 0b11011001, 0b00001111]
MAP = [0b01010101, 0b01000000, 0b10101010, 0b11111101]
# Level 4, one micro-triangle apart, child 0 all the way: 1111 then the leaves; 13 states, the first four 0 1 0 0.
DEEP_TREE, DEEP_DATA = [0b00001111, 0, 0], [0b00000100, 0, 0, 0]

ROUND_TRIP = {
    "level_0_two_states": bytes([0, 2, 0x01]),
    "level_0_four_states": bytes([0, 3, 0x03]),
    "level_1": bytes([1, 3, 0b11100100]),
    "worked_example": bytes([2, 3, *MAP]),
    "uniform_level_7": bytes([7, 1, run(2, 14)]),
    "checker_level_5": bytes([5, 2] + [0x55] * 128),
    "all_states_level_6": bytes([6, 3] + [0b11100100] * 1024),
    "runs_level_6": bytes([6, 0] + [run(k & 1, k % 7) for k in range(200)]),
    "runs_level_7": bytes([7, 1] + [run(k & 3, k % 10) for k in range(250)]),
    "dense_then_plain": bytes([6, 3] + list(range(256)) + [0] * 768),
}

DECODER = {
    "flat_container": container(2, 2, 0, 0, bytes(MAP)),
    "tree_container": container(2, 2, 1, 0, b"\x00\x03"),
    "uniform_level_12": container(12, 2, 1, 0, b"\x00\x02"),
    "deep_container": container(4, 2, 1, 4, bytes(DEEP_TREE + DEEP_DATA)),
    "level_0_container": container(0, 1, 0, 0, b"\x01"),
    "flat_of_a_uniform_map": container(2, 2, 0, 0, bytes(4)),
    "announces_more": container(12, 2, 1, 1000000, b"")[:16],
    "worked_stream": stream(2, 2, 13, TREE, DATA),
    "deep_stream": stream(4, 2, 17, DEEP_TREE, DEEP_DATA),
    "deep_stream_two_levels_short": stream(2, 2, 17, DEEP_TREE, DEEP_DATA),
    "four_alike": stream(1, 2, 5, [0b00001], [0b01010101]),
    "ends_early": stream(2, 2, 13, [0b00000100, 1], DATA),
    "ends_late": stream(2, 2, 13, [0b00000111, 1], DATA),
    "padding_set": stream(2, 2, 13, [0b00000101, 0x81], DATA),
    "one_leaf": stream(12, 1, 1, [0], [1]),
}

for name, seeds in {"tree_round_trip": ROUND_TRIP, "tree_decoder": DECODER}.items():
    folder = pathlib.Path(sys.argv[1], name)
    folder.mkdir(parents=True, exist_ok=True)
    for seed, data in seeds.items():
        (folder / seed).write_bytes(data)
