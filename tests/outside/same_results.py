#!/usr/bin/env python3
"""Holds two results of mmverify prove --json together: what either judged is judged alike, but for laws of a prover.

usage: same_results.py NATIVE.json WASM.json
"""
import json
import sys

PROVER = ("z3", "Embree")


def rows(path):
    with open(path, encoding="utf-8") as file:
        result = json.load(file)
    return {(r["law"], r["subject"], r["level"]): r for r in result["results"]}, result.get("mutants", [])


def main(native_path, wasm_path):
    (native, native_mutants), (wasm, wasm_mutants) = rows(native_path), rows(wasm_path)
    failures, left_out, same = [], 0, 0
    for key in sorted(native.keys() | wasm.keys(), key=str):
        n, w = native.get(key), wasm.get(key)
        reason = (w or {}).get("reason") or ""
        if w is not None and w["verdict"] == "not_applicable" and any(word in reason for word in PROVER):
            left_out += 1
            continue
        if n is None or w is None:
            failures.append(f"{key}: only {'WebAssembly' if n is None else 'native'} has it")
            continue
        fields = [f for f in ("verdict", "cases", "digest", "counterexamples") if n.get(f) != w.get(f)]
        if fields:
            failures.append(f"{key}: " + ", ".join(f"{f}: {n.get(f)} / {w.get(f)}" for f in fields))
        else:
            same += 1
    killed = {(m["law"], m["mutant"]): m["killed"] for m in native_mutants}
    for m in wasm_mutants:
        if killed.get((m["law"], m["mutant"])) != m["killed"]:
            failures.append(f"mutant {m['law']} {m['mutant']}")
    print(f"{same} results are the same, digests included; {left_out} need a prover or Embree; {len(wasm_mutants)} mutants")
    for line in failures[:20]:
        print("differs:", line[:300])
    return 1 if failures or same == 0 else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
