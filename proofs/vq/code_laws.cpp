// Laws of the codes of vectors (figure 4, 5.1, table 2); the oracle is sets of code words.
#include <cstdio>

#include "proofs/engine/spoils.hpp"
#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/laws.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;

/// A code word, or a vector of C with one O and one T, which has a code if and only if the two have palettes of their
/// own.
struct Word {
  std::uint32_t side;
  Code4 how;
  bool of_pair;
  std::uint32_t code;  ///< the word; for a pair, 16 times O's region plus T's
};

constexpr std::array<const char*, 5> kinds{"simple", "vertical", "horizontal", "generic", "mini"};
constexpr std::uint32_t code_bits(std::uint32_t side, Code4 how) {
  return side == 2 ? 5 : spec::vq::bits_of(how);
}

std::string text_of(const Word& w) {
  const char* kind = kinds[w.side == 2 ? 4 : static_cast<std::size_t>(w.how)];
  return w.of_pair ? fmt::format("{}-pair:{},{}", kind, w.code / 16, w.code % 16)
                   : fmt::format("{}:{:#x}", kind, w.code);
}

/// Whether O and T at two regions have different palettes.
bool apart(const Word& w) {
  const std::uint32_t o = w.code / 16, t = w.code % 16;
  if (w.side == 2 || w.how == Code4::simple) return false;
  const bool columns = o % 4 / 2 != t % 4 / 2, rows = o / 8 != t / 8;
  return w.how == Code4::vertical ? columns : w.how == Code4::horizontal ? rows : columns || rows;
}

template <std::size_t side>
Finding writes(const VqSubject& s, const Word& w) {
  const Vectors<side>& of = s.functions.vectors<side>();
  if (w.of_pair) {
    Vector<side> v = spec::vq::uniform<side>(C);
    v[w.code / 16] = O;
    v[w.code % 16] = T;
    const auto code = of.encode(w.how, v);
    if (code.has_value() != apart(w))
      return wrong(fmt::format("{} {}", letters(v), apart(w) ? "written" : "not written"),
                   code ? fmt::format("{:#x}", *code) : "none");
    if (code && of.decode(w.how, *code) != v) return wrong(letters(v), letters(of.decode(w.how, *code)));
    return {code.value_or(0)};
  }
  const Vector<side> v = of.decode(w.how, w.code);
  // The definition: bit k gives C, else the region's palette gives O or T.
  for (std::uint32_t k = 0; k < side * side; ++k) {
    const std::uint32_t x = k % side, y = k / side, m = x / 2 + 2 * (y / 2);
    const bool generic = side == 4 && w.how == Code4::generic;
    const std::uint32_t own = generic ? 5 * m + x % 2 + 2 * (y % 2) : k,
                        palette = side == 2                    ? 4
                                  : generic                    ? 5 * m + 4
                                  : w.how == Code4::vertical   ? 16 + x / 2
                                  : w.how == Code4::horizontal ? 16 + y / 2
                                                               : 16;
    const State expected = (w.code >> own & 1) != 0 ? C : (w.code >> palette & 1) != 0 ? O : T;
    if (v[k] != expected)
      return wrong(fmt::format("region {} {}", k, letters({&expected, 1})), letters({&v[k], 1}));
  }
  const auto again = of.encode(w.how, v);
  if (!again) return wrong(fmt::format("a code of {}", letters(v)), "none");
  // Every word is checked, so the code found is the least of all words of its vector.
  if (*again > w.code) return wrong(fmt::format("{:#x} or less", w.code), fmt::format("{:#x}", *again));
  if (const Vector<side> meant = of.decode(w.how, *again); meant != v)
    return wrong(letters(v), letters(meant));
  return {*again};
}

constexpr std::array<Code4, 4> ways{Code4::simple, Code4::vertical, Code4::horizontal, Code4::generic};

/// Case k: the words of each way, then its pairs.
Word word_number(Level n, std::uint64_t k) {
  if (n == 1) {
    if (k < 32) return {2, Code4::generic, false, static_cast<std::uint32_t>(k)};
    k -= 32;
    const auto o = static_cast<std::uint32_t>(k / 3), t = static_cast<std::uint32_t>(k % 3);
    return {2, Code4::generic, true, 16 * o + (t < o ? t : t + 1)};
  }
  for (const Code4 how : ways) {
    const std::uint64_t words = std::uint64_t{1} << code_bits(4, how);
    if (k < words) return {4, how, false, static_cast<std::uint32_t>(k)};
    k -= words;
    if (k < 240) {
      const auto o = static_cast<std::uint32_t>(k / 15), t = static_cast<std::uint32_t>(k % 15);
      return {4, how, true, 16 * o + (t < o ? t : t + 1)};
    }
    k -= 240;
  }
  throw std::logic_error("vq.codes: no such case");
}

