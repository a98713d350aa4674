#include "proofs/index/diagnosis.hpp"

#include "proofs/index/children_inside.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/known_orders.hpp"
#include "proofs/index/ties.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr std::uint32_t unknown = 4;

/// A micro-triangle of the level, with its index by the subject.
struct Given {
  GridPoint point;
  std::uint32_t index;
};

std::vector<Given> ask_all(Level n, const TriangleIndex& index) {
  std::vector<Given> all;
  for (std::uint32_t j = 0; j < side(n); ++j)
    for (std::uint32_t i = 0; i + j < side(n); ++i)
      for (const bool upside_down : {false, true}) {
        if (upside_down && i + j + 1 == side(n)) continue;
        const MicroTriangle m{i, j, upside_down};
        all.push_back({representative(m, n), index(m)});
      }
  return all;
}

template <class Order>
bool is(const std::vector<Given>& given, Order order) {
  return std::all_of(given.begin(), given.end(), [&](const Given& g) { return order(g.point) == g.index; });
}

/// The permutation of children at each depth that turns one order's digits into the other's; nothing if there is
/// none.
template <class Order>
std::optional<std::vector<Permutation>> digit_permutations(const std::vector<Given>& given, Level n,
                                                           Order order) {
  std::vector<Permutation> at_depth(n, {unknown, unknown, unknown, unknown});
  for (const Given& g : given) {
    const std::uint32_t right = order(g.point);
    for (Level depth = 0; depth < n; ++depth) {
      const Level shift = 2 * (n - 1 - depth);
      std::uint32_t& to = at_depth[depth][right >> shift & 3];
      const std::uint32_t got = g.index >> shift & 3;
      if (to == unknown) to = got;
      if (to != got) return std::nullopt;
    }
    if (g.index >= triangle_count(n)) return std::nullopt;
  }
  for (Permutation p : at_depth) {
    std::sort(p.begin(), p.end());
    if (p != identity) return std::nullopt;
  }
  return at_depth;
}

/// The permutations as text, "children 0 and 2 change places from digit 2 on".  The first digit is the highest; each
/// stretch of depths with the same permutation makes one clause.
std::string name(const std::vector<Permutation>& at_depth) {
  std::vector<std::string> clauses;
  for (std::size_t from = 0; from < at_depth.size();) {
    std::size_t to = from;
    while (to < at_depth.size() && at_depth[to] == at_depth[from]) ++to;
    if (at_depth[from] != identity) {
      const bool to_the_end = to == at_depth.size();
      const std::string where = from == 0 && to_the_end ? "in every digit"
                                : to_the_end            ? fmt::format("from digit {} on", from + 1)
                                : to == from + 1        ? fmt::format("in digit {}", from + 1)
                                                        : fmt::format("in digits {} to {}", from + 1, to);
      clauses.push_back(text_of_children(at_depth[from]) + " " + where);
    }
    from = to;
  }
  return fmt::format("{}", fmt::join(clauses, "; "));
}

std::uint64_t wrong(const CountByKind& counts, Kind kind) {
  return counts[static_cast<std::size_t>(kind)].mismatches;
}

std::string levels_text(Level first, Level last) {
  return first == last ? fmt::format("level {}", first) : fmt::format("levels {}..{}", first, last);
}

/// Wrong points on grid lines: "1 vertex and 3 edges of level 7".
std::string ties_text(std::uint64_t vertices, std::uint64_t edges, Level n) {
  const auto count = [](std::uint64_t number, const char* one, const char* many) {
    return fmt::format("{} {}", number, number == 1 ? one : many);
  };
  std::string text;
  if (vertices != 0) text = count(vertices, "vertex", "vertices");
  if (edges != 0) text += (text.empty() ? "" : " and ") + count(edges, "edge", "edges");
  return fmt::format("{} of level {}", text, n);
}

/// The kind of wrong answers at the level of `first`, the lowest refuted level: on ties or inside.  "Ties only"
/// covers the levels whose every case was run, and no other.
std::string where_wrong(const std::vector<Result>& results, const Result& first,
                        const CountByKind& at_first) {
  const std::uint64_t interiors = wrong(at_first, Kind::interior);
  if (interiors != 0)
    return fmt::format("wrong inside {} of {} micro-triangles of level {}", interiors,
                       triangle_count(first.level), first.level);
  const std::string ties = ties_text(wrong(at_first, Kind::vertex), wrong(at_first, Kind::edge), first.level);
  const auto inside = std::find_if(results.begin(), results.end(),
                                   [](const Result& r) { return wrong(r.by_kind, Kind::interior) != 0; });
  if (inside != results.end())
    return fmt::format("wrong on ties, {}; and inside {} micro-triangles of level {}", ties,
                       wrong(inside->by_kind, Kind::interior), inside->level);
  const bool all_ran = std::all_of(results.begin(), results.end(), [](const Result& r) {
    return !r.share && r.verdict != Verdict::broken && r.verdict != Verdict::incomplete;
  });
  return fmt::format("wrong on ties only: {}; every interior {}", ties,
                     all_ran ? "of the levels that ran is right" : "of this level is right");
}

}  // namespace

