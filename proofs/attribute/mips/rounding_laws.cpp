// Laws of rounded means, and of the error of chains.
#include "proofs/attribute/mips/law_parts.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::attribute::face_count;

/// Two children of the first channel; each case combines them with pairs of other codes.
struct TwoCodes {
  Rounding rounding;
  std::uint32_t a, b;
};

/// The pair of a channel; over all cases each channel has all pairs, in an order of its own.
std::uint32_t pair_of(const TwoCodes& two, unsigned which) {
  const std::uint32_t pair = two.a << 8 | two.b;
  return which == 0 ? pair : shuffled(pair, 16, which);
}

/// The other two children.
struct TwoMore {
  std::uint32_t c, d;
};

/// Checks the means of a pair with all pairs (c, d).  Word k has pair k in its first code, the next pair in its
/// second, and so on, so that each pair occurs in each of the four codes.  A second round takes every other pair
/// instead, for carries from code to code.  Three more words begin anew, for the remainder after multiples of eight.
Finding all_with(const AttributeSubject& s, const TwoCodes& two, std::span<const TwoMore> pairs,
                 std::size_t rounds) {
  const std::size_t count = pairs.size(), words = rounds * count + 3;
  std::vector<std::uint32_t> children(4 * words), parents(words);
  const auto codes = [&](std::size_t k, unsigned which) {
    const std::size_t step = k / count == 1 ? 2 : 1;
    const auto [c, d] = pairs[(k + which * step) % count];
    const std::uint32_t pair = pair_of(two, which);
    return Codes{pair >> 8, pair & 255, c, d};
  };
  for (std::size_t k = 0; k < words; ++k)
    for (unsigned which = 0; which < 4; ++which)
      for (std::size_t child = 0; child < 4; ++child)
        children[4 * k + child] |= codes(k, which)[child] << 8 * which;
  s.functions.mips.face_mip(two.rounding, children, parents);
  Finding found;
  for (std::size_t k = 0; k < words; ++k) {
    if (k < count) found.answer += Tally::digest_of(k, parents[k]);
    for (unsigned which = 0; which < 4; ++which) {
      const Codes x = codes(k, which);
      const std::uint32_t got = parents[k] >> 8 * which & 255;
      if (is_rounded(two.rounding, x, got)) continue;
      return wrong(fmt::format("the mean of {}, {}", fmt::join(x, " "), rounding_name(two.rounding)),
                   fmt::format("{}", got));
    }
  }
  return found;
}

TwoCodes read_two_codes(Level, const std::string& at) {
  const Groups g = groups_of(at, "([a-z-]+),a=(\\d+),b=(\\d+)");
  if (!g) throw BadCase(fmt::format("'{:.60}': write half-up,a=1,b=2", at));
  return TwoCodes{rounding_of((*g)[1], at), static_cast<std::uint32_t>(number_of((*g)[2], at, 255)),
                  static_cast<std::uint32_t>(number_of((*g)[3], at, 255))};
}

std::vector<TwoMore> other_pairs(bool all) {
  // Pairs with sums of every remainder, and the extremes.
  std::vector<TwoMore> pairs{{0, 0}, {0, 1}, {1, 1}, {3, 0}, {127, 128}, {3, 128}, {254, 255}, {255, 255}};
  if (all) {
    pairs.resize(65536);
    for (std::uint32_t k = 0; k < pairs.size(); ++k) pairs[k] = {k >> 8, k & 255};
  }
  return pairs;
}

