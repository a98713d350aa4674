// The laws of topic attribute, by what they are about.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::attribute {

/// Where vertices and faces lie in a map.
std::vector<Law> order_laws();
/// How orders and levels are related: those of order_laws() in a file of their own.
std::vector<Law> order_relation_laws();
/// The same on samples, to level 16.
std::vector<Law> order_sample_laws();
/// A point's triplet and weights, and the values between vertices.
std::vector<Law> lookup_laws();
/// Of those, in files of their own: on base edges, of the remaps, and on binary32 numbers.
std::vector<Law> edge_lookup_laws();
std::vector<Law> remap_laws();
std::vector<Law> float_lookup_laws();
/// Edges beside a neighbour of one level less.
std::vector<Law> decimation_laws();
/// Mip chains and levels of detail.
std::vector<Law> mip_laws();
/// Maps from textures.
std::vector<Law> bake_laws();
/// Packed maps: all of it, and what bytes are none.
std::vector<Law> compression_laws();
std::vector<Law> compression_hostile_laws();

/// What the paper claims, prints or leaves open: all of it, and the parts.
std::vector<Law> paper_laws();
std::vector<Law> order_paper_laws();
std::vector<Law> lookup_paper_laws();
std::vector<Law> decimation_paper_laws();
std::vector<Law> mip_paper_laws();

}  // namespace mmverify::proofs::attribute
