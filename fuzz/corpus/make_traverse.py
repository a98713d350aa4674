#!/usr/bin/env python3
"""Writes the seed corpus of traverse_differential: python3 fuzz/corpus/make_traverse.py build/seeds

Below it the folder traverse_differential. A record is who, candidate, instance and ray; see traverse_differential.cpp.
"""
import struct

import seeds

EXT_PIPELINE, EXT_QUERY, KHR_PIPELINE, KHR_QUERY, DXR_PIPELINE, DXR_QUERY = range(6)
ON = 0x100
T, O, UT, UO = (4 | state for state in range(4))
OPAQUE_GEOMETRY = 8
FORCE_OPAQUE, FORCE_NO_OPAQUE, INSTANCE_2_STATE, DISABLED = 4, 8, 16, 32
RAY_OPAQUE, RAY_NO_OPAQUE, CULL_OPAQUE, CULL_NO_OPAQUE, RAY_2_STATE = 1, 2, 64, 128, 1024
EVERY_RAY_FLAG = (0, RAY_OPAQUE, RAY_NO_OPAQUE, CULL_OPAQUE, CULL_NO_OPAQUE)


def hit(distance, accepted, value, payload=0):
    """As part of a ray; `payload`, of the last one, is the ray's, and its lowest byte picks the operation."""
    return (distance << 9 | accepted << 7, value, 0, payload)


SEEDS = {
    "each_state": [(KHR_PIPELINE | ON, state, 0, 0) for state in (T, O, UT, UO)],
    "two_state": [
        (KHR_QUERY | ON, state, instance, ray)
        for state in (T, O, UT, UO)
        for instance, ray in ((INSTANCE_2_STATE, 0), (0, RAY_2_STATE), (INSTANCE_2_STATE, RAY_2_STATE))
    ],
    "no_micromap": [(EXT_QUERY, geometry, 0, ray) for geometry in (0, OPAQUE_GEOMETRY) for ray in EVERY_RAY_FLAG],
    "disabled": [(DXR_PIPELINE | ON, state | OPAQUE_GEOMETRY, DISABLED, RAY_2_STATE) for state in (T, O, UT, UO)],
    "overrides": [
        (DXR_QUERY | ON, state, instance, ray)
        for state in (T, UO)
        for instance in (0, FORCE_OPAQUE, FORCE_NO_OPAQUE)
        for ray in EVERY_RAY_FLAG
    ],
    "not_enabled": [(api, O, instance, 0) for api in range(6) for instance in (0, DISABLED)],
    "exclusive_flags": [
        (KHR_PIPELINE | ON, UT, FORCE_OPAQUE | FORCE_NO_OPAQUE, 0),
        (KHR_PIPELINE | ON, UT, 0, RAY_OPAQUE | RAY_NO_OPAQUE),
        (KHR_PIPELINE | ON, UT, 0, CULL_OPAQUE | CULL_NO_OPAQUE | RAY_OPAQUE),
    ],
    "other_bits": [(EXT_PIPELINE | ON, 0xFFFFFFF0 | UO, 0xFFFFFFC3, 0xFFFFFB3C)],
    "wall_before_glass": [hit(2, 0, 0x02020202), hit(1, 1, 0, 0)],
    "glass_before_wall": [hit(1, 0, 0x40302010), hit(2, 1, 0), hit(3, 0, 0xFFFFFFFF, 2)],
    "multiply": [hit(1, 0, 0x40404040), hit(2, 0, 0x80808080, 0x02020203)],
    "over": [hit(1, 0, 0x80402010), hit(2, 0, 0xFF010203), hit(3, 0, 0x00FFFFFF, 0xC8C8C804)],
    "wall_and_glass_at_one_distance": [hit(1, 0, 0x02020202), hit(1, 1, 0, 0)],
    "twice": [hit(1, 0, 0x11223344), hit(1, 0, 0x11223344, 0xFFFFFF01)],
}

seeds.write({
    "traverse_differential": {
        name: b"".join(struct.pack("<IIII", *record) for record in records) for name, records in SEEDS.items()
    }
})  # fmt: skip