Law mip_rounding_law(const char* id, bool all) {
  Cases<TwoCodes> cases;
  cases.count = 4 * 65536;
  cases.number = [](Level, std::uint64_t k, std::uint64_t) {
    return TwoCodes{static_cast<Rounding>(k >> 16), static_cast<std::uint32_t>(k >> 8 & 255),
                    static_cast<std::uint32_t>(k & 255)};
  };
  cases.text = [](Level, const TwoCodes& t) {
    return fmt::format("{},a={},b={}", rounding_name(t.rounding), t.a, t.b);
  };
  cases.read = read_two_codes;
  const std::vector<TwoMore> pairs = other_pairs(all);
  cases.check = [pairs, rounds = all ? 1u : 2u](const AttributeSubject& s, Level, const TwoCodes& t) {
    return all_with(s, t, pairs, rounds);
  };
  Law law{
      .id = id,
      .says =
          "a mip is the mean of four codes by its rounding: within half a code and halves up, to even, below "
          "by less than 1, or two means of two and their mean, halves up",
      .source = "Color and Attribute Micromaps, 4.4, which names no rounding; docs/ATTRIBUTE.md",
      .subjects = {"attribute-spec", "attribute"},
      .tiers = {.seconds = 0.4},
      .at_once = "all levels",
      .domain = all ? "4 roundings; in each of the four codes the 2^32 quadruples"
                    : "4 roundings; in each of the four codes all pairs for two children, 8 pairs for "
                      "the others",
      .mutants =
          {mutant("half to even is half up", "attribute", {0, 0},
                  meaning([](Rounding r, const Codes& x, std::uint32_t right, unsigned) {
                    return r == Rounding::half_to_even ? (x[0] + x[1] + x[2] + x[3] + 2) / 4 : right;
                  })),
           mutant(
               "four codes of 255 make 254 in one of a word's four", "attribute", {0, 0},
               meaning([](Rounding r, const Codes& x, std::uint32_t right, unsigned which) {
                 return r == Rounding::half_up && which == 2 && x == Codes{255, 255, 255, 255} ? 254u : right;
               })),
           mutant("means of two are taken of the wrong two", "attribute", {0, 0},
                  meaning([](Rounding r, const Codes& x, std::uint32_t right, unsigned) {
                    return r == Rounding::halves_up ? ((x[0] + x[2] + 1) / 2 + (x[1] + x[3] + 1) / 2 + 1) / 2
                                                    : right;
                  })),
           mutant("one quadruple is off", "attribute-spec", {0, 0},
                  meaning([](Rounding r, const Codes& x, std::uint32_t right, unsigned) {
                    return r == Rounding::truncate && x == Codes{200, 17, 3, 128} ? right + 1 : right;
                  }))},
      .long_only = all};
  if (all) law.subjects = {"attribute"};
  return on_cases(std::move(law), needing({face_mip_entry}), std::move(cases));
}

/// A rounding's drift: the sum of 4 mip - sum over the 4096 quadruples of codes 0..7.  Their sums are spread evenly
/// over all remainders of 8, and adding 8 to a code changes sum and mip alike.
Finding drifts(const AttributeSubject& s, Rounding r) {
  constexpr std::array<std::int64_t, 4> eighths{1, 0, -3, 4};  // of a code
  std::vector<std::uint32_t> children(4096), parents(1024);
  // The order is shuffled, so that a word's four codes belong to unrelated quadruples.
  const auto code = [](std::size_t q, unsigned child) {
    return shuffled(static_cast<std::uint32_t>(q), 12, 0) >> 3 * child & 7;
  };
  for (std::size_t q = 0; q < 4096; ++q)
    for (unsigned child = 0; child < 4; ++child)
      children[4 * (q / 4) + child] |= code(q, child) << 8 * (q % 4);
  s.functions.mips.face_mip(r, children, parents);
  std::int64_t off = 0;
  for (std::size_t q = 0; q < 4096; ++q) {
    off += 4 * static_cast<std::int64_t>(parents[q / 4] >> 8 * (q % 4) & 255);
    for (unsigned child = 0; child < 4; ++child) off -= code(q, child);
  }
  const std::int64_t expected = 4096 * 4 * eighths[static_cast<std::size_t>(r)] / 8;
  if (off != expected)
    return wrong(fmt::format("{} codes on average", static_cast<double>(expected) / 16384),
                 fmt::format("{}", static_cast<double>(off) / 16384));
  return {.answer = static_cast<std::uint64_t>(off + (1 << 20))};
}

