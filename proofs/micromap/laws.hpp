// The laws of topic micromap, and its subjects.
#pragma once

#include "proofs/micromap/subject.hpp"

namespace mmverify::proofs::micromap {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// Packed maps: packing, force-2-state, levels, 1-bit modes.
std::vector<Law> map_laws();
/// The same of maps of one state but for one node of the curve, up to level 12.
std::vector<Law> apart_laws();
/// Sequences of states that are no maps: any number of them.
std::vector<Law> count_laws();
/// Lossy codecs, and who judges them.
std::vector<Law> lossy_laws();
/// Special indices.
std::vector<Law> special_laws();
/// Arrays and their validator.
std::vector<Law> array_laws();

}  // namespace mmverify::proofs::micromap
