#!/usr/bin/python3
"""Each link of an installed document leads to an installed file, and the manual page names no other document.

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
text = (gzip.decompress(manual.read_bytes()) if manual.suffix == ".gz" else manual.read_bytes()).decode("utf-8")
named = re.findall(r"docs/[A-Z_]+\.md", text)
dead += [f"the manual page: {name}" for name in named if not (documents / name).exists()]
print(f"{len(links)} links, {len(named)} names on the manual page")
sys.exit("\n".join(dead) if dead or len(links) < 200 or not named else 0)
