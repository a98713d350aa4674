#include "scene/validate/issues.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "impl/micromap/rules.hpp"
#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {
namespace {

using enum Severity;

/// A code.  The text and source of a rule are beside the rule; `says` and `source` are here only for codes
/// that are no rule's.
struct Row {
  const char* code;
  Severity severity;
  const char* remedy;
  const char* says = nullptr;
  const char* source = nullptr;
};

constexpr const char *ours = "ours", *sidecar = "ours: VALIDATE.md",
                     *container = "ours: the container's document";

constexpr Row rows[] = {
    // Files
    {"file.readable", error, "write the file again; a copy may be cut short, or lack the buffers beside it"},
    {"file.version", error, "write minVersion 2.0 if the file needs no more; here it is not judged"},
    {"file.newer", advice, "write version 2.0 if the file has nothing newer"},
    {"file.no_micromaps", warning, "name the file that has the micromaps; in this one nothing was judged",
     "a glTF file has micromaps", ours},
    {"draft.name", error, "leave --draft out, or rename the extension everywhere in the file",
     "the extension has its draft's name", "the drafts: GLTF.md"},
    {"used.listed", error, "add the extension's name to extensionsUsed"},
    {"required.unlisted", warning, "take the extension's name out of extensionsRequired"},

    // glTF: the root
    {"root.object", error, "write an object with the array micromaps"},
    {"root.micromaps", error, "write at least one micromap, or leave the extension out"},
    {"micromap.object", error, "write an object with data, triangles and the three usage arrays"},
    {"micromap.missing", error, "write the property that is missing"},
    {"micromap.name", error, "write the name as a string, or leave it out"},
    {"micromap.view", error, "name a bufferView by its index"},
    {"view.stride", error, "take byteStride out of the bufferView"},
    {"view.inside", error, "lengthen the buffer, or shorten the bufferView"},
    {"view.compressed", error, "compress the view again; a copy may be damaged"},
    {"view.shared", warning,
     "write the micromaps again, behind the tool that wrote the file: it does not know the extension"},
    {"usage.array", error, "write an array with a number for each level and format that occurs"},
    {"usage.integer", error, "write whole numbers"},
    {"usage.length", error, "give the three usage arrays one length"},

    // glTF: primitives
    {"primitive.object", error, "write an object with the property micromap"},
    {"primitive.micromap", error, "name a micromap of the root's array by its index"},
    {"primitive.base", error, "write the base triangle as a whole number, or leave it out"},
    {"primitive.mode", error, "write the triangles as a list, mode 4, their vertices in the order they had"},
    {"bake.stale", warning,
     "mmverify repair puts turned and reordered maps right, with --bake the others, too; or bake anew: "
     "mmverify scene FILE -o OUT.glb, with --moving for maps that were baked with it",
     "the inputs of a bake are those of its record", "ours: SCENE.md"},
    {"material.cutoff", warning,
     "write an alphaCutoff from 0 to 1, 0.5 if none was meant; or leave out what uses the material",
     "a material of alphaMode MASK has a cutoff of at most 1", "glTF 2.0, 3.9.4"},
    {"primitive.same_geometry", advice,
     "nothing is wrong; but copy the accessors for readers that find maps by them, or share the maps",
     "primitives that share their accessors share their maps",
     "no text; readers that key micromaps by accessors give both primitives the maps of one"},
    {"indices.accessor", error, "name an accessor by its index"},
    {"indices.type", error, "make the accessor SCALAR"},
    {"indices.component", error, "store the indices as 5121, 5122, 5123, 5124 or 5125"},
    {"indices.normalized", error, "take normalized out of the accessor"},
    {"indices.count", error, "write one index for each triangle of the primitive, degenerate ones too"},
    {"indices.inside", error, "lengthen the bufferView, or correct byteOffset and count"},
    {"indices.sparse", error, "sort the sparse indices, without doubles, below the accessor's count"},
    {"limits.indices", error, "split the file: what is beyond the limit was not judged"},

    {"limits.extension", error,
     "nothing may be wrong: use a build that reads the extension, or another form"},

    // Addresses and strides
    {"align.data_256", error, "put the data at a multiple of 256"},
    {"align.records_256", error, "put the records at a multiple of 256"},
    {"align.data_128", error, "put the data at a multiple of 128"},
    {"align.records_128", error, "put the records at a multiple of 128"},
    {"align.records_4", error, "put the records at a multiple of 4"},
    {"align.index", error, "put the indices at a multiple of an index's size"},
    {"align.index_ext", advice,
     "put the indices at a multiple of an index's size: a driver crashes otherwise",
     "for EXT, the indices' address is a multiple of an index's size",
     "no text; KhronosGroup/Vulkan-ValidationLayers, issue 11973: a crash of NVIDIA's driver 590"},
    {"stride.least", error, "lay the records at least 8 bytes apart"},
    {"stride.multiple", error, "make the records' stride a multiple of 4"},
    {"stride.tight", error, "lay the records 8 bytes apart"},

    // Records
    {"records.size", error, "lengthen the buffer of records, or correct their number"},
    {"records.whole", error, "cut the buffer of records behind its last whole record"},
    {"record.format", error, "write 1 (2-state) or 2 (4-state)"},
    {"record.level", error, "bake the map at a level that the device takes"},
    {"record.level_lossy", error, "bake the map at a level that the device takes in lossy builds"},
    {"record.level_12", error, "bake the map at level 12 or below"},
    {"record.lossy_format", error, "bake in 4-state, or build without the lossy flag"},
    {"record.region", error, "lengthen the data, or correct the record's offset, level or format"},
    {"record.overlap", error, "give each record bytes of its own; equal maps share a record, not bytes"},

    // Counts
    {"counts.format", error, "write 1 (2-state) or 2 (4-state)"},
    {"counts.level", error, "count maps of levels that the device takes"},
    {"counts.level_lossy", error, "count maps of levels that the device takes in lossy builds"},
    {"counts.level_12", error, "count maps of level 12 or below"},
    {"counts.lossy_format", error, "bake in 4-state, or build without the lossy flag"},
    {"counts.zero", error, "leave out counts of nothing"},
    {"counts.limit", error, "split the array"},
    {"counts.array", error, "count the array's records, each once, by level and format"},
    {"counts.array_is_geometry", error,
     "hand over the array's histogram here: one for each record, whoever refers to it"},
    {"counts.geometry", error,
     "count the triangles by the level and format of their records, special indices left out"},
    {"counts.geometry_is_array", error,
     "hand over the geometry's histogram here: one for each triangle that refers to a record"},

    // Indices
    {"index.encoding", error, "store the indices in a type that the API has"},
    {"index.uint8", error, "store the indices as u16 or u32, or turn the device's feature on",
     "8-bit indices are for a device with the feature indexTypeUint8", "KHR: VALIDATE.md"},
    {"index.none", error, "leave the buffer's file and address out, or name the indices' type",
     "index type NONE has no index buffer", "EXT, KHR: VALIDATE.md"},
    {"index.stride", error, "make the indices' stride a multiple of an index's size"},
    {"index.stride_most", error, "lay the indices closer together"},
    {"index.tight", error, "lay the indices one behind the other"},
    {"index.size", error, "lengthen the buffer of indices, or correct the number of triangles"},
    {"index.count", error, "cut the indices behind the last triangle's"},
    {"index.special", error, "write -1 (T), -2 (O), -3 (UT), -4 (UO), or a record's number"},
    {"index.range", error,
     "correct the index or the base triangle: their sum is less than the number of records"},
    {"index.mixed", error,
     "give uniform triangles records, put them into a geometry of their own, or take the flag from the "
     "pipelines",
     "no index buffer has both special indices and records where pipelines have the flag "
     "DISALLOW_MIXED_SPECIAL_INDEX",
     "KHR: VALIDATE.md"},
    {"index.mixed_khr", advice,
     "nothing is wrong; but trace this geometry by no pipeline with the flag, or name the flag in the limits",
     "for KHR, no index buffer has both special indices and records",
     "KHR, a pipeline's flag DISALLOW_MIXED_SPECIAL_INDEX: VALIDATE.md"},

    // Sidecars
    {"sidecar.readable", error, "write one JSON object, each member once",
     "a sidecar is a JSON object, no name in it twice", sidecar},
    {"sidecar.schema", error, "write \"schema\": \"mmverify.array/1\"", "its schema is mmverify.array/1",
     sidecar},
    {"sidecar.missing", error, "write the member that is missing", "the members that must be there are there",
     sidecar},
    {"sidecar.unknown", error, "correct the member's name, or take it out",
     "there are no members but the schema's", sidecar},
    {"sidecar.type", error, "write a value as docs/array.schema.json has it",
     "a member's value is of its type and range", sidecar},
    {"sidecar.api", error, "name at least one of ext, khr, dxr, gltf",
     "apis names APIs whose rules are known", sidecar},
    {"sidecar.path", error, "put the file beside the sidecar or below it, and name it from there",
     "a file's name is relative, with /, and does not leave the sidecar's folder", sidecar},
    {"sidecar.file", error, "put the file where its name says", "the files are there", sidecar},
    {"sidecar.range", error, "lengthen the file, or correct offset and bytes",
     "offset and bytes lie within the file", sidecar},

    // Containers
    {"container.version", error, "read the file with the program that wrote it",
     "the version is one that is known", container},
    {"container.header", error, "write the file again",
     "each field of the header has a value that a writer writes", container},
    {"container.size", error, "copy or download the file again: it is cut short, or has bytes too many",
     "the file has the bytes that its header announces", container},
    {"container.checksum", error, "copy or download the file again: bytes of it have changed",
     "the checksum is that of the bytes", container},
    {"container.content", error, "write the file again: its writer made what no map is written as",
     "the bytes are those that the writer makes of what they mean", container},
};

std::string sets_of(impl::micromap::Sets sets) {
  using namespace impl::micromap;
  std::string names;
  for (const auto& [set, name] : {std::pair{EXT, "EXT"}, {KHR, "KHR"}, {DXR, "DXR"}, {glTF, "glTF"}})
    if ((sets & set) != 0) names += (names.empty() ? "" : ", ") + std::string(name);
  return names + ": MICROMAP.md";
}

Issue made(const Row& row) {
  if (row.says != nullptr) return {row.code, row.severity, row.says, row.source, row.remedy};
  for (const impl::micromap::RuleText& rule : impl::micromap::rules)
    if (std::string_view(rule.id) == row.code)
      return {row.code, row.severity, rule.says, sets_of(rule.sets), row.remedy};
  for (const FileRule& rule : file_rules())
    if (std::string_view(rule.id) == row.code)
      return {row.code, row.severity, rule.says,
              std::string(std::string_view(rule.source).starts_with("glTF") ? "" : "glTF: ") + rule.source,
              row.remedy};
  throw std::logic_error(std::string("issues: no rule ") + row.code);
}

}  // namespace

const char* name_of(Severity severity) noexcept {
  constexpr const char* names[] = {"error", "warning", "advice"};
  return names[static_cast<std::size_t>(severity)];
}

std::span<const Issue> issues() {
  static const std::vector<Issue> all = [] {
    std::vector<Issue> made_of_rows;
    for (const Row& row : rows) made_of_rows.push_back(made(row));
    return made_of_rows;
  }();
  return all;
}

const Issue& issue_of(std::string_view code) {
  const auto all = issues();
  const auto at = std::find_if(all.begin(), all.end(), [code](const Issue& i) { return i.code == code; });
  if (at == all.end()) throw std::out_of_range("no issue " + std::string(code));
  return *at;
}

}  // namespace mmverify::scene
