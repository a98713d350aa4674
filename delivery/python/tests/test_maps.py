"""Baked maps against a baker on fractions, packing and arrays against plain Python."""
import collections
import threading
import unittest
from fractions import Fraction

import mmverify
import numpy as np
from mmverify import _maps
from naive_baker import Sampler, state

WRAPS = ("repeat", "mirrored_repeat", "clamp_to_edge", "clamp_to_border", "mirror_clamp_to_edge")
UNIT = {"uint8": 255, "uint16": 65535, "float32": 1}


def naive(alpha, uv, level, cutoff=Fraction(1, 2), wrap=("repeat", "repeat"), nearest=False, border=0, factor=1):
    """The map of one triangle. alpha: an array of two dimensions; uv: three pairs of floats."""
    unit = UNIT[alpha.dtype.name]
    texels = [[Fraction(float(a)) / unit * Fraction(factor) for a in row] for row in alpha]
    sampler = Sampler(texels, wrap, Fraction(border) / unit * Fraction(factor), nearest)
    sides = alpha.shape[1], alpha.shape[0]
    p, q, r = ([Fraction(float(x)) * side for x, side in zip(vertex, sides)] for vertex in uv)
    states = []
    for corners in mmverify.corners(level, np.arange(4**level, dtype=np.uint32)).tolist():
        polygon = [
            tuple(a + Fraction(i, 2**level) * (b - a) + Fraction(j, 2**level) * (c - a) for a, b, c in zip(p, q, r))
            for i, j in corners
        ]
        states.append(state(sampler, polygon, cutoff))
    return states


def drawn(random, dtype):
    """A small texture with uniform parts and single texels, and a value on the cutoff."""
    shape = tuple(random.integers(1, 5, 2))
    values = np.array([0, 0.25, 0.5, 0.75, 1]) if dtype == "float32" else np.array([0, 51, 102, 204, 255])
    values = values * (257 if dtype == "uint16" else 1)
    return random.choice(values, shape).astype(dtype)


