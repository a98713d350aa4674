"""The text of a transcript: its commands, the output written below each, how that is compared with what came out."""
import re

# What a name in braces stands for.
NAMES = {"seconds": r"[0-9]+\.[0-9]+", "threads": r"[0-9]+", "number": r"[0-9][0-9.,]*", "hash": r"[0-9a-f]+"}
# What an update never writes out, for it differs from run to run.
MASKS = (
    (r"( cases) +[0-9.]+ s( .*)?$", r"\1 ..."),
    (r"[0-9.]+ s on [0-9]+ threads", "{seconds} s on {threads} threads"),
    (r"[0-9.]+ s on 1 thread$", "{seconds} s on 1 thread"),
)


class Step:
    """A command and the output written below it. `line` is the last of the command, `end` that of the output."""

    def __init__(self, command, line):
        self.command, self.line, self.end, self.output = command, line, line, []


def steps_of(lines):
    """The commands of a transcript. A remark or a command ends an output; empty lines at its end do not count."""
    steps, below = [], False
    for number, line in enumerate(lines, 1):
        if line.startswith("$ "):
            steps.append(Step(line[2:], number))
            below = True
        elif line.startswith("> ") and below and not steps[-1].output:
            steps[-1].command += "\n" + line[2:]
            steps[-1].line = steps[-1].end = number
        elif line.startswith("# "):
            below = False
        elif line and below:
            steps[-1].output += [""] * (number - 1 - steps[-1].end) + [line.rstrip()]
            steps[-1].end = number
    return steps


def matches(written, line):
    pattern = re.sub(r"\\\{(\w+)\\\}", lambda name: NAMES.get(name[1], name[0]), re.escape(written))
    return re.fullmatch(pattern.replace(r"\.\.\.", ".*"), line) is not None


def matching(written, came, at):
    """How many of these lines match those that begin at `at`, up to the first that does not."""
    pairs = list(zip(written, came[at:]))
    return next((k for k, pair in enumerate(pairs) if not matches(*pair)), len(pairs))


def difference(written, came):
    """The first written line that did not come, as (its place, what came there); None where there is none.

    `...` alone stands for any lines. The lines between two of these are taken where they first match."""
    start, at = 0, 0
    while start <= len(written):
        end = written.index("...", start) if "..." in written[start:] else len(written)
        part = written[start:end]
        if start == 0:
            places = [0]
        elif end == len(written):
            places = [max(at, len(came) - len(part))]
        else:
            places = range(at, len(came) + 1)
        found = [matching(part, came, place) for place in places]
        most = max(found)
        at = places[found.index(most)] + most
        if most < len(part):
            return start + most, came[at] if at < len(came) else "nothing more"
        start = end + 1
    return None if at == len(came) else (len(written), came[at])


def alignment(written, came):
    """The longest sequence of written lines that came, as pairs of places."""
    longest = {}  # from two places on: how many match, and which two places come next
    for w in range(len(written), -1, -1):
        for c in range(len(came), -1, -1):
            if w == len(written) or c == len(came):
                longest[w, c] = 0, None
            elif written[w] != "..." and matches(written[w], came[c]):
                longest[w, c] = longest[w + 1, c + 1][0] + 1, (w + 1, c + 1)
            else:
                longest[w, c] = max((longest[place][0], place) for place in ((w + 1, c), (w, c + 1)))
    pairs, at = [], (0, 0)
    while (following := longest[at][1]) is not None:
        if following == (at[0] + 1, at[1] + 1):
            pairs.append(at)
        at = following
    return pairs


def updated(written, came):
    """What came, in the words of what is written where they still match."""
    lines, w, c = [], 0, 0
    for next_w, next_c in alignment(written, came) + [(len(written), len(came))]:
        if "..." in written[w:next_w]:
            lines.append("...")
        else:
            for line in came[c:next_c]:
                for pattern, mask in MASKS:
                    line = re.sub(pattern, mask, line)
                lines.append(line)
        lines += written[next_w : next_w + 1]
        w, c = next_w + 1, next_c + 1
    return lines
