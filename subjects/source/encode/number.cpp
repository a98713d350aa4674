#include "subjects/source/encode/number.hpp"

#include <algorithm>
#include <bit>

namespace mmverify::source {

Format format_of(unsigned bits) {
  return bits == 32 ? Format{32, 24, -149, 128} : Format{64, 53, -1074, 1024};
}

Number Numbers::of_constant(std::uint64_t bits, unsigned width) {
  const Format f = format_of(width);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << f.fraction_bits()) - 1);
  const std::uint64_t field = bits >> f.fraction_bits() & ((std::uint64_t{1} << f.exponent_bits()) - 1);
  Number x{f};
  x.bits = constant(bits, width).text;
  x.negative = bits >> (width - 1) != 0 ? "true" : "false";
  if (field == (std::uint64_t{1} << f.exponent_bits()) - 1) {
    (fraction == 0 ? x.infinite : x.nan) = "true";
    return x;
  }
  std::uint64_t size = fraction | (field == 0 ? 0 : std::uint64_t{1} << f.fraction_bits());
  x.unit = f.least + static_cast<int>(field == 0 ? 0 : field - 1);
  if (size != 0) {
    const int low = std::countr_zero(size);
    size >>= low;
    x.unit += low;
  }
  x.size = constant(size, static_cast<unsigned>(std::bit_width(size)));
  return x;
}

Number Numbers::of_bits(const Bits& word) {
  const Format f = format_of(word.width);
  const unsigned last = (1u << f.exponent_bits()) - 1;
  const Bits field = d.extract(word, word.width - 2, f.fraction_bits());
  const Bits fraction = d.extract(word, f.fraction_bits() - 1, 0);
  const Condition special = d.equal(field, constant(last, field.width));
  Number x = of_bits(word, false, 0, last - 1);
  x.negative = d.bit(word, word.width - 1);
  x.nan = both(special, negated(d.is_zero(fraction)));
  x.infinite = both(special, d.is_zero(fraction));
  return x;
}

Number Numbers::of_bits(const Bits& word, bool negative, unsigned first, unsigned last) {
  const Format f = format_of(word.width);
  const Bits fraction = d.extract(word, f.fraction_bits() - 1, 0);
  Number x{f};
  x.bits = word.text;
  x.negative = negative ? "true" : "false";
  x.unit = f.least + static_cast<int>(first == 0 ? 0 : first - 1);
  if (last == 0) {
    x.size = fraction;
    return x;
  }
  if (first == last) {
    x.size = d.concat(constant(1, 1), fraction);
    return x;
  }
  const Bits field = d.extract(word, word.width - 2, f.fraction_bits());
  const Condition subnormal = d.is_zero(field);
  const unsigned width = f.precision + last - std::max(first, 1u);
  const Bits significand = d.concat(d.of_condition(negated(subnormal), 1), fraction);
  const unsigned shift_width = std::max(width, field.width);
  const Bits by = d.choose_word(subnormal, zeros(field.width),
                                d.binary("bvsub", field, constant(std::max(first, 1u), field.width)));
  x.size =
      d.lowest(d.binary("bvshl", d.widened(significand, shift_width), d.widened(by, shift_width)), width);
  return x;
}

