#!/usr/bin/python3
"""The scripts for Amber that mmverify vectors --form amber writes: their numbers are read back by Amber's own rules and held
against geometry, their shaders are compiled, and their index function runs as C++ on all points, right and with mistakes.

usage: tests/outside/amber_test.py MMVERIFY CXX
Exit code 77: all is well, but glslangValidator is missing, and it says so."""
import json
import os
import pathlib
import re
import shutil
import struct
import sys
import tempfile
from fractions import Fraction

from needs import failures, need, run

KINDS = ["interior", "edge", "vertex", "outside"]
BEGIN, END = "// ---- your function begins ----\n", "// ---- your function ends ----\n"
MISTAKES = {  # a mistake as an edit of the script's function
    "tie_on_diagonal": (">= rest", "> rest"),
    "level_zero": ("(1u << level)", "(1u << max(level, 1u))"),
    "flip_missing": ("^ iu) & ~b0", "^ iu ^ f) & ~b0"),
    "cut_to_16_bits": ("return spread(b0) | spread(((f ^ iu) & ~b0) | t) << 1;", "return (spread(b0) | spread(((f ^ iu) & ~b0) | t) << 1) & 0xffffu;"),
    "u_v_exchanged": ("uint index_of(uint level, float u, float v)", "uint index_of(uint level, float v, float u)"),
    "rounded_sum": ("min(fu, fv) >= rest", "fu + fv >= 1.0"),
}  # fmt: skip
CPP = """#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
using uint = unsigned;
#define precise
static float clamp(float x, float a, float b) { return x < a ? a : b < x ? b : x; }
static float floor(float x) { return std::floor(x); }
using std::max;
using std::min;
%s
int main() {
  uint level, bits[2];
  while (scanf("%%u %%u %%u", &level, bits, bits + 1) == 3) {
    float f[2];
    memcpy(f, bits, sizeof f);
    printf("%%u\\n", index_of(level, f[0], f[1]));
  }
}
"""


def read_script(text):
    """Shaders, buffers and the other statements. Amber takes a `#` and what follows in its line for a comment, but not in a
    shader, which ends at a line END."""
    shaders, buffers, statements, lines = {}, {}, [], iter(text.splitlines())
    if next(lines) != "#!amber":
        raise ValueError("the first line is not #!amber")
    for line in lines:
        words = line.split("#")[0].split()
        if words[:1] == ["SHADER"]:
            source = []
            while (line := next(lines)) != "END":
                source.append(line)
            shaders[words[2]] = "\n".join(source) + "\n"
        elif words[:1] == ["BUFFER"] and words[2:] == ["DATA_TYPE", "uint32", "DATA"]:
            numbers = []
            while (more := next(lines).split("#")[0].split()) != ["END"]:
                numbers += [int(number, 0) for number in more]
            buffers[words[1]] = numbers
        elif words:
            statements.append(" ".join(words))
    return shaders, buffers, statements


def value(bits):
    return Fraction(struct.unpack("<f", struct.pack("<I", bits))[0])


def children(mistake):
    """Corners of the children 0 to 3 from those of the parent and the middles of its sides, as a known mistake has them."""
    return lambda p, p01, p02, p12: (
        (p[0], p01, p02),
        (p12, p02, p01) if mistake == "middle_not_turned" else (p02, p12, p01),
        (p01, p[1], p12),
        (p02, p12, p[2]) if mistake == "flip_missing" else (p12, p02, p[2]),
    )


def descended(level, u, v, mistake=""):
    """The index by geometry: the child that has the point inside, level by level. None if an edge or nothing has it."""
    split, corners, index = children(mistake), ((Fraction(0), Fraction(0)), (Fraction(1), Fraction(0)), (Fraction(0), Fraction(1))), 0
    def inside(t):
        turns = [(b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0]) for a, b in zip(t, t[1:] + t[:1])]
        return all(x > 0 for x in turns) or all(x < 0 for x in turns)
    if level and not inside(corners):
        return None
    for _ in range(level):
        middle = lambda a, b: ((corners[a][0] + corners[b][0]) / 2, (corners[a][1] + corners[b][1]) / 2)
        for digit, child in enumerate(split(corners, middle(0, 1), middle(0, 2), middle(1, 2))):
            if inside(child):
                index, corners = 4 * index + digit, child
                break
        else:
            return None
    return index


