// The functions that make the families; delivery/vectors/families.cpp is their table.
#pragma once

#include "delivery/vectors/table.hpp"

namespace mmverify::vectors {

/// Points and the index of each, in each dialect.  Source: spec/index/index.hpp.
namespace index {
Family family();
}
/// Indices and the corners of their micro-triangles.  Source: spec/index/index.hpp.
namespace corners {
Family family();
}
/// States, flags, and the decisions of traversal. Source: spec/micromap/, spec/traverse/decision.hpp.
namespace traverse {
Family family();
}
/// States packed in bytes. Source: spec/micromap/micromap.hpp.
namespace packing {
Family family();
/// Special indices.
Family special_family();
}  // namespace packing

/// Arrays of micromaps, valid and invalid. Source: spec/micromap/validate.hpp.
namespace arrays {
Family family();
}
/// Blocks of compressed square maps. Source: spec/vq/.
namespace vq {
Family family();
}
/// Succinct trees and graphs, their containers, and invalid containers. Source: spec/tree/tree.hpp,
/// spec/dag/.
namespace trees {
Family family();
}
/// Maps baked from textures. Source: spec/bake/state.hpp.
namespace bake {
Family family();
}
/// Micro-vertices, micro-triangles and weights.  Source: spec/attribute/.
namespace attribute {
Family family();
}

}  // namespace mmverify::vectors
