// Laws of operations on payloads, code by code.  If any two hits may be exchanged on any payload, any number of hits
// may be met in any order: exchanges of neighbours lead from each order to each other.
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/laws.hpp"

namespace mmverify::proofs::traverse {
namespace {

constexpr char cam_functions[] = "Color and Attribute Micromaps, 4.3, figure 6";

using spec::traverse::Code;

/// An operation and two codes; each case combines them with all 256 third codes.
struct Codes {
  Operation operation;
  Code first, second;
};

constexpr std::size_t all_codes = 256;
using CodeWords = std::vector<std::uint32_t>;

/// The words of a number of up to three codes, the first in its highest bits.  Each channel has its own permutation
/// of all such numbers, so that it meets every combination, and no channel determines another.
template <std::size_t codes>
constexpr std::array<std::uint32_t, codes> in_all(std::uint32_t number) {
  std::array<std::uint32_t, codes> words{};
  for (unsigned channel = 0; channel < 4; ++channel) {
    const std::uint32_t here = shuffled(number, 8 * codes, channel);
    for (std::size_t k = 0; k < codes; ++k) words[k] |= (here >> 8 * (codes - 1 - k) & 255) << 8 * channel;
  }
  return words;
}
/// The words of a payload's code, an alpha and a value's code.  Under each alpha each of R, G and B meets every pair
/// of codes, and A every payload's code.
constexpr std::array<std::uint32_t, 2> with_alpha(std::uint32_t number) {
  const Code p = number >> 16, alpha = number >> 8 & 255, v = number & 255;
  std::array<std::uint32_t, 2> words{((p + 85 * v) & 255) << 24, alpha << 24};
  for (unsigned channel = 0; channel < 3; ++channel) {
    const std::uint32_t pair = shuffled(p << 8 | v, 16, 4 * alpha + channel);
    words[0] |= pair >> 8 << 8 * channel;
    words[1] |= (pair & 255) << 8 * channel;
  }
  return words;
}

CodeWords blended(const TraverseSubject& s, Operation o, const CodeWords& payload, const CodeWords& value) {
  CodeWords out(payload.size());
  s.functions.blend(o, payload, value, out);
  return out;
}

/// The words of a first code with all pairs of a second and a third one, by columns: payloads, then values.
template <std::size_t columns>
std::array<CodeWords, columns> of_pairs(std::array<std::uint32_t, columns> (*words)(std::uint32_t),
                                        Code first) {
  constexpr std::uint32_t pairs = all_codes * all_codes;
  std::array<CodeWords, columns> all;
  for (CodeWords& column : all) column.resize(pairs);
  for (std::uint32_t pair = 0; pair < pairs; ++pair) {
    const auto row = words(first << 16 | pair);
    for (std::size_t c = 0; c < columns; ++c) all[c][pair] = row[c];
  }
  return all;
}

/// A subject's answers to all pairs, for one operation and one first code.
struct CodeSheet {
  CodeWords one, other;
};
using AsksSheet = CodeSheet (*)(const TraverseSubject&, Operation, Code first);

/// The answers to a case's second code: 256 words.  A thread asks for a whole sheet at once, as calls to a library
/// cost time, and keeps the last one.
struct TwoColumns {
  std::span<const std::uint32_t> one, other;
};
TwoColumns answers_to(const TraverseSubject& s, const Codes& c, AsksSheet asks) {
  struct LastColumns {
    std::uint64_t subject = 0;
    AsksSheet asks = nullptr;
    Operation operation = Operation::max;
    Code first = 0;
    CodeSheet sheet = {};
  };
  thread_local LastColumns kept;
  if (kept.subject != s.serial || kept.asks != asks || kept.operation != c.operation ||
      kept.first != c.first) {
    kept.subject = 0;  // until the sheet is complete, since `asks` may throw
    kept.sheet = asks(s, c.operation, c.first);
    kept.asks = asks;
    kept.operation = c.operation;
    kept.first = c.first;
    kept.subject = s.serial;
  }
  const auto of = [&c](const CodeWords& all) {
    const std::span<const std::uint32_t> whole = all;
    return whole.size() <= all_codes ? whole : whole.subspan(c.second * all_codes, all_codes);
  };
  return {of(kept.sheet.one), of(kept.sheet.other)};
}

std::string codes_of(std::uint32_t word) {
  return fmt::format("{} {} {} {}", word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24);
}

std::uint64_t digest_of(std::span<const std::uint32_t> column) {
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < column.size(); ++k) sum += Tally::digest_of(k, column[k]);
  return sum;
}

/// Cases of the operations first to last, with all pairs of codes.
Cases<Codes> on_codes(Operation first, Operation last,
                      std::function<Finding(const TraverseSubject&, const Codes&)> check) {
  const auto from = static_cast<std::uint64_t>(first), to = static_cast<std::uint64_t>(last) + 1;
  Cases<Codes> cases;
  cases.count = [from, to] { return (to - from) << 16; };
  cases.number = [from](std::uint64_t k) {
    return Codes{static_cast<Operation>(from + (k >> 16)), static_cast<Code>(k >> 8 & 255),
                 static_cast<Code>(k & 255)};
  };
  cases.text = [](const Codes& c) {
    return fmt::format("{},{},{}", name_of(c.operation), c.first, c.second);
  };
  cases.read = [from, to](const std::string& at) {
    const Groups g = groups_of(at, "(max|min|add|multiply|over),(\\d{1,3}),(\\d{1,3})");
    if (!g) throw BadCase(fmt::format("'{:.60}': write max,7,200", at));
    unsigned o = 0;
    while ((*g)[1] != name_of(static_cast<Operation>(o))) ++o;
    const Codes c{static_cast<Operation>(o), static_cast<Code>(std::stoul((*g)[2])),
                  static_cast<Code>(std::stoul((*g)[3]))};
    if (o < from || o >= to) throw BadCase(fmt::format("'{:.60}': the law is about other operations", at));
    if (c.first > 255 || c.second > 255) throw BadCase(fmt::format("'{:.60}': codes go up to 255", at));
    return c;
  };
  cases.check = std::move(check);
  cases.chunk = 256;
  return cases;
}

/// A mutant whose blended words `wrong` may alter.
std::function<void(Functions&)> blending(void (*wrong)(Operation, std::uint32_t payload, std::uint32_t value,
                                                       std::uint32_t& out)) {
  return spoils(&Functions::blend,
                [wrong](Operation o, std::span<const std::uint32_t> payload,
                        std::span<const std::uint32_t> value, std::span<std::uint32_t> out) {
                  for (std::size_t k = 0; k < out.size(); ++k) wrong(o, payload[k], value[k], out[k]);
                });
}

Law blend_law() {
  return on_cases(
      {.id = "traverse.blend",
       .says = "a payload's codes after a hit are the maximum, the minimum, the sum up to 255, the product, "
               "or the value over the payload, to the nearest code",
       .source = cam_functions,
       .subjects = {"traverse", "traverse-single"},
       .tiers = {.seconds = 1},
       .domain = "5 operations; in each channel all 2^24 of payload, alpha and value",
       .mutants = {mutant("over multiplies alpha into a red of 9 again", "traverse",
                          blending([](Operation o, std::uint32_t, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::over && (v & 255) == 9 && v >> 24 < 128) --out;
                          }))}},
      {entry::blend}, on_codes(Operation::max, Operation::over, [](const TraverseSubject& s, const Codes& c) {
        // The first code is a payload's, the second one the value's alpha, the third one a value's.
        const TwoColumns all = answers_to(s, c, [](const TraverseSubject& subject, Operation o, Code first) {
          const auto [payload, value] = of_pairs(with_alpha, first);
          CodeWords right;
          right.reserve(payload.size());
          for (std::size_t k = 0; k < payload.size(); ++k)
            right.push_back(word_of(spec::traverse::blend(o, colour_of(payload[k]), colour_of(value[k]))));
          return CodeSheet{blended(subject, o, payload, value), right};
        });
        for (Code third = 0; third < all_codes; ++third) {
          if (all.one[third] == all.other[third]) continue;
          const auto [payload, value] = with_alpha(c.first << 16 | c.second << 8 | third);
          return wrong(
              fmt::format("{} of {} and {}", codes_of(all.other[third]), codes_of(payload), codes_of(value)),
              codes_of(all.one[third]));
        }
        return Finding{digest_of(all.one)};
      }));
}

