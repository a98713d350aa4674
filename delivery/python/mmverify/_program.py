"""The program `mmverify`: judging is its work. The package finds it, and reads its JSON."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
from typing import Any, Sequence


class ProgramError(RuntimeError):
    """The program is missing, or could not do what it was asked; its own words follow."""


def find() -> str:
    """The program named by MMVERIFY_PROGRAM, else `mmverify` of the PATH."""
    named = os.environ.get("MMVERIFY_PROGRAM")
    found = shutil.which(named or "mmverify")
    if found is None and named:
        raise ProgramError(f"MMVERIFY_PROGRAM: {named} is no program")
    if found is None:
        raise ProgramError(
            "the program `mmverify` is not on the PATH; install it (README.md, 'Install it'), or name it in the"
            " environment variable MMVERIFY_PROGRAM"
        )
    return found


def fault(words: str, code: int) -> ProgramError:
    """The complaint among the program's words."""
    lines = [line.strip() for line in words.splitlines() if line.strip()]
    named = [line for line in lines if line.startswith("mmverify: ")]
    return ProgramError((named or lines or [f"mmverify ended with exit code {code}"])[0])


def read(text: str, words: str, code: int) -> Any:
    """The JSON of a run; one that could not do what it was asked writes none."""
    if code < 0 or not text.strip():
        raise fault(words, code)
    return json.loads(text)


def run(arguments: Sequence[str]) -> Any:
    """The JSON that the program writes to stdout."""
    done = subprocess.run([find(), *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    return read(done.stdout, done.stderr, done.returncode)
