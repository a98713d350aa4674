#!/usr/bin/env python3
"""Writes the seed corpus of dag_container: python3 fuzz/corpus/make_dag.py build/seeds

See the head of the harness for what an input is.  Containers are put together by hand here; one checksum is left wrong.
"""
import struct

import seeds


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def container(bits, records, tiles=(), flat=(), nodes=()):
    """Records (level, kind, value); tiles and flat by words of 64 bits; nodes by words of 32."""
    body = b"".join(struct.pack("<BBHI", level, kind, 0, value) for level, kind, value in records)
    body += b"".join(struct.pack("<Q", word) for word in (*tiles, *flat))
    body += b"".join(struct.pack("<I", word) for word in nodes)
    head = b"mmdg" + struct.pack("<BBHIIIII", 1, bits, 0, len(records), len(tiles) // bits, len(flat) // bits,
                                 len(nodes), 0)
    return b"\0" + head + struct.pack("<I", crc32c(head + body)) + body


def maps(four_states, *each):
    return bytes([1 + 2 * four_states]) + b"".join(bytes([level, share]) + data for level, share, data in each)


TILE = struct.pack("<Q", 1)
SMALL, UNIFORM, MIXED_TILE, NODE, FLAT = range(5)
SEEDS = {
    "empty": container(1, []),
    "small_2_state": container(1, [(0, SMALL, 1), (1, SMALL, 0xE), (2, SMALL, 0x1234)]),
    "small_4_state": container(2, [(0, SMALL, 3), (1, SMALL, 0xE4), (2, SMALL, 0xE4E4E4E4)]),
    "uniform": container(2, [(3, UNIFORM, 2), (12, UNIFORM, 3)]),
    "tiles": container(1, [(3, MIXED_TILE, 0), (3, MIXED_TILE, 1), (3, MIXED_TILE, 0)], [1, 2]),
    "node": container(1, [(4, NODE, 0)], [1], (), [0x00020009, 0]),
    "node_4_state": container(2, [(4, NODE, 0)], [1, 0], (), [0x00050002, 1]),
    "two_levels": container(1, [(5, NODE, 0), (7, NODE, 5)], [1], (), [0x00000001, 0, 0x00000001, 0]),
    "level_7": container(1, [(7, NODE, 5)], [1], (), [0x00000001, 0, 0x00000003, 0, 0]),
    "level_12": container(1, [(12, NODE, 21)], [1], (),
                          [1, 0, 0xFFFF, *[0] * 16, *[0xFFFF, *[5] * 16], 0xFFFF, *[39] * 16, 0xF, *[73] * 4]),
    "flat": container(1, [(4, FLAT, 0), (4, FLAT, 0)], (), [1, 2, 3, 4]),
    "flat_though_tiles_came": container(1, [(4, FLAT, 0), *[(3, MIXED_TILE, k) for k in range(4)], (4, FLAT, 0)],
                                        [1, 2, 4, 8], [1, 2, 4, 8]),
    "wide_too_early": container(1, [(4, NODE, 1)], [1], (), [0x00020009, 0, 0]),
    "node_before_its_child": container(1, [(7, NODE, 1)], [1], (), [0x00000001, 4, 0x00000001, 0]),
    "itself": container(1, [(7, NODE, 1)], [1], (), [0x00000001, 1]),
    "out_of_order": container(1, [(3, MIXED_TILE, 1), (3, MIXED_TILE, 0)], [1, 2]),
    "flat_that_is_small": container(1, [(4, FLAT, 0)], (), [1, 0, 0, 0]),
    "wrong_checksum": container(1, [(3, MIXED_TILE, 0)], [1])[:29] + b"\0\0\0\0" + container(1, [(3, MIXED_TILE, 0)], [1])[33:],
    "cut": container(1, [(4, NODE, 0)], [1], (), [0x00020009, 0])[:50],
    "maps_small": maps(0, (0, 15, b"\1"), (1, 15, b"\7"), (2, 15, b"\x34\x12")),
    "maps_again": maps(0, (4, 4, TILE * 4), (4, 4, TILE * 4), (6, 15, (TILE + bytes(24)) * 16)),
    "maps_4_state": maps(1, (4, 8, bytes(range(64))), (5, 15, TILE * 32)),
    "maps_noise": maps(1, (5, 15, bytes((k * k * 7 + k) % 251 for k in range(256)))),
    "maps_sparse": maps(0, (6, 15, bytes(k % 61 == 0 for k in range(512)))),
}

seeds.write({"dag_container": SEEDS})
