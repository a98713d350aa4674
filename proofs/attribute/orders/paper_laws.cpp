// Laws of the orders that figure 4 prints, in the words and roots of shaders.
#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/orders/parts.hpp"

namespace mmverify::proofs::attribute {
namespace {

struct OnLastDiagonals {
  VertexOrder order;
  Vertex at;
};

/// Vertices with i+j = N-1 in the first N cases of a half, i+j = N in the rest.  The first half is W-minor's.
OnLastDiagonals on_last_diagonals(Level n, std::uint64_t k) {
  const std::uint32_t N = spec::side(n), t = static_cast<std::uint32_t>(k % (2 * std::uint64_t{N} + 1));
  const std::uint32_t sum = t < N ? N - 1 : N, j = t < N ? t : t - N;
  return {k < 2 * std::uint64_t{N} + 1 ? VertexOrder::w_minor : VertexOrder::u_major, {sum - j, j}};
}

Finding products_wrap(const AttributeSubject& s, Level n, const OnLastDiagonals& c) {
  const std::uint32_t got = indices_of(s, c.order, n, {&c.at, 1})[0];
  const std::uint64_t right = spec::attribute::vertex_index(c.order, c.at, n);
  // r(r+1) passes 2^32 at r = 2^16.  i(N+2) does so from i = 65,535 on, but the difference undoes it.  i(i+1),
  // which is halved afterwards, does so at i = 2^16.
  const std::uint32_t limit = 1u << 16;
  const bool wraps = c.order == VertexOrder::w_minor ? c.at.i + c.at.j == limit : c.at.i == limit;
  if ((got == right) != wraps) return Finding{got};
  return wrong(fmt::format("{} {}", wraps ? "not" : "", right), fmt::format("{}", got));
}

Law products_law() {
  Cases<OnLastDiagonals> cases;
  cases.count = [](Level n, const Run&) { return 2 * (2 * std::uint64_t{spec::side(n)} + 1); };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) { return on_last_diagonals(n, k); };
  cases.text = [](Level, const OnLastDiagonals& c) {
    return fmt::format("{}:{}", name_of(c.order), text_of(c.at));
  };
  cases.read = [](Level n, const std::string& at) {
    const bool rows = at.starts_with("w-minor:");
    if (!rows && !at.starts_with("u-major:"))
      throw BadCase(fmt::format("'{:.60}': begin with w-minor: or u-major:", at));
    OnLastDiagonals c{rows ? VertexOrder::w_minor : VertexOrder::u_major, {}};
    read(n, at.substr(8), c.at);
    return c;
  };
  cases.check = products_wrap;
  cases.chunk = 4096;
  cases.kind = Kind::vertex;
  const auto differs = [](VertexOrder order, Level level, Vertex where, std::uint32_t index) {
    return on_vertex_index(order, [=](Level n, const Vertex& v, std::uint32_t x) {
      return n == level && v == where ? index : x;
    });
  };
  const auto wide = [](VertexOrder order) {
    return on_vertex_index(order, [=](Level n, const Vertex& v, std::uint32_t) {
      return static_cast<std::uint32_t>(spec::attribute::vertex_index(order, v, n));
    });
  };
  return on_cases<OnLastDiagonals>(
      {.id = "paper.vertex_products_overflow",
       .says = "with products in 32 bits figure 4's r(r+1)/2 is right below level 16 and wrong on all of "
               "level 16's hypotenuse; U-major's i(N+2) - i(i+1)/2 is wrong at level 16's u-corner alone, "
               "98,304 for 2,147,581,952",
       .source = cam_4,
       .subjects = {"attribute-32-bit"},
       .tiers = {.fast = {12, 16}, .long_run = {0, 16}, .seconds = 0.2},
       .domain = "the 2N+1 vertices of the last two diagonals, in 2 orders",
       .mutants = {mutant("U-major's products in 64 bits", "attribute-32-bit", {16, 16},
                          wide(VertexOrder::u_major)),
                   mutant("one vertex of W-minor's hypotenuse is right", "attribute-32-bit", {16, 16},
                          differs(VertexOrder::w_minor, 16, {0, 65'536}, 2'147'581'952)),
                   mutant("one more wrong, in the row before", "attribute-32-bit", {16, 16},
                          differs(VertexOrder::w_minor, 16, {535, 65'000}, 2'147'450'880))},
       .general = false},
      needing({entry::vertex_index}), cases);
}

// ---- Figure 4's triplets

std::uint32_t to_index(std::uint32_t row, std::uint32_t column) {
  return static_cast<std::uint32_t>(std::uint64_t{row} * (row + 1) / 2 + column);
}

/// Figure 4's triplet of a face in a row at a column, which may lie beyond the row's end.
Triplet printed(std::uint32_t row, std::uint32_t col) {
  const std::uint32_t c = col / 2;
  if (col % 2 == 0) return {to_index(row, c), to_index(row + 1, c), to_index(row + 1, c + 1)};
  return {to_index(row, c), to_index(row + 1, c + 1), to_index(row, c + 1)};
}

/// The expected triplet of a face in rows.
using Wanted = Triplet (*)(Level, const MicroTriangle&, std::uint32_t index);

Batches<MicroTriangle> triplets_of_rows(Wanted wanted) {
  Batches<MicroTriangle> cases;
  cases.settings = {"rows>w-minor"};
  cases.count = face_count;
  cases.kind = Kind::interior;
  const auto ask = [](const AttributeSubject& s, Level n, std::span<const MicroTriangle> at,
                      std::vector<std::uint32_t>& index) {
    for (const MicroTriangle& t : at)
      index.push_back(static_cast<std::uint32_t>(spec::attribute::face_index(FaceOrder::rows, t, n)));
    std::vector<Triplet> got(at.size());
    s.functions.orders.triplet(FaceOrder::rows, VertexOrder::w_minor, n, index, got);
    return got;
  };
  cases.check = [wanted, ask](const AttributeSubject& s, Level n, std::size_t,
                              std::span<const MicroTriangle> at, std::span<Outcome> out) {
    std::vector<std::uint32_t> index;
    const auto got = ask(s, n, at, index);
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = {got[k][2], got[k] == wanted(n, at[k], index[k])};
  };
  cases.words = [wanted, ask](const AttributeSubject& s, Level n, std::size_t, const MicroTriangle& at) {
    std::vector<std::uint32_t> index;
    const auto got = ask(s, n, {&at, 1}, index);
    return Words{text_of(wanted(n, at, index[0])), text_of(got[0])};
  };
  return cases;
}

/// A mutant that changes the triplets of rows.
template <class Change>
auto on_rows(Change change) {
  return spoils(
      &Functions::orders, &Orders::triplet,
      [change](FaceOrder, VertexOrder, Level, std::span<const std::uint32_t> face, std::span<Triplet> out) {
        for (std::size_t k = 0; k < out.size(); ++k) change(face[k], out[k]);
      });
}

Law printed_triplets_law() {
  return on_batches({.id = "paper.figure_4_triplets",
                     .says = "figure 4's triplet is that of its face, an odd one begun one corner later: its "
                             "weights are (1-fv, fu+fv-1, 1-fu), not those of even ones",
                     .source = cam_4,
                     .subjects = {"attribute-figure-4"},
                     .tiers = {.fast = {0, 9}, .long_run = {0, 12}, .seconds = 0.5},
                     .domain = "the 4^n faces",
                     .mutants = {mutant("odd triplets begin where ours do", "attribute-figure-4", {1, 3},
                                        on_rows([](std::uint32_t face, Triplet& t) {
                                          const std::uint32_t row = spec::index::w_minor_row(face);
                                          if ((face - row * row) % 2 != 0) t = {t[1], t[2], t[0]};
                                        })),
                                 mutant("row 100 begins a vertex late", "attribute-figure-4", {7, 7},
                                        on_rows([](std::uint32_t face, Triplet& t) {
                                          if (face == 100 * 100) ++t[0];
                                        })),
                                 mutant("an odd one's last two corners change places", "attribute-figure-4",
                                        {6, 6}, on_rows([](std::uint32_t face, Triplet& t) {
                                          if (face == 50 * 50 + 7) std::swap(t[1], t[2]);
                                        }))},
                     .general = false},
                    needing({entry::triplet}),
                    triplets_of_rows([](Level n, const MicroTriangle& t, std::uint32_t) {
                      const auto x = spec::attribute::triplet(VertexOrder::w_minor, t, n);
                      const Triplet ours{static_cast<std::uint32_t>(x[0]), static_cast<std::uint32_t>(x[1]),
                                         static_cast<std::uint32_t>(x[2])};
                      return t.upper ? Triplet{ours[2], ours[0], ours[1]} : ours;
                    }));
}

Law short_root_law() {
  return on_batches(
      {.id = "paper.short_root_aliases",
       .says = "with a root one number short, which Vulkan allows, figure 4 puts the first face of each row "
               "r from 1 on at column 2r-1 of the row before, and v2 is the vertex that begins row r; other "
               "faces stay right",
       .source = "Color and Attribute Micromaps, figure 4; Vulkan, \"Precision of Individual Operations\": "
                 "sqrt inherits from 1.0 / inversesqrt()",
       .subjects = {"attribute-short-root"},
       .tiers = {.fast = {0, 9}, .long_run = {0, 11}, .seconds = 0.5},
       .domain = "the 4^n faces",
       .mutants = {mutant("row 1 is right", "attribute-short-root", {1, 1},
                          on_rows([](std::uint32_t face, Triplet& t) {
                            if (face == 1) t = printed(1, 0);
                          })),
                   mutant("v2 does not alias in row 77", "attribute-short-root", {7, 7},
                          on_rows([](std::uint32_t face, Triplet& t) {
                            if (face == 77 * 77) --t[2];
                          })),
                   mutant("the last face of row 30 is the row after's", "attribute-short-root", {5, 5},
                          on_rows([](std::uint32_t face, Triplet& t) {
                            if (face == 31 * 31 - 1) t = printed(31, 0);
                          }))},
       .general = false},
      needing({entry::triplet}), triplets_of_rows([](Level, const MicroTriangle& t, std::uint32_t index) {
        const std::uint32_t row = t.iu + t.iv + (t.upper ? 1 : 0);
        const bool first = index == row * row && row != 0;
        Triplet wanted = first ? printed(row - 1, 2 * row - 1) : printed(row, index - row * row);
        if (first) wanted[2] = to_index(row, 0);  // the same index as to_index(row - 1, row)
        return wanted;
      }));
}

}  // namespace

std::vector<Law> order_paper_laws() { return {products_law(), printed_triplets_law(), short_root_law()}; }

}  // namespace mmverify::proofs::attribute