Bits Numbers::to_bits(const Number& x) {
  const Format& f = x.format;
  if (!x.bits.empty()) return {x.bits, f.bits};
  // The unit is chosen so that the significand has full length; the leading 1 is shifted to the top.
  const unsigned width = std::max(x.size.width, f.precision);
  const int unit = x.unit - static_cast<int>(width - x.size.width);
  Bits top = d.concat(x.size, zeros(width - x.size.width));
  constexpr unsigned count_bits = 13;
  Bits moved = zeros(count_bits);
  for (unsigned step = std::bit_floor(width - 1); step > 0; step /= 2) {
    const Condition empty = d.is_zero(d.extract(top, width - 1, width - step));
    top = d.choose_word(empty, d.times_two_to(d.lowest(top, width - step), step), top);
    moved = d.binary("bvadd", moved, d.choose_word(empty, constant(step, count_bits), zeros(count_bits)));
  }
  // The exponent field of the leading 1, exponent + bias.
  const int bias = f.beyond - 1, highest = unit + static_cast<int>(width) - 1 + bias;
  const Bits field = d.binary(
      "bvsub", constant(static_cast<std::uint64_t>(static_cast<std::int64_t>(highest)), count_bits), moved);
  const Condition normal = d.asked("bvsgt", field, zeros(count_bits));
  const Bits fraction = d.extract(top, width - 2, width - f.precision);
  // A subnormal number: the size in units of the least number.
  const Bits size = x.unit >= f.least ? d.concat(x.size, zeros(static_cast<unsigned>(x.unit - f.least)))
                                      : d.shifted_down(x.size, static_cast<unsigned>(f.least - x.unit));
  const Bits small = d.lowest(size, f.fraction_bits());
  const Bits finite =
      d.concat(d.choose_word(normal, d.lowest(field, f.exponent_bits()), zeros(f.exponent_bits())),
               d.choose_word(normal, fraction, small));
  const Bits beyond = d.concat(ones(f.exponent_bits()), zeros(f.fraction_bits()));
  Bits size_bits =
      d.choose_word(x.infinite, beyond, d.choose_word(d.is_zero(x.size), zeros(f.bits - 1), finite));
  Condition sign = x.negative;
  if (x.nan != "false") {
    // IEEE 754 leaves the payload of a NaN open.
    const Bits payload = d.binary("bvor", d.free_word(f.fraction_bits()),
                                  d.concat(constant(1, 1), zeros(f.fraction_bits() - 1)));
    size_bits = d.choose_word(x.nan, d.concat(ones(f.exponent_bits()), payload), size_bits);
    sign = choose(x.nan, d.free_condition(), sign);
  }
  return d.concat(d.of_condition(sign, 1), size_bits);
}

Numbers::Aligned Numbers::aligned(const Number& a, const Number& b, unsigned spare) {
  // Zero may have any unit.
  const int unit = a.size.width == 0 ? b.unit : b.size.width == 0 ? a.unit : std::min(a.unit, b.unit);
  const auto shifted = [&](const Number& x) {
    return x.size.width == 0 ? x.size : d.times_two_to(x.size, static_cast<unsigned>(x.unit - unit));
  };
  const Bits wide_a = shifted(a), wide_b = shifted(b);
  const unsigned width = std::max({wide_a.width, wide_b.width, 1u}) + spare;
  return {d.widened(wide_a, width), d.widened(wide_b, width), unit};
}

Number Numbers::exact_sum(const Number& a, const Number& b) {
  const Condition apart = d.name(differ(a.negative, b.negative));
  const auto [x, y, unit] = aligned(a, b, apart == "true" ? 0 : 1);
  Number s{a.format};
  s.unit = unit;
  const Condition both_infinite = both(a.infinite, b.infinite);
  s.nan = d.name(either(either(a.nan, b.nan), both(both_infinite, apart)));
  s.infinite = d.name(either(a.infinite, b.infinite));
  if (apart == "false") {
    s.size = d.binary("bvadd", x, y);
    s.negative = a.negative;
    return s;
  }
  const Condition less = d.below(x, y);
  const Bits gap = d.choose_word(less, d.binary("bvsub", y, x), d.binary("bvsub", x, y));
  s.size = apart == "true" ? gap : d.choose_word(apart, gap, d.binary("bvadd", x, y));
  // The sign of an exact 0 is +; the sign of an infinite sum is that of the infinite operand.
  const Condition of_gap = choose(less, b.negative, choose(d.equal(x, y), "false", a.negative));
  s.negative =
      choose(a.infinite, a.negative, choose(b.infinite, b.negative, choose(apart, of_gap, a.negative)));
  s.negative = d.name(s.negative);
  return s;
}

