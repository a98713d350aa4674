"""Judges a function of Python, or a library of C."""
from __future__ import annotations

import ctypes
import os
import re
from typing import Any, List, Optional, Sequence, Tuple, Union

from . import _arguments, _pipe, _program
from ._result import Result, result_of

HIGHEST = {"index": 16, "corners": 12, "tree": 12, "bake": 12}
USUAL = {"index": (0, 5), "corners": (0, 5), "tree": (0, 1), "bake": (0, 1)}


def prove(
    function: Any, law: Union[str, Sequence[str]] = "index", levels: Any = None, *, arrays: bool = False
) -> Result:
    """Judges a function against the specification, at each of these levels.

    function, a Python function or a ctypes one, by law:
        "index"    function(level, u, v) -> the index, as mmverify.index
        "corners"  function(level, index) -> three vertices (i, j), in any order, as mmverify.corners
        "tree", "tree.round_trip", ...    a pair (encode, decode) for the paper's codes (Succinct Opacity Micromaps,
                   Algorithms 1 and 2): encode(codes, states) -> bytes; decode(code, level, states) -> codes, or None
                   for bytes that are no code; codes is uint8 of shape (4^level,)
        "bake", "bake.conservative", ...  function(alpha, uv, level, states, cutoff=..., wrap=..., ...) -> codes, called
                   as mmverify.bake is, with the arguments that the case has; None declines a case
    function, a library: ctypes.CDLL, or a path to the .so, with the entry points of mmverify_subject.h; by every law
        that `mmverify list` names, law=None for all of them.
    levels: a level, a range, "A..B" (both included); not given: 0..5 of index and corners, 0..1 of trees and bakers,
        the program's own of a library.
    arrays: of index and corners: function takes float32 or uint32 arrays instead of one number.
    Returns a Result: "proved" means that every case of the levels was judged, "checked" that a sample was.
    Raises ValueError, naming the argument; ProgramError where the program `mmverify` is missing or complains. What the
    function raises goes through, with the case added to its notes (Python 3.11).
    """
    laws = _laws(law)
    if isinstance(function, (str, os.PathLike, ctypes.CDLL)):
        return _library(function, laws, levels)
    topic = _topic(laws)
    low, high = _levels(levels, HIGHEST[topic]) or USUAL[topic]
    answers = _pipe.answers_of(topic, function, arrays)
    if topic in ("tree", "bake"):
        chosen = [word for one in laws if "." in one for word in ("--law", one)]
        runs = [_pipe.dialogue([topic, "--levels", f"{low}..{high}", *chosen], answers)]
    else:
        runs = [_pipe.dialogue([topic, "--level", str(level)], answers) for level in range(low, high + 1)]
    return result_of(_pipe.name_of(function), runs)


def _laws(law: Any) -> List[str]:
    laws = [law] if isinstance(law, str) else [] if law is None else list(law)
    if not all(isinstance(one, str) and re.fullmatch(r"[a-z][a-z0-9_]*(\.[a-z0-9_]+)?", one) for one in laws):
        raise ValueError(f"law: {law!r} is no name of a law, such as index.equals_reference, or of a topic")
    return laws


def _topic(laws: Sequence[str]) -> str:
    """The questions on the pipe by which these laws are judged."""
    topics = {"corners" if one in ("corners", "index.corners") else one.split(".")[0] for one in laws}
    single = {"index", "index.equals_reference", "corners", "index.corners"}
    if len(topics) != 1 or not topics <= set(HIGHEST) or (topics <= {"index", "corners"} and not set(laws) <= single):
        raise ValueError(
            f"law: {', '.join(laws) or None}: a function of Python is judged by index, corners, laws of tree or laws of"
            " bake; a library by all"
        )
    return topics.pop()


def _levels(levels: Any, highest: int) -> Optional[Tuple[int, int]]:
    """The lowest and the highest level."""
    if levels is None:
        return None
    text = re.fullmatch(r"(\d+)(?:\.\.(\d+))?", levels) if isinstance(levels, str) else None
    if text:
        ends = [int(text[1]), int(text[2] or text[1])]
    elif isinstance(levels, (range, list, tuple)) and list(levels) and list(levels) == list(range(levels[0], levels[-1] + 1)):
        ends = [levels[0], levels[-1]]
    else:
        ends = [levels, levels]
    low, high = (_arguments.whole("levels", one, 0, highest) for one in ends)
    if low > high:
        raise ValueError(f"levels: {levels!r}: the first is above the last")
    return low, high


def _library(library: Any, laws: Sequence[str], levels: Any) -> Result:
    name = library._name if isinstance(library, ctypes.CDLL) else os.fspath(library)
    if not name or not os.path.isfile(name):
        raise ValueError(f"function: {name!r} is no file of a library; load it by its path, ctypes.CDLL('./mine.so')")
    asked = _levels(levels, 16)
    options = [] if asked is None else ["--levels", f"{asked[0]}..{asked[1]}"]
    name = name if os.path.isabs(name) else os.path.join(".", name)
    run = _program.run(["prove", *laws, "--subject", name, *options, "--no-mutants", "--quiet", "--json", "-"])
    return result_of(name, [run])
