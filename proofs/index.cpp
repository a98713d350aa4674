// The laws of topic index.
#include "proofs/index.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "proofs/index/altered.hpp"
#include "proofs/index/false_claims.hpp"
#include "proofs/index/judges.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr Level highest = 16;
constexpr char vulkan[] = "VK_EXT_opacity_micromap, appendix \"Reference Code\"";
constexpr char succinct_4_3[] = "Succinct Opacity Micromaps, 4.3, Algorithm 4";
constexpr char succinct_a[] = "Succinct Opacity Micromaps, Appendix A";
constexpr char attribute_4[] = "Color and Attribute Micromaps, 4.1, figure 4";

const IndexSubject& of_index(const Subject& s) { return dynamic_cast<const IndexSubject&>(s); }

using Judge = Tally (*)(const IndexSubject&, Level, const Run&);
using Replay = Replayed (*)(const IndexSubject&, Level, const std::string&);

std::function<Tally(const Subject&, Level, const Run&)> judged_by(Judge judge) {
  return [judge](const Subject& s, Level n, const Run& run) { return judge(of_index(s), n, run); };
}
std::function<Replayed(const Subject&, Level, const std::string&)> replayed_by(Replay replay) {
  return [replay](const Subject& s, Level n, const std::string& at) { return replay(of_index(s), n, at); };
}

// --- closed forms
// -----------------------------------------------------------------------------------------------------

std::uint64_t all_cells(Level n, Tier) { return cell_count(n); }
std::uint64_t next_cells(Level n, Tier) { return cell_count(n + 1); }
std::uint64_t all_triangles(Level n, Tier) { return triangle_count(n); }
std::uint64_t hard_pairs(Level, Tier tier) { return tier == Tier::fast ? 1'000'000 : 10'000'000; }
std::uint64_t rational_points(Level, Tier tier) { return tier == Tier::fast ? 1'000 : 100'000; }

// --- domains in words
// -------------------------------------------------------------------------------------------------

std::string points(const Subject& subject, Level n) {
  const IndexSubject& s = of_index(subject);
  if (s.exact()) return "every rational point of the triangle, by its 3N^2+3N+1 cells";
  const bool representable = s.arithmetic() != Arithmetic::binary16 || n + 2 <= 11;
  return fmt::format("the 3N^2+3N+1 representatives, {} {} numbers", representable ? "as" : "rounded to",
                     to_string(s.arithmetic()));
}
std::string next_points(const Subject& s, Level n) { return points(s, n + 1) + " of level n+1"; }
std::string triangles(const Subject& subject, Level) {
  return of_index(subject).exact() ? "the 4^n open micro-triangles"
                                   : "one point inside each of the 4^n micro-triangles";
}
std::string indices(const Subject&, Level) { return "the 4^n indices"; }
std::string floats(const Subject& s, Level) {
  return fmt::format("a sample of binary32 pairs near what breaks index functions{}",
                     of_index(s).arithmetic() == Arithmetic::binary16 ? ", rounded to binary16" : "");
}
std::string rationals(const Subject&, Level) { return "a sample of rational points inside cells"; }

// --- methods in words
// -------------------------------------------------------------------------------------------------

std::string in_fixed_point(const Subject& s, Level) {
  return s.exact() ? "exhaustive, 64-bit fixed point" : "exhaustive, against 64-bit fixed point";
}
std::string in_rationals_then_fixed_point(const Subject& s, Level n) {
  return s.exact() && n <= rational_levels ? "exhaustive, rationals" : in_fixed_point(s, n);
}
std::string exhaustively(const Subject&, Level) { return "exhaustive"; }
std::string by_sample(const Subject&, Level) { return "sample, against exact arithmetic"; }
std::string by_witness(const Subject&, Level) { return "witness, against exact arithmetic"; }

// --- who fits
// ---------------------------------------------------------------------------------------------------------

using Unfit = std::function<std::optional<std::string>(const Subject&, Level)>;

/// The subject has the entry points and is defined `above` levels further.
Unfit needing(std::vector<Entry> entries, Level above = 0) {
  return [=](const Subject& subject, Level n) -> std::optional<std::string> {
    const auto* s = dynamic_cast<const IndexSubject*>(&subject);
    if (s == nullptr) return "not a subject of topic index";
    constexpr const char* names[] = {"barycentrics -> index", "index -> corners", "barycentrics -> row order",
                                     "row order -> corners"};
    for (const Entry e : entries)
      if (!s->has(e))
        return fmt::format("{} has no entry point {}", s->name(), names[static_cast<std::size_t>(e)]);
    if (n + above > s->max_level())
      return fmt::format("{} is defined up to level {}", s->name(), s->max_level());
    return std::nullopt;
  };
}

