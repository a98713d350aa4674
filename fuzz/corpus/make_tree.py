#!/usr/bin/env python3
"""Writes the seed corpora of the tree's harnesses: python3 fuzz/corpus/make_tree.py build/seeds

Below it the folders tree_round_trip and tree_decoder; see the head of each harness for what an input is.
"""
import random
import struct

import seeds


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


def sequences(states, bits):
    """Both sequences of a map, as bytes, and the number of nodes: Algorithm 1."""
    tree, data = [], []

    def node(part):
        if min(part) == max(part):
            tree.append(0)
            data.append(part[0])
            return
        tree.append(1)
        quarter = len(part) // 4
        for k in range(4):
            node(part[k * quarter:(k + 1) * quarter])

    def packed(values, width):
        number = sum(value << width * k for k, value in enumerate(values))
        return number.to_bytes((len(values) * width + 7) // 8, "little")

    node(states)
    return packed(tree, 1), packed(data, bits), len(tree)


def streamed(level, bits, states):
    tree, data, nodes = sequences(states, bits)
    return stream(level, bits, nodes, tree, data)


def contained(level, bits, states):
    tree, data, nodes = sequences(states, bits)
    return container(level, bits, 1, (nodes - 1) // 4, tree + data)


def run(state, exponent):
    return state | exponent << 2


# The worked example of tests/impl/tree_test.cpp: 13 nodes, 10 leaves.
TREE, DATA = [0b00000101, 0b00000001], [0b00000001, 0b11011001, 0b00001111]
MAP = [0b01010101, 0b01000000, 0b10101010, 0b11111101]
# Level 4, one micro-triangle apart, child 0 all the way: 1111 then the leaves; 13 states, the first four 0 1 0 0.
DEEP_TREE, DEEP_DATA = [0b00001111, 0, 0], [0b00000100, 0, 0, 0]

rng = random.Random(1)
NOISE = [rng.randrange(4) for _ in range(256)]
TWO = [state % 2 for state in NOISE]
# Noise in one sixteenth of level 5, the rest uniform: a tree smaller than the map.
CORNER = NOISE[:64] + [1] * 960

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
    "noise_level_5": bytes([5, 3]) + rng.randbytes(256),
    "two_states_noise_level_6": bytes([6, 2]) + rng.randbytes(512),
    # The first byte also chooses how deep blocks begin, the second how deep the tree does.
    "deep_blocks": bytes([5 + 8 * 4, 2 + 4 * 2]) + rng.randbytes(128),
    "shallow_blocks": bytes([5 + 8 * 1, 3 + 4 * 1]) + rng.randbytes(256),
    "shallow_blocks_two_states": bytes([5 + 8 * 2, 2 + 4 * 2]) + rng.randbytes(128),
    "uniform_shallow_blocks": bytes([4 + 8 * 1, 1, run(1, 14)]),
    "dense_then_plain": bytes([6, 3] + list(range(256)) + [0] * 768),
}

def header(magic=b"mmtr", version=1, level=2, bits=2, kind=0, internal=0, payload=bytes(4)):
    return magic + bytes([version, level, bits, kind]) + struct.pack("<I", internal) + bytes(4) + payload


DECODER = {
    "noise_stream": streamed(4, 2, NOISE),
    "noise_stream_two_states": streamed(4, 1, TWO),
    "corner_stream": streamed(5, 2, CORNER),
    "corner_container": contained(5, 2, CORNER),
    "corner_container_two_states": contained(5, 1, [state % 2 for state in CORNER]),
    "four_alike_inside": stream(4, 2, 85, sequences(NOISE, 2)[0], bytes(70)),
    "too_many_nodes": stream(0, 2, 5, [1], [0, 0]),
    "short_data": stream(2, 2, 13, TREE, DATA[:1]),
    "a_fault_in_the_tree": container(4, 2, 1, 4, bytes([0x1f, 0, 0] + DEEP_DATA)),
    "not_ours": header(magic=b"glTF"),
    "version_2": header(version=2),
    "level_13": header(level=13),
    "three_bits": header(bits=3),
    "kind_2": header(kind=2),
    "flat_with_nodes": header(internal=1),
    "more_nodes_than_a_level_has": header(kind=1, internal=6),
    "tree_larger_than_flat": header(kind=1, internal=5),
    "flat_with_padding": header(level=0, payload=b"\xff"),
    "header_cut": header()[:15],

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

seeds.write({"tree_round_trip": ROUND_TRIP, "tree_decoder": DECODER})
