"""Python functions on the program's pipe: `mmverify gen` asks, `mmverify check` judges (docs/SUBJECTS.md, "A pipe")."""
from __future__ import annotations

import contextlib
import operator
import subprocess
import tempfile
from fractions import Fraction
from itertools import islice
from typing import Any, Callable, Dict, Iterable, Iterator, List, Sequence

import numpy as np

from . import _core, _program
from ._maps import WRAPS

Answers = Callable[[Iterator[str]], Iterable[str]]
BATCH = 65536  # cases that a function of arrays gets at once
# The names in texts of cases.
CASE_WRAPS = dict(zip(("repeat", "mirror", "clamp", "border", "once"), WRAPS))
CASE_TEXELS: Dict[str, np.dtype] = {"u8": np.dtype(">u1"), "u16": np.dtype(">u2"), "f32": np.dtype(">f4")}


def name_of(function: Any) -> str:
    if isinstance(function, tuple):
        return ", ".join(name_of(part) for part in function)
    return getattr(function, "__name__", type(function).__name__)


def dialogue(arguments: Sequence[str], answers: Answers) -> Any:
    """The JSON of `mmverify check`, which got these answers to the lines of `mmverify gen`."""
    program = _program.find()
    with tempfile.TemporaryFile("w+") as said, tempfile.TemporaryFile("w+") as words:
        asking = subprocess.Popen([program, "gen", *arguments], stdout=subprocess.PIPE, stderr=words, text=True)
        command = [program, "check", *arguments, "--quiet", "--json", "-"]
        judging = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=said, stderr=words, text=True)
        assert asking.stdout and judging.stdin
        try:
            for line in answers(asking.stdout):
                judging.stdin.write(line)
        except BrokenPipeError:  # it says why
            pass
        except BaseException:
            judging.kill()
            raise
        finally:
            asking.stdout.close()
            asking.kill()
            asking.wait()
            with contextlib.suppress(BrokenPipeError):
                judging.stdin.close()
            judging.wait()
        said.seek(0), words.seek(0)
        return _program.read(said.read(), words.read(), judging.returncode)


def called(function: Callable[..., Any], where: str, *arguments: Any, **more: Any) -> Any:
    """The function's answer; an exception gets the case as a note."""
    try:
        return function(*arguments, **more)
    except Exception as error:
        if hasattr(error, "add_note"):
            error.add_note(f"mmverify.prove asked: {where}")
        raise


def natural(answer: Any, where: str) -> int:
    """An answer as a whole number of 32 bits; beyond them nothing is an index."""
    try:
        number = operator.index(answer)
    except TypeError:
        number = -1
    if not 0 <= number < 2**32:
        raise ValueError(f"function: it returned {answer!r}, no whole number from 0 to 2^32 - 1, for {where}")
    return number


def answers_of(topic: str, function: Any, arrays: bool) -> Answers:
    """What answers the lines of a topic by this function."""
    if topic == "tree":
        if not isinstance(function, tuple) or len(function) != 2 or not all(map(callable, function)):
            raise ValueError(f"function: {function!r} is no pair of functions (encode, decode)")
        return lambda lines: _one_by_one(lines, lambda words: _tree(function, words))
    if not callable(function):
        raise ValueError(f"function: {function!r} is neither a function nor a library")
    if topic == "bake":
        return lambda lines: _one_by_one(lines, lambda words: _bake(function, words))
    numbers = _index if topic == "index" else _corners
    return lambda lines: _numbers(lines, function, numbers, BATCH if arrays else 0)


def _one_by_one(lines: Iterator[str], answer: Callable[[List[str]], str]) -> Iterator[str]:
    """The heading goes back, so that it is verified whose cases these are."""
    for line in lines:
        if line.startswith("#"):
            yield line
        else:
            words = line.split()
            yield f"{words[0]} {answer(words[1:])}\n"


def _numbers(lines: Iterator[str], function: Any, ask: Callable[..., List[str]], batch: int) -> Iterator[str]:
    heading = next(lines, "")
    yield heading
    level = int(heading.split()[4]) if heading.startswith("#") else 0
    for some in iter(lambda: [line.split() for line in islice(lines, batch or BATCH)], []):
        for (case, *_), answer in zip(some, ask(function, level, [words[1:] for words in some], batch > 0)):
            yield f"{case} {answer}\n"


