#include "impl/micromap/rules.hpp"

#include <array>

#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {
namespace {

constexpr FileRule of_array(impl::micromap::Rule rule, const char* source) {
  return {impl::micromap::text(rule).id, impl::micromap::text(rule).says, source};
}

using enum impl::micromap::Rule;

// All rules of files.  Of the rules of arrays, these are the ones that a file can break: it has no strides,
// and one kind of usage counts.
constexpr std::array rules{
    FileRule{"file.readable", "the file is glTF 2.0, and its buffers are there", "glTF 2.0"},
    FileRule{"file.version", "the file needs no glTF newer than 2.0", "glTF 2.0, 3.2"},
    FileRule{"file.newer", "the file is glTF 2.0, not a later minor version", "glTF 2.0, 3.2"},
    FileRule{"used.listed", "extensionsUsed lists the extension where anything uses it", "glTF 2.0, 3.12"},
    FileRule{"required.unlisted", "extensionsRequired does not list the extension", "Optional vs. Required"},
    FileRule{"root.object", "the root's extension is an object", "Extending the glTF Root"},
    FileRule{"root.micromaps", "micromaps is an array of at least one", "its schema"},
    FileRule{"micromap.object", "a micromap is an object", "its schema"},
    FileRule{"micromap.missing", "data, triangles and the three usage arrays are there",
             "Extending the glTF Root"},
    FileRule{"micromap.name", "a micromap's name is a string", "Extending the glTF Root"},
    FileRule{"micromap.view", "data and triangles are bufferViews that are there", "Extending the glTF Root"},
    FileRule{"view.stride", "the bufferViews of data, triangles and indices define no byteStride",
             "Extending the glTF Root; Accessor Requirements"},
    FileRule{"view.inside", "they lie within their buffers", "glTF 2.0, 3.6.1"},
    FileRule{"view.compressed", "a compressed view that is read can be decoded",
             "EXT_meshopt_compression, KHR_meshopt_compression"},
    FileRule{"view.shared", "nothing else of the file reads the views and the accessor of micromaps",
             "none: a tool that does not know the extension renumbers views and accessors"},
    FileRule{"usage.array", "a usage array is an array of at least one", "its schema"},
    FileRule{"usage.integer", "its elements are whole numbers from 0, below 2^32", "its schema; 32 bits"},
    FileRule{"usage.length", "the three usage arrays have one length", "Extending the glTF Root"},
    of_array(counts_zero, "Extending the glTF Root"),
    of_array(counts_level_12, "Extending the glTF Root"),
    of_array(counts_format, "Extending the glTF Root"),
    of_array(counts_array, "Extending the glTF Root"),
    of_array(records_whole, "Micromap Triangle Records"),
    of_array(record_level_12, "Micromap Triangle Records"),
    of_array(record_format, "Micromap Triangle Records"),
    of_array(record_region, "Microtriangle Data"),
    of_array(record_overlap, "Microtriangle Data"),
    FileRule{"primitive.object", "a primitive's extension is an object", "Extending Mesh Primitives"},
    FileRule{"primitive.micromap", "it names a micromap that is there", "Extending Mesh Primitives"},
    FileRule{"primitive.base", "micromapBaseTriangle is a whole number from 0, below 2^32",
             "its schema; 32 bits"},
    FileRule{"primitive.mode", "the primitive's mode is 4, triangles", "Extending Mesh Primitives"},
    FileRule{"indices.accessor", "micromapIndices is an accessor that is there", "Extending Mesh Primitives"},
    FileRule{"indices.type", "the indices are SCALAR", "Accessor Requirements"},
    FileRule{"indices.component", "their componentType is 5121, 5122, 5123, 5124 or 5125",
             "Accessor Requirements"},
    FileRule{"indices.normalized", "they are not normalized", "Accessor Requirements"},
    FileRule{"indices.count", "there is one index for each triangle", "Accessor Requirements"},
    FileRule{"indices.inside", "they lie within their bufferView", "glTF 2.0, 3.6.2.4"},
    FileRule{"indices.sparse",
             "sparse indices are there, ascend and lie below the count, their values are there",
             "glTF 2.0, 3.6.2.3"},
    of_array(align_index, "glTF 2.0, 3.6.2.4"),
    of_array(index_special, "Accessor Requirements"),
    of_array(index_range, "Lookup"),
    FileRule{"limits.indices", "so many indices that they are not judged", "none: a limit of this validator"},
    FileRule{"limits.extension", "what a rule needs is stored by an extension that is not read here",
             "none: a limit of this validator"},
};

}  // namespace

std::span<const FileRule> file_rules() { return rules; }

}  // namespace mmverify::scene
