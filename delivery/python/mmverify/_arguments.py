"""Checks of arguments. Each raises ValueError with the argument's name and the value at fault."""
from __future__ import annotations

import operator
from typing import Any, Iterable

import numpy as np


def whole(name: str, value: Any, low: int, high: int) -> int:
    """A whole number of Python or NumPy, low and high included."""
    try:
        number = operator.index(value)
    except TypeError:
        number = low - 1
    if isinstance(value, (bool, np.bool_)) or not low <= number <= high:
        raise ValueError(f"{name}: {value!r} is not a whole number from {low} to {high}")
    return number


def real(name: str, value: Any, low: float = -np.inf, below: float = np.inf) -> float:
    """A finite number, rounded to float32, from `low` on."""
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        number = float("nan")
    # From half a step beyond the greatest float32 on, a number is rounded to infinity.
    if isinstance(value, (bool, np.bool_, str)) or not abs(number) < 2**128 - 2**103:
        raise ValueError(f"{name}: {value!r} is not a finite number of float32")
    number = float(np.float32(number))
    if not low <= number < below:
        raise ValueError(f"{name}: {value!r} is not from {low:g} to below {below:g}")
    return number


def chosen(name: str, value: Any, names: Iterable[str]) -> int:
    """The place of a word in a list of words."""
    words = list(names)
    if value not in words:
        raise ValueError(f"{name}: {value!r} is none of {', '.join(words)}")
    return words.index(value)


def number_of_states(value: Any) -> int:
    if value not in (2, 4):
        raise ValueError(f"states: {value!r} is neither 2 nor 4")
    return int(value)


def floats(name: str, value: Any) -> np.ndarray:
    """A float32 array as it is; a single Python number, rounded to float32. All finite."""
    if isinstance(value, (int, float)):
        return np.asarray(real(name, value), np.float32)
    array = np.asarray(value)
    if array.dtype != np.float32:
        raise ValueError(f"{name}: dtype {array.dtype}, not float32; numpy.asarray({name}, numpy.float32) rounds it")
    finite = np.isfinite(array)
    if not finite.all():
        first = tuple(int(k) for k in np.argwhere(~finite)[0])
        raise ValueError(f"{name}: {array[first]} at {first} is not finite")
    return np.ascontiguousarray(array).reshape(array.shape)


def codes(name: str, value: Any, states: int) -> np.ndarray:
    """An array of uint8 with one state a byte."""
    array = np.asarray(value)
    if array.dtype != np.uint8:
        raise ValueError(f"{name}: dtype {array.dtype}, not uint8")
    if array.size and array.max() >= states:
        first = tuple(int(k) for k in np.argwhere(array >= states)[0])
        raise ValueError(f"{name}: {array[first]} at {first} is no state of {states}")
    return array


def level_of(name: str, size: int) -> int:
    """The level of a map with so many states."""
    level = (size.bit_length() - 1) // 2
    if size != 4**level or level > 12:
        raise ValueError(f"{name}: {size} states are no map; a map of level n has 4^n, n from 0 to 12")
    return level
