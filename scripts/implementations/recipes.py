"""Which implementations are known, by the recipes of examples/adapters, and which of them a checkout is."""
import re
import subprocess

KEYS = {"name", "marker", "below", "version", "extract", "asked", "says", "limits", "source", "flags", "adapter", "adapter_flags",
        "scene", "libraries", "debian"}


class Trouble(Exception):
    """What ends a run: the exit code, and what to tell."""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


def recipe_of(folder):
    """The file `recipe` of an adapter: lines KEY: VALUE; a key may stand again, for more of it."""
    found = {key: "" for key in KEYS}
    for number, line in enumerate((folder / "recipe").read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        key, colon, value = line.partition(":")
        if not colon or key not in KEYS:
            raise Trouble(2, f"{folder / 'recipe'}:{number}: not one of the keys {', '.join(sorted(KEYS))}")
        found[key] = f"{found[key]}\n{value.strip()}".strip()
    found["id"] = folder.name
    found["folder"] = folder if not found["adapter"] else folder.parent / found["adapter"]
    return found


def recipes_in(folder):
    found = [recipe_of(path.parent) for path in sorted(folder.glob("*/recipe"))]
    if not found:
        raise Trouble(2, f"{folder}: no adapters there")
    return found


def base_of(recipe, checkout):
    """Where the implementation lies in a checkout: at its top, or below it as a submodule; none where it is another."""
    for base in [checkout, checkout / recipe["below"]] if recipe["below"] else [checkout]:
        if (base / recipe["marker"]).is_file():
            return base
    return None


def known(recipes):
    return "".join(f"  {r['name']}: has {r['marker']}\n" for r in recipes)


def date_of(base):
    """The day of the checkout's commit; unknown without a commit of its own."""
    if (base / ".git").exists():
        told = subprocess.run(["git", "-C", base, "log", "-1", "--format=%cs"], capture_output=True, text=True)
        if told.returncode == 0 and told.stdout.strip():
            return told.stdout.strip()
    return "unknown"


def version_of(recipe, base):
    """What its header says and what git says of the checkout; of git only where the checkout is one's own top."""
    parts = []
    if recipe["version"]:
        file, _, pattern = recipe["version"].partition(" ")
        if (base / file).is_file():
            match = re.search(pattern, (base / file).read_text(encoding="utf-8", errors="replace"), re.S)
            if match:
                parts.append(".".join(match.groups()))
    if (base / ".git").exists():
        told = subprocess.run(["git", "-C", base, "describe", "--tags", "--always"], capture_output=True, text=True)
        if told.returncode == 0:
            parts.append(told.stdout.strip())
    return ", ".join(parts) or "unknown"