std::string name_order(Level n, const TriangleIndex& index) {
  const std::vector<Given> given = ask_all(n, index);
  const auto reference = [n](const GridPoint& p) { return spec::index::reference(p, n); };
  const auto rows = [n](const GridPoint& p) { return spec::index::w_minor(p, n); };
  const auto u_major = [n](const GridPoint& p) { return in_u_major(p, n); };
  if (is(given, reference)) return {};
  if (is(given, rows)) return "row order (w-minor), not the curve";
  if (is(given, u_major)) return "U-major, rows from the edge u = 0 on, not the curve";

  std::array<int, 3> order{0, 1, 2};
  while (std::next_permutation(order.begin(), order.end())) {
    const std::string read = letters_of(order);
    if (is(given, [&](const GridPoint& p) { return reference(rearranged(p, order)); }))
      return fmt::format("the curve, with (w, u, v) taken as {}", read);
    if (is(given, [&](const GridPoint& p) { return rows(rearranged(p, order)); }))
      return fmt::format("row order (w-minor), with (w, u, v) taken as {}", read);
    if (is(given, [&](const GridPoint& p) { return u_major(rearranged(p, order)); }))
      return fmt::format("U-major, with (w, u, v) taken as {}", read);
  }

  struct Base {
    bool flips, turns;
    const char* words;
  };
  for (const Base& base :
       {Base{true, true, ""},
        {false, true, "the flips of the top triangle are missing"},
        {true, false, "the middle triangle is not turned"},
        {false, false, "the flips of the top triangle are missing and the middle triangle is not turned"}}) {
    const auto permuted = digit_permutations(
        given, n, [&](const GridPoint& p) { return simplified(p, n, base.flips, base.turns); });
    if (!permuted) continue;
    const std::string children = name(*permuted), words = base.words;
    return "the curve, but " + words + (words.empty() || children.empty() ? "" : ", and ") + children;
  }
  std::vector<Renumbered> all;
  for (const Given& g : given) all.push_back({reference(g.point), g.index});
  const std::string inside = name_children_inside(n, all);
  return inside.empty() ? "" : "the curve, but " + inside;
}

std::vector<std::string> diagnose(const IndexSubject& s, const std::vector<Result>& results) {
  const Result& first = *std::find_if(results.begin(), results.end(),
                                      [](const Result& r) { return r.verdict == Verdict::refuted; });
  const Level first_wrong = first.level;
  // A few levels further show at which depth an order goes wrong; still higher levels cost more and show no more.
  const Level n = std::max(first_wrong, std::min<Level>({first_wrong + 3, 7, s.functions.max_level}));
  std::vector<std::string> lines;
  if (first.share)  // of the levels below, other shards have run a part
    lines.push_back(fmt::format("wrong at level {}", first_wrong));
  else if (results.front().level == first_wrong)
    lines.push_back(fmt::format("wrong at level {}, the lowest that was run", first_wrong));
  else
    lines.push_back(fmt::format("right at {}, first wrong at level {}",
                                levels_text(results.front().level, first_wrong - 1), first_wrong));
  const Tally at_first = equals_reference(s, first_wrong, Run{});
  const Tally out = in_range(s, first_wrong, Run{});
  if (!out.found().empty())
    lines.push_back(
        fmt::format("out of range at level {}: {} of {} cases", first_wrong, out.mismatches(), out.cases()));
  lines.push_back(where_wrong(results, first, at_first.by_kind()));
  if (wrong(at_first.by_kind(), Kind::interior) == 0 && first_wrong <= 7)
    if (const std::string rule = rule_of_ties(s, first_wrong); !rule.empty()) lines.push_back(rule);
  if (n >= 1 && n <= 7) {
    const std::string order = name_order(n, [&](const MicroTriangle& m) {
      std::uint32_t answer = 0;
      GridPoint p = representative(m, n);
      s.functions.receive(std::span<GridPoint>(&p, 1));
      s.functions.index(n, Batch{{&p, 1}, false}, {&answer, 1});
      return answer;
    });
    if (!order.empty())
      lines.push_back(
          fmt::format("it numbers level {}'s micro-triangles along {}{}", n, order,
                      order.find(" digit") == order.npos ? "" : " (digit 1: the index's top two bits)"));
  }
  return lines;
}

WrongCells wrong_cells(const IndexSubject& subject, Level n, Order order, const CellWindow& window) {
  WrongCells found;
  std::vector<GridPoint> points;
  std::vector<std::uint32_t> got;
  Cells(n).rows(0, cell_count(n), [&](const Row& whole_row) {
    for (std::uint64_t from = 0; from < whole_row.count; from += row_batch) {
      const Row row = Cells::cut(whole_row, from, std::min<std::uint64_t>(row_batch, whole_row.count - from));
      points.clear();
      for (std::uint64_t t = 0; t < row.count; ++t) points.push_back(representative(row, t, n));
      subject.functions.receive(points);
      got.resize(points.size());
      if (order == Order::curve)
        subject.functions.index(n, {points}, got);
      else
        subject.functions.row_index(n, {points}, got);
      for (std::uint64_t t = 0; t < row.count; ++t) {
        const std::uint32_t expected =
            order == Order::curve ? spec::index::reference(points[t], n) : spec::index::w_minor(points[t], n);
        if (got[t] == expected) continue;
        ++found.wrong;
        const std::int64_t ku = row.ku + static_cast<std::int64_t>(t) * row.stride;
        if (window.holds(ku, row.kv)) found.listed.push_back({ku, row.kv, expected, got[t]});
      }
      found.cells += row.count;
    }
  });
  return found;
}

}  // namespace mmverify::proofs::index