Number Numbers::exact_product(const Number& a, const Number& b) {
  Number p{a.format};
  p.negative = d.name(differ(a.negative, b.negative));
  const auto zero = [&](const Number& x) {
    return both(negated(either(x.infinite, x.nan)), d.is_zero(x.size));
  };
  p.nan = d.name(either(either(a.nan, b.nan), either(both(a.infinite, zero(b)), both(b.infinite, zero(a)))));
  p.infinite = d.name(either(a.infinite, b.infinite));
  p.unit = a.unit + b.unit;
  const auto by_one = [](const Number& x) { return x.size.value && *x.size.value == 1; };
  if (a.size.width == 0 || b.size.width == 0)
    p.size = {};
  else if (by_one(a) || by_one(b))
    p.size = by_one(a) ? b.size : a.size;
  else
    p.size = d.binary("bvmul", d.widened(a.size, a.size.width + b.size.width),
                      d.widened(b.size, a.size.width + b.size.width));
  return p;
}

Number Numbers::rounded(Number x) {
  const Format& f = x.format;
  x.bits.clear();
  const unsigned least =
      x.unit < f.least ? static_cast<unsigned>(f.least - x.unit) : 0;  // bits below the format's least
  if (x.size.width > f.precision || least > 0) {
    const unsigned width = std::max(x.size.width, least + 1);
    const Bits size = d.widened(x.size, width);
    // Ones at and below the leading 1.
    Bits below = size;
    for (unsigned k = 1; k < width; k *= 2) below = d.binary("bvor", below, d.shifted_down(below, k));
    // Places that are kept: `precision` places from the leading 1, none below the format's least.
    Bits kept = d.unary("bvnot", d.shifted_down(below, f.precision));
    if (least > 0) kept = d.binary("bvand", kept, d.concat(ones(width - least), zeros(least)));
    // Half of the last place less a unit; one unit more if the last place is odd.
    const Bits half = d.shifted_down(d.unary("bvnot", kept), 1);
    const Bits last =
        width == 1
            ? zeros(1)
            : d.binary("bvand", kept, d.unary("bvnot", d.concat(d.lowest(kept, width - 1), constant(1, 1))));
    const Condition odd = negated(d.is_zero(d.binary("bvand", size, last)));
    const Bits sum =
        d.binary("bvadd", d.binary("bvadd", d.widened(size, width + 1), d.widened(half, width + 1)),
                 d.of_condition(mistake_ == Mistake::ties_away ? "true" : odd, width + 1));
    const Bits all = d.binary("bvand", sum, d.concat(constant(1, 1), kept));
    x.size = least > 0 ? d.extract(all, width, least) : all;
    x.unit += static_cast<int>(least);
  }
  if (const int top = x.unit + static_cast<int>(x.size.width); top > f.beyond) {
    const int from = f.beyond - x.unit;  // the place of 2^beyond
    const Condition over =
        from <= 0 ? negated(d.is_zero(x.size))
                  : negated(d.is_zero(d.extract(x.size, x.size.width - 1, static_cast<unsigned>(from))));
    x.infinite = d.name(either(x.infinite, both(negated(x.nan), over)));
    // The size of an infinite number is arbitrary.
    x.size = d.lowest(x.size, from <= 0 ? 0 : static_cast<unsigned>(from));
  }
  return x;
}

Number Numbers::sum(const Number& a, const Number& b) {
  // x + 0 is x, except for the sign of -0 + 0.
  for (const auto& [x, zero] : {std::pair{&a, &b}, std::pair{&b, &a}})
    if (zero->size.width == 0 && zero->infinite == "false" && zero->nan == "false") {
      Number s = *x;
      if (s.negative == "false" || zero->negative == "true") return s;
      s.bits.clear();
      s.negative =
          d.name(both(s.negative, either(either(s.infinite, negated(d.is_zero(s.size))), zero->negative)));
      return s;
    }
  return rounded(exact_sum(a, b));
}
Number Numbers::product(const Number& a, const Number& b) { return rounded(exact_product(a, b)); }

