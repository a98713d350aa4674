#include "proofs/subdivision/laws.hpp"

#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/subdivision/checks.hpp"

namespace mmverify::proofs::subdivision {
namespace {

constexpr char som_7[] = "Succinct Opacity Micromaps, 7: other dimensions, shapes and subdivision levels";
constexpr char library[] = "subdivision";
const std::vector<std::string> specified_and_library{"subdivision-spec", library}, fast_alone{library};

constexpr auto mutant = mutant_of<built_in_subjects>;

Unfit needing(std::vector<Entry> entries) {
  return unless_of_topic<SubdivisionSubject>(
      lacking<SubdivisionSubject>(std::move(entries), above_its_levels<SubdivisionSubject>));
}

// ---- The cases

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

using SchemeCheck = std::function<Finding(const SubdivisionSubject&, Scheme, Level)>;
Law on_schemes(Law law, std::vector<Entry> entries, std::vector<Scheme> schemes, SchemeCheck check) {
  const bool settles_all = !law.at_once.empty();
  law.unfit = [settles_all, base = needing(std::move(entries))](const Subject& s, Level n) {
    std::optional<std::string> why = base(s, n);
    return why || settles_all || n > 0 ? why : std::optional<std::string>("level 0 has one cell");
  };
  return on_cases_of<SubdivisionSubject>(
      std::move(law), {schemes.size(),
                       [=](const SubdivisionSubject& s, Level n, std::uint64_t k, const Run&) {
                         return check(s, schemes[k], n);
                       },
                       [=](Level, std::uint64_t k, const Run&) { return std::string(cut(schemes[k]).name); },
                       [=](const SubdivisionSubject& s, Level n, const std::string& at) {
                         for (const Scheme scheme : schemes)
                           if (at == cut(scheme).name) return check(s, scheme, n);
                         throw BadCase(fmt::format("'{:.40}': no scheme of this law", at));
                       }});
}

// ---- The mutants

/// The index of one cell is another.
auto calls(Scheme scheme, Level level, std::uint64_t cell, std::uint64_t other) {
  return spoils(&Functions::index, [=](Scheme s, Level n, const Fractions&, std::uint64_t& k) {
    if (s == scheme && n == level && k == cell) k = other;
  });
}
/// Points with the first two coordinates in this relation have the index of the next cell.
auto on_line(Scheme scheme, Level level, bool (*line)(const Fractions&)) {
  return spoils(&Functions::index, [=](Scheme s, Level n, const Fractions& p, std::uint64_t& k) {
    if (s == scheme && n == level && line(p)) k = k == 0 ? 1 : k - 1;
  });
}
/// The corners of one cell are another's.
auto draws(Scheme scheme, Level level, std::uint64_t cell, std::uint64_t other) {
  return [=](Functions& f) {
    f.corners = [=, real = f.corners](Scheme s, Level n, std::uint64_t k) {
      return real(s, n, s == scheme && n == level && k == cell ? other : k);
    };
  };
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
auto builds(Scheme scheme, void (*change)(Machine&)) {
  return spoils(&Functions::machine, [=](Scheme s, Machine& machine) {
    if (s == scheme) change(machine);
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

// ---- The laws on schemes

Law fewest_law() {
  using enum Scheme;
  return on_schemes(
      {.id = "subdivision.fewest_breaks",
       .says = "no order of a shape's children has fewer steps without a common facet: 1 in a triangle in "
               "four, 2 in one in "
               "nine, 1 in a tetrahedron, 0 on Hilbert's curve and in the bisection.  So no nested order has "
               "fewer at "
               "any level: (b^n-1)/(b-1) times as many",
       .source = "docs/SUBDIVISION.md: each parent adds its children's, and a step between parents without a "
                 "common facet "
                 "stays one",
       .subjects = specified_and_library,
       .tiers = {.seconds = 0.1},
       .at_once = "all levels",
       .domain = "all orders of the children, by sets of them; the schemes but Morton's order",
       .mutants = {mutant("children 4 and 5 of nine change places", library, {0, 0},
                          [](Functions& f) { draws(triangle_9, 1, 4, 7)(f); }),
                   mutant("Hilbert's children come in Morton's order", library, {0, 0},
                          [](Functions& f) {
                            f.corners = [real = f.corners](Scheme s, Level n, std::uint64_t k) {
                              return real(s == hilbert ? morton : s, n, k);
                            };
                          }),
                   mutant("children 3 and 4 of a tetrahedron change places", library, {0, 0},
                          [](Functions& f) {
                            f.corners = [real = f.corners](Scheme s, Level n, std::uint64_t k) {
                              return real(s, n, s == tetrahedron && (k == 3 || k == 4) ? 7 - k : k);
                            };
                          })}},
      {entry::corners}, {triangle_4, triangle_9, hilbert, tetrahedron, bisection},
      [](const SubdivisionSubject& s, Scheme scheme, Level) { return fewest_breaks(s, scheme); });
}

Law dead_ends_law() {
  using enum Scheme;
  return on_schemes(
      {.id = "subdivision.dead_ends",
       .says =
           "of a level's cells, three of a triangle in four or nine and four of a tetrahedron in eight have "
           "one "
           "neighbour beyond a facet.  An order has two ends: so none, nested or not, is over facets alone",
       .source = "docs/SUBDIVISION.md",
       .subjects = specified_and_library,
       .tiers = {.fast = {1, 3}, .long_run = {1, 4}, .seconds = 0.2},
       .domain = "all facets of all cells of three schemes",
       .mutants = {mutant("cell 8 of nine lies on another", library, {1, 1}, draws(triangle_9, 1, 8, 7)),
                   mutant("a cell in a tetrahedron's corner lies on another", library, {2, 2},
                          draws(tetrahedron, 2, 0, 1)),
                   mutant("a triangle's first cell lies on another", library, {3, 3},
                          draws(triangle_4, 3, 0, 1))}},
      {entry::corners}, {triangle_4, triangle_9, tetrahedron},
      [](const SubdivisionSubject& s, Scheme scheme, Level n) { return dead_ends(s, scheme, n); });
}

Law all_levels_law() {
  using enum Scheme;
  return on_schemes(
      {.id = "subdivision.all_levels",
       .says = "at every level n >= 0 the cells are the specification's and tile the shape, a child lies in "
               "its parent, each "
               "point belongs to one cell, and, but in Morton's order, a cell shares with the next one a "
               "facet, or, after "
               "a digit that breaks, a corner",
       .source = som_7,
       .subjects = fast_alone,
       .tiers = {.seconds = 0.2},
       .at_once = "all levels",
       .domain = "every level of the six schemes",
       .how =
           "induction over the orientations of cells and of pairs of cells; each step run in whole numbers",
       .mutants = {mutant("an orientation of nine shifts child 7", library, {0, 0},
                          builds(triangle_9, [](Machine& m) { ++m[11].shift[7][0]; })),
                   mutant("an orientation of a tetrahedron takes another's child", library, {0, 0},
                          builds(tetrahedron, [](Machine& m) { m[59].next[3] = m[58].next[3]; })),
                   mutant("Hilbert's curve turns children 0 the wrong way", library, {0, 0},
                          builds(hilbert, [](Machine& m) { m[1].next[0] = m[2].next[0]; })),
                   mutant("an orientation of the bisection has a corner elsewhere", library, {0, 0},
                          builds(bisection, [](Machine& m) { ++m[5].corners[1][1]; }))}},
      {entry::machine}, {all_schemes.begin(), all_schemes.end()},
      [](const SubdivisionSubject& s, Scheme scheme, Level) { return all_levels(s, scheme); });
}

Law three_shapes_law() {
  using enum Scheme;
  return on_schemes(
      {.id = "subdivision.three_shapes",
       .says = "at every level each cell of a tetrahedron has its edges 01, 12 and 23, halved n times, in "
               "some order: six "
               "orders, of which one backwards is the same cell turned around, so three shapes at most, "
               "whatever the "
               "tetrahedron",
       .source = "Bey, Tetrahedral Grid Refinement, 1995",
       .subjects = fast_alone,
       .tiers = {.seconds = 0.05},
       .at_once = "all levels",
       .domain = "every level",
       .how = "induction over the orientations of cells",
       .mutants =
           {mutant("an orientation's diagonal is another", library, {0, 0},
                   builds(tetrahedron, [](Machine& m) { std::swap(m[40].corners[1], m[40].corners[2]); })),
            mutant("the unit tetrahedron's corners 2 and 3 change places", library, {0, 0},
                   builds(tetrahedron, [](Machine& m) { std::swap(m[0].corners[2], m[0].corners[3]); })),
            mutant("the last orientation has a corner elsewhere", library, {0, 0},
                   builds(tetrahedron, [](Machine& m) { ++m.back().corners[3][2]; }))}},
      {entry::machine}, {tetrahedron},
      [](const SubdivisionSubject& s, Scheme, Level) { return three_shapes(s); });
}

// ---- The octahedron's diagonals

/// Corners of whole numbers up to 9, and not in one plane.
Tetrahedron sample_tetrahedron(Level n, std::uint64_t seed, std::uint64_t k) {
  Random random(seed, 977 + n, k);
  Tetrahedron t{};
  do {
    for (At<std::int64_t>& corner : t)
      for (std::int64_t& x : corner) x = random.between(0, 9);
  } while (determinant(3, difference(t[1], t[0]), difference(t[2], t[0]), difference(t[3], t[0])) == 0);
  return t;
}

std::string text_of_tetrahedron(const Tetrahedron& t) {
  std::string text;
  for (const At<std::int64_t>& c : t)
    text += fmt::format("{}{},{},{}", text.empty() ? "" : " ", c[0], c[1], c[2]);
  return text;
}

Tetrahedron tetrahedron_of_text(const std::string& text) {
  const Groups parts = groups_of(text,
                                 "([0-9]),([0-9]),([0-9]) ([0-9]),([0-9]),([0-9]) ([0-9]),([0-9]),([0-9]) "
                                 "([0-9]),([0-9]),([0-9])");
  if (!parts) throw BadCase(fmt::format("'{:.60}': write four corners X,Y,Z of one digit each", text));
  Tetrahedron t{};
  for (std::size_t k = 0; k < 12; ++k) t[k / 3][k % 3] = std::stoll((*parts)[1 + k]);
  return t;
}

auto counts(Diagonal rule, void (*change)(std::size_t&)) {
  return spoils(&Functions::shapes, [=](const Tetrahedron&, Diagonal d, Level, std::size_t& count) {
    if (d == rule) change(count);
  });
}

Law diagonals_law() {
  return on_drawn_cases<SubdivisionSubject, Tetrahedron>(
      {.id = "subdivision.diagonals",
       .says =
           "Bey's diagonal makes three shapes at most on levels up to n, and the longest one at least n + 1",
       .source = "Bey, Tetrahedral Grid Refinement, 1995; Zhang, Successive Subdivisions of Tetrahedra, 1995",
       .method = Method::sample,
       .subjects = {"subdivision-spec"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 6}, .seconds = 0.5},
       .domain = "random tetrahedra with corners at whole numbers up to 9; lengths exact",
       .unfit = needing({entry::shapes}),
       .mutants = {mutant("Bey's shapes are counted four times", "subdivision-spec", {2, 2},
                          counts(Diagonal::bey, [](std::size_t& k) { k *= 4; })),
                   mutant("the longest diagonal is Bey's", "subdivision-spec", {4, 4},
                          [](Functions& f) {
                            f.shapes = [real = f.shapes](const Tetrahedron& t, Diagonal d, Level n) {
                              return real(t, d == Diagonal::longest ? Diagonal::bey : d, n);
                            };
                          }),
                   mutant("Bey's diagonal is the longest", "subdivision-spec", {3, 3},
                          [](Functions& f) {
                            f.shapes = [real = f.shapes](const Tetrahedron& t, Diagonal d, Level n) {
                              return real(t, d == Diagonal::bey ? Diagonal::longest : d, n);
                            };
                          })}},
      {.count = CaseCount(20, 200),
       .number = sample_tetrahedron,
       .text = [](Level, const Tetrahedron& t) { return text_of_tetrahedron(t); },
       .read = [](Level, const std::string& at) { return tetrahedron_of_text(at); },
       .check =
           [](const SubdivisionSubject& s, Level n, const Tetrahedron& t) {
             const std::size_t bey = s.functions.shapes(t, Diagonal::bey, n),
                               longest = s.functions.shapes(t, Diagonal::longest, n);
             if (bey <= 3 && longest > n) return Finding{bey + 4 * longest};
             return wrong(fmt::format("at most 3, and at least {}", n + 1),
                          fmt::format("{} and {}", bey, longest));
           },
       .chunk = 1});
}

/// Shapes of the tetrahedron (0,0,0) (4,0,0) (1,3,0) (1,1,1) on levels 0 to 6.
Law shortest_law() {
  static constexpr std::size_t shortest[] = {1, 3, 5, 9, 13, 14, 14};
  static constexpr char corners[] = "0,0,0 4,0,0 1,3,0 1,1,1";
  Law law{.id = "subdivision.other_diagonals",
          .says =
              "in the tetrahedron (0,0,0) (4,0,0) (1,3,0) (1,1,1) the shortest diagonal makes 1, 3, 5, 9, "
              "13, 14, 14 "
              "shapes on levels up to 0, ..., 6, and the longest one 2^(n+1) - 1: neither keeps three",
          .source = "docs/SUBDIVISION.md",
          .subjects = {"subdivision-spec"},
          .tiers = {.fast = {0, 6}, .long_run = {0, 6}, .seconds = 0.3},
          .domain = "one tetrahedron; lengths exact",
          .unfit = needing({entry::shapes}),
          .mutants = {mutant("the shortest diagonal is the longest", "subdivision-spec", {2, 2},
                             [](Functions& f) {
                               f.shapes = [real = f.shapes](const Tetrahedron& t, Diagonal d, Level n) {
                                 return real(t, d == Diagonal::shortest ? Diagonal::longest : d, n);
                               };
                             }),
                      mutant("the longest diagonal is Bey's", "subdivision-spec", {2, 2},
                             [](Functions& f) {
                               f.shapes = [real = f.shapes](const Tetrahedron& t, Diagonal d, Level n) {
                                 return real(t, d == Diagonal::longest ? Diagonal::bey : d, n);
                               };
                             }),
                      mutant("a shape more at the fifth level", "subdivision-spec", {5, 5},
                             counts(Diagonal::shortest, [](std::size_t& k) { k += k == 14 ? 1 : 0; }))}};
  const auto check = [](const SubdivisionSubject& s, Level n) {
    const Tetrahedron t = tetrahedron_of_text(corners);
    const std::size_t short_ones = s.functions.shapes(t, Diagonal::shortest, n),
                      long_ones = s.functions.shapes(t, Diagonal::longest, n);
    const std::size_t right = (std::size_t{2} << n) - 1;
    if (short_ones == shortest[n] && long_ones == right) return Finding{short_ones + (long_ones << 8)};
    return wrong(fmt::format("{} and {}", shortest[n], right),
                 fmt::format("{} and {}", short_ones, long_ones));
  };
  return on_cases_of<SubdivisionSubject>(
      std::move(law),
      {1, [check](const SubdivisionSubject& s, Level n, std::uint64_t, const Run&) { return check(s, n); },
       [](Level, std::uint64_t, const Run&) { return std::string(corners); },
       [check](const SubdivisionSubject& s, Level n, const std::string& at) {
         if (at != corners || n > 6)
           throw BadCase(fmt::format("'{:.60}': the case is {}, of levels 0 to 6", at, corners));
         return check(s, n);
       }});
}

}  // namespace

std::vector<Law> laws() {
  std::vector<Law> all = laws_on_points();
  for (Law& law : laws_on_cells()) all.push_back(std::move(law));
  for (Law& law : std::vector{micromaps_law(), all_levels_law(), fewest_law(), dead_ends_law(),
                              three_shapes_law(), diagonals_law(), shortest_law(), sample_law()})
    all.push_back(std::move(law));
  return all;
}

}  // namespace mmverify::proofs::subdivision
