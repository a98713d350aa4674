"""The verdict on a function or a library."""
from __future__ import annotations

import html
import os
import shlex
import subprocess
import tempfile
from dataclasses import dataclass
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

from . import _program

# From the strongest to the weakest; unknown words rank below all.
RANKS = ("not_applicable", "proved", "checked", "incomplete", "broken", "refuted")


class Counterexample(NamedTuple):
    """The simplest input on which a law fails."""

    law: str
    level: int
    case: str  #: such as v:u=0,v=1/2
    expected: str
    got: str
    hexadecimal: str  #: the same point as C's hexadecimal floats, where the case is one
    replay: str  #: the command that judges this case again


class LawResult(NamedTuple):
    """One law at one level, or at all levels together (level None)."""

    law: str
    level: Optional[int]
    verdict: str  #: proved: the whole domain was judged; checked: a sample; refuted; broken; not_applicable
    cases: int
    mismatches: int
    domain: str
    counterexample: Optional[Counterexample]


@dataclass(frozen=True)
class Result:
    """What mmverify.prove() returns. A notebook shows it as a table, with the picture of the counterexample."""

    subject: str
    laws: Tuple[LawResult, ...]
    diagnosis: Tuple[str, ...]  #: the mistake in words, where it has a name

    @property
    def verdict(self) -> str:
        """The weakest verdict: "proved" only if every law that applies is proved at every level that was asked."""
        return max((one.verdict for one in self.laws), key=_rank, default="not_applicable")

    @property
    def counterexample(self) -> Optional[Counterexample]:
        """The one of the lowest level; of several laws, of the first."""
        found = [one.counterexample for one in self.laws if one.counterexample is not None]
        return min(found, key=lambda one: one.level) if found else None

    def picture(self) -> Optional[str]:
        """The counterexample as SVG: a wrong index or wrong corners are drawn. None without one, or for other laws."""
        wrong = self.counterexample
        if wrong is None or not wrong.replay.startswith("mmverify replay "):
            return None
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "counterexample.svg")
            command = [_program.find(), *shlex.split(wrong.replay)[1:], "--picture", file]
            subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, check=False)
            if not os.path.exists(file):
                return None
            with open(file, encoding="utf-8") as drawn:
                return drawn.read()

    def __repr__(self) -> str:
        wrong = self.counterexample
        at = f"; level {wrong.level} {wrong.case}: expected {wrong.expected}, got {wrong.got}" if wrong else ""
        return f"<mmverify.Result: {self.subject}: {self.verdict} ({self._counts()}){at}>"

    def _counts(self) -> str:
        """The number of laws of each verdict, a law's being the weakest of its levels; and the levels."""
        of_law: Dict[str, str] = {}
        for one in self.laws:
            of_law[one.law] = max(of_law.get(one.law, one.verdict), one.verdict, key=_rank)
        verdicts = [verdict for verdict in of_law.values() if verdict != "not_applicable"]
        counts = [f"{verdicts.count(v)} {v}" for v in sorted(set(verdicts), key=_rank, reverse=True)]
        levels = sorted({one.level for one in self.laws if one.level is not None})
        where = f", levels {levels[0]}..{levels[-1]}" if levels else ""
        return f"laws: {', '.join(counts) or 'none applies'}{where}"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{html.escape(one.law)}</td><td>{'' if one.level is None else one.level}</td>"
            f"<td>{html.escape(one.verdict)}</td><td>{one.mismatches:,} of {one.cases:,} wrong</td></tr>"
            for one in self.laws
            if one.verdict != "not_applicable"
        )
        picture = self.picture() or ""
        words = "".join(f"<p>{html.escape(line)}</p>" for line in self.diagnosis)
        return (
            f"<p><b>{html.escape(self.subject)}: {html.escape(self.verdict)}</b></p>{words}"
            f"<table><tr><th>law</th><th>level</th><th>verdict</th><th>cases</th></tr>{rows}</table>"
            f"{picture[picture.find('<svg') :] if picture else ''}"
        )


def _rank(verdict: str) -> int:
    return RANKS.index(verdict) if verdict in RANKS else len(RANKS)


def result_of(subject: str, runs: Sequence[Dict[str, Any]]) -> Result:
    """The runs of several levels, as the program writes them (docs/result.schema.json), as one result."""
    laws: List[LawResult] = []
    words: List[str] = []
    for run in runs:
        for one in run["results"]:
            wrong = one["counterexample"]
            case = wrong and Counterexample(
                one["law"], wrong["level"], wrong["case"], wrong["expected"], wrong["got"], wrong.get("hex") or "",
                wrong["replay"],
            )  # fmt: skip
            cases, mismatches = one["cases_run"] or 0, one["mismatches"] or 0
            laws.append(LawResult(one["law"], one["level"], one["verdict"], cases, mismatches, one["domain"], case))
        for told in run.get("diagnoses", ()):
            words += [line for line in told["lines"] if line not in words]
    return Result(subject, tuple(laws), tuple(words))
