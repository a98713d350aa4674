#!/usr/bin/env python3
"""An index function on a pipe:  mmverify gen index --level N | ./index.py | mmverify check index --level N

Reads "CASE U V" lines, writes "CASE INDEX" lines.  The first line says the level: "# mmverify index level N cases M".
"""
import sys


def index_of(u, v, level):
    """Algorithm 4 of Succinct Opacity Micromaps; exact here, because Python's floats hold the cases' short numbers."""
    w = 1.0 - u - v
    index, mid_flip, top_flip = 0, False, False
    for _ in range(level):
        left, right = (2, 0) if top_flip else (0, 2)
        tie = v == 0.5 and mid_flip
        if w > 0.5:
            u, v, w, digit = 2 * u, 2 * v, w - u - v, left
        elif v >= 0.5 and not tie:
            u, v, w, digit, top_flip = 2 * u, v - u - w, 2 * w, 3, not top_flip
        elif u >= 0.5 and not tie:
            u, v, w, digit = u - v - w, 2 * v, 2 * w, right
        else:
            u, v, w, digit, mid_flip = u + v - w, w + u - v, v + w - u, 1, not mid_flip
        index = 4 * index + digit
    return index


level = None
for line in sys.stdin:
    if line.startswith("#"):
        level = int(line.split()[4])
        continue
    case, u, v = line.split()
    print(case, index_of(float.fromhex(u), float.fromhex(v), level))
