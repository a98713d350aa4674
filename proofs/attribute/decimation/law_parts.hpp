// Common parts of the laws of edge decimation.
#pragma once

#include "proofs/attribute/law_groups.hpp"
#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

extern const Entry snapped_entry, averaged_entry, place_entry;

/// Reads "flags=5".  Throws BadCase.
EdgeFlags flags_of_text(const std::string& text);

/// Laws of values at points, and on edges beside a neighbour.
std::vector<Law> decimated_value_laws();
/// The law of single vertices at high levels.
Law decimation_sample_law();
/// The law of neighbours two levels apart.
Law two_levels_law();

}  // namespace mmverify::proofs::attribute