/// The results of two values on a payload, in both orders.
using ThreeWords = std::array<std::uint32_t, 3>;
template <ThreeWords (*words)(std::uint32_t)>
TwoColumns in_both_orders(const TraverseSubject& s, const Codes& c) {
  return answers_to(s, c, [](const TraverseSubject& subject, Operation o, Code first) {
    const auto [payload, a, b] = of_pairs(words, first);
    return CodeSheet{blended(subject, o, blended(subject, o, payload, a), b),
                     blended(subject, o, blended(subject, o, payload, b), a)};
  });
}
/// Words with one code in all channels; opaque() sets A to 255.
constexpr ThreeWords alike(std::uint32_t number) {
  return {(number >> 16) * 0x01010101u, (number >> 8 & 255) * 0x01010101u, (number & 255) * 0x01010101u};
}
constexpr ThreeWords opaque(std::uint32_t number) {
  ThreeWords words = alike(number);
  for (std::uint32_t& word : words) word |= 0xFF000000;
  return words;
}

Finding wrong_order(const ThreeWords& words, std::uint32_t one, std::uint32_t other) {
  const auto& [payload, a, b] = words;
  return wrong(fmt::format("{} on payload {} with {}, then {}", codes_of(one), codes_of(payload), codes_of(a),
                           codes_of(b)),
               fmt::format("{} the other way around", codes_of(other)));
}

