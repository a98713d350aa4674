"""prove() and validate(), which the program decides; MMVERIFY_PROGRAM names it, MMVERIFY_EXAMPLE a library under test."""
import ctypes
import functools
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import mmverify
import numpy as np

PROGRAM, EXAMPLE = os.environ["MMVERIFY_PROGRAM"], os.environ["MMVERIFY_EXAMPLE"]


def one_wrong(level, u, v):
    """Right but for one vertex of level 3, which has two indices to choose from."""
    return 0 if (level, u, v) == (3, 0.375, 0.25) else mmverify.index(level, u, v)


class PythonFunctions(unittest.TestCase):
    def test_right_functions_are_proved_for_every_case_of_the_levels(self):
        for arrays in (False, True):
            result = mmverify.prove(mmverify.index, levels="0..4", arrays=arrays)
            self.assertEqual((result.verdict, result.counterexample, result.picture()), ("proved", None, None))
            cases = [3 * 4**n + 3 * 2**n + 1 for n in range(5)]  # vertices, edges and interiors of each level
            self.assertEqual([(one.level, one.cases, one.mismatches) for one in result.laws], [(n, cases[n], 0) for n in range(5)])
            corners = mmverify.prove(mmverify.corners, "corners", range(4), arrays=arrays)
            self.assertEqual([(one.level, one.cases) for one in corners.laws], [(n, 4**n) for n in range(4)])
            self.assertEqual(corners.verdict, "proved")

    def test_a_wrong_index_is_refuted_by_its_simplest_case(self):
        result = mmverify.prove(one_wrong)
        right = mmverify.index(3, 0.375, 0.25)
        self.assertEqual(result.verdict, "refuted")
        wrong = result.counterexample
        self.assertEqual(wrong[:5], ("index.equals_reference", 3, "v:u=3/8,v=1/4", str(right), "0"))
        self.assertEqual(wrong.hexadecimal, "(0x1.8p-2,0x1p-2)")
        self.assertEqual([one.verdict for one in result.laws], ["proved"] * 3 + ["refuted"] + ["proved"] * 2)
        self.assertIn("wrong on ties only", result.diagnosis[0])
        self.assertEqual(
            repr(result),
            "<mmverify.Result: one_wrong: refuted (laws: 1 refuted, levels 0..5); "
            f"level 3 v:u=3/8,v=1/4: expected {right}, got 0>",
        )
        page = result._repr_html_()
        for words in ("one_wrong: refuted", "<td>1 of 217 wrong</td>", "<svg", str(right)):
            self.assertIn(words, page)

    def test_the_counterexample_is_the_lowest_levels(self):
        result = mmverify.prove(lambda level, u, v: mmverify.index(level, u, v) ^ (level in (2, 4)))
        self.assertEqual(result.counterexample.level, 2)

    def test_wrong_corners_are_refuted(self):
        result = mmverify.prove(lambda level, index: mmverify.corners(level, index ^ (level == 2)), "corners")
        self.assertEqual((result.verdict, result.counterexample.level), ("refuted", 2))

    def test_a_ctypes_function(self):
        with tempfile.TemporaryDirectory() as folder:
            source, library = pathlib.Path(folder, "zero.c"), pathlib.Path(folder, "zero.so")
            source.write_text("unsigned zero(unsigned n, float u, float v) { return n + u + v > 100; }")
            subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
            zero = ctypes.CDLL(str(library)).zero
            zero.argtypes, zero.restype = [ctypes.c_uint, ctypes.c_float, ctypes.c_float], ctypes.c_uint
            result = mmverify.prove(zero, levels=range(3))
        self.assertEqual([one.verdict for one in result.laws], ["proved", "refuted", "refuted"])

    def test_a_codec(self):
        def encode(codes, states):
            """The paper's tree in pre-order, then from the next byte on its leaves."""
            tree, leaves = [], []

            def visit(some):
                tree.append(int(len(set(some)) > 1))
                if tree[-1]:
                    for k in range(4):
                        visit(some[k * len(some) // 4 : (k + 1) * len(some) // 4])
                else:
                    leaves.append(some[0])

            visit(codes.tolist())
            return b"".join(mmverify.pack(np.array(bits, np.uint8), n).tobytes() for bits, n in ((tree, 2), (leaves, states)))

        def every_map(level, states):
            return (np.array(codes, np.uint8) for codes in itertools.product(range(states), repeat=4**level))

        @functools.lru_cache
        def decoder(level, states):
            return {encode(codes, states): codes for codes in every_map(level, states)}

        def decode(code, level, states):
            return decoder(level, states).get(code)

        def forgetful(code, level, states):
            codes = decode(code, level, states)
            return codes if codes is None or len(codes) < 4 else codes * np.uint8(codes[3] != 1)

        result = mmverify.prove((encode, decode), ["tree.round_trip", "tree.equals_spec", "tree.canonical"])
        self.assertEqual(result.verdict, "proved")
        self.assertEqual([one.cases for one in result.laws if one.law == "tree.round_trip"], [2 + 4, 2**4 + 4**4])
        result = mmverify.prove((encode, forgetful), "tree.round_trip")
        self.assertEqual((result.verdict, result.counterexample.level), ("refuted", 1))

    def test_a_baker(self):
        law = "bake.conservative_blend"  # the shortest one over a whole domain
        self.assertEqual(mmverify.prove(mmverify.bake, law, 0).verdict, "proved")
        laws = ["bake.mips", "bake.margin", "bake.conservative_on_strata"]
        self.assertEqual(mmverify.prove(mmverify.bake, laws, 1).verdict, "checked")

        def bold(alpha, uv, level, states, **how):
            return mmverify.bake(alpha, uv, level, states, **how) & 1

        self.assertEqual(mmverify.prove(bold, "bake.conservative_on_strata", 1).verdict, "refuted")

    def test_what_the_function_raises_goes_through(self):
        def careless(level, u, v):
            return 1 // int(level < 2 or u < 0.5)

        with self.assertRaises(ZeroDivisionError) as caught:
            mmverify.prove(careless, levels=2)
        if sys.version_info >= (3, 11):
            self.assertRegex(caught.exception.__notes__[0], r"^mmverify.prove asked: level=2, u=0.5, v=0.0$")

    def test_errors_name_the_argument(self):
        index = mmverify.index
        for words, call in {
            "function: 3 is neither": lambda: mmverify.prove(3),
            "function: 'gone.so' is no file": lambda: mmverify.prove("gone.so"),
            "function: it returned -1,": lambda: mmverify.prove(lambda level, u, v: -1),
            "function: it returned 0.5,": lambda: mmverify.prove(lambda level, u, v: 0.5),
            "function: it returned an array of shape (1,)": lambda: mmverify.prove(lambda n, u, v: u[:1], arrays=True),
            "function: it returned 2 numbers": lambda: mmverify.prove(lambda level, k: (0, 0), "corners"),
            "function: it returned int64 of shape (2,)": lambda: mmverify.prove(lambda **how: [0, 0], "bake.tight"),
            "function: it returned a state beyond 3": lambda: mmverify.prove(lambda **how: [7], "bake.tight", 0),
            "function: <function": lambda: mmverify.prove(lambda codes: b"", "tree"),
            "law: vq2": lambda: mmverify.prove(index, "vq2"),
            "law: index.nested": lambda: mmverify.prove(index, "index.nested"),
            "law: '--help'": lambda: mmverify.prove(index, "--help"),
            "levels: 17": lambda: mmverify.prove(index, levels=17),
            "levels: 13": lambda: mmverify.prove(mmverify.corners, "corners", 13),
            "levels: 'high'": lambda: mmverify.prove(index, levels="high"),
            "levels: [0, 2]": lambda: mmverify.prove(index, levels=[0, 2]),
            "levels: '3..1'": lambda: mmverify.prove(index, levels="3..1"),
        }.items():
            with self.subTest(words):
                with self.assertRaises(ValueError) as caught:
                    call()
                self.assertTrue(str(caught.exception).startswith(words), caught.exception)


class Libraries(unittest.TestCase):
    def test_a_library_has_the_verdicts_of_the_command_line(self):
        command = [PROGRAM, "prove", "index", "--subject", EXAMPLE, "--levels", "0..1", "--no-mutants", "--quiet"]
        theirs = json.loads(subprocess.run([*command, "--json", "-"], capture_output=True, check=True).stdout)["results"]
        result = mmverify.prove(ctypes.CDLL(EXAMPLE), levels=(0, 1))
        self.assertEqual([(one.law, one.level, one.verdict, one.cases) for one in result.laws],
                         [(one["law"], one["level"], one["verdict"], one["cases_run"] or 0) for one in theirs])  # fmt: skip
        self.assertEqual(result.verdict, "checked")
        for library in (EXAMPLE, pathlib.Path(EXAMPLE)):
            laws = {one.law: one.verdict for one in mmverify.prove(library, "index.in_range", 1).laws}
            self.assertEqual(laws["index.in_range"], "proved")

    def test_no_library_at_all(self):
        with tempfile.NamedTemporaryFile(suffix=".so") as file, self.assertRaises(mmverify.ProgramError) as caught:
            mmverify.prove(file.name)
        self.assertIn(file.name, str(caught.exception))


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = self.folder / "scene.glb"
        subprocess.run([PROGRAM, "scene", "--samples", "9", "-o", self.scene, "--quiet"], check=True, stdout=subprocess.DEVNULL)

    def test_findings_are_those_of_the_command_line(self):
        self.assertEqual(mmverify.validate(self.scene), [])
        scene = self.scene.read_bytes()
        cut = self.folder / "cut.glb"
        cut.write_bytes(scene[:3000])
        wrong = self.folder / "wrong.glb"  # a level that no map has, in the JSON of the same length
        wrong.write_bytes(scene.replace(b'"EXT_mesh_opacity_micromap"', b'"EXT_mesh_opacity_micromop"', 1))
        for path in (cut, wrong, self.folder):
            told = subprocess.run([PROGRAM, "validate", path, "--json", "-"], capture_output=True, check=False).stdout
            files = json.loads(told)
            theirs = [one for file in (files if isinstance(files, list) else [files]) for one in file["findings"]]
            found = mmverify.validate(path)
            self.assertGreater(len(found), 0)
            self.assertEqual([(f.code, f.severity, f.place, f.message, f.rule, f.source, list(f.vuids), f.remedy) for f in found],
                             [tuple(one[k] for k in ("code", "severity", "pointer", "found", "says", "source", "vuids", "remedy"))
                              for one in theirs])  # fmt: skip
        self.assertEqual(mmverify.validate(cut)[0].code, "file.readable")

    def test_files_that_cannot_be_judged(self):
        with self.assertRaisesRegex(FileNotFoundError, "path: there is nothing at .*gone.glb"):
            mmverify.validate(self.folder / "gone.glb")
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        pathlib.Path("-other.glb").write_text("no such kind")
        for path in ("-other.glb", "."):  # a name like an option; a folder that has such a file
            with self.assertRaisesRegex(mmverify.ProgramError, r"-other\.glb: .*neither JSON"):
                mmverify.validate(path)
        with self.assertRaisesRegex(mmverify.ProgramError, "draft"):
            mmverify.validate(self.scene, draft="none")


class Missing(unittest.TestCase):
    def test_a_missing_program_is_named(self):
        with mock.patch.dict(os.environ, {"PATH": "/nowhere"}):
            with self.assertRaisesRegex(mmverify.ProgramError, "MMVERIFY_PROGRAM: /nowhere/mmverify is no program"):
                with mock.patch.dict(os.environ, {"MMVERIFY_PROGRAM": "/nowhere/mmverify"}):
                    mmverify.prove(mmverify.index)
            del os.environ["MMVERIFY_PROGRAM"]
            with self.assertRaisesRegex(mmverify.ProgramError, "not on the PATH"):
                mmverify.prove(mmverify.index)
