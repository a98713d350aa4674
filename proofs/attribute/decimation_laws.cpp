// Edges beside a neighbour of one level less.
#include "proofs/attribute/law_groups.hpp"

namespace mmverify::proofs::attribute {

std::vector<Law> decimation_laws() { return {}; }

std::vector<Law> decimation_paper_laws() { return {}; }

}  // namespace mmverify::proofs::attribute
