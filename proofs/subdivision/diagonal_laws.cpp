#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/subdivision/law_parts.hpp"

namespace mmverify::proofs::subdivision {
namespace {

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

std::vector<Law> diagonal_laws() { return {diagonals_law(), shortest_law()}; }

}  // namespace mmverify::proofs::subdivision
