"""Builds an adapter against a checkout, and runs mmverify on it; both leave their words in a log."""
import json
import pathlib
import signal
import subprocess

from recipes import Trouble

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


class Builder:
    """Compiles into the work folder; an object that two adapters share is made once a run."""

    def __init__(self, work):
        self.work = work
        self.objects = {}
        (work / "objects").mkdir(parents=True, exist_ok=True)

    def run(self, log, command):
        with open(log, "a", encoding="utf-8") as out:
            print("$", " ".join(map(str, command)), file=out, flush=True)
            return subprocess.run(command, stdout=out, stderr=out, cwd=ROOT).returncode == 0

    def library(self, recipe, base, suffix, flags):
        name = recipe["id"] + suffix
        log, library = self.work / f"{name}.log", self.work / f"{name}.so"
        log.write_text("", encoding="utf-8")
        library.unlink(missing_ok=True)
        common = ["c++", "-std=c++20", "-O2", "-fPIC", "-w", f"-I{ROOT / 'subjects/sdk'}", f"-I{ROOT}"]
        if recipe["extract"]:
            common.append(f"-I{self.extracted(recipe, base, log)}")
        common += [flag.replace("{}", str(base)).replace("{0}", str(base)) for flag in recipe["flags"].split()]
        objects = []
        for pattern in recipe["source"].split():
            sources = sorted(base.glob(pattern))
            if not sources:
                raise Trouble(4, f"{recipe['name']}: no {base / pattern}")
            for source in sources:
                key = (source, *common)
                if key not in self.objects:
                    made = self.work / "objects" / f"{len(self.objects)}.o"
                    if not self.run(log, [*common, "-c", source, "-o", made]):
                        raise self.failed(recipe, log)
                    self.objects[key] = made
                objects.append(self.objects[key])
        command = [*common, *flags, *recipe["adapter_flags"].split(), "-shared", recipe["folder"] / "adapter.cpp",
                   *objects, *recipe["libraries"].split(), "-o", library]
        if not self.run(log, command):
            raise self.failed(recipe, log)
        return library

    def bake_times(self, library, levels):
        """Nanoseconds of a state at each level that the baker has, {level: ns}."""
        timer, log = self.work / "time_bakes", library.with_suffix(".log")
        if timer not in self.objects:
            source = ROOT / "examples/adapters/time_bakes.cpp"
            if not self.run(log, ["c++", "-std=c++20", "-O2", f"-I{ROOT / 'subjects/sdk'}", source, "-o", timer]):
                raise Trouble(4, f"{source} does not build, see {log}")
            self.objects[timer] = timer
        told = subprocess.run([timer, library, *map(str, levels)], capture_output=True, text=True, timeout=600)
        if told.returncode != 0:
            with open(log, "a", encoding="utf-8") as out:
                out.write(told.stderr)
            return {}
        return {int(level): float(ns) for level, ns in (line.split() for line in told.stdout.splitlines())}

    def extracted(self, recipe, base, log):
        """The parts of the checkout's files that a recipe names, by sed, in a folder of their own."""
        folder = self.work / f"{recipe['id']}.extracted"
        folder.mkdir(exist_ok=True)
        for old in folder.iterdir():
            old.unlink()
        for line in recipe["extract"].splitlines():
            to, source, script = line.split(" ", 2)
            got = subprocess.run(["sed", "-n", script, base / source], capture_output=True)
            if got.returncode != 0 or not got.stdout:
                with open(log, "ab") as out:
                    out.write(f"nothing of {base / source} by {script}\n".encode() + got.stderr)
                raise self.failed(recipe, log)
            with open(folder / to, "ab") as out:
                out.write(got.stdout)
        return folder

    @staticmethod
    def failed(recipe, log):
        needs = f"; it needs the Debian packages {recipe['debian']}" if recipe["debian"] else ""
        return Trouble(4, f"{recipe['name']} does not build, see {log}{needs}")


def mmverify(program, arguments, result, log, limit):
    """Runs it for so many seconds at most; its JSON, and whether it came to its end."""
    result.unlink(missing_ok=True)
    with open(log, "a", encoding="utf-8") as out:
        print("$ mmverify", " ".join(map(str, arguments)), file=out, flush=True)
        running = subprocess.Popen([program, *arguments, "--json", result, "--quiet"], stdout=out, stderr=out, cwd=ROOT)
        whole = True
        try:
            running.wait(timeout=limit)
        except subprocess.TimeoutExpired:
            whole = False
            running.send_signal(signal.SIGINT)
        except KeyboardInterrupt:
            running.send_signal(signal.SIGINT)
            running.wait()
            raise
        running.wait()
    if running.returncode in (2, 4) or not result.is_file():
        raise Trouble(4, f"mmverify {' '.join(map(str, arguments))} failed, see {log}")
    return json.loads(result.read_text(encoding="utf-8")), whole
