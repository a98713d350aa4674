#!/usr/bin/env python3
"""Writes the seed corpora of scene_load and scene_validate: python3 fuzz/corpus/make_scene.py build/seeds

See scene_input.hpp for what an input is.
"""
import base64
import copy
import json
import pathlib
import struct
import zlib

import seeds

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


def ktx2(width, height, form, level, model=1, channel=0, keys=b"", scheme=0, uncompressed=None):
    """One level."""
    mark, begin = b"\xabKTX 20\xbb\r\n\x1a\n", 104 + 44
    header = struct.pack("<17I3Q", form, 1, width, height, 0, 0, 1, 1, scheme, 104, 44, begin if keys else 0, len(keys), 0, 0, 0, 0,
                         begin + len(keys), len(level), uncompressed or len(level))  # fmt: skip
    descriptor = struct.pack("<3I4B12xHBB8xI", 44, 0, 2 | 40 << 16, model, 1, 1, 0, 0, 127, channel, 2**32 - 1)
    return mark + header + descriptor + keys + level


# A block of each mode of UASTC, by the bits that begin it.
UASTC = b"".join(bytes([code]) + bytes(range(7 * code & 127, (7 * code & 127) + 15)) for code in (
    0x01, 0x35, 0x1D, 0x03, 0x13, 0x0B, 0x1B, 0x07, 0x17, 0x0F, 0x02, 0x00, 0x06, 0x1F, 0x0D, 0x05, 0x15, 0x25, 0x09, 0x45))  # fmt: skip
MADE = pathlib.Path(__file__).resolve().parent.parent / "tests/scene/files"


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


def samplers(file):
    """Each way to filter and to wrap, a material each."""
    ways = [{"minFilter": least} for least in (9728, 9729, 9984, 9985, 9986, 9987)]
    ways += [{"wrapS": 33648, "wrapT": 10497, "magFilter": 9729}]
    file.json["samplers"] += ways
    for k in range(len(ways)):
        file.json["textures"].append({"source": 0, "sampler": k + 1})
        texture = {"index": k + 1}
        file.json["materials"].append({"pbrMetallicRoughness": {"baseColorTexture": texture, "baseColorFactor": [1, 1, 1, 0.5]}})


def placed(file):
    """A mesh under every kind of transform, and instanced by an integer's rotations and uneven scales."""
    turns = file.accessor("8b", [0, 0, 0, 127, 0, 0, 90, 90], 5120, "VEC4", 2, normalized=True)
    scales = file.accessor("6f", [1, 2, 3, 1, 1, 1], FLOAT, "VEC3", 2)
    instanced = {"EXT_mesh_gpu_instancing": {"attributes": {"ROTATION": turns, "SCALE": scales}}}
    file.json["nodes"] = [
        {"mesh": 0, "matrix": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1], "children": [1]},
        {"mesh": 0, "rotation": [0, 0.6, 0, 0.8], "scale": [1, 3, 1], "translation": [1, 2, 3]},
        {"mesh": 0, "extensions": instanced},
    ]


