// Maps of one state but for one node of the curve.  Their codes have a closed form, so that they are judged at
// every level without the specification's encoder.
#include "proofs/tree/checks.hpp"
#include "proofs/tree/laws.hpp"
#include "proofs/tree/mutants.hpp"

namespace mmverify::proofs::tree {
namespace {

using spec::micromap::micro_triangles;

/// The first and the last micro-triangle, those of the node's own run, and those on either side of it; not in
/// order.
std::vector<std::uint32_t> telling_indices(Level n, const OneApart& apart) {
  const std::uint64_t all = micro_triangles(n), run = micro_triangles(n - apart.depth),
                      first = apart.node * run, last = first + run - 1;
  std::vector<std::uint32_t> indices;
  for (const std::uint64_t k : {last, first, all - 1, first + run / 2, first == 0 ? last : first - 1,
                                last + 1 == all ? first : last + 1, std::uint64_t{0}})
    indices.push_back(static_cast<std::uint32_t>(k));
  return indices;
}

Finding finds(const Functions& subject, const Code& code, const Map& map,
              const std::vector<std::uint32_t>& indices) {
  Bytes states(indices.size(), 0xFF);
  subject.lookup(code, indices, states);
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (const std::uint8_t expected = state_at(map, indices[k]); states[k] != expected)
      return wrong(fmt::format("state {}", indices[k]), fmt::format("{}", expected),
                   fmt::format("{}", states[k]));
  return {hash_of(states)};
}

/// At a point inside each micro-triangle: half of one corner and a quarter of either other, which floats hold.
Finding finds_points(const Functions& subject, const Code& code, const Map& map,
                     const std::vector<std::uint32_t>& indices) {
  std::vector<float> u, v;
  const float quarter = 0.25f / static_cast<float>(spec::side(map.level));
  for (const std::uint32_t k : indices) {
    const auto c = spec::index::corners(k, map.level);
    u.push_back(static_cast<float>(2 * c[0].i + c[1].i + c[2].i) * quarter);
    v.push_back(static_cast<float>(2 * c[0].j + c[1].j + c[2].j) * quarter);
  }
  Bytes states(indices.size(), 0xFF);
  subject.point(code, u, v, states);
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (const std::uint8_t expected = state_at(map, indices[k]); states[k] != expected)
      return wrong(fmt::format("state at u={:a},v={:a}, index {},", u[k], v[k], indices[k]),
                   fmt::format("{}", expected), fmt::format("{}", states[k]));
  return {hash_of(states)};
}

Finding judged(const TreeSubject& s, Level n, const OneApart& apart) {
  const Map map = map_of(n, apart);
  const Code code = s.functions.encode(map);
  Finding found = same_map(map, s.functions.decode(code));
  const auto also = [&](const Finding& more) {
    if (!found.holds) return;
    const std::uint64_t so_far = found.answer;
    found = more;
    found.answer += 3 * so_far;
  };
  const std::vector<std::uint32_t> indices = telling_indices(n, apart);
  if (s.functions.lookup) also(finds(s.functions, code, map, indices));
  if (s.functions.point) also(finds_points(s.functions, code, map, indices));
  if (entry::stream.there(s.functions)) {
    const Bytes expected = code_of(apart), got = s.functions.bytes(code);
    if (got != expected) also(wrong("bytes", hex(expected), hex(got).substr(0, 200)));
  }
  return found;
}

Cases cases(std::function<std::uint64_t(Level)> count, std::function<OneApart(Level, std::uint64_t)> number,
            std::uint64_t chunk) {
  return {std::move(count),
          [number](const TreeSubject& s, Level n, std::uint64_t k, const Run&) {
            return judged(s, n, number(n, k));
          },
          [number](Level n, std::uint64_t k, const Run&) { return text_of(number(n, k)); },
          [](const TreeSubject& s, Level n, const std::string& at) {
            const auto apart = apart_from_text(n, at);
            if (!apart) throw BadCase(fmt::format("'{:.60}': write 4-state:0+2@3:17", at));
            return judged(s, n, *apart);
          },
          chunk};
}

constexpr char says[] =
    "round trip, lookups by index and by point, and the paper's bytes, where one node differs";
const std::vector<std::string> subjects{"tree-spec", "tree-stream", "tree-ranked", "tree-stepwise",
                                        "tree-container"};

bool is(const Map& map, Level n, const OneApart& apart) {
  return map.level == n && map.format == apart.format && map.packed == map_of(n, apart).packed;
}

constexpr Format two = Format::two_state, four = Format::four_state;

}  // namespace

Law one_apart_law() {
  Law law{.id = "tree.one_apart",
          .says = says,
          .source = succinct_4_2,
          .subjects = subjects,
          .tiers = {.fast = {0, 4}, .long_run = {0, 6}}};
  law.tiers.seconds = 0.5;
  law.domain = [](Level n) {
    return fmt::format("all maps of level {} of one state but for one node, and the uniform ones", n);
  };
  law.mutants = {mutant("UT among T merges in the last four of level 4", "tree-stream", {4, 4},
                        encodes_another([](Map& map) {
                          if (is(map, 4, {four, 0, 2, 4, 254})) map.packed.back() = 0;
                        }))};
  law = on_cases(std::move(law), {}, cases(one_apart_count, one_apart_number, 64));
  law.unfit = [fits = law.unfit](const Subject& s, Level n) -> std::optional<std::string> {
    if (n > 6) return "all its maps are run up to level 6; tree.one_apart_on_samples goes beyond";
    return fits(s, n);
  };
  return law;
}

Law one_apart_samples_law() {
  Law law{.id = "tree.one_apart_on_samples",
          .says = says,
          .source = succinct_4_2,
          .method = Method::sample,
          .subjects = {"tree-stream", "tree-ranked", "tree-stepwise", "tree-container"},
          .tiers = {.fast = {5, 12}, .long_run = {5, 12}}};
  law.tiers.seconds = 1;
  law.domain = [](Level n) {
    return fmt::format(
        "{} maps of level {} of one state but for one micro-triangle at a word's or the map's end, or for "
        "none",
        chosen_apart_count(n), n);
  };
  law.how = "sample, against the closed form";
  law.mutants = {
      mutant("the last UO among O of level 7 is lost", "tree-stream", {7, 7}, encodes_another([](Map& map) {
               if (is(map, 7, {four, 1, 3, 7, 16383})) map.packed.back() = 0x55;
             }))};
  law = on_cases(std::move(law), {}, cases(chosen_apart_count, chosen_apart, 1));
  law.unfit = [fits = law.unfit](const Subject& s, Level n) -> std::optional<std::string> {
    if (n < 5) return "tree.one_apart has all such maps there";
    return fits(s, n);
  };
  return law;
}

}  // namespace mmverify::proofs::tree
