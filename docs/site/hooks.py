"""What mkdocs does differently here: links as the repository has them, anchors as GitHub makes them, a search from disk."""
import json
import pathlib
import posixpath
import re

from mkdocs.exceptions import PluginError


def anchor(text, separator):
    """As GitHub names headings: "What `a..b` is" -> "what-ab-is"."""
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", separator)


def on_config(config):
    config["mdx_configs"].setdefault("toc", {})["slugify"] = anchor
    return config


def on_files(files, config):
    """Each document of docs/ has its place in the navigation."""
    nav = json.dumps(config["nav"])
    missing = [f.src_path for f in files.documentation_pages()
               if re.fullmatch(r"docs/[^/]*\.md", f.src_path) and f'"{f.src_path}"' not in nav
               and not f.src_path.endswith((".json.md", ".yml.md"))]
    if missing:
        raise PluginError(f"docs/site/mkdocs.yml has no place for: {' '.join(missing)}")
    return files


def on_page_markdown(markdown, page, config, files):
    """Links to sources and folders lead to their pages."""
    here = posixpath.dirname(page.file.src_path)

    def led(match):
        link, sharp, name = match.group(1).partition("#")
        if files.get_file_from_path(posixpath.normpath(posixpath.join(here, link))):
            return match.group(0)
        # As docs/site/stage names what begins with a dot.
        link = re.sub(r"(^|/)\.(?=[a-z])", r"\1dot-", link)
        for page_of in (link + ".md", link.rstrip("/") + "/README.md"):
            if files.get_file_from_path(posixpath.normpath(posixpath.join(here, page_of))):
                return f"]({page_of}{sharp}{name})"
        return match.group(0)

    out, fenced = [], False
    for line in markdown.split("\n"):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        out.append(line if fenced else re.sub(r"\]\(([^()\s:]+)\)", led, line))
    return "\n".join(out)


def on_post_build(config):
    """A page from disk may neither fetch nor start a worker from a file: there the theme takes both from one script."""
    site = pathlib.Path(config["site_dir"])
    index = (site / "search/search_index.json").read_text(encoding="utf-8")
    workers = list(site.glob("assets/javascripts/workers/search.*.min.js"))
    if len(workers) != 1:
        raise PluginError(f"the theme has {len(workers)} workers of search, not one")
    worker = json.dumps(workers[0].read_text(encoding="utf-8")).replace("</", "<\\/")
    (site / "search/from_disk.js").write_text(
        f"var __search = {{\n  index: Promise.resolve({index}),\n"
        f"  worker: URL.createObjectURL(new Blob([{worker}], {{ type: \"text/javascript\" }}))\n}};\n", encoding="utf-8")
