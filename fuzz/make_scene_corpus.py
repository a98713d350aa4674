#!/usr/bin/env python3
"""Writes the seed corpora of scene_load and scene_validate: python3 fuzz/make_scene_corpus.py fuzz/corpus

See scene_input.hpp for what an input is.
"""
import base64
import copy
import json
import pathlib
import struct
import sys
import zlib

EXT = "EXT_mesh_opacity_micromap"
FLOAT, U8, I16, U16, U32 = 5126, 5121, 5122, 5123, 5125


def png(width, height, bits, colour, rows, before=b""):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + before + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


RGBA = png(2, 2, 8, 6, [b"\1\2\3\0\1\2\3\x55", b"\1\2\3\xaa\1\2\3\xff"])
SIXTEEN = png(1, 2, 16, 6, [bytes(6) + b"\x12\x34", bytes(6) + b"\xff\xfe"])
PALETTE = png(2, 1, 8, 3, [b"\1\0"],
              struct.pack(">I", 6) + b"PLTEabcdef" + bytes(4) + struct.pack(">I", 1) + b"tRNS\x21" + bytes(4))  # fmt: skip


def jpeg():
    """8 x 8 grey texels, with the smallest tables: one code each, for no difference and for the end of a block."""

    def segment(marker, data):
        return bytes([0xFF, marker]) + struct.pack(">H", len(data) + 2) + data

    one_code = bytes([1] + [0] * 15 + [0])
    return (
        b"\xff\xd8"
        + segment(0xDB, b"\0" + b"\1" * 64)
        + segment(0xC0, struct.pack(">BHHB", 8, 8, 8, 1) + b"\1\x11\0")
        + segment(0xC4, b"\x00" + one_code)
        + segment(0xC4, b"\x10" + one_code)
        + segment(0xDA, b"\1\1\0\0\x3f\0")
        + b"\x3f\xff\xd9"
    )


