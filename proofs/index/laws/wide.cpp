// Beyond level 16: where words of 32 bits end, and the index in words of 64.
#include "proofs/engine/spoils.hpp"
#include "proofs/index/grid/reference_sweep.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/laws.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"
#include "proofs/index/picture.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr std::uint64_t cells_per_chunk = 1 << 16, floats_per_chunk = 1 << 12, pairs = 20'000;
constexpr Level first_beyond = 17;

std::string number(std::uint64_t index) { return fmt::format("{}", index); }

Tally wide_equals_reference(const IndexSubject& s, Level n, const Run& run) {
  const Cells cells(n);
  return sweep(run, cells.size(), cells_per_chunk, [&](Chunk chunk, Tally& tally) {
    std::vector<std::uint64_t> want(cells_per_chunk), got(cells_per_chunk);
    cells.rows(chunk.begin, chunk.end, [&](const Row& row) {
      if (has(run.options, interiors_only) && row.even != Kind::interior) return;
      const std::span<std::uint64_t> w(want.data(), row.count), g(got.data(), row.count);
      reference_wide_row(n, row, w);
      s.functions.wide_index(n, row, g);
      for (const Kind kind : {Kind::vertex, Kind::edge, Kind::interior})
        if (kind == row.even || kind == row.odd) tally.count(kind, row.count_of(kind));
      const Agreement agreement = agreement_of<std::uint64_t>(row.first, w, g);
      tally.digest_sum(agreement.digest);
      for (std::uint64_t t = 0; !agreement.all && t < row.count; ++t) {
        if (w[t] == g[t]) continue;
        const GridPoint p = representative(row, t, n);
        tally.mismatch(row.kind(t), simplicity(p),
                       [&] { return at_point(p, n, number(w[t]), number(g[t])); });
      }
    });
  });
}

Replayed replay_wide(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  const std::uint64_t want = spec::index::reference_wide(p, n), got = s.functions.wide_index_at(n, p);
  // Beyond level 16 the picture is of the ancestors there: indices nest.
  const Level drawn = std::min(n, first_beyond - 1);
  const auto ancestor = [&](std::uint64_t index) {
    return static_cast<std::uint32_t>(index >> 2 * (n - drawn));
  };
  return {want == got, number(want), number(got),
          picture(drawn, p, ancestor(want), ancestor(got), Order::curve)};
}

/// The exact reference at a pair of floats.  uN has up to 2^30 beside 100 fraction bits, which 128 do not
/// hold.
std::uint64_t exact_wide(float u, float v, Level n) {
  constexpr Level fits_128 = 24;
  const auto reference = [n](const auto& p) { return spec::index::reference_wide(p, n); };
  return n <= fits_128 ? on_exact_wide(u, v, reference) : reference(RationalPoint{rational(u), rational(v)});
}

Tally wide_exact_on_floats(const IndexSubject& s, Level n, const Run& run) {
  return sweep(run, pairs, floats_per_chunk, [&](Chunk chunk, Tally& tally) {
    for (std::uint64_t sample = chunk.begin; sample < chunk.end; ++sample) {
      const FloatPair pair = stiff_floats(n, run.seed, sample);
      const RationalPoint p{rational(pair.u), rational(pair.v)};
      const std::uint64_t want = exact_wide(pair.u, pair.v, n), got = s.functions.wide_index_at(n, p);
      tally.count(Kind::interior, 1);
      tally.digest(sample, got);
      if (want != got)
        tally.mismatch(Kind::interior, simplicity(p), [&] {
          return Counterexample{simplicity(p), n, case_text(p, n), hex_text(p), number(want), number(got)};
        });
    }
  });
}

/// At level 17 words of 32 bits fail in two ways.  The v-corner's index, 4^17-1, does not fit them.  And at
/// (0, 1/2), digits 3222...2, bit 16 of the prefix XOR should come down to bit 0 and does not reach it, so
/// that not even the index's low 32 bits are right.
struct Beyond {
  GridPoint point;
  std::uint64_t bits;  ///< of the index that are wrong there, some of them
};
constexpr std::array beyond{
    Beyond{{coordinate(0, first_beyond), coordinate(corner(first_beyond), first_beyond)}, ~std::uint64_t{0}},
    Beyond{{coordinate(0, first_beyond), coordinate(corner(first_beyond) / 2, first_beyond)}, 0xffffffff}};

Tally ends_at_16(const IndexSubject& s, Level n, const Run& run) {
  Tally tally(run.errors);
  std::uint64_t case_number = 0;
  for (const auto& [point, bits] : beyond) {
    const RationalPoint p = rational(point);
    const std::uint64_t want = spec::index::reference_wide(p, n) & bits,
                        got = s.functions.wide_index_at(n, p) & bits;
    tally.count(kind_of(p, n), 1);
    tally.digest(case_number++, got);
    if (got == want)
      tally.mismatch(kind_of(p, n), simplicity(point),
                     [&, &at = point] { return at_point(at, n, fmt::format("not {}", want), number(got)); });
  }
  return tally;
}

/// (level, point, true answer) -> answer.
using WideChange = std::function<std::uint64_t(Level, const RationalPoint&, std::uint64_t)>;

/// A built-in subject whose answers in 64-bit words are changed.
Mutant wide_mutant(const char* name, const char* base, Levels levels, const WideChange& change) {
  return mutant(name, base, levels, [&](Functions& f) {
    f.max_wide_level = 30;
    spoils(&Functions::wide_index, [change](Level n, const Row& row, std::span<std::uint64_t> out) {
      for (std::uint64_t t = 0; t < row.count; ++t)
        out[t] = change(n, rational(representative(row, t, n)), out[t]);
    })(f);
    spoils(&Functions::wide_index_at, [change](Level n, const RationalPoint& p, std::uint64_t& answer) {
      answer = change(n, p, answer);
    })(f);
  });
}

