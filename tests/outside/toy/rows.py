"""Adds the toy's rows to the files that CONTRIBUTING.md names.  usage: rows.py REPOSITORY"""
import pathlib
import sys

# file, the text behind which a row comes, the row
ROWS = [
    ("subjects/sdk/mmverify_subject.h",
     "const float* u, const float* v, uint8_t* state, size_t count);\n",
     "\n  /* Twice each number, which is below 2^31. */\n"
     "  void (*toy_twice)(uint32_t level, const uint32_t* number, uint32_t* twice, size_t count);\n"),
    ("subjects/dock/entry_points.hpp", "array, dag", ", toy"),
    ("subjects/dock/entry_points.hpp",
     "(a.format, a.blob, a.blob_bytes, a.words(0), a.floats(1), a.floats(2), a.bytes(), a.count))",
     " \\\n  ROW(toy_twice, toy, 1, (a.level, a.words(0), a.numbers(), a.count))"),
    ("proofs/registry/topics.cpp", '#include "proofs/micromap/plugin_subject.hpp"\n',
     '#include "proofs/toy/laws.hpp"\n#include "proofs/toy/plugin_subject.hpp"\n'),
    ("proofs/registry/topics.cpp", '     Call::dag_encode, 12, "dag"},\n',
     '    {"toy", {"toy"}, toy::laws, all<toy::built_in_subjects>, {"toy"},\n'
     '     [](const LibraryPtr& l, bool first) { return one<toy::plugin_subject>(l, "toy", first); },\n'
     "     Call::toy_twice, 8},\n"),
]

for name, behind, row in ROWS:
    path = pathlib.Path(sys.argv[1], name)
    before, found, after = path.read_text().rpartition(behind)
    if not found:
        sys.exit(f"{name}: no line has {behind.strip()!r}")
    path.write_text(before + found + row + after)
