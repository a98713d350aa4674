"""Writes docs/IMPLEMENTATIONS.md from the results."""
import re
import textwrap

MOST = 120  # characters a line
WEAKEST_FIRST = ["broken", "refuted", "incomplete", "checked", "proved", "not_applicable"]


def command(text):
    """The lines of a command.  A shell joins lines at a backslash, in the middle of a word, too: so long cases are cut."""
    lines, line = [], ""
    for word in re.split(r" (?=--)", text):
        if line and len(line) + 1 + len(word) > MOST - 2:
            lines.append(line + " \\")
            line = "  " + word
        else:
            line += " " * bool(line) + word
        while len(line) > MOST - 2:
            at = line.rfind(",", 0, MOST - 2) + 1
            at = at if at > 60 else MOST - 2
            lines.append(line[:at] + "\\")
            line = line[at:]
    return [*lines, line]


def message(text):
    """The lines of a message, further ones indented."""
    indent = " " * (len(text) - len(text.lstrip()) + 2)
    return textwrap.wrap(text, MOST, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def by_law(results):
    laws = {}
    for one in results:
        laws.setdefault(one["law"], []).append(one)
    return laws


def weakest(results):
    return min((r["verdict"] for r in results), key=WEAKEST_FIRST.index)


BAKING = r"baking (?:the mesh )?|on case "  # what stands before a case in a reason


def broken_case(one):
    """The replay line of the case that a reason names, where it names one."""
    at = re.search(rf"at level (\d+) (?:{BAKING})(\S+)", one.get("reason", ""))
    return at and f"mmverify replay {one['law']} --level {at[1]} --case {at[2]} --subject {one['subject']}"


def simplest(results):
    """For each law the case that refutes it, and one without an answer, at its lowest such level: lines of text.  Laws
    that say the same of one case are told together."""
    alike = {}
    for of_law in by_law(results).values():
        for verdict in ("refuted", "broken"):
            one = next((r for r in of_law if r["verdict"] == verdict), None)
            if not one:
                continue
            if case := one.get("counterexample"):
                told = f"{one['law']} level {case['level']}: expected {case['expected']}; got {case['got']}"
                replay = case["replay"]
            else:
                replay, reason = broken_case(one), one.get("reason", verdict)
                if replay:
                    reason = re.sub(rf"({BAKING})\S+", lambda at: at[1].replace("the mesh ", "") + "this:", reason)
                told = f"{one['law']}: {reason}"
            about = f"{told} {replay}".replace(one["law"], "")
            alike.setdefault(about, []).append((one["law"], told, replay))
    found = []
    for (_, told, replay), *others in alike.values():
        same = message(f"  the same with {', '.join(law for law, *_ in others)}") if others else []
        found.append([*message(told), *same, *(command(replay) if replay else [])])
    return found


def cell(text):
    return str(text).replace("|", "\\|")


def verdicts(results):
    """How many laws end how, the weakest level of each law: {"proved": 3, ...}."""
    ends = [weakest(of_law) for of_law in by_law(results).values()]
    return {verdict: ends.count(verdict) for verdict in WEAKEST_FIRST if verdict in ends}


def overall(found):
    ends = [verdict for verdict in verdicts(found["results"]) if verdict != "not_applicable"]
    return (ends[0] if ends else "not_applicable") + ("" if found["whole"] else ", incomplete")


def input_of(found):
    """What was asked: the entry points, the cases of the laws that ran, the scenes."""
    names = re.sub(r": .*|, as a baker.*", "", found["recipe"]["asked"])  # the section has it in full
    cases = sum(r.get("cases_run", 0) for r in found["results"] if r["verdict"] != "not_applicable")
    scenes = len({scene for scene, _, _ in found["scenes"]})
    return f"{names}: {cases:,} cases" + (f", {scenes} scenes" if scenes else "")


def summary(found_all):
    lines = ["| implementation | version | of | input | verdict | laws |", "|---|---|---|---|---|---|"]
    for found in found_all:
        counts = ", ".join(f"{n} {verdict}" for verdict, n in verdicts(found["results"]).items()
                           if verdict != "not_applicable")
        row = [found["recipe"]["name"], found["version"], found["date"], input_of(found), overall(found), counts]
        lines.append("| " + " | ".join(map(cell, row)) + " |")
    return lines


def laws_of(found):
    lines = ["| law | levels | verdict | wrong |", "|---|---|---|---|"]
    for law, results in by_law(found["results"]).items():
        verdict = weakest(results)
        if verdict == "not_applicable":
            continue
        results = [r for r in results if r["verdict"] != "not_applicable"]
        levels = [r["level"] for r in results]
        span = f"{min(levels)}" if min(levels) == max(levels) else f"{min(levels)} to {max(levels)}"
        cases, wrong = (sum(r.get(key, 0) for r in results) for key in ("cases_run", "mismatches"))
        crashed = sum(r.get("cases_broken", 0) for r in results)
        tail = f", {crashed:,} without an answer" if crashed else ""
        lines.append(f"| {law} | {span} | {verdict} | {wrong:,} of {cases:,}{tail} |")
    return lines


def scenes_of(found_all, levels):
    rows = [(found["recipe"]["name"], *scene) for found in found_all for scene in found["scenes"]]
    if not rows:
        return []
    lines = ["", "## On scenes", "",
             "A state is wrong if it is O or T and the texture under it is not, by the baker's own declaration. It is needless",
             "if it is unknown, and one state holds on the whole micro-triangle. The column `outside` counts triangles beyond",
             "the adapter's limits; they are not baked.",
             "",
             "| implementation | scene | level | triangles | outside | declined | states | wrong per million | needless |",
             "|---|---|---|---|---|---|---|---|---|"]
    for name, scene, row, _ in rows:
        judged = row["micro_triangles"] > 0
        lines.append("| " + " | ".join(map(cell, [
            name, scene, row["level"], f"{row['triangles']:,}", f"{row['outside']:,}", f"{row['declined']:,}",
            f"{row['micro_triangles']:,}", f"{row['wrong_per_million']:.1f}" if judged else "-",
            f"{100 * row['needless_share']:.3f} %" if judged else "-"])) + " |")
    subjects = list(dict.fromkeys((scene, subject) for _, scene, _, subject in rows))
    lines += ["", "These commands, with the path of the scene, measure again:", "", "```"]
    for scene, subject in subjects:
        lines += command(f"mmverify bench bake --scene {scene} --levels {levels} --subject {subject}")
    return lines + ["```"]


def speeds_of(found_all, ours):
    """The times of bakers and of indices, beside this project's own."""
    lines = []
    bakers = [found for found in found_all if found["times"]]
    if bakers:
        lines += ["", "## Speed", "", "Bakers: the processor time of a state, on one thread, in one process with the library, for 128 triangles of a",
                  "texture of 128 x 128 texels. Our baker is exact. Speeds differ from run to run, and a law may reach its time limit",
                  "at another case; everything else in this document stays the same. The command above measures again.",
                  "[BAKE_CELLS.md](BAKE_CELLS.md) has meshoptimizer's by texture, size of triangle and level.", "",
                  "| implementation | level | ns a state | ours | x ours |", "|---|---|---|---|---|"]
        for found in bakers:
            for level, ns in found["times"].items():
                lines.append(f"| {cell(found['recipe']['name'])} | {level} | {ns:.1f} | {ours[level]:.1f} | "
                             f"{ns / ours[level]:.2f} |")
    timed = [found for found in found_all if found["index"]]
    if timed:
        lines += ["", "Barycentrics to index: level 9, one thread, a bare loop over batches of 4096.", "",
                  "| implementation | ns an index | ours, one by one | ours, in batches |", "|---|---|---|---|"]
    for found in timed:
        theirs, own = found["index"]
        ns = {row["subject"]: row["ns_per_index"] for row in own["rows"]}
        lines.append(f"| {cell(found['recipe']['name'])} | {theirs['bare_ns']:.1f} | {ns['impl-scalar']:.1f} | "
                     f"{ns['impl-batched']:.1f} |")
    if timed:
        lines += ["", "```", *(f"mmverify bench index --levels 9 --subject {found['subject']}" for found in timed), "```"]
    return lines


def sections(found):
    recipe = found["recipe"]
    points = [f"Version: {found['version']}.", f"Entry points: {recipe['asked']}.", f"Limits: {recipe['limits']}.",
              f"Its own claim: {recipe['says']}.",
              f"Adapter: [{recipe['id']}](../examples/adapters/{recipe['id']}/recipe)."]
    lines = ["", f"## {recipe['name']}", ""]
    for point in points:
        lines += message("- " + point)
    lines += ["", *laws_of(found)]
    if not found["whole"]:
        lines += ["", "The time limit ended the run before its last law."]
    blocks = simplest(found["results"])
    if found["diagnoses"]:
        blocks.append([line for text in found["diagnoses"] for line in message(text)])
    if blocks:
        lines += ["", "```", *(line for text in blocks for line in [*text, ""])]
        lines[-1] = "```"
    return lines


def document(found_all, tool, options, ours, builds):
    words = [f"--limit {options.limit:g}", *(f"--scene {scene.name}" for scene in options.scene)]
    if options.scene:
        words.insert(1, f"--levels {options.levels}")
    lines = ["# Implementations that exist", "",
             "The laws judge implementations by others. `./run implementations` builds each from a checkout, calls it through an",
             "adapter of [examples/adapters](../examples/adapters), and writes this file. A verdict is about one version, within",
             "the limits beside it, and about nothing else. A law may demand more than an implementation promises, so each",
             "section quotes the implementation's own claim. [SUBJECTS.md](SUBJECTS.md#implementations-that-exist) explains",
             "recipes, and how to add an implementation.", "",
             f"mmverify {tool['version']}, specification `{tool['spec_hash'][:16]}`, {tool['cpu']}, {tool['compiler']}.", "",
             "```", f"./run implementations {' '.join(words)} DIR...", "```", "",
             "After that command the `mmverify replay` lines below work from the root of this repository. A shell joins a line",
             "that ends in a backslash with the next one.", "", "## What passes", "",
             "Each row is a version, the day of its commit, and what was asked; `mmverify prove --subject` gives the verdict. `laws`",
             "counts laws by verdict, each by its weakest level.", "", *summary(found_all)]
    lines += ["", *builds]
    lines += scenes_of(found_all, options.levels) + speeds_of(found_all, ours)
    for found in found_all:
        lines += sections(found)
    return "\n".join(lines) + "\n"