def left_out(file):
    """A material each that nothing is planned for."""
    file.json["materials"] += [
        {"alphaMode": "MASK"},
        {"alphaMode": "MASK", "extensions": {"KHR_materials_pbrSpecularGlossiness": {}},
         "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}},
        {"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}},
        {"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}},
        {"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 2}}},
    ]  # fmt: skip
    file.json["samplers"].append({"magFilter": 9728, "minFilter": 9729})
    file.json["textures"] += [{}, {"source": 0, "sampler": 1}]
    primitives = file.json["meshes"][0]["primitives"]
    primitives += [file.primitive | {"material": k + 1} for k in range(5)]
    far = file.accessor("8f", [2.0**21] * 8, FLOAT, "VEC2", 4)
    primitives.append(file.primitive | {"attributes": file.primitive["attributes"] | {"TEXCOORD_0": far}})
    # No node uses the second mesh.
    file.json["meshes"].append({"primitives": [{"attributes": {}}, file.primitive]})


def sparse_indices_of_shape(file):
    where, values = file.view(struct.pack("<H", 5)), file.view(struct.pack("<I", 1))
    file.primitive["indices"] = file.accessor("6I", [0, 1, 2, 0, 2, 2], U32, "SCALAR", 6, sparse={
        "count": 1,
        "indices": {"bufferView": where, "componentType": U16},
        "values": {"bufferView": values},
    })  # fmt: skip


def meshopt(file):
    view = file.json["bufferViews"][0]
    view["extensions"] = {"EXT_meshopt_compression": {"buffer": 0, "byteOffset": 4, "byteLength": 8}}
    file.json["images"].append({"uri": "data:application/octet-stream;base64,AAAA", "mimeType": "image/ktx2"})


def positions(*values):
    def change(file):
        file.primitive["attributes"] = {"POSITION": file.accessor("3f", values, FLOAT, "VEC3", 1)}
        del file.primitive["indices"]

    return changed(change)


def of_json(**parts):
    return b"j" + json.dumps({"asset": {"version": "2.0"}} | parts, separators=(",", ":")).encode()


def of_sampler(**sampler):
    texture = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    return of_json(images=[{"uri": "a.png"}], samplers=[sampler], textures=[{"source": 0, "sampler": 0}], materials=[texture])


# Refused, for one reason each: as few bytes as will do.
BAD = {
    "bad_version": of_json(asset={"version": "1.0"}),
    "bad_object": of_json(asset=2),
    "bad_array": of_json(meshes=[{"primitives": 1}]),
    "bad_list": of_json(nodes=1),
    "bad_text": of_json(materials=[{"alphaMode": 1}]),
    "bad_flag": of_json(accessors=[{"componentType": 5126, "count": 1, "type": "VEC2", "normalized": 1}]),
    "bad_number": of_json(materials=[{"alphaCutoff": "a"}]),
    "bad_numbers": of_json(materials=[{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, None]}}]),
    "bad_whole": of_json(samplers=[{"wrapS": 1.5}]),
    "bad_index": of_json(nodes=[{"mesh": 0}]),
    "bad_alpha_mode": of_json(materials=[{"alphaMode": "CUT"}]),
    "bad_cutoff": of_json(materials=[{"alphaCutoff": -1}]),
    "bad_factor": of_json(materials=[{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 2]}}]),
    "bad_wrap": of_sampler(wrapS=1),
    "bad_magnification": of_sampler(magFilter=1),
    "bad_minification": of_sampler(minFilter=1),
    "bad_mode": of_json(meshes=[{"primitives": [{"attributes": {}, "mode": 7}]}]),
    "two_parents": of_json(nodes=[{"children": [2]}, {"children": [2]}, {}]),
    "no_buffer": of_json(buffers=[{"byteLength": 0}, {"byteLength": 4}]),
    "short_buffer": of_json(buffers=[{"byteLength": 4}]),
    "no_source": of_json(images=[{}]),
    "no_files": of_json(images=[{"uri": "a.png"}, {"uri": "b.png"}]),
    "no_json": b"j{",
}

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
    "ktx2_plain": File(ktx2(2, 1, 37, b"abcdefgh")).parts(),
    "ktx2_blue_first": File(ktx2(1, 2, 30, b"abcdef")).parts(),
    "ktx2_uastc": File(ktx2(16, 20, 0, UASTC, 166, 3)).parts(),
    "ktx2_keys": File(ktx2(1, 1, 9, b"a", keys=struct.pack("<I", 16) + b"KTXswizzle\0rrr1\0")).parts(),
    "ktx2_format": File(ktx2(1, 1, 157, bytes(16))).parts(),
    "ktx2_words": File(ktx2(2, 1, 91, bytes(range(16)))).parts(),
    "ktx2_halves": File(ktx2(2, 1, 97, bytes(range(16)))).parts(),
    "ktx2_floats": File(ktx2(1, 1, 109, bytes(range(16)))).parts(),
    "ktx2_zlib": File(ktx2(2, 2, 37, zlib.compress(bytes(range(16)), 9), scheme=3, uncompressed=16)).parts(),
} | {
    f"ktx2_{form}": File(ktx2(4, 4, form, bytes(range(8 if form in (131, 133, 139) else 16)))).parts()
    for form in (131, 133, 135, 137, 139, 141, 145)
} | {path.stem: File(path.read_bytes()).parts() for path in sorted(MADE.glob("etc1s_*.ktx2"))} | {
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
    "samplers": changed(samplers),
    "placed": changed(placed),
    "left_out": changed(left_out),
    "sparse_indices": changed(sparse_indices_of_shape),
    "meshopt": changed(meshopt),
    "not_finite": positions(0, float("nan"), 0),
    "gif": changed(lambda file: None, b"GIF89a"),
    "no_ihdr": changed(lambda file: None, RGBA[:12]),
    "wide_png": changed(lambda file: None, RGBA[:16] + struct.pack(">II", 1 << 20, 1) + RGBA[24:60]),
    "hollow_png": changed(lambda file: None, RGBA[:16] + struct.pack(">II", 16384, 16384) + RGBA[24:60]),
    "restart": changed(lambda file: file.primitive.update(indices=file.accessor("3H", [0, 1, 65535], U16, "SCALAR", 3))),
    "beyond_vertices": changed(lambda file: file.primitive.update(indices=file.accessor("3B", [0, 1, 9], U8, "SCALAR", 3))),
    "other_count": changed(lambda file: file.json["accessors"][1].update(count=3)),
    "no_elements": changed(lambda file: file.json["accessors"][1].update(count=0)),
    "wrong_shape": changed(lambda file: file.json["accessors"][1].update(type="VEC3")),
    "wrong_type": changed(lambda file: file.json["accessors"][1].update(componentType=5124)),
    "short_stride": changed(lambda file: file.json["bufferViews"][1].update(byteStride=4)),
    "deep": b"j" + b'{"extras":' + b"[" * 70 + b"]" * 70 + b"}",
    "nothing": b"j{}",
} | BAD


