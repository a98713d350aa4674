"""What implementations hand to a build: small arrays with the arguments that their sources fill in, judged by mmverify
validate.

A row says which arguments a source fills in, as read at that commit; nobody's code runs.  The triangles, and their maps of
level 1 with four states, are made up.
"""
import json
import pathlib
import struct
import subprocess

from recipes import Trouble

BITS = {"u8": "B", "u16": "H", "u32": "I"}
LEVEL, FORMAT = 1, 2
HEADING = "## What they hand to a build"

# shared: three triangles on two records, and a fourth with a special index; each: a record each.
SHARED, EACH = [0, 1, 0, -4], [0, 1]
BUILDS = [
    {"name": "dxvk-remix", "version": "574be6b7", "of": "2026-08-20",
     "source": "src/dxvk/rtx_render/rtx_opacity_micromap_manager.cpp", "indices": EACH, "type": "u16", "array": 2, "geometry": 0},
    {"name": "nvpro vk_mini_samples, mm_opacity", "version": "bec5c37", "of": "2026-03-13",
     "source": "samples/mm_opacity/mm_opacity.cpp", "indices": EACH, "type": "u32", "array": 2, "geometry": 0},
    {"name": "vierkant", "version": "e284c079", "of": "2026-08-07", "source": "src/RayBuilder.cpp", "indices": SHARED,
     "type": "u32", "array": 2, "geometry": 2},
    {"name": "VK-GL-CTS, `non_zero_base`", "version": "c57d29f9", "of": "2026-07-20",
     "source": "ray_query/vktRayQueryOpacityMicromapTests.cpp", "indices": [0], "base": 1, "type": "u32", "array": 2,
     "geometry": 2},
    {"name": "VK-GL-CTS, `special_index`", "version": "c57d29f9", "of": "2026-07-20",
     "source": "ray_query/vktRayQueryOpacityMicromapTests.cpp", "indices": [-1], "records": 1, "type": "u32", "array": 1,
     "geometry": 1},
    {"name": "vk_gltf_renderer", "version": "81750f4", "of": "2026-07-21", "source": "src/gltf_scene_rtx.cpp",
     "indices": SHARED, "type": "u16", "array": 2, "geometry": 0},
    {"name": "vk_gltf_renderer, 8-bit indices", "version": "81750f4", "of": "2026-07-21", "source": "src/gltf_scene_omm.cpp",
     "indices": SHARED, "type": "u8", "array": 2, "geometry": 0},
    {"name": "Vulkan-Tutorial, OpacityMicromapBuilder", "version": "126fa41", "of": "2026-07-22",
     "source": "attachments/simple_engine/Courses/opacity_micromap_builder.cpp", "api": "khr", "indices": EACH,
     "type": None, "array": 2},
]


def histogram(count):
    return [{"count": count, "level": LEVEL, "format": FORMAT}] if count else []


def sidecar(build, folder):
    """The raw array of a build, docs/VALIDATE.md, in files of a folder; the path of its JSON."""
    folder.mkdir(parents=True, exist_ok=True)
    records = build.get("records", 2)
    (folder / "data.bin").write_bytes(bytes([0b11100100] * records))
    (folder / "records.bin").write_bytes(b"".join(struct.pack("<IHH", k, LEVEL, FORMAT) for k in range(records)))
    geometry = {"triangles": len(build["indices"]), "indices": None, "baseTriangle": build.get("base", 0)}
    if build["type"]:
        letter = BITS[build["type"]]
        mask = (1 << 8 * struct.calcsize(letter)) - 1
        (folder / "indices.bin").write_bytes(b"".join(struct.pack("<" + letter, k & mask) for k in build["indices"]))
        geometry["indices"] = {"file": "indices.bin", "type": build["type"]}
    if "geometry" in build:
        geometry["usageCounts"] = histogram(build["geometry"])
    array = {"schema": "mmverify.array/1", "apis": [build.get("api", "ext")], "records": {"file": "records.bin"},
             "data": {"file": "data.bin"}, "usageCounts": histogram(build["array"]), "geometries": [geometry]}
    path = folder / "build.json"
    path.write_text(json.dumps(array, indent=1), encoding="utf-8")
    return path


def findings(program, path):
    told = subprocess.run([program, "validate", path, "--json", "-"], capture_output=True, text=True)
    if told.returncode not in (0, 1):
        raise Trouble(4, f"mmverify validate {path}: {told.stderr.strip()}")
    return json.loads(told.stdout)["findings"]


def plural(count, noun):
    return f"{count} {noun}" + ("s" if count != 1 else "")


def input_of(build):
    indices = build["indices"]
    special = sum(index < 0 for index in indices)
    words = [plural(len(indices), "triangle") + (f", {special} with a special index" if special else ""),
             plural(build.get("records", 2), "record"),
             f"indices of {build['type'][1:]} bits" if build["type"] else "no indices"]
    if build.get("base"):
        words.append(f"base triangle {build['base']}")
    return ", ".join(words)


def section(program, work):
    """The section of docs/IMPLEMENTATIONS.md, as lines."""
    lines = [HEADING, "",
             "`mmverify validate` judges the arguments that each source, read at this commit, fills in for a build of made-up",
             "triangles. Nobody's code runs. `counts.geometry` and `counts.geometry_is_array`: in EXT a geometry has a histogram of",
             "its own, by which the driver sizes the acceleration structure ([ARRAYS.md](ARRAYS.md)). The structure's description",
             "demands the right one (\"must\"), though no VUID does. [CTS.md](CTS.md) has more about VK-GL-CTS.", "",
             "Three of them stand in no other table here. dxvk-remix bakes in a shader in Slang, of which Debian packages no compiler.",
             "vk_gltf_renderer bakes nothing and computes no index: it hands over what a glTF file has. VK-GL-CTS needs a device.", "",
             "| implementation | version | of | source | input | verdict |", "|---|---|---|---|---|---|"]
    examples = {}
    for number, build in enumerate(BUILDS):
        path = sidecar(build, pathlib.Path(work) / "builds" / str(number))
        found = [one for one in findings(program, path) if one["severity"] == "error"]
        for one in found:
            examples.setdefault(one["code"], f"{one['code']}, {build['name'].replace('`', '')}: {one['found']}")
        verdict = "finds " + ", ".join(f"`{one['code']}`" for one in found) if found else "passes"
        api = build.get("api", "ext").upper()
        lines.append("| " + " | ".join([build["name"], build["version"], build["of"], f"`{build['source']}`",
                                        f"{api}: {input_of(build)}", verdict]) + " |")
    return [*lines, "", "```", *examples.values(), "```"]


def replaced(text, lines):
    """The document with this section in the place of the old one, or before the first section where it has none."""
    start = text.find("\n" + HEADING + "\n")
    start = text.find("\n## ") if start < 0 else start
    if start < 0:
        raise Trouble(4, "the document has no sections")
    end = text.find("\n## ", start + 1) if text.startswith("\n" + HEADING + "\n", start) else start
    end = len(text) if end < 0 else end
    return text[:start + 1] + "\n".join(lines) + "\n" + text[end:]