std::optional<Number> Numbers::quotient(const Number& a, const Number& b) {
  if (!b.size.value || *b.size.value != 1 || b.nan != "false" || b.infinite != "false") return std::nullopt;
  Number inverse = b;
  inverse.unit = -b.unit;
  return product(a, inverse);
}

Number Numbers::fused(const Number& a, const Number& b, const Number& c) {
  return rounded(exact_sum(exact_product(a, b), c));
}

Number Numbers::negative_of(Number x) const {
  x.bits.clear();
  x.negative = negated(x.negative);
  return x;
}
Number Numbers::size_of(Number x) const {
  if (x.negative != "false") x.bits.clear();
  x.negative = "false";
  return x;
}
Number Numbers::with_sign_of(Number x, const Number& y) {
  x.bits.clear();
  // The sign of a computed NaN is open.
  x.negative = y.nan == "false" ? y.negative : d.name(choose(y.nan, d.free_condition(), y.negative));
  return x;
}

Number Numbers::chosen(const Condition& c, const Number& a, const Number& b) {
  if (c == "true") return a;
  if (c == "false") return b;
  Number x{a.format};
  const auto [p, q, unit] = aligned(a, b, 0);
  x.unit = unit;
  x.size = d.choose_word(c, p, q);
  x.nan = d.name(choose(c, a.nan, b.nan));
  x.infinite = d.name(choose(c, a.infinite, b.infinite));
  x.negative = d.name(choose(c, a.negative, b.negative));
  if (!a.bits.empty() && !b.bits.empty())
    x.bits = d.choose_word(c, {a.bits, a.format.bits}, {b.bits, b.format.bits}).text;
  return x;
}

Number Numbers::lesser(const Number& a, const Number& b, bool greater) {
  Condition first = compared(greater ? 2 : 4, a, b);
  // For 0 and -0 the result may be either.
  if (const Condition same = compared(1, a, b); a.negative != b.negative)
    first = d.name(choose(same, d.free_condition(), first));
  return chosen(a.nan, b, chosen(b.nan, a, chosen(first, a, b)));
}

Condition Numbers::compared(unsigned predicate, const Number& a, const Number& b) {
  const Condition unordered = d.name(either(a.nan, b.nan));
  auto [x, y, unit] = aligned(a, b, a.infinite == "false" && b.infinite == "false" ? 0 : 1);
  // Infinity is above every finite number.
  const Bits top = d.concat(constant(1, 1), zeros(x.width - 1));
  x = d.choose_word(a.infinite, top, x);
  y = d.choose_word(b.infinite, top, y);
  const Condition same = d.equal(x, y), zero = both(d.is_zero(x), d.is_zero(y));
  const Condition equal = either(zero, both(same, negated(differ(a.negative, b.negative))));
  const Condition sizes = choose(a.negative, d.below(y, x), d.below(x, y));
  const Condition less = choose(differ(a.negative, b.negative), both(a.negative, negated(zero)), sizes);
  Condition ordered = "false";
  if (predicate & 1) ordered = either(ordered, equal);
  if (predicate & 4) ordered = either(ordered, less);
  if (predicate & 2) ordered = either(ordered, both(negated(less), negated(equal)));
  if ((predicate & 7) == 7) ordered = "true";
  return d.name(choose(unordered, predicate & 8 ? "true" : "false", ordered));
}

Bits Numbers::whole_part(const Number& x) {
  if (x.size.width == 0) return {};
  if (x.unit >= 0) return d.times_two_to(x.size, static_cast<unsigned>(x.unit));
  const auto cut = static_cast<unsigned>(-x.unit);
  return cut >= x.size.width ? Bits{} : d.extract(x.size, x.size.width - 1, cut);
}