Unfit needing_exact(std::vector<Entry> entries) {
  return [fits = needing(std::move(entries))](const Subject& subject, Level n) -> std::optional<std::string> {
    if (!subject.exact()) return subject.name() + " does not compute in exact arithmetic";
    return fits(subject, n);
  };
}

// --- mutants
// ----------------------------------------------------------------------------------------------------------

std::shared_ptr<const IndexSubject> the(const char* name) { return built_in_subject(name); }

/// One answer of one level, one bit off: as small as a mistake gets.
Mutant single(const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv,
              std::uint32_t flip = 1) {
  return {name, altered(name, the(base), only_at_point(level, ku, kv, level, flip)), {level, level}};
}

Mutant on_points(const char* name, const char* base, Levels levels,
                 std::function<std::uint32_t(Level, const GridPoint&, std::uint32_t)> change,
                 bool on_rationals = true) {
  return {name, altered(name, the(base), {std::move(change), {}, {}, on_rationals}), levels};
}

Mutant on_indices(const char* name, const char* base, Levels levels,
                  std::function<Corners(Level, std::uint32_t, Corners)> change) {
  return {name, altered(name, the(base), {{}, {}, std::move(change), true}), levels};
}

Mutant only_rationals_right(Mutant single_point, const char* base, Level level, std::int64_t ku,
                            std::int64_t kv) {
  Alteration a = only_at_point(level, ku, kv, level, 1);
  a.on_rationals = false;
  single_point.subject = altered(single_point.name, the(base), std::move(a));
  return single_point;
}

/// Whether the point is on a line u = i/N of the level.
bool on_u_line(const GridPoint& p, Level n) {
  return times(side(n), p.u) == Fixed64(whole(times(side(n), p.u)));
}

// v-corner of level n as grid units of 1/4N, and the middle vertex.
constexpr std::int64_t corner(Level n) { return std::int64_t{4} << n; }

std::vector<Mutant> wrong_on_cells(const char* base) {
  return {single("one vertex of level 7", base, 7, corner(7) / 2, corner(7) / 4),
          single("the v-corner of level 6, the last cell", base, 6, 0, corner(6)),
          on_points("u ties round down at level 5", base, {0, 5},
                    [base_subject = the(base)](Level n, const GridPoint& p, std::uint32_t answer) {
                      if (n != 5 || !on_u_line(p, n) || p.u == Fixed64(0) || p.u + p.v == Fixed64(1))
                        return answer;
                      const GridPoint left{Fixed64::from_raw(p.u.raw() - 1), p.v};
                      std::uint32_t rounded_down = 0;
                      base_subject->index(n, Batch{{&left, 1}, false}, {&rounded_down, 1});
                      return rounded_down;
                    }),
          on_points("children 0 and 2 change places below level 4", base, {0, 6},
                    [](Level n, const GridPoint&, std::uint32_t answer) {
                      return n > 4 && answer % 2 == 0 ? answer ^ 2 : answer;
                    })};
}

/// wrong_on_cells, but for the one that is wrong in the same way everywhere.
std::vector<Mutant> inconsistent_on_cells(const char* base) {
  std::vector<Mutant> mutants = wrong_on_cells(base);
  mutants.pop_back();
  return mutants;
}

// --- the laws
// ---------------------------------------------------------------------------------------------------------

Law equals_reference_law() {
  return {.id = "index.equals_reference",
          .topic = "index",
          .says = "the subject's index is that of the Vulkan reference",
          .source = vulkan,
          .method = Method::exhaustive,
          .subjects = {"step", "reference-wide", "impl"},
          .fast = {0, 11},
          .long_run = {0, 16},
          .fast_seconds = 5,
          .cases = all_cells,
          .domain = points,
          .how = in_rationals_then_fixed_point,
          .unfit = needing({Entry::index}),
          .judge = judged_by(equals_reference),
          .replay = replayed_by(replay_equals_reference),
          .mutants = wrong_on_cells("step"),
          .general = true,
          .float_companion = "index.exact_on_floats"};
}