Law mip_drift_law() {
  Cases<Rounding> cases;
  cases.count = 4;
  cases.number = [](Level, std::uint64_t k, std::uint64_t) { return static_cast<Rounding>(k); };
  cases.text = [](Level, Rounding r) { return std::string(rounding_name(r)); };
  cases.read = [](Level, const std::string& at) { return rounding_of(at, at); };
  cases.check = [](const AttributeSubject& s, Level, Rounding r) { return drifts(s, r); };
  const auto on_average = [](const char* name, Rounding of, auto by) {
    return mutant(name, "attribute", {0, 0},
                  meaning([of, by](Rounding r, const Codes& x, std::uint32_t right, unsigned) {
                    return r == of ? by(x, right) : right;
                  }));
  };
  return on_cases(
      {.id = "attribute.mip_drift",
       .says =
           "over all quadruples a mip is off by +1/8 of a code on average with halves up, 0 with halves to "
           "even, -3/8 truncated, +1/2 by two means with halves up: what a chain drifts by for each level",
       .source = "docs/ATTRIBUTE.md, \"Mips and level of detail\"",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.seconds = 0.01},
       .at_once = "all levels",
       .domain = "4 roundings, the 4096 quadruples of codes 0..7; adding 8 to a code adds 2 to mean and mip "
                 "(attribute.mip_rounding)",
       .mutants = {on_average(
           "truncated is 0 where all but one are 0", Rounding::truncate,
           [](const Codes& x, std::uint32_t right) { return x[0] + x[1] + x[2] == 0 ? 0 : right; })}},
      needing({face_mip_entry}), std::move(cases));
}

// ---- Chains

/// A chain of one rounding from a random base; number 0 has the base that every step rounds worst.
struct ChainCase {
  Rounding rounding;
  std::uint64_t number;
  std::uint64_t seed;
};

/// Four children whose mean rounds to x with the greatest error.
Codes worst_children(Rounding r, std::uint32_t x) {
  switch (r) {
    case Rounding::half_up: return {x, x, x - 1, x - 1};  // sum 4x - 2
    case Rounding::half_to_even: return x % 2 == 0 ? Codes{x, x, x - 1, x - 1} : Codes{x, x, x, x};
    case Rounding::truncate: return {x + 1, x + 1, x + 1, x};  // sum 4x + 3
    case Rounding::halves_up: break;
  }
  return {x - 1, x, x - 2, x - 1};  // x and x - 1, then x: sum 4x - 4
}

std::vector<std::uint32_t> base_of(Level n, const ChainCase& c) {
  std::vector<std::uint32_t> base(static_cast<std::size_t>(face_count(n)));
  if (c.number != 0) {
    Random random(c.seed, n, c.number);
    // Codes near each other, near a border, or any.
    const std::uint32_t range = c.number % 3 == 0   ? 0xffffffffu
                                : c.number % 3 == 1 ? 0x03030303u
                                                    : 0x01010101u;
    const std::uint32_t above = c.number % 2 == 0 || range == 0xffffffffu ? 0 : 0xfcfcfcfcu;
    for (std::uint32_t& x : base)
      x = (static_cast<std::uint32_t>(random.next()) & range) +
          (range == 0x01010101u ? above | 0x02020202u * (above != 0) : above);
    return base;
  }
  std::vector<std::uint32_t> codes{100};
  for (Level m = 0; m < n; ++m) {
    std::vector<std::uint32_t> finer;
    for (const std::uint32_t x : codes)
      for (const std::uint32_t child : worst_children(c.rounding, x)) finer.push_back(child);
    codes = std::move(finer);
  }
  for (std::size_t k = 0; k < base.size(); ++k) base[k] = codes[k] * 0x01010101u;
  return base;
}

/// 4 times the greatest error per level, upwards and downwards, of a chain made level by level.
struct ErrorBound {
  std::int64_t up, down;
};
ErrorBound quarters_a_level(Rounding r) {
  switch (r) {
    case Rounding::half_up:
    case Rounding::half_to_even: return {2, 2};
    case Rounding::truncate: return {0, 3};
    case Rounding::halves_up: break;
  }
  return {4, 0};
}

