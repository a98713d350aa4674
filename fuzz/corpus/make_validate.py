#!/usr/bin/env python3
"""Writes the seed corpus of scene_validate_file: python3 fuzz/corpus/make_validate.py build/seeds

An input is a byte that says what the rest is, as the harness's head has it."""
import json
import struct

import seeds

# Two records of level 1 in 4-state, their data, and three indices of 16 bits: 0, 1 and O.
RECORDS = struct.pack("<IHHIHH", 0, 1, 2, 1, 1, 2)
BESIDE = RECORDS + bytes([0x1B, 0xE4]) + struct.pack("<3H", 0, 1, 0xFFFE)


def raw(**changes):
    """A raw array whose buffers all lie in one file; a change may be None: the member is left out."""
    whole = {
        "schema": "mmverify.array/1", "apis": ["ext", "khr", "dxr"],
        "records": {"file": "a.bin", "bytes": 16}, "data": {"file": "a.bin", "offset": 16, "bytes": 2},
        "usageCounts": [{"count": 2, "level": 1, "format": 2}],
        "geometries": [{"triangles": 3, "indices": {"file": "a.bin", "offset": 18, "type": "u16"}}],
    } | changes  # fmt: skip
    return b"s" + json.dumps({k: v for k, v in whole.items() if v is not None}).encode() + b"\0" + BESIDE


def geometry(**changes):
    return raw(geometries=[{"triangles": 3, "indices": {"file": "a.bin", "offset": 18, "type": "u16"}} | changes])


def array_file(*parts):
    """Version 2; the harness puts the checksum right."""
    head = b"MMARRAYS" + struct.pack("<4I", 2, 2, 2, len(parts))
    for encoding, base, indices, width in parts:
        head += struct.pack("<3I", encoding, base, len(indices) // width)
    return b"a" + head + RECORDS + b"".join(indices for _, _, indices, _ in parts) + bytes([0x1B, 0xE4]) + bytes(4)


SIGNED = struct.pack("<2h", 0, -1)
seeds.write({
    "scene_validate_file": {
        "raw": raw(),
        "raw_gltf": raw(apis=["gltf"]),
        "raw_without_counts": raw(usageCounts=None),
        "raw_alone": raw(geometries=None),
        "raw_without_indices": geometry(indices=None, triangles=2),
        "raw_base": geometry(baseTriangle=1, triangles=1),
        "raw_one_for_all": geometry(indices={"file": "a.bin", "offset": 18, "type": "u16", "stride": 0}, triangles=1000000),
        "raw_u8": geometry(indices={"file": "a.bin", "offset": 18, "type": "u8", "bytes": 3}),
        "raw_i32": geometry(indices={"file": "a.bin", "offset": 18, "type": "i32", "bytes": 4}, triangles=1),
        "raw_advice": raw(apis=["ext"], geometries=[{"triangles": 1, "indices": {"file": "a.bin", "type": "u16", "address": 1}}]),
        "raw_histograms": geometry(usageCounts=[{"count": 1, "level": 1, "format": 2}, {"count": 0, "level": 13, "format": 3}]),
        "raw_wrong_histogram": raw(apis=["ext"], usageCounts=[{"count": 3, "level": 1, "format": 2}]),
        "raw_limits": raw(limits={"twoStateLevel": 0, "fourStateLevel": 0, "triangles": 1}, lossy=True),
        "raw_strides": raw(records={"file": "a.bin", "stride": 12, "count": 2}),
        "raw_addresses": raw(records={"file": "a.bin", "bytes": 16, "address": 3}, data={"file": "a.bin", "address": 5}),
        "raw_types": raw(records=7, data={"file": 7}, usageCounts={}, geometries=[5, {"triangles": "3"}], limits=[], lossy=0),
        "raw_paths": raw(records={"file": "../a.bin"}, data={"file": ""}),
        "raw_ranges": raw(records={"file": "a.bin", "offset": 2**64 - 1}, data={"file": "a.bin", "offset": 1, "bytes": 2**63}),
        "raw_unknown": raw(more=1, apis=["ext", "metal"], data=None),
        "raw_of_another_schema": raw(schema="mmverify.array/2"),
        "raw_cut": raw()[:40],
        "array": array_file((1, 0, struct.pack("<2H", 1, 0xFFFF), 2)),
        "array_two": array_file((3, 0, SIGNED, 2), (0, 1, b"\0\xfe", 1)),
        "array_out_of_range": array_file((0, 2, b"\0", 1)),
        "array_encoding": array_file((5, 0, b"\0", 1)),
        "array_cut": array_file((0, 0, b"\0", 1))[:30],
        "array_of_version_1": b"fMMARRAYS" + struct.pack("<5I", 1, 2, 2, 1, 0) + RECORDS + struct.pack("<I", 1) + bytes([0x1B, 0xE4]),
        "array_of_version_3": b"fMMARRAYS" + struct.pack("<I", 3),
        "tree_flat": b"fmmtr\1\0\2\0" + bytes(8) + b"\3",
        "graph": b"fmmdg\1\1\0\0" + bytes(24),
        "attributes": b"fmmat\1" + bytes(40),
        "gltf": b'f{"asset":{"version":"2.0"}}',
        "gltf_khr": b'f{"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_opacity_micromap"],'
                    b'"extensions":{"KHR_mesh_opacity_micromap":{"micromaps":[{}]}}}',
        "text": b"ftext",
    },
})  # fmt: skip