Law in_range_law() {
  return {.id = "index.in_range",
          .topic = "index",
          .says = "the index is below 4^n",
          .source = vulkan,
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 10},
          .long_run = {0, 15},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing({Entry::index}),
          .judge = judged_by(in_range),
          .replay = replayed_by(replay_in_range),
          .mutants = {single("one vertex of level 7 leaves the range", "reference", 7, corner(7) / 2,
                             corner(7) / 4, 1u << 14),
                      single("the v-corner of level 5 is 4^5", "step", 5, 0, corner(5), 1u << 10),
                      on_points("the hypotenuse of level 6 has a row of its own", "reference", {0, 6},
                                [](Level n, const GridPoint& p, std::uint32_t answer) {
                                  return n == 6 && p.u + p.v == Fixed64(1) ? answer + (1u << 12) : answer;
                                })},
          .general = true,
          .float_companion = {}};
}

Law bijective_law() {
  return {.id = "index.bijective",
          .topic = "index",
          .says = "each index below 4^n belongs to exactly one micro-triangle",
          .source = vulkan,
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 10},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = all_triangles,
          .domain = triangles,
          .how = in_fixed_point,
          .unfit = needing({Entry::index}),
          .judge = judged_by(bijective),
          .replay = replayed_by(replay_bijective),
          .mutants = {single("one micro-triangle of level 7 takes its sibling's index", "reference", 7,
                             4 * 20 + 1, 4 * 30 + 1),
                      single("the last micro-triangle of level 5 leaves the range", "step", 5, 1,
                             corner(5) - 3, 1u << 10),
                      on_points("child 3 is taken for child 2 at level 6", "reference", {0, 6},
                                [](Level n, const GridPoint&, std::uint32_t answer) {
                                  return n == 6 && answer % 4 == 3 ? answer - 1 : answer;
                                })},
          .general = true,
          .float_companion = {}};
}

Law nested_law() {
  return {.id = "index.nested",
          .topic = "index",
          .says = "the index at level n+1, divided by 4, is the index at level n, ties included",
          .source = "Succinct Opacity Micromaps, 4.3; Algorithm 3 needs it",
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 9},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = next_cells,
          .domain = next_points,
          .how = in_fixed_point,
          .unfit = needing({Entry::index}, 1),
          .judge = judged_by(nested),
          .replay = replayed_by(replay_nested),
          .mutants = {single("one vertex of level 7 falls into the next parent", "step", 7, corner(7) / 2,
                             corner(7) / 4, 4),
                      single("one edge of level 6 falls into the next parent", "reference", 6,
                             corner(6) / 4 + 2, corner(6) / 4, 4),
                      on_points("order of the first digit changes from level 6 on", "reference", {0, 7},
                                [](Level n, const GridPoint&, std::uint32_t answer) {
                                  return n >= 6 ? answer ^ (2u << (2 * n - 2)) : answer;
                                })},
          .general = true,
          .float_companion = {}};
}

Law contiguous_law() {
  return {
      .id = "index.contiguous",
      .topic = "index",
      .says =
          "consecutive micro-triangles share an edge; where the highest differing digit steps from 2 to 3, "
          "one vertex only",
      .source = "Succinct Opacity Micromaps, figure 2",
      .method = Method::exhaustive,
      .subjects = {"reference", "step", "impl"},
      .fast = {0, 9},
      .long_run = {0, 12},
      .fast_seconds = 1,
      .cases = all_triangles,
      .domain = triangles,
      .how = in_fixed_point,
      .unfit = needing({Entry::index}),
      .judge = judged_by(contiguous),
      .replay = replayed_by(replay_contiguous),
      .mutants = {on_points("two neighbours of level 7 change places", "reference", {7, 7},
                            [](Level n, const GridPoint&, std::uint32_t answer) {
                              return n == 7 && (answer == 8000 || answer == 8001) ? answer ^ 1 : answer;
                            }),
                  single("one micro-triangle of level 6 is one ahead", "step", 6, 4 * 11 + 3, 4 * 13 + 3, 1),
                  on_points("children 0 and 2 change places below level 4", "reference", {0, 6},
                            [](Level n, const GridPoint&, std::uint32_t answer) {
                              return n > 4 && answer % 2 == 0 ? answer ^ 2 : answer;
                            })},
      .general = true,
      .float_companion = {}};
}

