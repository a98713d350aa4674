"""Maps of states: baked from textures, packed and unpacked."""
from __future__ import annotations

from fractions import Fraction
from typing import Any, List, Union

import numpy as np

from . import _arguments, _core

# The order is that of the library's own numbers.
WRAPS = ("repeat", "mirrored_repeat", "clamp_to_edge", "clamp_to_border", "mirror_clamp_to_edge")
LONGEST_SIDE = 16384


def _plane(name: str, mip: Any, channel: int) -> np.ndarray:
    """One channel as an array of two dimensions: a view wherever the library reads its strides, else a copy."""
    array = np.asarray(mip)
    if array.dtype not in (np.uint8, np.uint16, np.float32) or not array.dtype.isnative:
        raise ValueError(f"{name}: dtype {array.dtype}, not uint8, uint16 or float32")
    if array.ndim == 3:
        last = array.shape[2] - 1
        array = array[:, :, _arguments.whole("channel", channel, -last - 1, last)]
    if array.ndim != 2:
        raise ValueError(f"{name}: shape {array.shape}, not (height, width) or (height, width, channels)")
    if not all(1 <= side <= LONGEST_SIDE for side in array.shape):
        raise ValueError(f"{name}: shape {array.shape}; a texture has 1 to {LONGEST_SIDE} texels along each side")
    if array.dtype == np.float32 and not np.isfinite(array).all():
        raise ValueError(f"{name}: a texel is not finite")
    row, column = array.strides
    step = 16 if array.dtype == np.uint8 else array.itemsize
    readable = array.itemsize <= column <= step and row >= column * array.shape[1] and row % array.itemsize == 0
    return array if readable and array.flags.aligned else np.array(array, order="C")


def _mips(alpha: Any, channel: int) -> List[np.ndarray]:
    levels = list(alpha) if isinstance(alpha, (list, tuple)) else [alpha]
    if not levels:
        raise ValueError("alpha: no mip level")
    planes = [_plane("alpha" if len(levels) == 1 else f"alpha[{k}]", mip, channel) for k, mip in enumerate(levels)]
    if any(plane.dtype != planes[0].dtype for plane in planes):
        raise ValueError(f"alpha: mip levels of several dtypes: {', '.join(str(p.dtype) for p in planes)}")
    return planes


def _cutoff(cutoff: Any) -> Any:
    """As the library takes it: a numerator and a denominator, a float32, or None for blending."""
    if cutoff is None:
        return None
    if isinstance(cutoff, Fraction):
        if cutoff < 0 or max(cutoff.numerator, cutoff.denominator) >= 2**32:
            raise ValueError(f"cutoff: {cutoff} is not a quotient of two numbers from 0 to 2^32 - 1")
        return cutoff.numerator, cutoff.denominator
    return _arguments.real("cutoff", cutoff)


def _wraps(wrap: Any) -> tuple[int, int]:
    pair = (wrap, wrap) if isinstance(wrap, str) else wrap
    if not isinstance(pair, (list, tuple)) or len(pair) != 2:
        raise ValueError(f"wrap: {wrap!r} is neither a name nor two of them, for u and v")
    return _arguments.chosen("wrap", pair[0], WRAPS), _arguments.chosen("wrap", pair[1], WRAPS)


def _border(border: Any, dtype: np.dtype) -> float:
    """A stored number, as a texel could be one."""
    number = _arguments.real("border", border)
    if dtype != np.float32 and number != _arguments.whole("border", int(number), 0, np.iinfo(dtype).max):
        raise ValueError(f"border: {border!r} is no texel of {dtype}")
    return number


def _triangles(uv: Any) -> np.ndarray:
    array = _arguments.floats("uv", uv)
    if array.shape[-2:] != (3, 2) or array.ndim not in (2, 3):
        raise ValueError(f"uv: shape {array.shape}, not (3, 2) or (triangles, 3, 2)")
    if array.size and np.abs(array).max() >= 2**20:
        raise ValueError(f"uv: {np.abs(array).max()} is not below 2^20 in size")
    return array


def _levels(level: Any, count: int) -> np.ndarray:
    """A level for each triangle."""
    if np.ndim(level) == 0:
        return np.full(count, _arguments.whole("level", level, 0, 12), np.uint32)
    if np.shape(level) != (count,):
        raise ValueError(f"level: shape {np.shape(level)} for {count} triangles")
    return np.array([_arguments.whole("level", one, 0, 12) for one in level], np.uint32)


