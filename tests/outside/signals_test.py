#!/usr/bin/env python3
"""Each command ends soon after SIGINT or SIGTERM, at whatever moment: exit code 3, results whole or none, no child left.

usage: signals_test.py FOLDER_OF_THE_PROGRAM SUBJECT.so SOURCE.c [SIGNALS_A_COMMAND]
The moments are drawn anew in each run; the seed is printed, and SEED=N repeats them.
"""
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

MOST_DELAY = 1.5  # seconds until a signal
BEFORE_MAIN = 1.0  # seconds in which a busy machine may still load libraries: a signal then ends the process as usual
HANG = 60  # seconds; the program itself ends within one of a quiet machine
INTERRUPTED = 3

COMMANDS = {
    "prove": "prove --no-mutants --json r.json",
    "prove, shared out": "prove index --levels 0..12 --shard 1/2 --journal journal --json r.json",
    "prove a library": "prove --subject {subject} --json r.json",
    "prove a source": "prove index.floats --source {source} --function index_of --levels 9 --json r.json",
    "scene": "scene --level 10 --json r.json -o out.glb",
    "scene, whole": "scene --level 7 --exhaustive --json r.json",
    "scene, levels": "scene --sizes 1..11 --no-laws --json r.json",
    "check maps": "check maps {large} --exhaustive --json r.json",
    "check wrong maps": "check maps {wrong} --json r.json",
    "repair": "repair {wrong} -o out.glb --json r.json",
    "validate": "validate {large} --json r.json",
    "attributes": "attributes --level 1..7 --json r.json",
    "bench": "bench tree vq --levels 7..9 --json r.json",
    "render": "render --level 1..8 --size 1024x1024 --json r.json",
    "views": "views --level 1..7 --size 512x512 --json r.json",
    "vectors": "vectors -o vectors",
    "gen": "gen index --level 11",
    "list": "list",
}


def results_are_whole(folder):
    """A result file is valid JSON or not there; nothing half-written lies about."""
    for file in pathlib.Path(folder).iterdir():
        if file.suffix == ".json":
            json.loads(file.read_text())
        if file.name.endswith(".part"):
            raise AssertionError(f"{file.name} was left")


def children_of(group):
    listing = subprocess.run(["ps", "-e", "-o", "pgid="], capture_output=True, text=True, check=True).stdout
    return listing.split().count(str(group))


def interrupt(program, arguments, signal_sent, delay):
    """Returns (exit code, seconds from the signal to the end); no seconds if it had ended before."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "out"), "w") as out, open(os.path.join(folder, "err"), "w") as err:
            process = subprocess.Popen(
                [program, *arguments], cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                start_new_session=True)
            time.sleep(delay)
            ended_before = process.poll() is not None
            sent = time.monotonic()
            if not ended_before:
                process.send_signal(signal_sent)
            try:
                code = process.wait(HANG)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                raise AssertionError(f"did not end within {HANG} s") from None
            seconds = time.monotonic() - sent
        said = pathlib.Path(folder, "err").read_text()
        results_are_whole(folder)
        for _ in range(50):  # a killed worker may still be a zombie for a moment
            if children_of(process.pid) == 0:
                break
            time.sleep(0.1)
        else:
            raise AssertionError("a process of its own was left")
        if not ended_before and code == INTERRUPTED and "a second signal ends it at once" not in said:
            raise AssertionError(f"it does not say that a second signal ends it: {said}")
        return code, None if ended_before else seconds


def large_files(program, folder):
    """A file of many maps, and one whose maps were baked by another cutoff."""
    large, wrong = os.path.join(folder, "large.glb"), os.path.join(folder, "wrong.glb")
    subprocess.run([program, "scene", "--level", "10", "--no-laws", "--quiet", "-o", large], check=True,
                   stdout=subprocess.DEVNULL)
    text = pathlib.Path(large).read_bytes()
    # The text keeps its length, and so does the chunk.
    changed = text.replace(b'"alphaCutoff":0.4,', b'"alphaCutoff":0.6,')
    assert changed != text, "the file names no cutoff of 0.4"
    pathlib.Path(wrong).write_bytes(changed)
    return large, wrong


def main():
    build, subject, source = sys.argv[1:4]
    times = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    program = os.path.join(os.path.abspath(build), "mmverify")
    seed = int(os.environ.get("SEED", random.SystemRandom().randrange(10**6)))
    draw = random.Random(seed)
    failures = caught = 0
    slowest = (0.0, "none")
    with tempfile.TemporaryDirectory() as folder:
        large, wrong = large_files(program, folder)
        places = {"subject": os.path.abspath(subject), "source": os.path.abspath(source), "large": large, "wrong": wrong}
        for name, line in COMMANDS.items():
            for _ in range(times):
                sent, delay = draw.choice([signal.SIGINT, signal.SIGTERM]), draw.uniform(0.02, MOST_DELAY)
                try:
                    code, seconds = interrupt(program, line.format(**places).split(), sent, delay)
                    # A refutation from before the signal stays one.
                    refuted = "wrong" in name or name == "prove a source"
                    allowed = (INTERRUPTED, 1) if seconds is not None and refuted else (INTERRUPTED,)
                    if seconds is None or code == 0 or (delay < BEFORE_MAIN and code == -sent):
                        continue  # it had ended by itself, or not begun
                    caught += 1
                    slowest = max(slowest, (seconds, name))
                    if code not in allowed:
                        raise AssertionError(f"exit code {code}")
                except (AssertionError, ValueError) as wrong_end:
                    failures += 1
                    print(f"FAILED: {name}: {sent.name} after {delay:.2f} s (seed {seed}): {wrong_end}")
    print(f"{caught} runs of {len(COMMANDS)} commands were interrupted, seed {seed}; {failures} failed; "
          f"the slowest, {slowest[1]}, ended after {slowest[0]:.2f} s")
    return 1 if failures or caught < len(COMMANDS) // 2 else 0


if __name__ == "__main__":
    sys.exit(main())
