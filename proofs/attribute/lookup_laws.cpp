// A point's triplet and weights, and the values between vertices.
#include "proofs/attribute/law_groups.hpp"

namespace mmverify::proofs::attribute {

std::vector<Law> lookup_laws() { return {}; }

std::vector<Law> lookup_paper_laws() { return {}; }

}  // namespace mmverify::proofs::attribute
