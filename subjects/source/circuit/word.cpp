#include "subjects/source/circuit/word.hpp"

#include <bit>

namespace mmverify::source::circuit {

Word constant(std::uint64_t value, std::size_t width) {
  Word word(width, never);
  for (std::size_t k = 0; k < width; ++k)
    if (k < 64 && (value >> k & 1) != 0) word[k] = always;
  return word;
}

std::optional<std::uint64_t> value_of(const Word& word) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (word[k] > always) return std::nullopt;
    if (word[k] == always && k < 64) value |= std::uint64_t{1} << k;
  }
  return value;
}

std::uint64_t at_most(const Word& word) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < word.size() && k < 64; ++k)
    if (word[k] != never) value |= std::uint64_t{1} << k;
  return value;
}

Word inverted(Word word) {
  for (Literal& l : word) l = negated(l);
  return word;
}

Word resized(Word word, std::size_t width, bool with_sign) {
  const Literal fill = with_sign && !word.empty() ? word.back() : never;
  word.resize(width, fill);
  return word;
}

Word chosen(Graph& g, Literal when, const Word& a, const Word& b) {
  Word word(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) word[k] = g.chosen(when, a[k], b[k]);
  return word;
}

Word sum(Graph& g, const Word& a, const Word& b, Literal carry) {
  Word word(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Literal odd = g.differ(a[k], b[k]);
    word[k] = g.differ(odd, carry);
    carry = g.either(g.both(a[k], b[k]), g.both(odd, carry));
  }
  return word;
}

Word difference(Graph& g, const Word& a, const Word& b) { return sum(g, a, inverted(b), always); }

Word product(Graph& g, const Word& a, const Word& b) {
  Word word(a.size(), never);
  for (std::size_t k = 0; k < b.size(); ++k) {
    if (b[k] == never) continue;
    Word part(a.size(), never);
    for (std::size_t j = k; j < a.size(); ++j) part[j] = g.both(a[j - k], b[k]);
    word = sum(g, word, part);
  }
  return word;
}

Division divided(Graph& g, const Word& a, const Word& b) {
  const std::size_t width = a.size();
  if (const auto divisor = value_of(b); divisor && std::has_single_bit(*divisor)) {
    const auto bits = static_cast<std::size_t>(std::countr_zero(*divisor));
    Division d{shifted(g, Shift::right, a, constant(bits, width)), a};
    for (std::size_t k = bits; k < width; ++k) d.remainder[k] = never;
    return d;
  }
  Division d{Word(width, never), Word(width, never)};
  for (std::size_t k = width; k-- > 0;) {
    // The remainder may have one bit more than b before it is reduced.
    const Literal beyond = d.remainder.back();
    for (std::size_t j = width - 1; j > 0; --j) d.remainder[j] = d.remainder[j - 1];
    d.remainder[0] = a[k];
    const Literal goes = g.either(beyond, negated(less(g, d.remainder, b)));
    d.remainder = chosen(g, goes, difference(g, d.remainder, b), d.remainder);
    d.quotient[k] = goes;
  }
  return d;
}

namespace {

Word shifted_by(const Word& a, Shift shift, std::uint64_t amount, Literal fill) {
  Word word(a.size(), fill);
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (shift == Shift::left && k >= amount) word[k] = a[k - amount];
    if (shift != Shift::left && amount < a.size() - k) word[k] = a[k + amount];
  }
  return word;
}

}  // namespace

Word shifted(Graph& g, Shift shift, const Word& a, const Word& amount) {
  const Literal fill = shift == Shift::right_with_sign ? a.back() : never;
  if (const auto known = value_of(amount)) return shifted_by(a, shift, *known, fill);
  Word word = a;
  for (std::size_t bit = 0; bit < amount.size(); ++bit) {
    if (amount[bit] == never) continue;
    const std::uint64_t step = bit < 7 ? std::uint64_t{1} << bit : a.size();
    word = chosen(g, amount[bit], shifted_by(word, shift, step, fill), word);
  }
  return word;
}

Literal equal(Graph& g, const Word& a, const Word& b) {
  Literal all = always;
  for (std::size_t k = 0; k < a.size() && all != never; ++k) all = g.both(all, negated(g.differ(a[k], b[k])));
  return all;
}

Literal less(Graph& g, const Word& a, const Word& b) {
  Literal lower = never;
  for (std::size_t k = 0; k < a.size(); ++k) lower = g.chosen(g.differ(a[k], b[k]), b[k], lower);
  return lower;
}

Literal less_signed(Graph& g, Word a, Word b) {
  a.back() = negated(a.back());
  b.back() = negated(b.back());
  return less(g, a, b);
}

Literal not_zero(Graph& g, const Word& word) { return g.any_of(word); }

}  // namespace mmverify::source::circuit
