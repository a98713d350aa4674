"""Findings in files of micromaps."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Iterable, List, NamedTuple, Optional, Tuple, Union

from . import _program


class Finding(NamedTuple):
    """One finding, as `mmverify validate --json` has it; docs/ISSUES.md lists the codes."""

    code: str  #: stable, such as array.index_range
    severity: str  #: error, warning or advice
    place: str  #: a JSON pointer into the file, or byte N of a container; empty: the file
    message: str  #: what was found
    rule: str  #: what holds where all is well
    source: str  #: whose rule it is
    vuids: Tuple[str, ...]  #: Vulkan's identifiers of the rule
    remedy: str
    file: str


def validate(
    path: Union[str, os.PathLike[str]], *, draft: Optional[str] = None, apis: Union[str, Iterable[str]] = (),
    limits: Union[str, os.PathLike[str], None] = None,
) -> List[Finding]:  # fmt: skip
    """What is wrong with a file of micromaps, or with all such files of a folder; an empty list: nothing.

    path: glTF, the JSON sidecar of a raw array, or a container of the library; its content tells which.
    draft: of glTF: khr, ext-1 or ext-2. apis: ext, khr, dxr, or several. limits: a JSON file of the device's limits.
    Raises FileNotFoundError where nothing is at the path; ProgramError where a file cannot be judged, with the reason,
    or where the program `mmverify` is missing.
    """
    place = Path(path)
    if not place.exists():
        raise FileNotFoundError(f"path: there is nothing at {place}")
    options = ["--draft", draft] if draft is not None else []
    for api in [apis] if isinstance(apis, str) else apis:
        options += ["--api", api]
    if limits is not None:
        options += ["--limits", os.fspath(limits)]
    # A name that begins with - is no option.
    named = os.fspath(place) if place.is_absolute() else os.path.join(".", os.fspath(place))
    files = _program.run(["validate", named, *options, "--json", "-"])
    found = []
    for file in files if isinstance(files, list) else [files]:
        if file["unread"] is not None:
            raise _program.ProgramError(f"{file['file']}: {file['unread']}")
        found += [_finding(one, file["file"]) for one in file["findings"]]
    return found


def _finding(one: Any, file: str) -> Finding:
    return Finding(
        one["code"], one["severity"], one["pointer"], one["found"], one["says"], one["source"], tuple(one["vuids"]),
        one["remedy"], file,
    )  # fmt: skip
