// Who makes each family; vectors/families.cpp is the table of them.
#pragma once

#include "vectors/table.hpp"

namespace mmverify::vectors {

/// Points and the index of each, in each dialect.  Source: spec/index/index.hpp.
namespace index {
Family family();
}
/// Indices and the corners of their micro-triangles.  Source: spec/index/index.hpp.
namespace corners {
Family family();
}
/// States, substitutions, decisions.  Source: spec/micromap/, spec/traverse/decision.hpp.
namespace traverse {
Family family();
}
/// States in bytes.  Source: spec/micromap/micromap.hpp.
namespace packing {
Family family();
/// Special indices.
Family special_family();
}  // namespace packing

/// Arrays that are well or broken.  Source: spec/micromap/validate.hpp.
namespace arrays {
Family family();
}
/// Blocks of square maps.  Source: spec/vq/.
namespace vq {
Family family();
}
/// Succinct trees and graphs, their containers, and what is none.  Source: spec/tree/tree.hpp, spec/dag/.
namespace trees {
Family family();
}
/// Maps of textures.  Source: spec/bake/state.hpp.
namespace bake {
Family family();
}
/// Micro-vertices, micro-triangles and weights.  Source: spec/attribute/.
namespace attribute {
Family family();
}

}  // namespace mmverify::vectors
