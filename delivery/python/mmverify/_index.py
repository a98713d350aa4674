"""The index of a micro-triangle on the curve, and back."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import _arguments, _core


def index(level: int, u: Any, v: Any) -> Any:
    """The micro-triangle that contains the barycentrics (u, v) of the second and third vertex.

    Formula: Vulkan, VK_EXT_opacity_micromap, "Reference Code", evaluated exactly for every float32.
    level: 0 to 16. u, v: float32 arrays of one shape, or two numbers, which are rounded to float32. The triangle is
    u >= 0, v >= 0, u + v <= 1; u and v are clamped to [0, 1] one by one, and every index is below 4^level.
    Returns uint32 of the same shape; an int for two numbers.
    Raises ValueError, naming the argument: a level beyond 16, NaN or infinity, another dtype, different shapes.
    Laws: index.equals_reference, index.exact_on_floats.
    """
    level = _arguments.whole("level", level, 0, 16)
    us, vs = _arguments.floats("u", u), _arguments.floats("v", v)
    if us.shape != vs.shape:
        raise ValueError(f"v: shape {vs.shape}, but u has {us.shape}")
    found = _core.index(level, us.ravel(), vs.ravel())
    return int(found[0]) if us.ndim == 0 else found.reshape(us.shape)


def corners(level: int, index: Any) -> np.ndarray:
    """The vertices of micro-triangles: the way back from an index.

    Vertex (i, j) is the point u = i / 2^level, v = j / 2^level. Vertices 0, 1, 2 are those that the children 0, 2, 3
    touch.
    level: 0 to 16. index: uint32 array, or an int, below 4^level.
    Returns uint32 of shape index.shape + (3, 2).
    Raises ValueError, naming the argument: a level beyond 16, an index beyond its level, another dtype.
    Laws: index.corners, index.corner_order.
    """
    level = _arguments.whole("level", level, 0, 16)
    if isinstance(index, (int, np.integer)):
        index = np.uint32(_arguments.whole("index", index, 0, 4**level - 1))
    array = np.asarray(index)
    if array.dtype != np.uint32:
        raise ValueError(f"index: dtype {array.dtype}, not uint32")
    if array.size and int(array.max()) >= 4**level:
        raise ValueError(f"index: {array.max()} is not below 4^{level} = {4**level}")
    return _core.corners(level, array.ravel()).reshape(*array.shape, 3, 2)