Law inverse_law() {
  return {.id = "index.inverse",
          .topic = "index",
          .says = "the corners of an index span a micro-triangle, and the points inside it have that index",
          .source = succinct_4_3,
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 9},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = all_triangles,
          .domain = indices,
          .how = exhaustively,
          .unfit = needing({Entry::index, Entry::corners}),
          .judge = judged_by(inverse),
          .replay = replayed_by(replay_inverse),
          .mutants = {on_indices("one corner of one index of level 7 is off", "impl", {7, 7},
                                 [](Level n, std::uint32_t k, Corners c) {
                                   if (n == 7 && k == 9999) ++c[1].i;
                                   return c;
                                 }),
                      on_indices("the last index of level 5 gets the corners of the one before", "reference",
                                 {0, 5},
                                 [](Level n, std::uint32_t k, Corners c) {
                                   return n == 5 && k == 1023 ? spec::index::corners(1022, 5) : c;
                                 }),
                      on_points("the index of one micro-triangle of level 6 is off", "step", {6, 6},
                                [](Level n, const GridPoint&, std::uint32_t answer) {
                                  return n == 6 && answer == 1234 ? answer + 1 : answer;
                                })},
          .general = true,
          .float_companion = {}};
}

Law corners_law() {
  return {.id = "index.corners",
          .topic = "index",
          .says = "the corners of an index are those of the specification, in the order of children 0, 2, 3",
          .source = succinct_4_3,
          .method = Method::exhaustive,
          .subjects = {"impl"},
          .fast = {0, 10},
          .long_run = {0, 15},
          .fast_seconds = 0.5,
          .cases = all_triangles,
          .domain = indices,
          .how = exhaustively,
          .unfit = needing({Entry::corners}),
          .judge = judged_by(corners_in_order),
          .replay = replayed_by(replay_corners_in_order),
          .mutants = {{"two corners of one index of level 7 change places",
                       altered("two corners of one index of level 7 change places", the("impl"),
                               only_at_index(7, 7777)),
                       {7, 7}},
                      {"two corners of the last index of level 6 change places",
                       altered("two corners of the last index of level 6 change places", the("impl"),
                               only_at_index(6, 4095)),
                       {6, 6}},
                      on_indices("u and v change places", "impl", {0, 3},
                                 [](Level, std::uint32_t, Corners c) {
                                   for (auto& vertex : c) std::swap(vertex.i, vertex.j);
                                   return c;
                                 })},
          .general = true,
          .float_companion = {}};
}

Law rounding_law() {
  return {.id = "index.rounding",
          .topic = "index",
          .says =
              "a point of a grid line belongs to the micro-triangle on its +u, +v side; on the hypotenuse to "
              "that on "
              "its -u side, at the v-corner to the last",
          .source = "Succinct Opacity Micromaps, Appendix A (3): rounds globally away from w",
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 9},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing({Entry::index}),
          .judge = judged_by(rounding),
          .replay = replayed_by(replay_rounding),
          .mutants = inconsistent_on_cells("reference"),
          .general = true,
          .float_companion = "index.exact_on_floats"};
}

Law exact_on_floats_law() {
  const auto wrong_at = [](const char* name, const char* base, Level level, float u, float v) {
    return Mutant{name,
                  altered(name, the(base),
                          {{},
                           [=](Level n, float pu, float pv, std::uint32_t answer) {
                             return n == level && pu == u && pv == v ? answer ^ 1 : answer;
                           },
                           {},
                           true}),
                  {level, level}};
  };
  return {
      .id = "index.exact_on_floats",
      .topic = "index",
      .says = "for binary32 numbers the index is that of the exact reference for those very numbers",
      .source = vulkan,
      .method = Method::sample,
      .subjects = {"step", "impl"},
      .fast = {0, 16},
      .long_run = {0, 16},
      .fast_seconds = 12,
      .cases = hard_pairs,
      .domain = floats,
      .how = by_sample,
      .unfit = needing({Entry::index}),
      .judge = [](const Subject& s, Level n,
                  const Run& run) { return exact_on_floats(of_index(s), n, run, hard_pairs(n, run.tier)); },
      .replay = replayed_by(replay_equals_reference),
      .mutants = {wrong_at("one pair of level 9, an ulp under the hypotenuse", "impl", 9, 0.5f,
                           0x1.fffffep-2f),
                  {"the reference in binary32", the("reference-f32"), {4, 8}},
                  {"the step algorithm in binary32", the("step-f32"), {4, 4}},
                  wrong_at("the least subnormal number is taken for another", "impl", 12, 0x1p-149f, 0.5f)},
      .general = true,
      .float_companion = {}};
}

