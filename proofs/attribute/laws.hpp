// The laws of topic attribute, and its subjects.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// The places of vertices and faces in a map.
std::vector<Law> order_laws();
/// Relations of orders and levels: the part of order_laws() in a file of its own.
std::vector<Law> order_relation_laws();
/// Orders on samples, to level 16.
std::vector<Law> order_sample_laws();
/// A point's triplet and weights, and the values between vertices.
std::vector<Law> lookup_laws();
/// Parts of lookup_laws() in files of their own: base edges, remaps, binary32 numbers.
std::vector<Law> edge_lookup_laws();
std::vector<Law> remap_laws();
std::vector<Law> float_lookup_laws();
/// Edges beside a neighbour of one level less.
std::vector<Law> decimation_laws();
/// Mip chains and levels of detail.
std::vector<Law> mip_laws();
/// Maps from textures.
std::vector<Law> bake_laws();
/// Packed maps: all laws of them, and those of bytes that are no packed map.
std::vector<Law> compression_laws();
std::vector<Law> compression_hostile_laws();

/// Claims, printed formulas and open questions of the paper: all laws, and their parts.
std::vector<Law> paper_laws();
std::vector<Law> order_paper_laws();
std::vector<Law> lookup_paper_laws();
std::vector<Law> decimation_paper_laws();
std::vector<Law> mip_paper_laws();

}  // namespace mmverify::proofs::attribute
