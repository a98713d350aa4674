#!/usr/bin/env python3
"""Writes the seed corpora of result_file and of journal: python3 fuzz/corpus/make_results.py build/seeds

An input of result_file is "j", a result's JSON, a zero byte, and the JSON of an earlier result or of a baseline."""
import json
import zlib

import seeds

KINDS = ("vertex", "edge", "interior")


def law(level=0, verdict="proved", cases=1, wrong=0, **changes):
    by_kind = {kind: {"cases": 0, "mismatches": 0} for kind in KINDS}
    by_kind["interior"] = {"cases": cases, "mismatches": wrong}
    found = {"rank": [0, 0], "level": level, "case": "k=0", "expected": "0", "got": "1"} if wrong else None
    return {
        "law": "index.corners", "topic": "index", "subject": "impl", "level": level, "method": "exhaustive",
        "domain": "the 4^n indices", "verdict": verdict, "cases_expected": cases, "cases_run": cases, "mismatches": wrong,
        "by_kind": by_kind, "counterexample": found, "digest": "08a97b0004e7fead", "seconds": 0.5,
    } | changes  # fmt: skip


def run(*results, **changes):
    return {
        "schema": "mmverify.result/1",
        "tool": {"version": "0.2.0", "compiler": "c", "flags": "", "cpu": "c", "threads": 2, "seed": 1,
                 "spec_hash": "0" * 64, "source_hash": "0" * 64},
        "results": list(results),
        "mutants": [{"law": "index.corners", "mutant": "one is off", "killed": True, "level": 7, "case": "k=7777"}],
    } | changes  # fmt: skip


def baseline(**figures):
    return {"schema": "mmverify.baseline/1", "of": "mmverify.result/1", "processor": "c", "settings": {"tool.seed": 1},
            "figures": {"index.corners impl level 0": {"cases_run": 1, "verdict": "proved"} | figures}}  # fmt: skip


def inputs(now, before=None):
    return b"j" + json.dumps(now).encode() + (b"\0" + json.dumps(before).encode() if before is not None else b"")


NONE = {"verdict": "not_applicable", "cases_run": 0, "cases_expected": 0, "reason": "no function"}


def line(members):
    text = json.dumps(members, separators=(",", ":"))
    return f"{zlib.crc32(text.encode()):08x} {text}\n".encode()


FIRST = line({"schema": "mmverify.journal/1", "laws": "index.equals_reference", "seed": "1"})
PIECE = {"about": "index", "from": 0, "to": 3, "of": 256, "counts": [[0, 0, 0, 0], [0, 0, 0, 0], [3, 0, 0, 0]],
         "digest": "00000000000000ff"}  # fmt: skip
# The count of the first piece that the harness writes for 0, 0, 9, 3; a place after the checksum and a space.
COUNT = len(FIRST) + 9 + json.dumps(PIECE | {"to": 10}, separators=(",", ":")).index("[3,0") + 1

seeds.write({
    "result_file": {
        "alone": inputs(run(law())),
        "same": inputs(run(law()), run(law())),
        "two_levels": inputs(run(law(), law(1, cases=4)), run(law(1, cases=4))),
        "refuted": inputs(run(law(verdict="refuted", wrong=1)), run(law())),
        "mended": inputs(run(law()), run(law(verdict="refuted", wrong=1))),
        "sampled": inputs(run(law(verdict="checked", method="sample")), run(law())),
        "broken": inputs(run(law(verdict="broken", cases_run=0, reason="crashed"))),
        "not_applicable": inputs(run(law(**NONE), law(1)), run(law(), law(1))),
        "contradiction": inputs(run(law(mismatches=1))),
        "more_run_than_expected": inputs(run(law(cases_run=2))),
        "of_two_seeds": inputs(run(law()), run(law(), tool={"seed": 2})),
        "shard": inputs(run(law(share={"from": 0, "to": 1, "of": 2}), shard={"number": 1, "of": 2, "finished": True, "run": {}})),
        "twice": inputs(run(law(), law())),
        "list": inputs([run(law()), run(law(1))]),
        "great_numbers": inputs(run(law(cases=2**64 - 1, digest="f" * 16))),
        "negative": inputs(run(law(cases_run=-1))),
        "baseline": inputs(run(law()), baseline()),
        "baseline_changed": inputs(run(law()), baseline(verdict="checked", digest="0" * 16)),
        "baseline_of_another": inputs(run(law()), baseline() | {"of": "mmverify.bench/1"}),
        "bench": inputs({"schema": "mmverify.bench/1", "topic": "tree", "rows": []}),
        "scene": inputs(run(scenes=[])),
        "no_schema": inputs({"schema": 7}),
        "deep": b"j" + b"[" * 80,
        "cut": inputs(run(law()))[:200],
    },
    "journal": {
        "empty": bytes([0]),
        "one": bytes([1, 0, 0, 9, 3]),
        "three_that_overlap": bytes([3, 0, 0, 9, 3, 0, 5, 20, 4, 1, 7, 7, 8]),
        "of_strange_names": bytes([3, 1, 0, 9, 3, 2, 5, 20, 4, 3, 7, 7, 8]),
        "cut": bytes([2, 0, 0, 9, 3, 0, 10, 20, 4, 150, 0, 255]),
        "cut_in_the_first_line": bytes([2, 0, 0, 9, 3, 0, 10, 20, 4, 20, 0, 255]),
        "a_digit_changed": bytes([2, 0, 0, 9, 3, 0, 10, 20, 4, COUNT, 0, ord("7")]),
        "raw": b"r" + FIRST + line(PIECE),
        "raw_beyond_the_work": b"r" + FIRST + line(PIECE | {"to": 999}) + line(PIECE | {"from": 4, "to": 2}),
        "raw_twice": b"r" + FIRST + line(PIECE) + line(PIECE | {"from": 1, "to": 5}),
        "raw_types": b"r" + FIRST + line(PIECE | {"counts": 7}) + line(PIECE | {"digest": "xyz"}) + line(PIECE | {"from": -1}),
        "raw_of_another_run": b"r" + line({"schema": "mmverify.journal/1", "laws": "tree.decode", "seed": "1"}),
        "raw_no_journal": b"rhello\n",
    },
})  # fmt: skip