def bake(
    alpha: Any, uv: Any, level: Any, states: int = 4, *, cutoff: Any = 0.5, channel: int = -1, wrap: Any = "repeat",
    filter: str = "bilinear", border: float = 0, factor: float = 1, vertex_factor: float = 1, margin: float = 0,
    packed: bool = False, threads: int = 1,
) -> Union[np.ndarray, List[np.ndarray]]:  # fmt: skip
    """The maps of triangles on a texture: the exact state of every micro-triangle.

    A closed micro-triangle, grown by the margin, is O if alpha >= cutoff on all of it, T if alpha < cutoff on all of
    it, in every mip level; else unknown, UO or UT by alpha at its centroid. With cutoff=None (blending): O where alpha
    >= 1, T where alpha <= 0, UO where alpha >= 1/2.

    alpha: (height, width), or (height, width, channels) with `channel`, of uint8 (alpha = byte / 255), uint16
        (/ 65535) or float32; a list of these is mip levels, the largest first. 1 to 16384 texels a side; row 0 is at
        v = 0. Strided views are read where they lie, such as rgba[..., 3] or a part of a picture; reversed axes, and
        one channel of several of uint16 or float32, are copied once.
    uv: float32 of shape (triangles, 3, 2), or (3, 2) for one; finite, below 2^20 in size. (0, 0) and (1, 1) are the
        texture's outer corners.
    level: 0 to 12, one for all or one a triangle.
    states: 4, or 2, which makes UT T and UO O.
    cutoff: a number, rounded to float32 as glTF's alphaCutoff; a fractions.Fraction, exact; None for blending.
    wrap: a name or two, for u and v: repeat, mirrored_repeat, clamp_to_edge, clamp_to_border, mirror_clamp_to_edge.
    filter: bilinear or nearest. border: stored number of clamp_to_border, in the unit of alpha's dtype.
    factor, vertex_factor: alpha is multiplied by both. margin: texels, along both axes to either side.
    packed: maps as Vulkan and glTF store them, as pack() makes them. threads: 1 to 1024; the maps are the same.
    Returns uint8, a byte a state, in the order of index(): (triangles, 4^level); (4^level,) for one triangle; where
        each triangle has its level, a list of arrays.
    Raises ValueError, naming the argument, for anything else.
    Laws: bake.conservative, bake.tight, bake.unknown_side. Other Python threads run meanwhile.
    """
    planes, triangles, states = _mips(alpha, channel), _triangles(uv), _arguments.number_of_states(states)
    levels = _levels(level, triangles.size // 6)
    factors = (_arguments.real("factor", factor, 0), _arguments.real("vertex_factor", vertex_factor, 0))
    made = _core.bake(
        planes, triangles.ravel(), levels, states, bool(packed), _arguments.whole("threads", threads, 1, 1024),
        _cutoff(cutoff), _wraps(wrap), _arguments.chosen("filter", filter, ("bilinear", "nearest")) == 1,
        _border(border, planes[0].dtype), factors, _arguments.real("margin", margin, 0, 2**20),
    )  # fmt: skip
    if np.ndim(level) == 0:
        size = _size(level, states, packed)
        return made.reshape(size if triangles.ndim == 2 else (len(levels), size))
    sizes = [_size(one, states, packed) for one in levels]
    return np.split(made, np.cumsum(sizes)[:-1]) if sizes else []


def _size(level: Any, states: int, packed: bool) -> int:
    count = 4 ** int(level)
    return _bytes(count, states) if packed else count


def _bytes(count: int, states: int) -> int:
    return (count * (states // 2) + 7) // 8


def pack(codes: Any, states: int = 4) -> np.ndarray:
    """States as Vulkan and glTF store them: 2 bits a state (1 with states=2), from each byte's least significant bit on.

    codes: uint8 of any shape, below `states`; the last axis is packed.
    Returns uint8 of shape (..., ceil(count bits / 8)). The bits after the last state are 0.
    Raises ValueError, naming the argument: another dtype, a code beyond `states`.
    Law: micromap.packing.
    """
    states = _arguments.number_of_states(states)
    array = _arguments.codes("codes", codes, states)
    if array.ndim == 0:
        raise ValueError("codes: shape (), not (..., count)")
    rows = array.reshape(-1, array.shape[-1]) if array.size else np.zeros((0, 1), np.uint8)
    packed = np.zeros((len(rows), _bytes(array.shape[-1], states)), np.uint8)
    for row, out in zip(rows, packed):
        out[:] = _core.pack(row, states)
    return packed.reshape(*array.shape[:-1], packed.shape[1])


def unpack(packed: Any, count: int, states: int = 4) -> np.ndarray:
    """The first `count` states of packed maps: pack() undone.

    packed: uint8 of any shape; the last axis has at least ceil(count bits / 8) bytes. count: 4^level for a whole map.
    Returns uint8 of shape (..., count).
    Raises ValueError, naming the argument: another dtype, fewer bytes than `count` states take.
    Law: micromap.packing.
    """
    states = _arguments.number_of_states(states)
    array = np.asarray(packed)
    count = _arguments.whole("count", count, 0, 2**40)
    if array.dtype != np.uint8:
        raise ValueError(f"packed: dtype {array.dtype}, not uint8")
    if array.ndim == 0 or array.shape[-1] < _bytes(count, states):
        raise ValueError(f"packed: shape {array.shape}; {count} states take {_bytes(count, states)} bytes of the last axis")
    rows = array.reshape(-1, array.shape[-1]) if array.size else np.zeros((0, 1), np.uint8)
    codes = np.zeros((len(rows), count), np.uint8)
    for row, out in zip(rows, codes):
        out[:] = _core.unpack(row, count, states)
    return codes.reshape(*array.shape[:-1], count)


def useful_level(uv: Any, width: int, height: int, limit: int = 12) -> Any:
    """The highest useful level of triangles: the smallest n with 4^n >= max |e|^2, e the edges in texels.

    At it no edge of a micro-triangle is longer than a texel. Exact; at most `limit`, which is the device's, and 12.
    uv: as bake() takes it. width, height: the texture's, 1 to 16384.
    Returns uint32 of shape (triangles,); an int for one triangle.
    Raises ValueError, naming the argument.
    Source: Succinct Opacity Micromaps, 3.1.1.
    """
    triangles = _triangles(uv)
    sides = _arguments.whole("width", width, 1, LONGEST_SIDE), _arguments.whole("height", height, 1, LONGEST_SIDE)
    levels = _core.useful_levels(triangles.ravel(), *sides, _arguments.whole("limit", limit, 0, 31))
    return int(levels[0]) if triangles.ndim == 2 else levels
