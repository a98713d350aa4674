#include "proofs/subdivision/law_parts.hpp"

namespace mmverify::proofs::subdivision {
namespace {

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
auto builds(Scheme scheme, void (*change)(Machine&)) {
  return spoils(&Functions::machine, [=](Scheme s, Machine& machine) {
    if (s == scheme) change(machine);
  });
}

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
}  // namespace

std::vector<Law> scheme_laws() {
  return {all_levels_law(), fewest_law(), dead_ends_law(), three_shapes_law()};
}

}  // namespace mmverify::proofs::subdivision