class Bake(unittest.TestCase):
    def test_random_textures_triangles_and_samplers(self):
        random = np.random.default_rng(3)
        met = collections.Counter()
        for k in range(160):
            alpha = drawn(random, ("uint8", "uint16", "float32")[k % 3])
            uv = (random.integers(-8, 17, (3, 2)) / 8 + (k % 2) * random.random((3, 2)) / 16).astype(np.float32)
            wrap, nearest, level = tuple(random.choice(WRAPS, 2)), bool(k % 5 == 0), int(random.integers(3))
            border = UNIT[alpha.dtype.name] if k % 4 == 0 else 0
            cutoff = None if k % 6 == 0 else Fraction(int(random.choice([51, 102, 128])), 255)
            more = {"factor": 0.75} if k % 7 == 0 else {}
            expected = naive(alpha, uv, level, cutoff, wrap, nearest, border, **more)
            filter = "nearest" if nearest else "bilinear"
            got = mmverify.bake(alpha, uv, level, cutoff=cutoff, wrap=wrap, filter=filter, border=border, **more)
            self.assertEqual(got.tolist(), expected, (k, alpha, uv, level, cutoff, wrap, filter, border))
            self.assertEqual(mmverify.bake(alpha, uv, level, 2, cutoff=cutoff, wrap=wrap, filter=filter, border=border,
                                           **more).tolist(), [s % 2 for s in expected])  # fmt: skip
            met.update(expected)
        self.assertTrue(all(met[s] > 50 for s in range(4)), met)  # each state was asked for

    def test_a_float_cutoff_is_rounded_to_float32(self):
        alpha = np.array([[np.float32(0.3)]])
        self.assertEqual(mmverify.bake(alpha, np.zeros((3, 2), np.float32), 0, cutoff=0.3).tolist(), [1])
        self.assertEqual(mmverify.bake(alpha, np.zeros((3, 2), np.float32), 0, cutoff=0.3000001).tolist(), [0])

    def test_mip_levels_agree_or_are_unknown(self):
        uv = np.array([[0, 0], [1, 0], [0, 1]], np.float32)
        large, small = np.full((4, 4), 255, np.uint8), np.array([[255, 255], [0, 255]], np.uint8)
        for got, a, b in zip(mmverify.bake([large, small], uv, 3), naive(large, uv, 3), naive(small, uv, 3)):
            self.assertEqual(got, a if a == b and a < 2 else 3)

    def test_strided_views_are_read_where_they_lie(self):
        random = np.random.default_rng(4)
        rgba = random.integers(0, 256, (9, 12, 4), np.uint8, endpoint=False)
        wide = random.integers(0, 65536, (9, 12), np.uint16)
        uv = random.random((4, 3, 2), np.float32)
        views = {"channel": rgba, "plane": rgba[..., 3], "part": rgba[2:7, 3:9, 3], "words": wide[1:, 2:9]}
        for name, view in views.items():
            plain = np.ascontiguousarray(view[..., 3] if view.ndim == 3 else view)
            self.assertTrue(np.shares_memory(_maps._plane("alpha", view, -1), view), name)
            self.assertEqual(mmverify.bake(view, uv, 4).tolist(), mmverify.bake(plain, uv, 4).tolist(), name)
        for name, view in {"flipped": rgba[::-1, :, 3], "every other": wide[:, ::2], "turned": wide.T}.items():
            plain = view.copy()
            self.assertEqual(mmverify.bake(view, uv, 4).tolist(), mmverify.bake(plain, uv, 4).tolist(), name)

    def test_many_triangles_levels_threads_and_packing(self):
        random = np.random.default_rng(5)
        alpha, uv = random.integers(0, 256, (16, 16), np.uint8), random.random((40, 3, 2), np.float32)
        whole = mmverify.bake(alpha, uv, 3)
        self.assertEqual(whole.shape, (40, 64))
        self.assertEqual(whole.tolist(), mmverify.bake(alpha, uv, 3, threads=3).tolist())
        levels = random.integers(0, 5, 40)
        for states in (2, 4):
            packed = mmverify.bake(alpha, uv, levels, states, packed=True, threads=2)
            for one, level, triangle in zip(packed, levels, uv):
                single = mmverify.bake(alpha, triangle, level, states)
                self.assertEqual(one.tolist(), mmverify.pack(single, states).tolist())
        self.assertEqual(mmverify.bake(alpha, uv[:0], 3).shape, (0, 64))
        self.assertEqual(mmverify.bake(alpha, uv[:0], []), [])

    def test_other_threads_run_while_it_bakes(self):
        noise = np.random.default_rng(6).integers(0, 256, (2048, 2048), np.uint8)
        triangles = np.array([[[0, 0], [1, 0], [0, 1]]] * 4, np.float32)
        baking, turns = threading.Thread(target=mmverify.bake, args=(noise, triangles, 9)), 0
        baking.start()
        while baking.is_alive():
            baking.join(0.001)
            turns += 1
        self.assertGreater(turns, 10)

    def test_errors_name_the_argument(self):
        alpha, uv = np.zeros((2, 2), np.uint8), np.zeros((1, 3, 2), np.float32)
        bad_uv = uv.copy()
        bad_uv[0, 1, 0] = np.nan
        for words, call in {
            "alpha: dtype float64": lambda: mmverify.bake(np.zeros((2, 2)), uv, 1),
            "alpha: shape (4,)": lambda: mmverify.bake(np.zeros(4, np.uint8), uv, 1),
            "alpha: shape (0, 2)": lambda: mmverify.bake(np.zeros((0, 2), np.uint8), uv, 1),
            "alpha: shape (1, 16385)": lambda: mmverify.bake(np.zeros((1, 16385), np.uint8), uv, 1),
            "alpha: a texel is not finite": lambda: mmverify.bake(np.full((1, 1), np.nan, np.float32), uv, 1),
            "alpha: no mip level": lambda: mmverify.bake([], uv, 1),
            "alpha: mip levels of several dtypes": lambda: mmverify.bake([alpha, alpha.astype(np.uint16)], uv, 1),
            "channel: 4": lambda: mmverify.bake(np.zeros((2, 2, 4), np.uint8), uv, 1, channel=4),
            "uv: dtype float64": lambda: mmverify.bake(alpha, uv.astype(float), 1),
            "uv: shape (1, 2, 2)": lambda: mmverify.bake(alpha, uv[:, :2], 1),
            "uv: nan at (0, 1, 0)": lambda: mmverify.bake(alpha, bad_uv, 1),
            "uv: 1048576.0": lambda: mmverify.bake(alpha, uv + np.float32(2**20), 1),
            "level: 13": lambda: mmverify.bake(alpha, uv, 13),
            "level: 99999999999999999999": lambda: mmverify.bake(alpha, uv, 99999999999999999999),
            "level: shape (2,) for 1": lambda: mmverify.bake(alpha, uv, [1, 2]),
            "states: 3": lambda: mmverify.bake(alpha, uv, 1, 3),
            "cutoff: nan": lambda: mmverify.bake(alpha, uv, 1, cutoff=float("nan")),
            "cutoff: '1/2'": lambda: mmverify.bake(alpha, uv, 1, cutoff="1/2"),
            "cutoff: 1/4294967296": lambda: mmverify.bake(alpha, uv, 1, cutoff=Fraction(1, 2**32)),
            "wrap: 'clamp'": lambda: mmverify.bake(alpha, uv, 1, wrap="clamp"),
            "wrap: 3": lambda: mmverify.bake(alpha, uv, 1, wrap=3),
            "filter: 'cubic'": lambda: mmverify.bake(alpha, uv, 1, filter="cubic"),
            "border: 256": lambda: mmverify.bake(alpha, uv, 1, wrap="clamp_to_border", border=256),
            "factor: -1": lambda: mmverify.bake(alpha, uv, 1, factor=-1),
            "margin: -1": lambda: mmverify.bake(alpha, uv, 1, margin=-1),
            "margin: 1048576": lambda: mmverify.bake(alpha, uv, 1, margin=2**20),
            "threads: 0": lambda: mmverify.bake(alpha, uv, 1, threads=0),
            "codes: dtype int64": lambda: mmverify.pack([0, 1]),
            "codes: 2 at (1,)": lambda: mmverify.pack(np.array([0, 2], np.uint8), 2),
            "packed: shape (1,)": lambda: mmverify.unpack(np.zeros(1, np.uint8), 5),
            "count: -1": lambda: mmverify.unpack(np.zeros(1, np.uint8), -1),
            "width: 0": lambda: mmverify.useful_level(uv, 0, 1),
            "maps: neither": lambda: mmverify.build_array(np.zeros(4, np.uint8)),
            "maps[0]: 5 states": lambda: mmverify.build_array(np.zeros((1, 5), np.uint8)),
            "maps[1]: dtype int64": lambda: mmverify.build_array([np.zeros(4, np.uint8), np.zeros(4, int)]),
            "api: 'metal'": lambda: mmverify.build_array(np.zeros((1, 4), np.uint8), api="metal"),
            "index_type: u8 with api ext": lambda: mmverify.build_array(np.zeros((1, 4), np.uint8), index_type="u8"),
            "codes: 6 states": lambda: mmverify.draw(np.zeros(6, np.uint8)),
        }.items():
            with self.subTest(words):
                with self.assertRaises(ValueError) as caught:
                    call()
                self.assertTrue(str(caught.exception).startswith(words), caught.exception)


