// What the laws of edge decimation have in common.
#pragma once

#include "proofs/attribute/law_groups.hpp"
#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

extern const Entry snapped_entry, averaged_entry, place_entry;

/// Reads "flags=5".  Throws BadCase.
EdgeFlags flags_of_text(const std::string& text);

/// Values at points, and on edges beside a neighbour.
std::vector<Law> decimated_value_laws();
/// Single vertices of high levels.
Law decimation_sample_law();
/// Two levels of difference.
Law two_levels_law();

}  // namespace mmverify::proofs::attribute
