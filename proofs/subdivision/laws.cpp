#include "proofs/subdivision/laws.hpp"

#include "proofs/subdivision/law_parts.hpp"

namespace mmverify::proofs::subdivision {
namespace {

using PointCheck = Finding (*)(const SubdivisionSubject&, const Placed&);
Law on_points(Law law, std::vector<Entry> entries, PointCheck check) {
  law.domain = [](Level n) {
    return fmt::format("corners, midpoints and means of the cells of level {}; bisection: {} and {}", n,
                       2 * n, 2 * n + 1);
  };
  law.unfit = needing(std::move(entries));
  return on_cases_of<SubdivisionSubject>(
      std::move(law), {point_count,
                       [check](const SubdivisionSubject& s, Level n, std::uint64_t k, const Run&) {
                         return check(s, point_number(n, k));
                       },
                       [](Level n, std::uint64_t k, const Run&) { return text_of(point_number(n, k)); },
                       [check](const SubdivisionSubject& s, Level, const std::string& at) {
                         return check(s, point_of_text(at));
                       }});
}

using CellCheck = Finding (*)(const SubdivisionSubject&, const Indexed&);
Law on_cells(Law law, std::vector<Entry> entries, CellCheck check) {
  law.domain = [](Level n) {
    return fmt::format("the cells of level {} of each scheme; bisection: {} and {}", n, 2 * n, 2 * n + 1);
  };
  law.unfit = needing(std::move(entries));
  return on_cases_of<SubdivisionSubject>(
      std::move(law), {cell_count,
                       [check](const SubdivisionSubject& s, Level n, std::uint64_t k, const Run&) {
                         return check(s, cell_number(n, k));
                       },
                       [](Level n, std::uint64_t k, const Run&) { return text_of(cell_number(n, k)); },
                       [check](const SubdivisionSubject& s, Level, const std::string& at) {
                         return check(s, cell_of_text(at));
                       }});
}
// ---- The mutants

/// The index of one cell is another.
auto calls(Scheme scheme, Level level, std::uint64_t cell, std::uint64_t other) {
  return spoils(&Functions::index, [=](Scheme s, Level n, const Fractions&, std::uint64_t& k) {
    if (s == scheme && n == level && k == cell) k = other;
  });
}
/// Points with coordinates in this relation have the index of the cell before.
auto on_line(Scheme scheme, Level level, bool (*line)(const Fractions&)) {
  return spoils(&Functions::index, [=](Scheme s, Level n, const Fractions& p, std::uint64_t& k) {
    if (s == scheme && n == level && line(p)) k = k == 0 ? 1 : k - 1;
  });
}
auto turns_corners(Scheme scheme, Level level, std::uint64_t cell) {
  return spoils(&Functions::corners, [=](Scheme s, Level n, std::uint64_t k, Corners<Whole>& corners) {
    if (s == scheme && n == level && k == cell) std::swap(corners[0], corners[1]);
  });
}
auto moves_corner(Scheme scheme, Level level, std::uint64_t cell) {
  return spoils(&Functions::corners, [=](Scheme s, Level n, std::uint64_t k, Corners<Whole>& corners) {
    if (s == scheme && n == level && k == cell) corners[2][0] += corners[2][0] == 0 ? 1 : -1;
  });
}
// ---- The laws on points

std::vector<Law> laws_on_points() {
  using enum Scheme;
  return {
      on_points(
          {.id = "subdivision.index_is_specified",
           .says = "the index of a point is the specification's, ties included",
           .source = som_7,
           .subjects = fast_alone,
           .tiers = {.fast = {0, 3}, .long_run = {0, 5}, .seconds = 1},
           .mutants =
               {mutant("points on u = 1/3 belong to the cell before", library, {1, 1},
                       on_line(triangle_9, 1,
                               [](const Fractions& p) { return 3 * p.numerators[0] == p.denominator; })),
                mutant("cells 30 and 31 of a quad are one", library, {3, 3}, calls(hilbert, 3, 31, 30)),
                mutant("points with u = v at bisection 6 belong to the cell before", library, {3, 3},
                       on_line(bisection, 6,
                               [](const Fractions& p) { return p.numerators[0] == p.numerators[1]; }))}},
          {entry::index}, index_is_specified),
      on_points(
          {.id = "subdivision.in_one_cell",
           .says = "each point belongs by the tie rule to one cell of a level alone, the one with its index",
           .source = "docs/SUBDIVISION.md",
           .subjects = {"subdivision-spec", "subdivision-rational", library},
           .tiers = {.fast = {0, 2}, .long_run = {0, 2}, .seconds = 1},
           .mutants = {mutant(
                           "points on z = 1/2 belong to the cell before", library, {1, 1},
                           on_line(tetrahedron, 1,
                                   [](const Fractions& p) { return 2 * p.numerators[2] == p.denominator; })),
                       mutant("the last cell of nine has the first one's index", library, {1, 1},
                              calls(triangle_9, 1, 8, 0)),
                       mutant("a quad's centre belongs to the cell before", library, {1, 1},
                              on_line(morton, 1,
                                      [](const Fractions& p) {
                                        return 2 * p.numerators[0] == p.denominator &&
                                               2 * p.numerators[1] == p.denominator;
                                      }))}},
          {entry::index}, in_one_cell),
      on_points(
          {.id = "subdivision.nested",
           .says = "the index without its last digit is the point's index at the level before, ties included",
           .source = som_7,
           .subjects = specified_and_library,
           .tiers = {.fast = {0, 3}, .long_run = {0, 5}, .seconds = 1},
           .mutants =
               {mutant("cell 9 of nine is cell 8 at level 2", library, {2, 2}, calls(triangle_9, 2, 9, 8)),
                mutant("cell 64 of a tetrahedron is cell 63 at level 3", library, {3, 3},
                       calls(tetrahedron, 3, 64, 63)),
                mutant("points with x = y at bisection 5 belong to the cell before", library, {2, 2},
                       on_line(bisection, 5,
                               [](const Fractions& p) { return p.numerators[0] == p.numerators[1]; }))}},
          {entry::index}, nested)};
}

/// All points of denominator 4N in a triangle, row by row.
std::uint64_t quarters(Level n) { return (std::uint64_t{4} << n) + 1; }
Placed quarter_point(Level n, std::uint64_t k) {
  std::uint32_t v = 0;
  for (std::uint64_t row = quarters(n); k >= row; --row, ++v) k -= row;
  return {Scheme::triangle_4, n, {{static_cast<std::uint32_t>(k), v, 0}, std::uint32_t{4} << n}};
}

Law micromaps_law() {
  using enum Scheme;
  Law law{.id = "subdivision.is_micromaps",
          .says =
              "on the triangle in four the index is the one of opacity micromaps, ties included, and its "
              "cell has the "
              "same corners in the same order",
          .source = "VK_EXT_opacity_micromap, appendix \"Reference Code\"; spec/index",
          .subjects = specified_and_library,
          .tiers = {.fast = {0, 4}, .long_run = {0, 7}, .seconds = 0.5},
          .domain = "all points of denominator 4N: every cell, edge and vertex",
          .unfit = needing({entry::index, entry::corners}),
          .mutants = {mutant("points with u + v = 1/2 belong to the cell before", library, {1, 1},
                             on_line(triangle_4, 1,
                                     [](const Fractions& p) {
                                       return 2 * (p.numerators[0] + p.numerators[1]) == p.denominator;
                                     })),
                      mutant("cell 200 of level 4 has another cell's corners", library, {4, 4},
                             draws(triangle_4, 4, 200, 201)),
                      mutant("cell 5 of level 2 has its corners in another order", library, {2, 2},
                             turns_corners(triangle_4, 2, 5))}};
  const auto on_triangle = [](const std::string& at) {
    const Placed placed = point_of_text(at);
    if (placed.scheme != triangle_4) throw BadCase(fmt::format("'{:.40}': not of triangle-4", at));
    return placed;
  };
  return on_cases_of<SubdivisionSubject>(
      std::move(law), {[](Level n) { return quarters(n) * (quarters(n) + 1) / 2; },
                       [](const SubdivisionSubject& s, Level n, std::uint64_t k, const Run&) {
                         return is_micromaps(s, quarter_point(n, k));
                       },
                       [](Level n, std::uint64_t k, const Run&) { return text_of(quarter_point(n, k)); },
                       [on_triangle](const SubdivisionSubject& s, Level, const std::string& at) {
                         return is_micromaps(s, on_triangle(at));
                       }});
}

Law sample_law() {
  using enum Scheme;
  return on_drawn_cases<SubdivisionSubject, Placed>(
      {.id = "subdivision.on_samples",
       .says = "the index of a point is the specification's, at any level and for any denominator up to 2^31",
       .source = som_7,
       .method = Method::sample,
       .subjects = fast_alone,
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 1},
       .domain = "points of random schemes and fractions, half of them of a multiple of the grid's side",
       .unfit = needing({entry::index}),
       .mutants = {mutant("the tetrahedron's z counts for nothing at level 9", library, {9, 9},
                          [](Functions& f) {
                            f.index = [real = f.index](Scheme s, Level n, Fractions p) {
                              if (s == tetrahedron && n == 9) p.numerators[2] = 0;
                              return real(s, n, p);
                            };
                          }),
                   mutant("points with u < 1/16 at bisection 18 belong to the cell before", library, {9, 9},
                          on_line(bisection, 18,
                                  [](const Fractions& p) {
                                    return std::uint64_t{16} * p.numerators[0] < p.denominator;
                                  })),
                   mutant("Hilbert's curve turns the wrong way at level 16", library, {16, 16},
                          spoils(&Functions::index,
                                 [](Scheme s, Level n, const Fractions&, std::uint64_t& k) {
                                   if (s == hilbert && n == 16 && k % 4 == 1) k += 2;
                                 }))}},
      {.count = CaseCount(2'000, 100'000),
       .number = sample_point,
       .text = [](Level, const Placed& at) { return text_of(at); },
       .read = [](Level, const std::string& at) { return point_of_text(at); },
       .check = [](const SubdivisionSubject& s, Level,
                   const Placed& at) { return index_is_specified(s, at); }});
}

// ---- The laws on cells

std::vector<Law> laws_on_cells() {
  using enum Scheme;
  return {
      on_cells({.id = "subdivision.corners_are_specified",
                .says = "the corners of a cell are the specification's, in its order",
                .source = som_7,
                .subjects = fast_alone,
                .tiers = {.fast = {0, 4}, .long_run = {0, 6}, .seconds = 0.5},
                .mutants = {mutant("cell 100 of a quad has its corners in another order", library, {4, 4},
                                   turns_corners(hilbert, 4, 100)),
                            mutant("a corner of cell 77 of a tetrahedron lies elsewhere", library, {3, 3},
                                   moves_corner(tetrahedron, 3, 77)),
                            mutant("cell 40 of nine has cell 41's corners", library, {2, 2},
                                   draws(triangle_9, 2, 40, 41))}},
               {entry::corners}, corners_are_specified),
      on_cells(
          {.id = "subdivision.bijective",
           .says = "points inside the cell with an index, near each corner and in the middle, have that "
                   "index: so each "
                   "index has a cell of its own",
           .source = som_7,
           .subjects = specified_and_library,
           .tiers = {.fast = {0, 3}, .long_run = {0, 5}, .seconds = 1},
           .mutants = {mutant("two cells of the bisection have one index", library, {2, 2},
                              calls(bisection, 5, 17, 16)),
                       mutant("cell 3 of a quad is drawn as cell 2", library, {2, 2}, draws(morton, 2, 3, 2)),
                       mutant("a corner of cell 44 of nine lies elsewhere", library, {2, 2},
                              moves_corner(triangle_9, 2, 44))}},
          {entry::index, entry::corners}, inverse),
      on_cells(
          {.id = "subdivision.contiguous",
           .says =
               "a cell shares a facet with the next one, but for the steps that are inside a parent from "
               "child 2 of "
               "a triangle in four, 2 and 3 of one in nine, and 3 of a tetrahedron, which are over a corner; "
               "in Morton's order every second step is over less than an edge",
           .source = som_7,
           .subjects = specified_and_library,
           .tiers = {.fast = {0, 4}, .long_run = {0, 6}, .seconds = 0.5},
           .mutants = {mutant("two cells of Hilbert's curve change places", library, {3, 3},
                              draws(hilbert, 3, 33, 40)),
                       mutant("a cell of nine comes twice", library, {2, 2}, draws(triangle_9, 2, 13, 12)),
                       mutant("a tetrahedron lies elsewhere", library, {4, 4},
                              draws(tetrahedron, 4, 2000, 60))}},
          {entry::corners}, contiguous)};
}
}  // namespace

std::vector<Law> laws() {
  std::vector<Law> all = laws_on_points();
  for (auto group : {laws_on_cells(), {micromaps_law()}, scheme_laws(), diagonal_laws(), {sample_law()}})
    for (Law& law : group) all.push_back(std::move(law));
  return all;
}

}  // namespace mmverify::proofs::subdivision