def on(level, u, v):
    if u < 0 or v < 0 or u + v > 1:
        return "outside"
    whole = [(x * 2**level).denominator == 1 for x in (u, v, u + v)]
    return "vertex" if whole[0] and whole[1] else "edge" if any(whole) else "interior"


def wrong_by_geometry(level, u, v, expected, published):
    """Mistakes that a point inside of a micro-triangle finds, of those that geometry alone decides: True, False, or None where
    the mistaken function lands on an edge."""
    other = lambda *point, **more: None if (index := descended(*point, **more)) is None else index != expected
    return {
        "level_zero": other(max(level, 1), u, v),
        "u_v_exchanged": other(level, v, u),
        "first_vertex_as_u": other(level, 1 - u - v, u),
        "flip_missing": other(level, u, v, mistake="flip_missing"),
        "middle_not_turned": other(level, u, v, mistake="middle_not_turned"),
        "cut_to_16_bits": expected > 0xFFFF,
        "rounded_sum": published != expected,
    }


def numbers_agree(buffers, vectors, names, dialect):
    """The buffers against the JSON form, and those of `exact` against geometry."""
    points, marks, expected = buffers["points"], buffers["marks"], buffers["expected"]
    need(len(points) == 3 * len(vectors) and len(marks) == 2 * len(vectors) and len(expected) == len(vectors), f"{dialect}: sizes")
    inside, decided = 0, dict.fromkeys(names, 0)
    for k, vector in enumerate(vectors):
        level, u_bits, v_bits = points[3 * k : 3 * k + 3]
        finds = {name for i, name in enumerate(names) if marks[2 * k + 1] >> i & 1}
        need((level, f"{u_bits:08x}", f"{v_bits:08x}", KINDS[marks[2 * k]], sorted(finds), expected[k])
             == (vector["level"], vector["u"], vector["v"], vector["on"], sorted(vector["finds"]), vector[dialect]), f"{dialect} {k}")  # fmt: skip
        if dialect != "exact":
            continue
        u, v = value(u_bits), value(v_bits)
        need(on(level, u, v) == vector["on"], f"{k}: {vector['on']} by Fractions")
        need(vector["on"] == "outside" or expected[k] in vector["touched"], f"{k}: the answer is none of `touched`")
        if vector["on"] != "interior":
            continue
        inside += 1
        need(descended(level, u, v) == expected[k], f"{k}: {expected[k]} by geometry")
        for name, wrong in wrong_by_geometry(level, u, v, expected[k], vector["published"]).items():
            if wrong is not None:
                need(wrong == (name in finds), f"{k}: {name}")
                decided[name] += wrong
    if dialect == "exact":
        need(inside > 1500 and all(decided[name] for name in ("level_zero", "flip_missing", "middle_not_turned", "rounded_sum")), f"{inside} inside, {decided}")
    return inside


def comments_agree(text, vectors):
    lines = re.findall(r"^\d+ 0x\w{8} 0x\w{8} # (\d+): (\w+): (.*?)(?:; finds (.*))?$", text, re.M)
    need([(int(k), on, about, finds.split()) for k, on, about, finds in lines]
         == [(v["id"], v["on"], v["about"], v["finds"]) for v in vectors], "a comment a vector")  # fmt: skip


def answers(folder, cxx, function, points):
    source, program = folder / "ask.cpp", folder / "ask"
    source.write_text(CPP % function)
    built = run(cxx, "-std=c++17", "-O1", "-ffp-contract=off", "-fsingle-precision-constant", "-o", program, source)
    if built.returncode:
        raise ValueError(f"the function as C++: {built.stderr[:2000]}")
    asked = "\n".join(" ".join(map(str, points[k : k + 3])) for k in range(0, len(points), 3))
    return list(map(int, run(program, input=asked).stdout.split()))