# ---- scene_validate: two primitives with micromaps, and a thing or two wrong with them


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


def sparse_indices(where=b"\0\1", component=U8):
    def change(file):
        indices, values = file.view(where), file.view(struct.pack("<2h", 1, 0))
        file.json["accessors"][3]["sparse"] = {
            "count": 2,
            "indices": {"bufferView": indices, "componentType": component},
            "values": {"bufferView": values},
        }

    return spoilt(change)


def broken_micromaps(file):
    """Behind the one that is used: nothing there, of other types, of other things than numbers, twelve unsorted records."""
    twelve = file.view(struct.pack("<IHH", 9, 13, 3) * 12)
    file.json["extensions"][EXT]["micromaps"] += [
        {},
        7,
        {"name": 5, "data": "a", "triangles": 99, "usageCounts": [1.5, -1], "usageLevels": 3, "usageFormats": []},
        file.micromap | {"triangles": twelve, "usageCounts": [0, 12], "usageFormats": [1, 3]},
    ]


def broken_primitives(file):
    primitives = file.json["meshes"][0]["primitives"]
    given = primitives[1]["extensions"][EXT]
    for wrong in (5, given | {"micromap": 9}, {}, given | {"micromapBaseTriangle": -1}, given | {"micromapIndices": 77}):
        primitives.append(primitives[1] | {"extensions": {EXT: wrong}})
    primitives.append({"attributes": {}, "extensions": {EXT: given}})


def many_out_of_range(file):
    codes = file.accessor("40B", [200] * 40, U8, "SCALAR", 40)
    file.primitive["extensions"][EXT]["micromapIndices"] = codes
    file.json["accessors"][file.primitive["indices"]].update(count=120)


def codes(**changes):
    return spoilt(lambda file: file.json["accessors"][3].update(changes))


VALIDATE = {
    "clean": micromapped().parts(),
    "clean_glb": micromapped().glb(),
    "u8": micromapped(U8, "2B", (0, 252)).parts(),
    "u16": micromapped(U16, "2H", (65535, 1)).parts(),
    "u32": micromapped(U32, "2I", (1, 2**32 - 4)).parts(),
    "i32": micromapped(5124, "2i", (1, -1)).parts(),
    "below_minus_4": micromapped(I16, "2h", (1, -5)).parts(),
    "out_of_range": micromapped(I16, "2h", (2, -1)).parts(),
    "sparse": sparse_indices(),
    "sparse_descending": sparse_indices(b"\1\0"),
    "sparse_signed": sparse_indices(b"\0\1", 5120),
    "broken_micromaps": spoilt(broken_micromaps),
    "broken_primitives": spoilt(broken_primitives),
    "many_out_of_range": spoilt(many_out_of_range),
    "codes_of_floats": codes(componentType=FLOAT, type="VEC2", normalized=True),
    "codes_outside": codes(byteOffset=1000),
    "too_few_codes": codes(count=1),
    "root_is_a_list": spoilt(lambda file: file.json.update(extensions={EXT: []})),
    "root_is_empty": spoilt(lambda file: file.json.update(extensions={EXT: {}})),
    "unreadable": b"j{",
    "no_data": spoilt(lambda file: file.micromap.pop("data")),
    "counts_of_another": spoilt(lambda file: file.micromap.update(usageCounts=[3, 4294967295], usageLevels=[0, 13])),
    "lengths": spoilt(lambda file: file.micromap.update(usageFormats=[1])),
    "names": spoilt(lambda file: file.micromap.update(name="leaves", extras={"a": 1})),
    "required": spoilt(lambda file: file.json.update(extensionsRequired=[EXT])),
    "not_listed": spoilt(lambda file: file.json.update(extensionsUsed=["KHR_texture_transform"])),
    "stride": spoilt(lambda file: file.json["bufferViews"][file.micromap["triangles"]].update(byteStride=8)),
    "view_outside": spoilt(lambda file: file.json["bufferViews"][file.micromap["data"]].update(byteLength=1000000)),
    "zeros": spoilt(lambda file: file.json["accessors"][3].pop("bufferView")),
    "zeros_without_end": spoilt(lambda file: file.json["accessors"].__setitem__(
        3, {"componentType": U8, "type": "SCALAR", "count": 2**23})),
    "strip": spoilt(lambda file: file.primitive.update(mode=5)),
    "no_extension": File().parts(),
}

seeds.write({"scene_load": LOAD, "scene_validate": VALIDATE})
