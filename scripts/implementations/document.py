"""docs/IMPLEMENTATIONS.md of what was found."""
import re
import textwrap

WEAKEST_FIRST = ["broken", "refuted", "incomplete", "checked", "proved", "not_applicable"]


def by_law(results):
    laws = {}
    for one in results:
        laws.setdefault(one["law"], []).append(one)
    return laws


def weakest(results):
    return min((r["verdict"] for r in results), key=WEAKEST_FIRST.index)


def broken_case(one):
    """The replay line of the case that a reason names, where it names one."""
    at = re.search(r"at level (\d+) (?:baking|on case) (\S+)", one.get("reason", ""))
    if not at:
        return []
    return [f"mmverify replay {one['law']} --level {at[1]} --case {at[2]} --subject {one['subject']}"]


def simplest(results):
    """Of each law the case that refutes it, and one without an answer, at its lowest such level: lines of text."""
    found = []
    for of_law in by_law(results).values():
        for verdict in ("refuted", "broken"):
            one = next((r for r in of_law if r["verdict"] == verdict), None)
            case = one and one.get("counterexample")
            if case:
                told = f"{one['law']} level {case['level']}: expected {case['expected']}; got {case['got']}"
                found.append([told, case["replay"]])
            elif one:
                found.append([f"{one['law']}: {one.get('reason', verdict)}", *broken_case(one)])
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


def summary(found_all):
    lines = ["| implementation | version | what was asked | verdict | laws |", "|---|---|---|---|---|"]
    for found in found_all:
        counts = ", ".join(f"{n} {verdict}" for verdict, n in verdicts(found["results"]).items()
                           if verdict != "not_applicable")
        recipe = found["recipe"]
        lines.append("| " + " | ".join(map(cell, [recipe["name"], found["version"], recipe["asked"], overall(found),
                                                  counts])) + " |")
    return lines


def laws_of(found):
    lines = ["| law | levels | verdict | wrong |", "|---|---|---|---|"]
    for law, results in by_law(found["results"]).items():
        verdict = weakest(results)
        if verdict == "not_applicable":
            continue
        levels = [r["level"] for r in results if r["verdict"] != "not_applicable"]
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
             "A state is wrong where it is O or T and the texture under it is not, by what the baker declares, and",
             "needless where it is unknown and need not be. Triangles outside of what the adapter declares are not asked.",
             "",
             "| implementation | scene | level | triangles | outside | declined | states | wrong a million | needless |",
             "|---|---|---|---|---|---|---|---|---|"]
    for name, scene, row, _ in rows:
        judged = row["micro_triangles"] > 0
        lines.append("| " + " | ".join(map(cell, [
            name, scene, row["level"], f"{row['triangles']:,}", f"{row['outside']:,}", f"{row['declined']:,}",
            f"{row['micro_triangles']:,}", f"{row['wrong_per_million']:.1f}" if judged else "-",
            f"{100 * row['needless_share']:.3f} %" if judged else "-"])) + " |")
    subjects = list(dict.fromkeys((scene, subject) for _, scene, _, subject in rows))
    lines += ["", "Again, with the scene's own path:", "", "```"]
    lines += [f"mmverify bench bake --scene {scene} --levels {levels} --subject {subject}" for scene, subject in subjects]
    return lines + ["```"]


def speeds_of(found_all, ours):
    """Of bakers and of indices, beside this project's own."""
    lines = []
    bakers = [found for found in found_all if found["times"]]
    if bakers:
        lines += ["", "## Speed", "", "Of bakers: processor time of a state, one thread, in one process with the library, 128 triangles of a texture",
                  "of 128 x 128 texels; ours is exact. Speeds differ from run to run, and so does where the time limit stops a law;",
                  "nothing else in this document does. The command above takes them again.", "",
                  "| implementation | level | ns a state | ours | x ours |", "|---|---|---|---|---|"]
        for found in bakers:
            for level, ns in found["times"].items():
                lines.append(f"| {cell(found['recipe']['name'])} | {level} | {ns:.1f} | {ours[level]:.1f} | "
                             f"{ns / ours[level]:.2f} |")
    timed = [found for found in found_all if found["index"]]
    if timed:
        lines += ["", "Of barycentrics to index: at level 9, one thread, a bare loop over batches of 4096.", "",
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
    points = [f"Version: {found['version']}.", f"Asked: {recipe['asked']}.", f"Within: {recipe['limits']}.",
              f"What it says of itself: {recipe['says']}.",
              f"Adapter: [{recipe['id']}](../examples/adapters/{recipe['id']}/recipe)."]
    lines = ["", f"## {recipe['name']}", ""]
    for point in points:
        lines += textwrap.wrap("- " + point, 120, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)
    lines += ["", *laws_of(found)]
    if not found["whole"]:
        lines += ["", "The time limit came before the last of the laws."]
    for text in simplest(found["results"]):
        lines += ["", "```", *text, "```"]
    if found["diagnoses"]:
        lines += ["", "```", *found["diagnoses"], "```"]
    return lines


def document(found_all, tool, options, ours):
    words = [f"--limit {options.limit:g}", *(f"--scene {scene.name}" for scene in options.scene)]
    if options.scene:
        words.insert(1, f"--levels {options.levels}")
    lines = ["# Implementations that exist", "",
             "What the laws say of implementations by others, each built from a checkout and asked through an adapter of",
             "[examples/adapters](../examples/adapters). This file is written by `./run implementations`; a verdict is about",
             "the version and the limits that stand beside it, and about nothing else. A law may ask for more than an",
             "implementation promises: what each says of itself stands with it. How to add one, and what a recipe is:",
             "[SUBJECTS.md](SUBJECTS.md#implementations-that-exist).", "",
             f"mmverify {tool['version']}, specification `{tool['spec_hash'][:16]}`, {tool['cpu']}, {tool['compiler']}.", "",
             "```", f"./run implementations {' '.join(words)} DIR...", "```", "",
             "The replay lines hold from the checkout's root, once that has run.", "", *summary(found_all)]
    lines += scenes_of(found_all, options.levels) + speeds_of(found_all, ours)
    for found in found_all:
        lines += sections(found)
    return "\n".join(lines) + "\n"
