// The choices of a harness as the text of a case, and back.
#pragma once

#include <optional>

#include "proofs/codecs/laws.hpp"

namespace mmverify::proofs::codecs {

/// The text of choices, "4-state:3210,index=3": the question's beginning, then each group of choices.
///   digits   a digit for each number, in their order: a map's states by the index
///   bytes    two hexadecimal digits for each number
///   number   decimal
/// Domain: numbers are as many as the question's choices.
/// Test: codec_laws_test.
std::string text_of(const Question& question, const std::vector<std::uint64_t>& numbers);

/// The numbers of a text; nothing if it is no case of the question.
/// Test: codec_laws_test.
std::optional<std::vector<std::uint64_t>> numbers_of(const Question& question, const std::string& text);

/// The number of choices of a question.
std::uint64_t count_of(const Question& question);

}  // namespace mmverify::proofs::codecs
