// The laws of topic attribute, by what they are about.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::attribute {

/// Where vertices and faces lie in a map.
std::vector<Law> order_laws();
/// A point's triplet and weights, and the values between vertices.
std::vector<Law> lookup_laws();
/// Edges beside a neighbour of one level less.
std::vector<Law> decimation_laws();
/// Mip chains and levels of detail.
std::vector<Law> mip_laws();
/// Maps from textures.
std::vector<Law> bake_laws();

/// What the paper claims, prints or leaves open: all of it, and the parts.
std::vector<Law> paper_laws();
std::vector<Law> order_paper_laws();
std::vector<Law> lookup_paper_laws();
std::vector<Law> decimation_paper_laws();
std::vector<Law> mip_paper_laws();

}  // namespace mmverify::proofs::attribute