Law order_free() {
  return on_cases(
      {.id = "traverse.blend_order_free",
       .says = "max, min and add up to 255 give one payload in any order of hits: on every payload any two "
               "values may change places, and so any number",
       .source = cam_functions,
       .subjects = {"traverse"},
       .tiers = {.seconds = 1.5},
       .domain = "3 operations; in each channel all 2^24 of a payload and two values",
       .mutants = {mutant("min takes signs in alpha", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::min && p >> 24 == 128 && v >> 24 == 127) out |= 0xFF000000;
                          }))}},
      {entry::blend}, on_codes(Operation::max, Operation::add, [](const TraverseSubject& s, const Codes& c) {
        const TwoColumns orders = in_both_orders<in_all<3>>(s, c);
        for (std::size_t b = 0; b < all_codes; ++b)
          if (orders.one[b] != orders.other[b])
            return wrong_order(in_all<3>(c.first << 16 | c.second << 8 | static_cast<Code>(b)), orders.one[b],
                               orders.other[b]);
        return Finding{digest_of(orders.one)};
      }));
}

Law duplicates() {
  return on_cases(
      {.id = "traverse.blend_duplicates",
       .says = "a hit that is reported twice counts once for max and min; for add only where the value is 0 "
               "or the sum reaches 255, and for multiply only where the product m has 2 m (255 - v) < 255",
       .source = "Color and Attribute Micromaps, 4.3; VK_GEOMETRY_NO_DUPLICATE_ANY_HIT_INVOCATION_BIT_KHR",
       .subjects = {"traverse-spec", "traverse"},
       .tiers = {.seconds = 0.3},
       .domain = "4 operations; in each channel all 2^16 of a payload and a value",
       .mutants = {mutant("max adds one to equal codes of 77", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::max && (p & 255) == 77 && (v & 255) == 77) ++out;
                          }))}},
      {entry::blend},
      on_codes(Operation::max, Operation::multiply, [](const TraverseSubject& s, const Codes& c) {
        // The sheet has all second codes, since there is no third.
        const auto asks = [](const TraverseSubject& subject, Operation o, Code first) {
          CodeWords payload, value;
          for (Code second = 0; second < all_codes; ++second) {
            const auto words = in_all<2>(first << 8 | second);
            payload.push_back(words[0]);
            value.push_back(words[1]);
          }
          const CodeWords single = blended(subject, o, payload, value);
          return CodeSheet{single, blended(subject, o, single, value)};
        };
        const TwoColumns all = answers_to(s, {c.operation, c.first, 0}, asks);
        const auto [payload, value] = in_all<2>(c.first << 8 | c.second);
        const std::uint32_t once = all.one[c.second], twice = all.other[c.second];
        for (unsigned shift = 0; shift < 32; shift += 8) {
          const Code p = payload >> shift & 255, v = value >> shift & 255, m = once >> shift & 255,
                     n = twice >> shift & 255;
          const bool counts_once = c.operation == Operation::add        ? v == 0 || p + v >= 255
                                   : c.operation == Operation::multiply ? 2 * m * (255 - v) < 255
                                                                        : true;
          if ((m == n) != counts_once)
            return wrong(fmt::format("{}{} on payload {} with {} twice", counts_once ? "" : "not ", m, p, v),
                         fmt::format("{}", n));
        }
        return Finding{once + (std::uint64_t{twice} << 32) + 1};
      }));
}

