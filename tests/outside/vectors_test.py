#!/usr/bin/python3
"""The files of mmverify vectors: one content in three forms, whole, the same each time; and the readers of
examples/vectors/ on them, spoilt ones too.

usage: tests/outside/vectors_test.py MMVERIFY CC CXX HOME      HOME: where display/report/packages has put esbuild, if it has
Exit code 77: all is well but what Node.js or esbuild is missing for, and it says so."""
import contextlib
import copy
import hashlib
import io
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

from needs import failures, need, run

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
READERS = ROOT / "examples" / "vectors"
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
WIDE = {"optional", "wide", "set", "bytes", "digits", "words", "binary32s"}


def sha256(data):
    return hashlib.sha256(data).hexdigest()


def sections(file):
    """(family, section) to (version, bytes of a record, bytes), in the order of the table of contents."""
    entries, at = struct.unpack_from("<2I", file, 12)
    found = {}
    for k in range(entries):
        family, section, version, size, records, start = struct.unpack_from("<16s16s4I", file, at + 64 * k)
        name = tuple(text.rstrip(b"\0").decode() for text in (family, section))
        found[name] = version, size, file[start : start + size * records]
    return found


def value_of(words, column, data, abouts):
    """What the JSON form has to say, of a column's words in the binary form."""
    kind, names = column["kind"], column.get("names")
    part = data[words[0] : words[0] + words[1]] if kind in WIDE else b""
    listed = struct.unpack(f"<{len(part) // 4}I", part[: len(part) // 4 * 4])
    return {
        "number": lambda: words[0],
        "optional": lambda: words[0] if words[1] else None,
        "binary32": lambda: f"{words[0]:08x}",
        "name": lambda: names[words[0]],
        "about": lambda: abouts[words[0]],
        "wide": lambda: words[0] | words[1] << 32,
        "set": lambda: [name for k, name in enumerate(names) if (words[0] | words[1] << 32) >> k & 1],
        "bytes": part.hex,
        "digits": lambda: "".join(map(str, part)),
        "words": lambda: list(listed),
        "binary32s": lambda: [f"{word:08x}" for word in listed],
    }[kind]()


def same_in_json_and_binary(family, parts):
    """Each vector of a JSON file, read out of the binary file."""
    name = family["family"]
    data = parts[name, "data"][2]
    abouts = [text.rstrip(b"\0").decode() for (text,) in struct.iter_unpack("64s", parts[name, "about"][2])]
    mine = [key for key in parts if key[0] == name]
    need([key[1] for key in mine] == [t["table"] for t in family["tables"]] + ["data", "about"], f"{name}: tables")
    need(sha256(b"".join(parts[key][2] for key in mine)) == family["sha256"], f"{name}: the hash of its records")
    for table in family["tables"]:
        version, size, records = parts[name, table["table"]]
        need(version == family["version"], f"{name}: version")
        need(size * len(table["vectors"]) == len(records), f"{name}.{table['table']}: how many")
        for vector, words in zip(table["vectors"], struct.iter_unpack(f"<{size // 4}I", records)):
            at = 0
            for column in table["columns"]:
                width = 2 if column["kind"] in WIDE else 1
                said = value_of(words[at : at + width], column, data, abouts)
                need(said == vector[column["name"]], f"{name}.{table['table']} {vector['id']}: {column['name']}")
                at += width


def spoilt_are_seen(family, parts):
    """A digit, a name or a number of the first vector of each table, changed: seen by same_in_json_and_binary."""
    for i, table in enumerate(family["tables"]):
        for column in table["columns"]:
            spoilt = copy.deepcopy(family)
            vector = spoilt["tables"][i]["vectors"][0]
            vector[column["name"]] = [vector[column["name"]], "spoilt"]
            before = len(failures)
            with contextlib.redirect_stdout(io.StringIO()):
                same_in_json_and_binary(spoilt, parts)
            found = len(failures) - before
            del failures[before:]
            need(found == 1, f"{family['family']}.{table['table']}: {column['name']} spoilt, {found} differences seen")


def same_in_header_and_binary(folder, families, parts, cc, cxx):
    """A program that writes the arrays of the header, by either language: the bytes of the binary file."""
    lines, wanted = ['#include "mmverify_vectors.h"', "#include <stdio.h>", "int main(void) {", "  size_t n = 0;"], b""
    for family in families:
        name = family["family"]
        for table in family["tables"]:
            array = f"mmverify_vectors_{name}_{table['table']}"
            lines.append(f"  n += fwrite({array}, 1, sizeof {array}, stdout);")
            lines.append(f"  if (sizeof {array} / sizeof {array}[0] != {array.upper()}) return 1;")
            wanted += parts[name, table["table"]][2]
        if parts[name, "data"][2]:
            lines.append(f"  n += fwrite(mmverify_vectors_{name}_data, 1, sizeof mmverify_vectors_{name}_data, stdout);")
            wanted += parts[name, "data"][2]
    lines.append("  return n == 0;\n}\n")
    for compiler, language, standard in (cc, "c", "c99"), (cxx, "c++", "c++11"):
        source, program = folder / f"dump.{language}", folder / "dump"
        source.write_text("\n".join(lines))
        built = run(compiler, "-x", language, f"-std={standard}", "-O0", *STRICT, "-o", program, source)
        need(built.returncode == 0, f"the header in {language}: {built.stderr[:2000]}")
        said = subprocess.run([program], capture_output=True, check=False)
        need(said.returncode == 0 and said.stdout == wanted, f"the arrays of the header in {language}")


def spoils(points):
    """(vector, word of its record, new word): both answers of the first point, so that no dialect has all; and of the
    points where all answer 2^32 - 1, the first gets no answer of `prose`, and another one a wrong one."""
    first, other, *_ = [p["id"] for p in points if p["prose"] == p["exact"] == p["published"] == 2**32 - 1]
    return [(0, 6, 3), (0, 7, 3), (first, 8, 0), (first, 9, 0), (other, 8, 5)]


def spoilt_header(text, points):
    start = text.index("\n", text.index("mmverify_vectors_index_points[")) + 1
    rows = text[start:].split("\n", len(points))
    for vector, word, value in spoils(points):
        words = rows[vector].strip(" {},").split(", ")
        words[word] = f"{value}u"
        rows[vector] = "  {" + ", ".join(words) + "},"
    return text[:start] + "\n".join(rows)


def spoilt_json(folder):
    spoilt = json.loads((folder / "index.json").read_text())
    vectors = spoilt["tables"][0]["vectors"]
    for vector, word, value in spoils(vectors):
        vectors[vector].update({6: {"exact": value}, 7: {"published": value}, 8: {"prose": value}, 9: {"prose": None}}[word])
    return json.dumps(spoilt)


def readers(folder, points, cc, home):
    """Each reader on whole vectors and on spoilt ones."""
    total, inside = len(points), sum(p["prose"] is not None for p in points)

    def judged(what, good, bad, dialect):
        prose = sum(p["prose"] == p[dialect] for p in points)
        need(good.returncode == 0 and f"{dialect}: {total} of {total}" in good.stdout and f"prose: {prose} of {inside}\n" in good.stdout,
             f"{what}, prose: {prose} of {inside}: {good.stdout}{good.stderr}")  # fmt: skip
        need(bad.returncode == 1 and f"{dialect}: {total - 1} of {total}" in bad.stdout and "first: level 0" in bad.stdout
             and f"prose: {prose - 2} of {inside - 1}\n" in bad.stdout,
             f"{what}, vectors spoilt, prose: {prose - 2} of {inside - 1}: {bad.stdout}{bad.stderr}")  # fmt: skip

    said = []
    text = (folder / "mmverify_vectors.h").read_text()
    for header in text, spoilt_header(text, points):
        place = folder / f"c{len(said)}"
        place.mkdir()
        (place / "mmverify_vectors.h").write_text(header)
        built = run(cc, "-std=c99", "-O2", "-ffp-contract=off", *STRICT, "-I", place, "-o", place / "read", READERS / "read.c")
        need(built.returncode == 0, f"read.c: {built.stderr[:2000]}")
        said.append(run(place / "read"))
    judged("read.c", *said, "published")

    binary = bytearray((folder / "mmverify_vectors.bin").read_bytes())
    good = run(sys.executable, READERS / "read.py", folder / "mmverify_vectors.bin")
    _, size, records = sections(binary)["index", "points"]
    at = binary.index(records)
    for vector, word, value in spoils(points):
        struct.pack_into("<I", binary, at + size * vector + 4 * word, value)
    (folder / "spoilt.bin").write_bytes(binary)
    judged("read.py", good, run(sys.executable, READERS / "read.py", folder / "spoilt.bin"), "exact")
    (folder / "cut.bin").write_bytes(binary[:-1])
    need(run(sys.executable, READERS / "read.py", folder / "cut.bin").returncode == 1, "read.py takes a file that was cut short")

    esbuild = pathlib.Path(home, "node_modules", ".bin", "esbuild")
    if shutil.which("node") is None or not esbuild.exists():
        print("skipped: read.ts: no Node.js, or no esbuild, which the page of mmverify report is built with")
        return 77
    program = folder / "read.mjs"
    built = run(esbuild, READERS / "read.ts", f"--outfile={program}", "--log-level=warning")
    need(built.returncode == 0, f"read.ts: {built.stderr}")
    (folder / "spoilt.json").write_text(spoilt_json(folder))
    judged("read.ts", run("node", program, folder / "index.json"), run("node", program, folder / "spoilt.json"), "published")
    return 0


def main(program, cc, cxx, home):
    with tempfile.TemporaryDirectory() as temporary:
        folder, again = pathlib.Path(temporary, "vectors"), pathlib.Path(temporary, "again")
        for place in folder, again:
            made = run(program, "vectors", "-o", place)
            need(made.returncode == 0, f"mmverify vectors: {made.stderr}")
        names = sorted(file.name for file in folder.iterdir())
        need(all((folder / name).read_bytes() == (again / name).read_bytes() for name in names), "the same bytes each time")
        manifest = json.loads((folder / "MANIFEST.json").read_text())
        need(sorted(file["file"] for file in manifest["files"]) + ["MANIFEST.json"] == sorted(names, key=lambda n: (n == "MANIFEST.json", n)), "the manifest lists the files")
        total = 0
        for file in manifest["files"]:
            data = (folder / file["file"]).read_bytes()
            need((len(data), sha256(data)) == (file["bytes"], file["sha256"]), f"{file['file']}: size and hash")
            total += len(data)
        need(total < 5_000_000, f"{total} bytes, and 5 MB are the most")
        binary = (folder / "mmverify_vectors.bin").read_bytes()
        need(binary[:8] == b"MMVECTOR" and struct.unpack_from("<I", binary, 20) == (len(binary),), "the binary's head")
        need(binary[96:128] == hashlib.sha256(binary[128:]).digest(), "the binary's own hash")
        families = [json.loads((folder / (f["family"] + ".json")).read_text()) for f in manifest["families"]]
        header = (folder / "mmverify_vectors.h").read_text()
        for family, listed in zip(families, manifest["families"]):
            need(family["sha256"] == listed["sha256"], f"{family['family']}: the manifest's hash")
            need(f'_{family["family"].upper()}_SHA256 "{family["sha256"]}"' in header, f"{family['family']}: the header's hash")
            need(family["tool"]["spec_hash"] == binary[64:96].hex(), "the hash of the specification")
            same_in_json_and_binary(family, sections(binary))
            if family["family"] in ("arrays", "bake"):  # between them they have each kind of column
                spoilt_are_seen(family, sections(binary))
        same_in_header_and_binary(folder, families, sections(binary), cc, cxx)
        checked = run(ROOT / "scripts" / "check-schema", *(folder / name for name in names if name.endswith(".json")))
        need(checked.returncode == 0, f"docs/vectors.schema.json: {checked.stdout[:2000]}{checked.stderr[:2000]}")
        code = readers(folder, families[0]["tables"][0]["vectors"], cc, home)
    if failures:
        return 1
    vectors = sum(len(table["vectors"]) for family in families for table in family["tables"])
    print(f"{vectors} vectors of {len(families)} families in three forms, {total} bytes")
    return code


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