class Packing(unittest.TestCase):
    def test_against_whole_numbers(self):
        random = np.random.default_rng(7)
        for states, bits in ((2, 1), (4, 2)):
            for count in (1, 3, 4, 5, 16, 64, 257):
                codes = random.integers(0, states, (3, count), np.uint8)
                packed = mmverify.pack(codes, states)
                for row, got in zip(codes.tolist(), packed):
                    number = sum(code << bits * k for k, code in enumerate(row))
                    self.assertEqual(got.tobytes(), number.to_bytes((bits * count + 7) // 8, "little"))
                self.assertEqual(mmverify.unpack(packed, count, states).tolist(), codes.tolist())


class Arrays(unittest.TestCase):
    def test_each_triangle_finds_its_map_and_the_histograms_count(self):
        random = np.random.default_rng(8)
        for states in (2, 4):
            maps = [random.integers(0, states, 4 ** int(n), np.uint8) for n in random.integers(0, 4, 30)]
            maps += [np.full(16, state, np.uint8) for state in range(states)] + maps[:5]
            array = mmverify.build_array(maps, states, index_type="u16")
            self.assertEqual(array.indices.dtype, np.uint16)
            used = collections.Counter()
            for codes, index in zip(maps, array.indices.astype(np.int16).tolist()):
                if index < 0:
                    self.assertEqual(set(codes.tolist()), {-1 - index})
                    continue
                record = array.records[index]
                used[int(record["level"]), int(record["format"])] += 1
                self.assertEqual(record["format"], states // 2)
                self.assertEqual(4 ** int(record["level"]), codes.size)
                self.assertEqual(mmverify.unpack(array.data[record["offset"] :], codes.size, states).tolist(), codes.tolist())
            different = {codes.tobytes() for codes in maps if len(set(codes.tolist())) > 1}
            self.assertEqual(len(array.records), len(different))  # equal maps share a record
            built = collections.Counter((int(r["level"]), int(r["format"])) for r in array.records)
            for histogram, counts in ((array.histogram, built), (array.geometry_histogram, used)):
                self.assertEqual({(int(h["level"]), int(h["format"])): int(h["count"]) for h in histogram}, counts)

    def test_without_special_indices_and_sharing(self):
        array = mmverify.build_array(np.zeros((3, 16), np.uint8), api="khr", special=False, share=False)
        self.assertEqual((len(array.records), array.indices.tolist(), array.geometry_histogram), (3, [0, 1, 2], None))
        self.assertEqual(len(array.records.tobytes()), 24)

    def test_near_duplicates_merge(self):
        maps = np.ones((2, 16), np.uint8)
        maps[:, 0], maps[1, 5] = 0, 0
        array = mmverify.build_array(maps, merge=1)
        self.assertEqual(array.indices.tolist(), [0, 0])
        merged = mmverify.unpack(array.data, 16)
        self.assertEqual([k for k in range(16) if merged[k] >= 2], [5])


class Levels(unittest.TestCase):
    def test_useful_level_by_its_formula(self):
        random = np.random.default_rng(9)
        uv = (random.integers(-64, 65, (50, 3, 2)) / 64).astype(np.float32)
        expected = []
        for triangle in uv:
            points = [(Fraction(float(u)) * 100, Fraction(float(v)) * 60) for u, v in triangle]
            longest = max((a - c) ** 2 + (b - d) ** 2 for (a, b), (c, d) in zip(points, points[1:] + points[:1]))
            expected.append(next(n for n in range(13) if 4**n >= longest))
        self.assertEqual(mmverify.useful_level(uv, 100, 60).tolist(), expected)
        self.assertEqual(mmverify.useful_level(uv[0], 100, 60, limit=2), min(2, expected[0]))


class Drawing(unittest.TestCase):
    def test_each_micro_triangle_is_drawn_in_its_colour(self):
        codes = np.array([0, 1, 2, 3] * 16, np.uint8)
        svg = mmverify.draw(codes)._repr_svg_()
        for name in ("T", "O", "UT", "UO"):
            line = next(line for line in svg.splitlines() if f'class="{name}"' in line)
            self.assertEqual(line.count("M"), 16)

    def test_a_fine_map_is_drawn_coarser(self):
        codes = np.zeros((4**6, 16), np.uint8)
        codes[0] = 1  # all O
        codes[1, :8], codes[2, :15] = 1, 3  # half of them O, nearly all UO
        codes[3, :7], codes[4] = 1, 2  # nearly half of them O, all UT
        svg = mmverify.draw(codes.ravel()).svg
        self.assertIn("level 8, drawn at level 6", svg)
        counts = {name: line.count("M") for line in svg.splitlines() for name in ("T", "O", "UT", "UO") if f'class="{name}"' in line}
        self.assertEqual(counts, {"T": 4**6 - 5, "O": 1, "UT": 2, "UO": 2})