Law cells_decide_law() {
  return {
      .id = "index.cells_decide",
      .topic = "index",
      .says = "every rational point inside a cell has the index of the cell's representative",
      .source = "docs/SOUNDNESS.md, \"Why cells prove all rationals\"",
      .method = Method::sample,
      .subjects = {"reference", "step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names"},
      .fast = {0, 16},
      .long_run = {0, 16},
      .fast_seconds = 3,
      .cases = rational_points,
      .domain = rationals,
      .how = by_sample,
      .unfit = needing_exact({Entry::index}),
      .judge = [](const Subject& s, Level n,
                  const Run& run) { return cells_decide(of_index(s), n, run, rational_points(n, run.tier)); },
      .replay = {},
      .mutants = {single("one interior representative of level 4", "reference", 4, 1, corner(4) - 3),
                  single("one edge's representative of level 5", "step", 5, 4 * 3 + 2, 4 * 5),
                  on_points("representatives of level 9 only", "step", {9, 9},
                            [](Level n, const GridPoint&, std::uint32_t answer) {
                              return n == 9 ? answer ^ 1 : answer;
                            })},
      .general = true,
      .float_companion = {}};
}

Law fixed_is_rational_law() {
  const auto off = [](const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv) {
    return only_rationals_right({name, nullptr, {level, level}}, base, level, ku, kv);
  };
  return {
      .id = "index.fixed_is_rational",
      .topic = "index",
      .says = "64-bit fixed point gives the answers of rational arithmetic",
      .source = "docs/SOUNDNESS.md, \"No sum overflows\"",
      .method = Method::exhaustive,
      .subjects = {"reference", "step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names"},
      .fast = {0, 7},
      .long_run = {0, 8},
      .fast_seconds = 3,
      .cases = all_cells,
      .domain = points,
      .how = in_fixed_point,
      .unfit = needing_exact({Entry::index}),
      .judge = judged_by(fixed_is_rational),
      .replay = {},
      .mutants = {off("one vertex of level 6", "step", 6, corner(6) / 4, corner(6) / 2),
                  off("one interior point of level 5", "reference", 5, 4 * 7 + 3, 4 * 9 + 3),
                  on_points(
                      "a fraction bit is lost from level 4 on", "reference", {0, 5},
                      [](Level n, const GridPoint& p, std::uint32_t answer) {
                        if (n < 4) return answer;
                        const auto even = [n](const Fixed64& q) {
                          const std::int64_t lost = std::int64_t{1} << (Fixed64::fraction_bits - n - 1);
                          return Fixed64::from_raw(q.raw() & ~lost);
                        };
                        return spec::index::reference(GridPoint{even(p.u), even(p.v)}, n);
                      },
                      false)},
      .general = true,
      .float_companion = {}};
}

Law sweep_is_spec_law() {
  const auto in_rows_only = [](const char* name, Level level, std::int64_t ku, std::int64_t kv) {
    return Mutant{
        name, altered_in_rows(name, the("step"), only_at_point(level, ku, kv, level, 1)), {level, level}};
  };
  return {
      .id = "index.sweep_is_spec",
      .topic = "index",
      .says = "a row of points answered at once gets the answers that Algorithm 4 gives each of them alone",
      .source = "docs/SOUNDNESS.md, \"Rows\"",
      .method = Method::exhaustive,
      .subjects = {"step"},
      .fast = {0, 10},
      .long_run = {0, 14},
      .fast_seconds = 1,
      .cases = all_cells,
      .domain = points,
      .how = in_fixed_point,
      .unfit = needing_exact({Entry::index}),
      .judge = judged_by(sweep_is_spec),
      .replay = {},
      .mutants = {in_rows_only("one vertex of level 7", 7, corner(7) / 2, corner(7) / 4),
                  in_rows_only("the first cell of level 6", 6, 0, 0),
                  in_rows_only("the last cell of level 8", 8, 0, corner(8))},
      .general = true,
      .float_companion = {}};
}