/// The smallest case: payload, value and value.
constexpr std::array<Code, 3> smallest{2, 64, 128};

Law multiply_depends() {
  return on_cases(
      {.id = "paper.blend_multiply_depends_on_order",
       .says = "multiply, rounded to codes, is not independent of the order of hits, as exact multiplication "
               "is: payload 2 with 64 and 128 is the smallest case, 1 or 0; two hits that change places "
               "change a code by 1 at most",
       .source = cam_functions,
       .subjects = {"traverse"},
       .tiers = {.seconds = 0.5},
       .domain = "all 2^24 of a payload and two values, the same in the four channels",
       .mutants = {mutant("2 by 64 is 0", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::multiply && (p & 255) == 2 && (v & 255) == 64) out &= ~255u;
                          })),
                   mutant("1 by 128 is 0", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::multiply && (p & 255) == 1 && (v & 255) == 128) out &= ~255u;
                          })),
                   mutant("products of 200 and more lose 2", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::multiply && (out & 255) >= 200 && (p & 255) < 255 && v != p)
                              out -= 2;
                          }))},
       .general = false},
      {entry::blend},
      on_codes(Operation::multiply, Operation::multiply, [](const TraverseSubject& s, const Codes& c) {
        const TwoColumns orders = in_both_orders<alike>(s, c);
        for (Code b = 0; b < all_codes; ++b) {
          const std::array<Code, 3> here{c.first, c.second, b};
          const int change = static_cast<int>(orders.one[b] & 255) - static_cast<int>(orders.other[b] & 255);
          const int least = here == smallest ? 1 : 0, most = here < smallest ? 0 : 1;
          if (std::abs(change) < least || std::abs(change) > most)
            return wrong(fmt::format("a difference of {} to {} on payload {} with {} and {}", least, most,
                                     c.first, c.second, b),
                         fmt::format("{} and {}", orders.one[b] & 255, orders.other[b] & 255));
        }
        return Finding{digest_of(orders.one)};
      }));
}

Law over_depends() {
  return on_cases(
      {.id = "paper.blend_over_depends_on_order",
       .says = "over keeps of opaque hits the one that is met last alone, so any two different ones depend "
               "on their order: 0 and 1 on payload 0 are the smallest case",
       .source = cam_functions,
       .subjects = {"traverse"},
       .tiers = {.seconds = 0.5},
       .domain = "all 2^24 of a payload and two opaque values, the same in R, G and B",
       .mutants = {mutant("payloads of 255 shine through", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::over && (p & 255) == 255 && (v & 255) < 255) ++out;
                          })),
                   mutant("the darker one stays", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t v, std::uint32_t& out) {
                            if (o == Operation::over) out = (out & ~255u) | std::min(p & 255, v & 255);
                          })),
                   mutant("under, not over", "traverse",
                          blending([](Operation o, std::uint32_t p, std::uint32_t, std::uint32_t& out) {
                            if (o == Operation::over) out = p;
                          }))},
       .general = false},
      {entry::blend},
      on_codes(Operation::over, Operation::over, [](const TraverseSubject& s, const Codes& c) {
        const TwoColumns orders = in_both_orders<opaque>(s, c);
        for (Code b = 0; b < all_codes; ++b)
          if ((orders.one[b] & 255) != b || (orders.other[b] & 255) != c.second)
            return wrong(fmt::format("{} and {} on payload {}", b, c.second, c.first),
                         fmt::format("{} and {}", orders.one[b] & 255, orders.other[b] & 255));
        return Finding{digest_of(orders.one)};
      }));
}

}  // namespace

std::vector<Law> blend_laws() {
  return {blend_law(), order_free(), duplicates(), multiply_depends(), over_depends()};
}

}  // namespace mmverify::proofs::traverse
