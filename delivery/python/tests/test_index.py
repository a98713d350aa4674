"""The index and the corners, against exact fractions in Python."""
import struct
import unittest
from fractions import Fraction

import mmverify
import numpy as np

HALF = Fraction(1, 2)


def descended(level, u, v):
    """Succinct Opacity Micromaps, Algorithm 4, on fractions."""
    w = 1 - u - v
    index, mid, top = 0, False, False
    for _ in range(level):
        tie = v == HALF and mid
        if w > HALF:
            digit, u, v, w = (2 if top else 0), 2 * u, 2 * v, w - u - v
        elif v >= HALF and not tie:
            digit, u, v, w, top = 3, 2 * u, v - u - w, 2 * w, not top
        elif u >= HALF and not tie:
            digit, u, v, w = (0 if top else 2), u - v - w, 2 * v, 2 * w
        else:
            digit, u, v, w, mid = 1, u + v - w, w + u - v, v + w - u, not mid
        index = 4 * index + digit
    return index


def random_floats(random, count):
    """Points of the triangle of any exponent, tiny ones and those near the diagonal among them."""
    while count > 0:
        bits = random.integers(0, struct.unpack("<I", struct.pack("<f", 1.0))[0], 2, endpoint=True)
        u, v = (np.uint32(b).view(np.float32) for b in bits)
        if random.integers(3) == 0:
            v = np.nextafter(np.float32(1) - u, np.float32(random.integers(2)))
        if Fraction(float(u)) + Fraction(float(v)) <= 1 and v >= 0:
            count -= 1
            yield u, v


class Index(unittest.TestCase):
    def test_every_point_of_a_grid_four_times_as_fine(self):
        for level in range(5):
            n = 4 * 2**level
            points = [(i, j) for i in range(n + 1) for j in range(n + 1 - i)]
            got = mmverify.index(level, *(np.array(points, np.float32) / np.float32(n)).T)
            self.assertEqual(got.dtype, np.uint32)
            self.assertEqual(got.tolist(), [descended(level, Fraction(i, n), Fraction(j, n)) for i, j in points])

    def test_random_floats_at_every_level(self):
        random = np.random.default_rng(1)
        for level in range(17):
            points = list(random_floats(random, 60))
            got = mmverify.index(level, np.array([p[0] for p in points]), np.array([p[1] for p in points]))
            self.assertEqual(got.tolist(), [descended(level, *(Fraction(float(x)) for x in p)) for p in points])

    def test_numbers_shapes_and_strides(self):
        self.assertEqual(mmverify.index(3, 0.375, 0.3125), descended(3, Fraction(3, 8), Fraction(5, 16)))
        self.assertIs(type(mmverify.index(3, np.float32(0.25), 0)), int)
        points = np.random.default_rng(2).random((5, 7, 2), np.float32) / 2
        got = mmverify.index(6, points[..., 0], points[..., 1])
        self.assertEqual(got.shape, (5, 7))
        for k in np.ndindex(5, 7):
            self.assertEqual(got[k], descended(6, *(Fraction(float(x)) for x in points[k])))
        self.assertEqual(mmverify.index(4, np.zeros(0, np.float32), np.zeros(0, np.float32)).shape, (0,))

    def test_corners_lead_back_to_their_index_and_cover_the_triangle_once(self):
        for level in range(7):
            n, indices = 2**level, np.arange(4**level, dtype=np.uint32)
            corners = mmverify.corners(level, indices)
            self.assertEqual(corners.shape, (4**level, 3, 2))
            self.assertEqual(corners.dtype, np.uint32)
            upright = {frozenset([(i, j), (i + 1, j), (i, j + 1)]) for i in range(n) for j in range(n - i)}
            others = {frozenset([(i + 1, j + 1), (i + 1, j), (i, j + 1)]) for i in range(n) for j in range(n - i - 1)}
            self.assertEqual({frozenset(map(tuple, one)) for one in corners.tolist()}, upright | others)
            inner = (2 * corners[:, 0] + corners[:, 1] + corners[:, 2]).astype(np.float32) / np.float32(4 * n)
            self.assertEqual(mmverify.index(level, inner[:, 0], inner[:, 1]).tolist(), indices.tolist())

    def test_the_order_of_the_corners(self):
        """Corners 0, 1, 2 are those that the children 0, 2, 3 touch."""
        for index in range(64):
            for corner, child in enumerate((0, 2, 3)):
                vertex = tuple(2 * x for x in mmverify.corners(3, index)[corner].tolist())
                self.assertIn(vertex, [tuple(one) for one in mmverify.corners(4, 4 * index + child).tolist()])

    def test_errors_name_the_argument(self):
        two = np.zeros(2, np.float32)
        for words, call in {
            "level: 17 is not": lambda: mmverify.index(17, 0, 0),
            "level: -1 is not": lambda: mmverify.index(-1, 0, 0),
            "level: 1.5 is not": lambda: mmverify.index(1.5, 0, 0),
            "level: True is not": lambda: mmverify.index(True, 0, 0),
            "u: nan is not": lambda: mmverify.index(1, float("nan"), 0),
            "v: 1e+300 is not": lambda: mmverify.index(1, 0, 1e300),
            "v: inf at (1,) is not finite": lambda: mmverify.index(1, two, np.array([0, np.inf], np.float32)),
            "u: nan at (0,) is not finite": lambda: mmverify.index(1, np.array([np.nan, 0], np.float32), two),
            "u: dtype float64": lambda: mmverify.index(1, np.zeros(2), two),
            "u: dtype >f4": lambda: mmverify.index(1, np.zeros(2, ">f4"), two),
            "v: shape (3,), but u has (2,)": lambda: mmverify.index(1, two, np.zeros(3, np.float32)),
            "index: 4 is not": lambda: mmverify.corners(1, 4),
            "index: 4 is not below 4^1 = 4": lambda: mmverify.corners(1, np.array([0, 4], np.uint32)),
            "index: dtype int64": lambda: mmverify.corners(1, np.array([0, 1])),
        }.items():
            with self.subTest(words):
                with self.assertRaises(ValueError) as caught:
                    call()
                self.assertTrue(str(caught.exception).startswith(words), caught.exception)