Law row_order_law() {
  return {.id = "index.row_order",
          .topic = "index",
          .says = "the subject's row-order index is that of figure 4 in exact arithmetic",
          .source = attribute_4,
          .method = Method::exhaustive,
          .subjects = {"impl"},
          .fast = {0, 10},
          .long_run = {0, 15},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing({Entry::row_index}),
          .judge = judged_by(row_order),
          .replay = replayed_by(replay_row_order),
          .mutants = {single("one vertex of level 7", "impl", 7, corner(7) / 2, corner(7) / 4),
                      single("the u-corner of level 5", "impl", 5, corner(5), 0, 2),
                      on_points("the hypotenuse of level 6 falls into the next column", "impl", {0, 6},
                                [](Level n, const GridPoint& p, std::uint32_t answer) {
                                  return n == 6 && p.u + p.v == Fixed64(1) ? answer ^ 1 : answer;
                                })},
          .general = true,
          .float_companion = {}};
}

Law row_corners_law() {
  return {.id = "index.row_corners",
          .topic = "index",
          .says = "the corners of a row-order index are those of figure 4 with a root in whole numbers",
          .source = attribute_4,
          .method = Method::exhaustive,
          .subjects = {"impl", "w-minor-f64"},
          .fast = {0, 11},
          .long_run = {0, 16},
          .fast_seconds = 1,
          .cases = all_triangles,
          .domain = indices,
          .how = exhaustively,
          .unfit = needing({Entry::row_corners}),
          .judge = judged_by(row_corners),
          .replay = replayed_by(replay_row_corners),
          .mutants = {{"the root in binary32", the("w-minor-f32"), {13, 13}},
                      {"two corners of one index of level 7 change places",
                       altered("two corners of one index of level 7 change places", the("impl"),
                               only_at_index(7, 127 * 127)),
                       {7, 7}},
                      on_indices("the last index of a row goes to the next", "w-minor", {0, 6},
                                 [](Level n, std::uint32_t k, Corners c) {
                                   return n == 6 && k == 50 * 50 - 1 ? spec::index::w_minor_corners(k + 1)
                                                                     : c;
                                 })},
          .general = true,
          .float_companion = {}};
}

Law row_holds_point_law() {
  return {.id = "paper.w_minor_holds_point",
          .topic = "index",
          .says = "the micro-triangle that figure 4 gives holds the point, on every line of the grid",
          .source = attribute_4,
          .method = Method::exhaustive,
          .subjects = {"w-minor"},
          .fast = {0, 9},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing({Entry::row_index}),
          .judge = judged_by(row_holds_point),
          .replay = replayed_by(replay_row_holds_point),
          .mutants = {single("one point inside a micro-triangle of level 7", "w-minor", 7, 4 * 20 + 1,
                             4 * 30 + 1),
                      single("the w-corner of level 5 is in row 1", "w-minor", 5, 0, 0),
                      on_points("column and diagonal round apart on u lines of level 6", "w-minor", {0, 6},
                                [](Level n, const GridPoint& p, std::uint32_t answer) {
                                  return n == 6 && on_u_line(p, n) ? answer + 1 : answer;
                                })},
          .general = true,
          .float_companion = {}};
}

Law step_claim_law() {
  Law law = equals_reference_law();
  law.id = "paper.step_equals_reference";
  law.says =
      "Algorithm 4 as printed equals the reference, which the paper proved up to level 15 and not at 16";
  law.source = succinct_4_3;
  law.subjects = {"step"};
  law.fast = {0, 10};
  law.long_run = {0, 16};
  law.fast_seconds = 3;
  law.general = false;
  law.float_companion = {};
  return law;
}

Law differs_law(const char* id, const char* says, const char* source, const char* reading,
                std::vector<Difference> stated) {
  const auto repaired = [&](Level level) {
    const Difference& last = stated.back();
    const GridPoint where{coordinate(last.ku, last.from_level), coordinate(last.kv, last.from_level)};
    return on_points("right at its simplest wrong point of level 6", reading, {level, level},
                     [=](Level n, const GridPoint& p, std::uint32_t answer) {
                       return n == level && p.u == where.u && p.v == where.v ? spec::index::reference(p, n)
                                                                             : answer;
                     });
  };
  return {.id = id,
          .topic = "index",
          .says = says,
          .source = source,
          .method = Method::exhaustive,
          .subjects = {reading},
          .fast = {0, 7},
          .long_run = {0, 8},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_rationals_then_fixed_point,
          .unfit = needing({Entry::index}),
          .judge = [stated](const Subject& s, Level n,
                            const Run& run) { return differs_first(of_index(s), n, run, stated); },
          .replay = {},
          .mutants = {repaired(6),
                      {"the reading without its difference", the("step"), {0, 2}},
                      single("one more wrong vertex, at level 1", reading, 1, 4, 0)},
          .general = false,
          .float_companion = {}};
}

