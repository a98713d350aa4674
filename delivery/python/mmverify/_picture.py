"""A map as a picture."""
from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Any, List, Union

import numpy as np

from . import _arguments
from ._index import corners

FINEST = 6  # a finer micro-triangle would be smaller than a pixel or two
SIDE, EDGE = 480, 12  # pixels
# The states' names and colours, which the colour-blind tell apart too.
STATES = (("T", "#ffffff"), ("O", "#222222"), ("UT", "#a6cee3"), ("UO", "#0072b2"))


@dataclass(frozen=True)
class Picture:
    """An SVG, which a notebook shows."""

    svg: str

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<mmverify.Picture: {len(self.svg)} bytes of SVG>"

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)


def draw(codes: Any) -> Picture:
    """One map: T white, O black, UT light blue, UO blue. u grows to the right, v upwards.

    codes: uint8 of shape (4^level,). Above level 6 a triangle of level 6 is drawn for its micro-triangles: in their
    colour if they have one, else as UO if half of them or more are O or UO, else as UT.
    Raises ValueError, naming the argument.
    """
    states = _arguments.codes("codes", codes, 4)
    if states.ndim != 1:
        raise ValueError(f"codes: shape {states.shape}, not (4^level,)")
    level = _arguments.level_of("codes", states.size)
    drawn = min(level, FINEST)
    states = _coarser(states, drawn)
    vertices = corners(drawn, np.arange(4**drawn, dtype=np.uint32)).astype(float) / 2**drawn
    x = EDGE + SIDE * (vertices[..., 0] + vertices[..., 1] / 2)
    y = EDGE + SIDE * math.sqrt(3) / 2 * (1 - vertices[..., 1])
    size, note = SIDE + 2 * EDGE, "" if drawn == level else f", drawn at level {drawn}"
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size} {size}" width="{size}" height="{size}" role="img">',
        f"<title>A map of level {level}{note}</title>",
        '<rect width="100%" height="100%" fill="#ffffff"/>',
    ]
    for state, (name, colour) in enumerate(STATES):
        path = "".join(_triangle(x[k], y[k]) for k in np.flatnonzero(states == state))
        if path:
            parts.append(f'<path class="{name}" fill="{colour}" stroke="#9a9a9a" stroke-width="0.5" d="{path}"/>')
    parts += _legend(states, size) + ["</svg>"]
    return Picture("\n".join(parts) + "\n")


def _triangle(x: np.ndarray, y: np.ndarray) -> str:
    return "M" + "L".join(f"{a:.2f} {b:.2f}" for a, b in zip(x, y)) + "Z"


def _coarser(states: np.ndarray, level: int) -> np.ndarray:
    children = states.reshape(4**level, -1)
    uniform = (children == children[:, :1]).all(axis=1)
    rather = 2 * (children & 1).sum(axis=1) >= children.shape[1]
    return np.where(uniform, children[:, 0], np.where(rather, 3, 2))


def _legend(states: np.ndarray, size: int) -> List[str]:
    lines = []
    for k, (name, colour) in enumerate(STATES):
        x, y = EDGE + 62 * k, size - 30
        lines.append(f'<rect x="{x}" y="{y}" width="16" height="16" fill="{colour}" stroke="#9a9a9a"/>')
        lines.append(f'<text x="{x + 22}" y="{y + 13}" font-family="sans-serif" font-size="14">{name}</text>')
    return lines
