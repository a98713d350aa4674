// What the laws of mips and those of levels of detail have in common.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "proofs/attribute/law_groups.hpp"
#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

/// Roundings of means, and what chains of them are off by.
std::vector<Law> rounding_laws();
/// Whole pictures, each code drawn on its own.
Law mip_sample_law();
/// Levels of detail.
std::vector<Law> lod_laws();
std::vector<Law> lod_paper_laws();

extern const Entry face_mip_entry, face_chain_entry;

/// "half-up", "half-to-even", "truncate", "halves-up".
const char* rounding_name(Rounding rounding);
/// Throws BadCase, with the case's text.
Rounding rounding_of(const std::string& name, const std::string& text);
/// The number of some digits.  Throws BadCase where it is beyond the last.
std::uint64_t number_of(const std::string& digits, const std::string& text, std::uint64_t last);

/// The codes of four children.
using Codes = std::array<std::uint32_t, 4>;
/// Whether m is what the rounding makes of a sum of four codes, said by the distance that it may be off; of halves_up also
/// by its own formula.
bool is_rounded(Rounding r, const Codes& x, std::uint32_t m);
/// The mean of four codes; what is right, and which of a word's four they are.
using Mean = std::function<std::uint32_t(Rounding, const Codes&, std::uint32_t right, unsigned which)>;
/// A subject whose means are those.
std::function<void(Functions&)> meaning(Mean mean);

using Chain =
    std::function<void(Level, Rounding, ChainOf, std::span<const std::uint32_t>, std::span<std::uint32_t>)>;
/// A subject whose chains are made so from the real ones.
std::function<void(Functions&)> chaining(
    std::function<void(const Chain& real, Level, Rounding, ChainOf, std::span<const std::uint32_t>,
                       std::span<std::uint32_t>)>
        by);

}  // namespace mmverify::proofs::attribute
