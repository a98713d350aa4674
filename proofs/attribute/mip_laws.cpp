// Mip chains and levels of detail.
#include "proofs/attribute/law_groups.hpp"

namespace mmverify::proofs::attribute {

std::vector<Law> mip_laws() { return {}; }

std::vector<Law> mip_paper_laws() { return {}; }

}  // namespace mmverify::proofs::attribute
