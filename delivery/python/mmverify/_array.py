"""Arrays of micromaps: what an acceleration structure is built from."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from . import _arguments, _core

# The order is that of the library's own numbers.
APIS = ("ext", "khr", "dxr", "optix", "nvapi", "gltf")
INDEX_TYPES = {"u8": "uint8", "u16": "uint16", "u32": "uint32", "i16": "int16", "i32": "int32"}
RECORD = np.dtype([("offset", "<u4"), ("level", "<u2"), ("format", "<u2")])
USAGE = np.dtype([("count", "<u4"), ("level", "<u4"), ("format", "<u4")])


@dataclass(frozen=True, eq=False)
class Array:
    """The buffers of an array of micromaps and of the geometry that refers to it. .tobytes() gives each one's bytes."""

    records: np.ndarray  #: VkMicromapTriangleEXT: offset, level, format
    data: np.ndarray  #: uint8, the packed maps
    indices: np.ndarray  #: one a triangle; -1 T, -2 O, -3 UT, -4 UO in two's complement are special
    histogram: np.ndarray  #: VkMicromapUsageEXT of the array's build: count, level, format of records
    geometry_histogram: Optional[np.ndarray]  #: the same of the triangles that refer to records; None if the API has none

    def __repr__(self) -> str:
        return (
            f"<mmverify.Array: {len(self.indices)} triangles, {len(self.records)} records, {len(self.data)} bytes of data>"
        )


def build_array(
    maps: Any, states: int = 4, *, api: str = "ext", index_type: str = "u32", special: bool = True, share: bool = True,
    merge: int = 0,
) -> Array:  # fmt: skip
    """The array of these maps, one a triangle, and the indices of the geometry.

    maps: uint8, a byte a state, as bake() returns them: (triangles, 4^level), or a list of arrays of any levels.
    states: 4 or 2. api: ext, khr, dxr, optix, nvapi, gltf. index_type: u8, u16, u32, and glTF's i16, i32, as far as
        the API has them.
    special: a uniform map becomes a special index. share: equal maps share a record. merge: near duplicates, too, which
        differ in at most so many micro-triangles; where they differ, the record is unknown.
    Raises ValueError, naming the argument: what is no map, an index type that the API lacks or that is too small.
    Laws: array.resolves, array.shares, array.merging.
    """
    states = _arguments.number_of_states(states)
    encoding = _arguments.chosen("index_type", index_type, INDEX_TYPES)
    if not isinstance(maps, (list, tuple, np.ndarray)) or (isinstance(maps, np.ndarray) and maps.ndim != 2):
        raise ValueError("maps: neither an array of shape (triangles, 4^level) nor a list of arrays")
    packed, levels = [], []
    for t, states_of_one in enumerate(maps):
        codes = _arguments.codes(f"maps[{t}]", states_of_one, states)
        if codes.ndim != 1:
            raise ValueError(f"maps[{t}]: shape {codes.shape}, not (4^level,)")
        levels.append(_arguments.level_of(f"maps[{t}]", codes.size))
        packed.append(_core.pack(codes, states))
    number, bound = _arguments.chosen("api", api, APIS), _arguments.whole("merge", merge, 0, 2**32 - 1)
    try:
        records, data, indices, histogram, geometry = _core.build(
            packed, np.array(levels, np.uint32), states, number, encoding, bool(special), bool(share), bound
        )
    except ValueError as error:
        raise ValueError(f"index_type: {index_type} with api {api}: {error}") from None
    return Array(
        records.view(RECORD), data, indices.view(np.dtype(INDEX_TYPES[index_type]).newbyteorder("<")),
        histogram.view(USAGE), None if geometry is None else geometry.view(USAGE),
    )  # fmt: skip