class File:
    """Two masked triangles of a square."""

    def __init__(self, picture=RGBA):
        self.json = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": []}
        self.bytes = b""
        positions = self.accessor("12f", [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], FLOAT, "VEC3", 4)
        uvs = self.accessor("8f", [0, 1, 1, 1, 1, 0, 0, 0], FLOAT, "VEC2", 4)
        indices = self.accessor("6H", [0, 1, 2, 0, 2, 3], U16, "SCALAR", 6)
        self.json |= {
            "images": [{"bufferView": self.view(picture), "mimeType": "image/png"}],
            "samplers": [{"wrapS": 33071, "magFilter": 9728}],
            "textures": [{"source": 0, "sampler": 0}],
            "materials": [{"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": positions, "TEXCOORD_0": uvs},
                                        "indices": indices, "material": 0}]}],
            "nodes": [{"mesh": 0}],
            "scenes": [{"nodes": [0]}],
        }  # fmt: skip
        self.primitive = self.json["meshes"][0]["primitives"][0]
        self.texture = self.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]

    def view(self, data):
        self.bytes += bytes(-len(self.bytes) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, form, values, component, kind, count, **more):
        view = self.view(struct.pack("<" + form, *values))
        self.json["accessors"].append({"bufferView": view, "componentType": component, "type": kind, "count": count} | more)
        return len(self.json["accessors"]) - 1

    def text(self, buffer=None):
        buffers = [{"byteLength": len(self.bytes)} | (buffer or {})]
        return json.dumps(self.json | {"buffers": buffers}, separators=(",", ":")).encode()

    def parts(self):
        return b"j" + self.text() + b"\0" + self.bytes

    def with_data_uri(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
        return b"r" + self.text({"uri": uri})

    def glb(self):
        text, binary = self.text(), self.bytes
        text += b" " * (-len(text) % 4)
        binary += bytes(-len(binary) % 4)
        body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
        return b"rglTF" + struct.pack("<II", 2, 12 + len(body)) + body


def changed(change, picture=RGBA):
    file = File(picture)
    change(file)
    return file.parts()


def strip(mode, indexed):
    def change(file):
        file.primitive["mode"] = mode
        if not indexed:
            del file.primitive["indices"]

    return changed(change)


def everything(file):
    """Whatever is read, in one file."""
    file.primitive["attributes"]["COLOR_0"] = file.accessor("16B", [255] * 15 + [9], U8, "VEC4", 4, normalized=True)
    file.primitive["targets"] = [{"TEXCOORD_0": 1}]
    file.primitive["extensions"] = {"KHR_materials_variants": {"mappings": [{"material": 0, "variants": [0]}]}}
    pointer = {"pointer": "/materials/0/alphaCutoff"}
    file.json |= {
        "extensionsUsed": ["KHR_texture_transform"],
        "extensions": {"KHR_materials_variants": {"variants": [{"name": "a"}]}},
        "animations": [{"channels": [{"sampler": 0, "target": {
            "path": "pointer", "extensions": {"KHR_animation_pointer": pointer}}}]}],
    }  # fmt: skip
    file.json["nodes"] += [
        {"mesh": 0, "children": [0], "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}}}
    ]


def transform(file):
    file.texture |= {"texCoord": 0, "extensions": {"KHR_texture_transform": {"offset": [0, 1], "rotation": 1.5, "scale": [2, -1]}}}


def sparse(file):
    indices, values = file.view(b"\3"), file.view(struct.pack("<2f", 8, 9))
    file.json["accessors"][1]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": indices, "componentType": U8},
        "values": {"bufferView": values},
    }


def without_views(file):
    for accessor in file.json["accessors"][:2]:
        del accessor["bufferView"]


def in_a_circle(file):
    file.json["nodes"] = [{"mesh": 0, "children": [1]}, {"children": [0]}]


def quantised(file):
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    file.primitive["attributes"]["TEXCOORD_0"] = file.accessor("8h", range(8), I16, "VEC2", 4, normalized=True)


def image_uri(file):
    file.json["images"] = [{"uri": "data:image/png;base64," + base64.b64encode(RGBA).decode()}]


LOAD = {
    "square": File().parts(),
    "glb": File().glb(),
    "data_uri": File().with_data_uri(),
    "sixteen_bits": File(SIXTEEN).parts(),
    "palette": File(PALETTE).parts(),
    "cut_png": File(RGBA[:60]).parts(),
    "jpeg": File(jpeg()).parts(),
    "cut_jpeg": File(jpeg()[:-20]).parts(),
    "webp": changed(lambda file: file.json["materials"][0].update(alphaMode="OPAQUE"), b"RIFF....WEBPVP8 "),
    "strip": strip(5, True),
    "strip_without_indices": strip(5, False),
    "fan": strip(6, True),
    "fan_without_indices": strip(6, False),
    "lines": strip(1, False),
    "everything": changed(everything),
    "transform": changed(transform),
    "sparse": changed(sparse),
    "without_views": changed(without_views),
    "circle": changed(in_a_circle),
    "quantised": changed(quantised),
    "image_uri": changed(image_uri),
    "blend": changed(lambda file: file.json["materials"][0].update(alphaMode="BLEND")),
    "huge_count": changed(lambda file: file.json["accessors"][0].update(count=2147483647)),
    "lying_view": changed(lambda file: file.json["bufferViews"][2].update(byteOffset=2147483647)),
    "draco": changed(lambda file: file.json.update(extensionsRequired=["KHR_draco_mesh_compression"])),
    "deep": b"j" + b'{"extras":' + b"[" * 70 + b"]" * 70 + b"}",
    "nothing": b"j{}",
}


# ----------------------------------------------------------------------------------------------------------------------
# scene_validate: two primitives with micromaps, and a thing or two wrong with them
# ----------------------------------------------------------------------------------------------------------------------


def micromapped(component=I16, form="2h", codes=(1, -2)):
    file = File()
    data = file.view(bytes([0xE4, 0x1B, 0, 0, 0xF5]))
    records = file.view(struct.pack("<IHHIHH", 0, 2, 2, 4, 1, 1))
    file.json |= {
        "extensionsUsed": [EXT],
        "extensions": {EXT: {"micromaps": [{"data": data, "triangles": records, "usageCounts": [1, 1],
                                            "usageLevels": [1, 2], "usageFormats": [1, 2]}]}},
    }  # fmt: skip
    second = copy.deepcopy(file.primitive)
    del second["indices"]
    second["extensions"] = {EXT: {"micromap": 0, "micromapBaseTriangle": 1}}
    indices = file.accessor(form, codes, component, "SCALAR", 2)
    file.primitive["extensions"] = {EXT: {"micromap": 0, "micromapIndices": indices}}
    file.json["meshes"][0]["primitives"].append(second)
    file.micromap = file.json["extensions"][EXT]["micromaps"][0]
    return file


def spoilt(change):
    file = micromapped()
    change(file)
    return file.parts()


def sparse_indices(file):
    indices, values = file.view(b"\0\1"), file.view(struct.pack("<2h", 1, 0))
    file.json["accessors"][3]["sparse"] = {
        "count": 2,
        "indices": {"bufferView": indices, "componentType": U8},
        "values": {"bufferView": values},
    }


VALIDATE = {
    "clean": micromapped().parts(),
    "clean_glb": micromapped().glb(),
    "u8": micromapped(U8, "2B", (0, 252)).parts(),
    "u16": micromapped(U16, "2H", (65535, 1)).parts(),
    "u32": micromapped(U32, "2I", (1, 2**32 - 4)).parts(),
    "i32": micromapped(5124, "2i", (1, -1)).parts(),
    "below_minus_4": micromapped(I16, "2h", (1, -5)).parts(),
    "out_of_range": micromapped(I16, "2h", (2, -1)).parts(),
    "sparse": spoilt(sparse_indices),
    "no_data": spoilt(lambda file: file.micromap.pop("data")),
    "counts_of_another": spoilt(lambda file: file.micromap.update(usageCounts=[3, 4294967295], usageLevels=[0, 13])),
    "lengths": spoilt(lambda file: file.micromap.update(usageFormats=[1])),
    "names": spoilt(lambda file: file.micromap.update(name="leaves", extras={"a": 1})),
    "required": spoilt(lambda file: file.json.update(extensionsRequired=[EXT])),
    "not_listed": spoilt(lambda file: file.json.update(extensionsUsed=["KHR_texture_transform"])),
    "stride": spoilt(lambda file: file.json["bufferViews"][file.micromap["triangles"]].update(byteStride=8)),
    "view_outside": spoilt(lambda file: file.json["bufferViews"][file.micromap["data"]].update(byteLength=1000000)),
    "zeros": spoilt(lambda file: file.json["accessors"][3].pop("bufferView")),
    "strip": spoilt(lambda file: file.primitive.update(mode=5)),
    "no_extension": File().parts(),
}

for target, files in {"scene_load": LOAD, "scene_validate": VALIDATE}.items():
    folder = pathlib.Path(sys.argv[1]) / target
    folder.mkdir(parents=True, exist_ok=True)
    for name, seed in files.items():
        (folder / name).write_bytes(seed)
