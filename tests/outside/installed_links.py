#!/usr/bin/python3
"""Each link of an installed document leads to an installed file, and so does each example or document that it names; a page
that names files of the source tree says where they are; the manual page names no other document.

usage: tests/outside/installed_links.py DOCUMENTS MANUAL_PAGE      MANUAL_PAGE: as it is, or compressed (.gz)
"""
import gzip
import importlib.machinery
import importlib.util
import pathlib
import re
import sys

sys.dont_write_bytecode = True
stage_file = pathlib.Path(__file__).resolve().parents[2] / "docs/site/stage"
loader = importlib.machinery.SourceFileLoader("stage", str(stage_file))
stage = importlib.util.module_from_spec(importlib.util.spec_from_loader("stage", loader))
loader.exec_module(stage)
documents, manual = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
links = [(page, link) for page in documents.rglob("*.md") for _, link in stage.links(page.read_text(encoding="utf-8"))]
dead = [f"{page}: {link}" for page, link in links if not (page.parent / link).exists()]
tree = re.compile(r"(?:\./run |[` (](?:bench|cli|cmake|delivery|display|fuzz|impl|proofs|scene|scripts|spec|subjects|tests)/[a-z])")
for page in set(documents.rglob("*.md")) - {documents / "CHANGELOG.md"}:  # which tells of older files, too
    words = page.read_text(encoding="utf-8")
    dead += [f"{page} names {name}" for name in re.findall(r"`((?:examples|docs)/[\w./-]*\w)`", words)
             if not (documents / name).exists()]  # fmt: skip
    if page.is_relative_to(documents / "docs") and tree.search(words) and "source tree, which no package installs" not in words:
        dead.append(f"{page} names files of the source tree, and does not say where these are")
text = (gzip.decompress(manual.read_bytes()) if manual.suffix == ".gz" else manual.read_bytes()).decode("utf-8")
named = re.findall(r"docs/[A-Z_]+\.md", text)
dead += [f"the manual page: {name}" for name in named if not (documents / name).exists()]
print(f"{len(links)} links, {len(named)} names on the manual page")
sys.exit("\n".join(dead) if dead or len(links) < 200 or not named else 0)