Number Numbers::whole(Op how, const Number& x) {
  if (x.unit >= 0 || x.size.width == 0) return x;
  Number w = x;
  w.bits.clear();
  w.unit = 0;
  const auto cut = static_cast<unsigned>(-x.unit);
  const Bits size = d.widened(x.size, std::max(x.size.width, cut + 1));
  const Bits whole = d.extract(size, size.width - 1, cut), rest = d.extract(size, cut - 1, 0);
  const Condition half = d.bit(rest, cut - 1);
  const Condition above_half = cut == 1 ? "false" : negated(d.is_zero(d.extract(rest, cut - 2, 0)));
  Condition up = "false";
  if (how == Op::floor && mistake_ != Mistake::floor_towards_zero)
    up = both(x.negative, negated(d.is_zero(rest)));
  if (how == Op::ceil) up = both(negated(x.negative), negated(d.is_zero(rest)));
  if (how == Op::round) up = half;
  if (how == Op::roundeven) up = both(half, either(above_half, d.bit(whole, 0)));
  w.size = up == "false"
               ? whole
               : d.binary("bvadd", d.widened(whole, whole.width + 1), d.of_condition(up, whole.width + 1));
  return w;
}

Number Numbers::converted(Number x, Format to) {
  const bool wider = to.precision > x.format.precision;
  x.format = to;
  x.bits.clear();
  return wider ? x : rounded(x);
}

Number Numbers::of_word(const Bits& word, std::uint64_t most, bool is_signed, Format to) {
  Number x{to};
  const std::uint64_t sign = std::uint64_t{1} << (word.width - 1);
  if (is_signed && most >= sign) {
    x.negative = d.bit(word, word.width - 1);
    x.size = d.choose_word(x.negative, d.unary("bvneg", word), word);
  } else {
    x.size = d.lowest(word, static_cast<unsigned>(std::bit_width(most)));
    // Trailing zeros of a constant go into the unit: a product with a power of two then only adds units.
    if (x.size.value && *x.size.value != 0) {
      x.unit = std::countr_zero(*x.size.value);
      const std::uint64_t odd = *x.size.value >> x.unit;
      x.size = constant(odd, static_cast<unsigned>(std::bit_width(odd)));
    }
  }
  return rounded(x);
}

Numbers::Word Numbers::to_word(const Number& x, unsigned bits, bool is_signed) {
  const Bits whole = whole_part(x);
  const Condition number = negated(either(x.nan, x.infinite));
  const Condition small = [&]() -> Condition {
    // Whether it is at most 2^bits - 1 and not below 0; if signed, at most 2^(bits-1) - 1, or 2^(bits-1)
    // below 0.
    const unsigned room = is_signed ? bits - 1 : bits;
    const Condition over =
        whole.width <= room ? "false" : negated(d.is_zero(d.extract(whole, whole.width - 1, room)));
    if (!is_signed) return both(negated(over), either(negated(x.negative), d.is_zero(whole)));
    const Bits wide = d.widened(whole, std::max(whole.width, bits + 1));
    const Condition least = d.equal(wide, d.widened(d.concat(constant(1, 1), zeros(bits - 1)), wide.width));
    return either(negated(over), both(x.negative, least));
  }();
  const Bits cut = d.lowest(whole, bits);
  const Bits word = is_signed ? d.choose_word(x.negative, d.unary("bvneg", cut), cut) : cut;
  const unsigned known = std::min(whole.width, bits);
  const bool may_be_negative = is_signed && x.negative != "false";
  const std::uint64_t most = known >= 64 || (may_be_negative && bits == 64)
                                 ? ~std::uint64_t{0}
                                 : (std::uint64_t{1} << (may_be_negative ? bits : known)) - 1;
  return {word, d.name(both(number, small)), most};
}

Bits Numbers::to_word_saturated(const Number& x, unsigned bits, bool is_signed) {
  const Word word = to_word(x, bits, is_signed);
  const Bits least = is_signed ? d.concat(constant(1, 1), zeros(bits - 1)) : zeros(bits);
  const Bits most = is_signed ? d.concat(zeros(1), ones(bits - 1)) : ones(bits);
  return d.choose_word(x.nan, zeros(bits),
                       d.choose_word(word.fits, word.word, d.choose_word(x.negative, least, most)));
}

}  // namespace mmverify::source