WideChange wrong_at(Level level, RationalPoint where) {
  return [=](Level n, const RationalPoint& p, std::uint64_t index) {
    return n == level && p.u == where.u && p.v == where.v ? index ^ 1 : index;
  };
}

RationalPoint at(std::int64_t ku, std::int64_t kv, Level n) {
  return rational(GridPoint{coordinate(ku, n), coordinate(kv, n)});
}

/// The subject has an index in 64-bit words, and its rows or its points go as far as the level.
Unfit needing_wide(Level last) {
  return [last](const Subject& subject, Level n) -> std::optional<std::string> {
    const auto* s = dynamic_cast<const IndexSubject*>(&subject);
    if (s == nullptr || !entry::wide_index.there(s->functions))
      return subject.name() + " has no index in 64-bit words";
    const Level highest = last == 0 ? s->functions.max_wide_level : last;
    if (n <= highest) return std::nullopt;
    return fmt::format("{}'s domain ends at level {}", s->name(), highest);
  };
}

Law wide_equals_reference_law() {
  return {.id = "index.wide_equals_reference",
          .says = "the subject's index in 64-bit words is that of the reference in 64-bit words",
          .source =
              "VK_EXT_opacity_micromap, appendix \"Reference Code\"; docs/SOUNDNESS.md, \"Beyond level 16\"",
          .subjects = {"impl", "step"},
          .tiers = {.fast = {0, 9}, .long_run = {0, 12}, .seconds = 1},
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing_wide(0),
          .divisible = true,
          .judge = judged_by(wide_equals_reference),
          .replay = replayed_by(replay_wide),
          .mutants = {wide_mutant("one vertex of level 7", "impl", {7, 7},
                                  wrong_at(7, at(corner(7) / 2, corner(7) / 4, 7))),
                      wide_mutant("the v-corner of level 6, the last cell", "step", {6, 6},
                                  wrong_at(6, at(0, corner(6), 6))),
                      wide_mutant(
                          "words of 16 bits", "impl", {0, 9},
                          [](Level, const RationalPoint&, std::uint64_t index) { return index & 0xffff; })},
          .heeds = {&interiors_only},
          .companion = "index.wide_exact_on_floats"};
}

Law wide_exact_on_floats_law() {
  return {.id = "index.wide_exact_on_floats",
          .says =
              "for binary32 numbers the index in 64-bit words is that of the exact reference for those very "
              "numbers",
          .source =
              "VK_EXT_opacity_micromap, appendix \"Reference Code\"; docs/SOUNDNESS.md, \"Beyond level 16\"",
          .method = Method::sample,
          .subjects = {"impl"},
          .tiers = {.fast = {first_beyond, 30}, .long_run = {0, 30}, .seconds = 3},
          .cases = pairs,
          .domain = fmt::format("{} stiff pairs of binary32 numbers", pairs),
          .how = by_sample,
          .unfit = needing_wide(30),
          .divisible = true,
          .judge = judged_by(wide_exact_on_floats),
          .replay = replayed_by(replay_wide),
          .mutants = {wide_mutant("bit 33 of the index is lost", "impl", {17, 20},
                                  [](Level, const RationalPoint&, std::uint64_t index) {
                                    return index & ~(std::uint64_t{1} << 33);
                                  }),
                      wide_mutant("words of 32 bits", "reference", {17, 17},
                                  [](Level, const RationalPoint&, std::uint64_t index) { return index; }),
                      wide_mutant("one off where u is above 3/4, at level 30", "impl", {30, 30},
                                  [](Level, const RationalPoint& p, std::uint64_t index) {
                                    return index +
                                           (p.u > Rational(spec::Integer(3), spec::Integer(4)) ? 1 : 0);
                                  })}};
}

Law ends_at_16_law() {
  return {
      .id = "index.vulkan_ends_at_16",
      .says =
          "in 32-bit words the reference is wrong at level 17: the last index does not fit, and bit 16 "
          "of the prefix XOR does not come down to bit 0",
      .source = vulkan,
      .method = Method::witness,
      .subjects = {"reference"},
      .tiers = {.fast = {first_beyond, first_beyond}, .long_run = {first_beyond, first_beyond}, .seconds = 1},
      .cases = beyond.size(),
      .domain = fmt::format("{} given points", beyond.size()),
      .how = by_witness,
      .unfit = [fits = needing_wide(0)](const Subject& s, Level n) -> std::optional<std::string> {
        if (n != first_beyond) return "it is about level 17";
        return fits(s, n);
      },
      .judge = judged_by(ends_at_16),
      .mutants = {{"64-bit words", built_in("reference-wide"), {first_beyond, first_beyond}},
                  wide_mutant("right at the v-corner", "reference", {first_beyond, first_beyond},
                              [](Level n, const RationalPoint& p, std::uint64_t index) {
                                return p.v == at(0, corner(n), n).v ? spec::index::reference_wide(p, n)
                                                                    : index;
                              }),
                  wide_mutant(
                      "a prefix XOR that reaches, in 32-bit words", "reference-wide",
                      {first_beyond, first_beyond},
                      [](Level, const RationalPoint&, std::uint64_t index) { return index & 0xffffffff; })},
      .general = false};
}

}  // namespace

std::vector<Law> wide_laws() {
  return {wide_equals_reference_law(), wide_exact_on_floats_law(), ends_at_16_law()};
}

}  // namespace mmverify::proofs::index
