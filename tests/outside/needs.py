"""For tests that go on after a failure: each is printed, and kept in `failures`."""
import subprocess

failures = []


def need(holds, what):
    if not holds:
        failures.append(what)
        print(f"FAILED: {what}")


def run(*command, **more):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **more)
