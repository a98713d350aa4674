"""A baker that is as plain as can be, on fractions: slow, and without any code of the library.

Bilinear alpha is continuous, and within the square between four texel centres of the form a + b x + c y + d x y. Such a
form has its extremes over a polygon on the polygon's edges, and is a parabola along each.
"""
from fractions import Fraction
from math import floor

HALF = Fraction(1, 2)


def wrapped(k, n, mode):
    """The texel that texel k of a row of n is; None is the border."""
    if mode == "repeat":
        return k % n
    if mode == "mirrored_repeat":
        k %= 2 * n
        return k if k < n else 2 * n - 1 - k
    if mode == "mirror_clamp_to_edge":
        return min(k if k >= 0 else -1 - k, n - 1)
    if mode == "clamp_to_border":
        return k if 0 <= k < n else None
    return min(max(k, 0), n - 1)


def clipped(polygon, axis, bound, keep_below):
    """The part of a convex polygon on one side of an axis-parallel line, which belongs to it."""
    kept = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        before, after = ((bound - p[axis]) * (1 if keep_below else -1) for p in (a, b))
        if before >= 0:
            kept.append(a)
        if before * after < 0:
            t = before / (before - after)
            kept.append(tuple(x + t * (y - x) for x, y in zip(a, b)))
    return kept


def squares(polygon, shift):
    """(i, j, part) of each closed square [i, i+1] x [j, j+1], moved by `shift`, that a polygon meets."""
    low, high = ([floor(f(p[k] for p in polygon) - shift) for k in (0, 1)] for f in (min, max))
    for i in range(low[0] - 1, high[0] + 1):
        for j in range(low[1] - 1, high[1] + 1):
            part = polygon
            for axis, start in ((0, i + shift), (1, j + shift)):
                part = clipped(clipped(part, axis, start, False), axis, start + 1, True) if part else part
            if part:
                yield i, j, part


class Sampler:
    def __init__(self, texels, wrap, border, nearest):
        """texels: rows of fractions; border: a fraction."""
        self.texels, self.wrap, self.border, self.nearest = texels, wrap, border, nearest

    def texel(self, i, j):
        i, j = wrapped(i, len(self.texels[0]), self.wrap[0]), wrapped(j, len(self.texels), self.wrap[1])
        return self.border if i is None or j is None else self.texels[j][i]

    def at(self, x, y):
        if self.nearest:
            return self.texel(floor(x), floor(y))
        i, j = floor(x - HALF), floor(y - HALF)
        s, t = x - HALF - i, y - HALF - j
        top = (1 - s) * self.texel(i, j) + s * self.texel(i + 1, j)
        return (1 - t) * top + t * ((1 - s) * self.texel(i, j + 1) + s * self.texel(i + 1, j + 1))

    def values(self, polygon):
        """Values of alpha on a closed polygon, its least and greatest among them."""
        if self.nearest:
            for i, j, part in squares(polygon, Fraction(0)):
                # Texels are half open: their right and lower edges belong to the next ones.
                if any(p[0] < i + 1 for p in part) and any(p[1] < j + 1 for p in part):
                    yield self.texel(i, j)
            return
        for i, j, part in squares(polygon, HALF):
            corners = [self.texel(i + di, j + dj) for dj in (0, 1) for di in (0, 1)]

            def form(x, y, i=i, j=j, corners=corners):
                s, t = x - HALF - i, y - HALF - j
                return (1 - t) * ((1 - s) * corners[0] + s * corners[1]) + t * ((1 - s) * corners[2] + s * corners[3])

            for a, b in zip(part, part[1:] + part[:1]):
                along = [form(*(p + t * (q - p) for p, q in zip(a, b))) for t in (0, HALF, 1)]
                yield from (along[0], along[2])
                curve = 2 * (along[0] + along[2] - 2 * along[1])  # along[0] + slope t + curve t^2
                slope = along[2] - along[0] - curve
                if curve != 0 and 0 < -slope / (2 * curve) < 1:
                    yield along[0] - slope * slope / (4 * curve)


def state(sampler, polygon, cutoff):
    """Of one closed micro-triangle; polygon: its three corners in texels. cutoff None: blending."""
    values = list(sampler.values(polygon))
    if min(values) >= (1 if cutoff is None else cutoff):
        return 1
    if (max(values) <= 0) if cutoff is None else (max(values) < cutoff):
        return 0
    centroid = sampler.at(*(sum(p[k] for p in polygon) / 3 for k in (0, 1)))
    return 3 if centroid >= (HALF if cutoff is None else cutoff) else 2