Finding chain_holds(const AttributeSubject& s, Level n, const ChainCase& c) {
  const std::vector<std::uint32_t> base = base_of(n, c);
  std::vector<std::uint32_t> chain(static_cast<std::size_t>(spec::attribute::face_chain(n)));
  Finding found;
  for (const ChainOf of : {ChainOf::level_above, ChainOf::exact_sums}) {
    if (of == ChainOf::exact_sums && c.rounding == Rounding::halves_up) continue;
    s.functions.mips.face_chain(n, c.rounding, of, base, chain);
    for (Level m = 0; m < n; ++m) {
      const auto under = static_cast<std::int64_t>(face_count(n - m));
      const auto [up, down] = quarters_a_level(c.rounding);
      // The errors count in units of 1/(4 under) of a code.
      const std::int64_t levels = of == ChainOf::level_above ? n - m : 1;
      std::int64_t above = up * levels * under, below = down * levels * under;
      if (of == ChainOf::exact_sums && c.rounding == Rounding::truncate) below = 4 * under - 1;
      for (std::size_t k = 0; k < face_count(m); ++k)
        for (unsigned which = 0; which < 4; ++which) {
          std::int64_t sum = 0;
          for (std::size_t x = k * static_cast<std::size_t>(under);
               x < (k + 1) * static_cast<std::size_t>(under); ++x)
            sum += base[x] >> 8 * which & 255;
          const std::int64_t mip = chain[spec::attribute::face_chain(m) + k] >> 8 * which & 255,
                             off = 4 * (mip * under - sum);
          found.answer +=
              Tally::digest_of(spec::attribute::face_chain(m) + k, static_cast<std::uint64_t>(mip));
          const bool worst =
              c.number == 0 && of == ChainOf::level_above && c.rounding != Rounding::half_to_even;
          if (off > above || off < -below ||
              (worst && off != (c.rounding == Rounding::truncate ? -below : above)))
            return wrong(
                fmt::format("number {} of level {} between {} below the mean and {} above{}", k, m,
                            static_cast<double>(below) / static_cast<double>(4 * under),
                            static_cast<double>(above) / static_cast<double>(4 * under),
                            worst ? ", and there" : ""),
                fmt::format("{} above, by {}", static_cast<double>(off) / static_cast<double>(4 * under),
                            of == ChainOf::level_above ? "levels" : "exact sums"));
        }
    }
  }
  return found;
}

Law mip_chain_law() {
  Cases<ChainCase> cases;
  constexpr std::uint64_t fast = 40, slow = 10'000;
  cases.count = [](Level, const Run& run) { return 4 * (run.tier == Tier::fast ? fast : slow); };
  cases.number = [](Level, std::uint64_t k, std::uint64_t seed) {
    return ChainCase{static_cast<Rounding>(k % 4), k / 4, seed};
  };
  cases.text = [](Level, const ChainCase& c) {
    return c.number == 0 ? fmt::format("{},worst", rounding_name(c.rounding))
                         : fmt::format("{},seed={},map={}", rounding_name(c.rounding), c.seed, c.number);
  };
  cases.read = [](Level, const std::string& at) {
    const Groups g = groups_of(at, "([a-z-]+),(worst|seed=(\\d+),map=(\\d+))");
    if (!g) throw BadCase(fmt::format("'{:.60}': write half-up,worst or half-up,seed=1,map=2", at));
    const Rounding r = rounding_of((*g)[1], at);
    if ((*g)[2] == "worst") return ChainCase{r, 0, 0};
    return ChainCase{r, number_of((*g)[4], at, slow), number_of((*g)[3], at, ~std::uint64_t{0} >> 8)};
  };
  cases.check = chain_holds;
  cases.chunk = 4;
  return on_cases(
      {.id = "attribute.mip_chain_error",
       .says = "d levels up a chain is off by d/2 at most with halves up or to even, 3d/4 truncated, d by "
               "two means, and a base reaches it (not with halves to even); made of exact sums, by 1/2 at "
               "most, truncated by less than 1",
       .source = "docs/ATTRIBUTE.md, \"Mips and level of detail\"",
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 8}, .seconds = 0.3},
       .domain = "random bases, and for each rounding the one that is worst",
       .mutants = {mutant(
           "one of level 4's is one more", "attribute-spec", {5, 5},
           chaining([](const Chain& real, Level n, Rounding r, ChainOf of, auto base, auto chain) {
             real(n, r, of, base, chain);
             if (n == 5 && of == ChainOf::exact_sums && chain[100] % 256 < 255) ++chain[100];
           }))}},
      needing({face_chain_entry}), std::move(cases));
}

}  // namespace

std::vector<Law> rounding_laws() {
  return {mip_rounding_law("attribute.mip_rounding", false),
          mip_rounding_law("attribute.mip_rounding_all", true), mip_drift_law(), mip_chain_law()};
}

}  // namespace mmverify::proofs::attribute
