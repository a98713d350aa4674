// Numbers of 1 to 64 bits in a graph: a literal a bit, the lowest first.
#pragma once

#include <optional>

#include "subjects/source/circuit/graph.hpp"

namespace mmverify::source::circuit {

using Word = std::vector<Literal>;

Word constant(std::uint64_t value, std::size_t width);
/// The value of a word without inputs.
std::optional<std::uint64_t> value_of(const Word& word);
/// The greatest value that the word's constant bits leave.
std::uint64_t at_most(const Word& word);

Word inverted(Word word);
Word resized(Word word, std::size_t width, bool with_sign);
Word chosen(Graph& g, Literal when, const Word& a, const Word& b);

/// a + b + carry, modulo 2^width.
Word sum(Graph& g, const Word& a, const Word& b, Literal carry = never);
Word difference(Graph& g, const Word& a, const Word& b);
Word product(Graph& g, const Word& a, const Word& b);
/// Quotient and remainder of unsigned numbers, b not 0.
struct Division {
  Word quotient, remainder;
};
Division divided(Graph& g, const Word& a, const Word& b);

enum class Shift { left, right, right_with_sign };
/// Amounts of the width or more give 0, or the sign.
Word shifted(Graph& g, Shift shift, const Word& a, const Word& amount);

Literal equal(Graph& g, const Word& a, const Word& b);
Literal less(Graph& g, const Word& a, const Word& b);
Literal less_signed(Graph& g, Word a, Word b);
/// Some bit is set.
Literal not_zero(Graph& g, const Word& word);

}  // namespace mmverify::source::circuit