def judged(folder, cxx, function, buffers):
    """What the script's second pipeline counts: vectors with a wrong answer."""
    got = answers(folder, cxx, function, buffers["points"])
    need(len(got) == len(buffers["expected"]), "an answer a vector")
    return {k for k, (mine, right) in enumerate(zip(got, buffers["expected"])) if mine != right}


def statements_agree(statements, vectors, names, dialect):
    groups = -(-len(vectors) // 64)
    need([s for s in statements if s.startswith("RUN")] == [f"RUN ask {groups} 1 1", f"RUN count {groups} 1 1"], f"{dialect}: runs")
    counters = len(KINDS) + len(names)
    need([s for s in statements if s.startswith("EXPECT")]
         == [f"EXPECT wrong IDX {4 * k} EQ 0" for k in range(counters)] + ["EXPECT answers EQ_BUFFER expected"], f"{dialect}: expectations")  # fmt: skip
    need(f"BUFFER wrong DATA_TYPE uint32 SIZE {counters} FILL 0" in statements
         and f"BUFFER answers DATA_TYPE uint32 SIZE {len(vectors)} FILL 4294967295" in statements, f"{dialect}: buffers")  # fmt: skip


def compiled(folder, shaders):
    for name, source in shaders.items():
        (folder / f"{name}.comp").write_text(source)
        built = run("glslangValidator", "-V", "--target-env", "vulkan1.0", "-o", folder / f"{name}.spv", folder / f"{name}.comp")
        need(built.returncode == 0, f"{name}: {built.stdout}{built.stderr}")
        if shutil.which("spirv-val"):
            valid = run("spirv-val", "--target-env", "vulkan1.0", folder / f"{name}.spv")
            need(valid.returncode == 0, f"{name}: {valid.stdout}{valid.stderr}")


def mistakes_are_counted(folder, cxx, function, buffers, vectors):
    """A function with a mistake is wrong on the vectors that say so, and on no other."""
    for name, (before, after) in MISTAKES.items():
        need(function.count(before) == 1, f"{name}: the edit")
        need(judged(folder, cxx, function.replace(before, after), buffers) == {v["id"] for v in vectors if name in v["finds"]}, f"{name}: counted")


def by_amber(path, text):
    """Amber itself, where it is installed: the script passes, and fails with a mistake."""
    need(run("amber", path).returncode == 0, f"amber {path.name}")
    path.write_text(text.replace(" min(uint(y), last)", " uint(y)"))
    need(run("amber", path).returncode != 0, f"amber {path.name}, with a mistake")


def main(program, cxx):
    glslang = shutil.which("glslangValidator") is not None
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary, "vectors")
        made = run(program, "vectors", "-o", folder, "--form", "json,amber", "--family", "index")
        need(made.returncode == 0, f"mmverify vectors: {made.stderr}")
        need(sorted(os.listdir(folder)) == ["MANIFEST.json", "index.json", "index_exact.amber", "index_published.amber"], "its files")
        table = json.loads((folder / "index.json").read_text())["tables"][0]
        vectors, names = table["vectors"], next(c["names"] for c in table["columns"] if c["name"] == "finds")
        need({name for v in vectors for name in v["finds"]} == set(names), "each mistake has a vector")
        for dialect in "exact", "published":
            path = folder / f"index_{dialect}.amber"
            text = path.read_text()
            shaders, buffers, statements = read_script(text)
            inside = numbers_agree(buffers, vectors, names, dialect) or inside
            comments_agree(text, vectors)
            statements_agree(statements, vectors, names, dialect)
            function = shaders["asks"].split(BEGIN)[1].split(END)[0]
            need(judged(pathlib.Path(temporary), cxx, function, buffers) == set(), f"{dialect}: its own function is right")
            if dialect == "exact":
                mistakes_are_counted(pathlib.Path(temporary), cxx, function, buffers, vectors)
            if glslang:
                compiled(pathlib.Path(temporary), shaders)
            if shutil.which("amber"):
                by_amber(path, text)
    if failures:
        return 1
    print(f"{len(vectors)} vectors in two scripts, {inside} of them held against geometry; {len(MISTAKES)} mistakes counted")
    if not glslang:
        print("skipped: the shaders: no glslangValidator")
    return 0 if glslang else 77


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
