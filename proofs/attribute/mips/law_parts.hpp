// Common parts of the laws of mips and of levels of detail.
#pragma once

#include "proofs/attribute/law_parts.hpp"
#include "proofs/attribute/laws.hpp"

namespace mmverify::proofs::attribute {

/// Laws of rounded means, and of the error of chains.
std::vector<Law> rounding_laws();
/// The law of whole pictures, each code drawn on its own.
Law mip_sample_law();
/// Levels of detail.
std::vector<Law> lod_laws();
std::vector<Law> lod_paper_laws();

extern const Entry face_mip_entry, face_chain_entry;

/// "half-up", "half-to-even", "truncate", "halves-up".
const char* rounding_name(Rounding rounding);
/// Throws BadCase, with the case's text.
Rounding rounding_of(const std::string& name, const std::string& text);
/// The number of some digits.  Throws BadCase if it is above `last`.
std::uint64_t number_of(const std::string& digits, const std::string& text, std::uint64_t last);

/// The codes of four children.
using Codes = std::array<std::uint32_t, 4>;
/// Whether m is the rounded mean of four codes, judged by its distance from their sum; for halves_up by its formula
/// as well.
bool is_rounded(Rounding r, const Codes& x, std::uint32_t m);
/// A wrong mean: four codes, the right mean, and the code's place in the word give the wrong mean.
using Mean = std::function<std::uint32_t(Rounding, const Codes&, std::uint32_t right, unsigned which)>;
/// A mutant with that mean.
std::function<void(Functions&)> meaning(Mean mean);

using Chain =
    std::function<void(Level, Rounding, ChainOf, std::span<const std::uint32_t>, std::span<std::uint32_t>)>;
/// A mutant whose chains `by` makes from the real ones.
std::function<void(Functions&)> chaining(
    std::function<void(const Chain& real, Level, Rounding, ChainOf, std::span<const std::uint32_t>,
                       std::span<std::uint32_t>)>
        by);

}  // namespace mmverify::proofs::attribute