Law floats_err_law() {
  const auto right_at_7 = [](const char* name, const char* base) {
    return on_points(name, base, {7, 7}, [](Level n, const GridPoint& p, std::uint32_t answer) {
      return n == 7 ? spec::index::reference(p, n) : answer;
    });
  };
  return {.id = "index.rounded_arithmetic_errs",
          .topic = "index",
          .says =
              "neither algorithm is exact in binary16, binary32 or binary64: each misplaces one of two given "
              "points",
          .source = "docs/ERRATA.md, \"In rounded arithmetic\"",
          .method = Method::witness,
          .subjects = {"reference-f16", "reference-f32", "reference-f64", "step-f16", "step-f32", "step-f64"},
          .fast = {1, 10},
          .long_run = {1, 10},
          .fast_seconds = 0.1,
          .cases = [](Level, Tier) -> std::uint64_t { return 1; },
          .domain = [](const Subject&, Level) { return std::string("two points"); },
          .how = by_witness,
          .unfit = needing({Entry::index}),
          .judge = judged_by(floats_err),
          .replay = {},
          .mutants = {right_at_7("binary16 with a guard at level 7", "reference-f16"),
                      {"impl, which compares without a sum", the("impl"), {1, 1}},
                      {"exact arithmetic", the("reference"), {5, 5}}},
          .general = false,
          .float_companion = {}};
}

Law binary32_root_law() {
  constexpr std::uint32_t first_wrong = 4097 * 4097 - 2;
  return {.id = "paper.w_minor_binary32_root_errs",
          .topic = "index",
          .says = "figure 4's row of an index, rooted in binary32, is right below 4097^2-2 and wrong there",
          .source = attribute_4,
          .method = Method::exhaustive,
          .subjects = {"w-minor-f32"},
          .fast = {10, 13},
          .long_run = {0, 16},
          .fast_seconds = 3,
          .cases = all_triangles,
          .domain = indices,
          .how = exhaustively,
          .unfit = needing({Entry::row_corners}),
          .judge = judged_by(binary32_root_errs),
          .replay = {},
          .mutants = {{"the root in binary64", the("w-minor-f64"), {13, 13}},
                      on_indices("one more wrong index, at level 8", "w-minor-f32", {8, 8},
                                 [](Level n, std::uint32_t k, Corners c) {
                                   return n == 8 && k == 40'000 ? spec::index::w_minor_corners(k + 1) : c;
                                 }),
                      on_indices("right at the first wrong index", "w-minor-f32", {13, 13},
                                 [](Level, std::uint32_t k, Corners c) {
                                   return k == first_wrong ? spec::index::w_minor_corners(k) : c;
                                 })},
          .general = false,
          .float_companion = {}};
}

}  // namespace

std::vector<Law> laws() {
  return {
      equals_reference_law(),
      in_range_law(),
      bijective_law(),
      nested_law(),
      contiguous_law(),
      inverse_law(),
      corners_law(),
      rounding_law(),
      exact_on_floats_law(),
      floats_err_law(),
      cells_decide_law(),
      fixed_is_rational_law(),
      sweep_is_spec_law(),
      row_order_law(),
      row_corners_law(),
      step_claim_law(),
      differs_law(
          "paper.appendix_middle_differs",
          "with the middle triangle's coordinates in Appendix A's order, Algorithm 4 is not the reference",
          succinct_a, "step-appendix-middle", {{2, 6, 2, 7, 4}, {3, 8, 8, 20, 23}}),
      differs_law("paper.appendix_ties_differ",
                  "with the R test's exception on u = 1/2, as Appendix A's prose has it, Algorithm 4 is not "
                  "the reference",
                  succinct_a, "step-appendix-ties", {{2, 6, 6, 6, 5}}),
      differs_law(
          "paper.appendix_names_differ",
          "with the coordinates that Appendix A gives under L, R and T, Algorithm 4 is not the reference",
          succinct_a, "step-appendix-names", {{2, 0, 8, 14, 15}}),
      row_holds_point_law(),
      binary32_root_law()};
}

}  // namespace mmverify::proofs::index
