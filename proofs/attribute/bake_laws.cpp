// Maps from textures.
#include "proofs/attribute/law_groups.hpp"

namespace mmverify::proofs::attribute {

std::vector<Law> bake_laws() { return {}; }

}  // namespace mmverify::proofs::attribute