def _index(function: Any, level: int, points: List[List[str]], arrays: bool) -> List[str]:
    us, vs = ([float.fromhex(words[k]) for words in points] for k in (0, 1))
    wheres = [f"level={level}, u={u!r}, v={v!r}" for u, v in zip(us, vs)]
    if not arrays:
        return [str(natural(called(function, w, level, u, v), w)) for u, v, w in zip(us, vs, wheres)]
    first = f"{len(us)} points, the first of them {wheres[0]}"
    got = np.asarray(called(function, first, level, np.array(us, np.float32), np.array(vs, np.float32)))
    if got.shape != (len(us),):
        raise ValueError(f"function: it returned an array of shape {got.shape} for {first}")
    return [str(natural(one, where)) for one, where in zip(got.tolist(), wheres)]


def _corners(function: Any, level: int, indices: List[List[str]], arrays: bool) -> List[str]:
    asked = [int(words[0]) for words in indices]
    wheres = [f"level={level}, index={k}" for k in asked]
    if arrays:
        first = f"{len(asked)} indices, the first of them {wheres[0]}"
        got = np.asarray(called(function, first, level, np.array(asked, np.uint32)))
        if got.size != 6 * len(asked):
            raise ValueError(f"function: it returned an array of shape {got.shape} for {first}")
        rows = got.reshape(len(asked), 6).tolist()
    else:
        rows = [np.asarray(called(function, where, level, k)).ravel().tolist() for k, where in zip(asked, wheres)]
    for row, where in zip(rows, wheres):
        if len(row) != 6:
            raise ValueError(f"function: it returned {len(row)} numbers, not three vertices (i, j), for {where}")
    return [" ".join(str(natural(one, where)) for one in row) for row, where in zip(rows, wheres)]


def _hexadecimal(text: str) -> bytes:
    return b"" if text == "-" else bytes.fromhex(text)


def _codes(data: bytes, level: int, bits: int) -> np.ndarray:
    return _core.unpack(np.frombuffer(data, np.uint8), 4**level, 2 * bits)


def _packed(answer: Any, level: int, bits: int, where: str) -> str:
    """The states that a function returned, as a map in hexadecimal."""
    codes = np.asarray(answer)
    if codes.shape != (4**level,) or not np.issubdtype(codes.dtype, np.integer):
        raise ValueError(f"function: it returned {codes.dtype} of shape {codes.shape}, not {4**level} states, for {where}")
    if codes.min() < 0 or codes.max() >= 2 * bits:
        raise ValueError(f"function: it returned a state beyond {2 * bits - 1} for {where}")
    return _core.pack(codes.astype(np.uint8), 2 * bits).tobytes().hex()


def _tree(pair: Any, words: List[str]) -> str:
    what, level, bits, data = words[0], int(words[1]), int(words[2]), _hexadecimal(words[3])
    where = " ".join(words)
    if what == "encode":
        code = bytes(called(pair[0], where, _codes(data, level, bits), 2 * bits))
        return code.hex() or "-"
    codes = called(pair[1], where, data, level, 2 * bits)
    return "-" if codes is None else _packed(codes, level, bits, where)


def _bake(function: Any, words: List[str]) -> str:
    level, bits, where = int(words[0]), int(words[1]), " ".join(words)
    codes = called(function, where, **question(words[2]), level=level, states=2 * bits)
    return "-" if codes is None else _packed(codes, level, bits, where)


def question(text: str) -> Dict[str, Any]:
    """The arguments of mmverify.bake() that a case's text stands for."""
    items = dict(part.split("=", 1) for part in text.split(","))
    kind, size, digits = items.pop("texels").split(":")
    width, height = map(int, size.split("x"))
    stored = CASE_TEXELS[kind]
    mips: List[np.ndarray] = []
    texels = np.frombuffer(bytes.fromhex(digits), stored)
    for k in range(int(items.pop("mips", 1))):
        sides = max(1, height >> k), max(1, width >> k)
        mips.append(texels[: sides[0] * sides[1]].reshape(sides).astype(stored.newbyteorder("=")))
        texels = texels[mips[-1].size :]
    cutoff, wrap = items.pop("cutoff"), items.pop("wrap").split(":")
    uv = [float.fromhex(number) for number in items.pop("uv").split(":")]
    asked: Dict[str, Any] = {
        "alpha": mips[0] if len(mips) == 1 else mips,
        "uv": np.array(uv, np.float32).reshape(3, 2),
        "cutoff": None if cutoff == "blend" else Fraction(cutoff),
        "wrap": tuple(CASE_WRAPS[one] for one in wrap),
    }
    if "border" in items:
        asked["border"] = float(np.frombuffer(bytes.fromhex(items.pop("border")), stored)[0])
    if "filter" in items:
        asked["filter"] = items.pop("filter")
    for name, theirs in (("factor", "factor"), ("vertex", "vertex_factor"), ("margin", "margin")):
        if name in items:
            asked[theirs] = float.fromhex(items.pop(name))
    if items:
        raise ValueError(f"law: its cases have {', '.join(items)}, which a function of Python is not asked")
    return asked