Word word_from(Level n, const std::string& at) {
  const auto bad = [&] {
    return BadCase(fmt::format(
        "'{:.60}': write simple, vertical, horizontal or generic, at level 1 mini, then :0xWORD or -pair:O,T",
        at));
  };
  const std::size_t colon = at.find(':');
  if (colon == std::string::npos) throw bad();
  std::string kind = at.substr(0, colon);
  const bool pair = kind.ends_with("-pair");
  if (pair) kind.resize(kind.size() - 5);
  return at_side(n, [&](auto side) {
    const auto found = std::find(kinds.begin(), kinds.end(), kind);
    const auto number = static_cast<std::size_t>(found - kinds.begin());
    if (found == kinds.end() || (number == 4) != (side == 2)) throw bad();
    const Code4 how = side == 2 ? Code4::generic : ways[number];
    const std::string rest = at.substr(colon + 1);
    unsigned long long first = 0, second = 0;
    int read = -1;
    if (pair) {
      if (std::sscanf(rest.c_str(), "%2llu,%2llu%n", &first, &second, &read) != 2 || first == second ||
          first >= side * side || second >= side * side)
        throw bad();
    } else if (std::sscanf(rest.c_str(), "0x%8llx%n", &first, &read) != 1 ||
               first >> code_bits(side, how) != 0) {
      throw bad();
    }
    if (static_cast<std::size_t>(read) != rest.size()) throw bad();
    return Word{side, how, pair, static_cast<std::uint32_t>(pair ? 16 * first + second : first)};
  });
}

}  // namespace

Law codes_law() {
  Cases<Word> cases;
  cases.count = [](Level n, const Run&) -> std::uint64_t {
    return n == 1 ? 32 + 12 : (1u << 17) + 2 * (1u << 18) + (1u << 20) + 4 * 240;
  };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) { return word_number(n, k); };
  cases.text = text_of;
  cases.read = word_from;
  cases.check = [](const VqSubject& s, const Word& w) {
    return w.side == 2 ? writes<2>(s, w) : writes<4>(s, w);
  };
  cases.chunk = 4096;
  return on_cases(
      {.id = "vq.codes",
       .says = "a code word decodes by figure 4 and table 2, and encoding that gives the least word that "
               "means it; O and T are written where each has its palette, and nowhere else",
       .source = "Compressed Opacity Maps, figure 4, 5.1 and table 2",
       .subjects = {"vq-spec"},
       .tiers = {.fast = both_sides, .seconds = 1},
       .domain =
           [](Level n) {
             return std::string(n == 1 ? "all words of 5 bits; O at one region, T at another, C elsewhere"
                                       : "all words of 17, 18, 18 and 20 bits; O at one region, T at "
                                         "another, C elsewhere, each of the four ways");
           },
       .mutants = {mutant("one word of 20 bits has T for C in its last region", "vq-spec", {2, 2},
                          spoils(&Functions::of4, &Vectors<4>::decode,
                                 [](Code4 how, std::uint32_t code, Vector<4>& v) {
                                   if (how == Code4::generic && code == 0x7beef) v[15] = T;
                                 })),
                   mutant("all C is written with the palette of O", "vq-spec", {1, 1},
                          spoils(&Functions::of2, &Vectors<2>::encode,
                                 [](Code4, const Vector<2>& v, auto& code) {
                                   if (v == spec::vq::uniform<2>(C)) code = 31;
                                 })),
                   mutant("a horizontal line takes O and T of one row", "vq-spec", {2, 2},
                          spoils(&Functions::of4, &Vectors<4>::encode,
                                 [](Code4 how, const Vector<4>& v, auto& code) {
                                   if (how == Code4::horizontal && v[12] == O && v[15] == T && !code)
                                     code = 0x36fff;
                                 }))}},
      lacks_vectors, cases);
}

}  // namespace mmverify::proofs::vq
