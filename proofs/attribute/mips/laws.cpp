// Mip chains: what a mip is, how many there are, and where.
#include "proofs/attribute/elements.hpp"
#include "proofs/attribute/mips/law_parts.hpp"
#include "proofs/engine/shape.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::attribute::face_count;
using spec::attribute::vertex_count;

constexpr char cam_44[] = "Color and Attribute Micromaps, 4.4, figure 7";
constexpr char cam_441[] = "Color and Attribute Micromaps, 4.4.1";

const Entry sizes_entry{
    "sizes of chains", [](const Functions& f) { return f.mips.face_chain_size && f.mips.vertex_chain_size; }};
const Entry source_entry{"vertex of a lower level -> index",
                         [](const Functions& f) { return bool{f.mips.vertex_mip_source}; }};

std::string codes_of(std::uint32_t word) {
  return fmt::format("{} {} {} {}", word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24);
}

// ---- Means

/// The number on the curve, at level m, of the micro-triangle that holds the whole of number x of level n: found by
/// where the middle of x lies, not by its digits.
std::uint32_t holder_of(std::uint32_t x, Level n, Level m) {
  const spec::index::Corners c = spec::index::corners(x, n);
  // Twice one corner and the other two once: a point inside, in quarters of the grid.
  const auto at = [n](std::uint32_t quarters) {
    return spec::Fixed64::dyadic(static_cast<std::int64_t>(quarters), n + 2);
  };
  const spec::Point<spec::Fixed64> inside{at(2 * c[0].i + c[1].i + c[2].i), at(2 * c[0].j + c[1].j + c[2].j)};
  return spec::index::reference(inside, m);
}

/// The map of level n that is 255, 200, 100 and 1 on one micro-triangle of a level up to n, and 0 elsewhere.
struct Lit {
  Level level;
  std::uint32_t number;
};
constexpr std::uint32_t lit_word = 255u | 200u << 8 | 100u << 16 | 1u << 24;

Finding mean_of_lit(const AttributeSubject& s, Level n, const Lit& lit) {
  std::vector<std::uint32_t> base(static_cast<std::size_t>(face_count(n)));
  std::vector<std::uint64_t> holds(static_cast<std::size_t>(spec::attribute::face_chain(n)));
  for (std::uint32_t x = 0; x < base.size(); ++x) {
    if (holder_of(x, n, lit.level) != lit.number) continue;
    base[x] = lit_word;
    for (Level m = 0; m < n; ++m) ++holds[spec::attribute::face_chain(m) + holder_of(x, n, m)];
  }
  std::vector<std::uint32_t> chain(holds.size());
  s.functions.mips.face_chain(n, Rounding::half_up, ChainOf::exact_sums, base, chain);
  Finding found;
  for (Level m = 0; m < n; ++m)
    for (std::uint32_t k = 0; k < face_count(m); ++k) {
      const std::size_t place = spec::attribute::face_chain(m) + k;
      std::uint32_t expected = 0;
      for (unsigned which = 0; which < 4; ++which) {
        const std::uint64_t sum = holds[place] * (lit_word >> 8 * which & 255), count = face_count(n - m);
        expected |= static_cast<std::uint32_t>((2 * sum + count) / (2 * count)) << 8 * which;
      }
      found.answer += Tally::digest_of(place, chain[place]);
      if (chain[place] != expected)
        return wrong(fmt::format("number {} of level {}: {}", k, m, codes_of(expected)),
                     codes_of(chain[place]));
    }
  return found;
}

Law face_mean_law() {
  Cases<Lit> cases;
  cases.count = [](Level n, const Run&) { return spec::attribute::face_chain(n + 1); };
  cases.number = [](Level, std::uint64_t k, std::uint64_t) {
    Level m = 0;
    while (k >= spec::attribute::face_chain(m + 1)) ++m;
    return Lit{m, static_cast<std::uint32_t>(k - spec::attribute::face_chain(m))};
  };
  cases.text = [](Level, const Lit& lit) { return fmt::format("lit={}/{}", lit.level, lit.number); };
  cases.read = [](Level n, const std::string& at) {
    const Groups g = groups_of(at, "lit=(\\d+)/(\\d+)");
    if (!g) throw BadCase(fmt::format("'{:.60}': write lit=LEVEL/NUMBER", at));
    const auto level = static_cast<Level>(number_of((*g)[1], at, n));
    return Lit{level, static_cast<std::uint32_t>(number_of((*g)[2], at, face_count(level) - 1))};
  };
  cases.check = mean_of_lit;
  cases.chunk = 4;
  const auto wrong_chain = [](const char* name, Levels levels, auto by) {
    return mutant(name, "attribute-spec", levels, chaining(by));
  };
  return on_cases(
      {.id = "attribute.face_mip_is_mean",
       .says = "the mip of a face map at micro-triangle k is the mean over all micro-triangles of the base "
               "that lie in it, rounded once: four children along the curve, and theirs",
       .source = cam_44,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 6}, .seconds = 0.3},
       .domain = "the maps that are lit on one micro-triangle of a level up to n; every level below",
       .mutants = {wrong_chain("one mip of level 4's chain is its neighbour's", {4, 4},
                               [](const Chain& real, Level n, Rounding r, ChainOf of, auto base, auto chain) {
                                 real(n, r, of, base, chain);
                                 if (n == 4) chain[60] = chain[61];
                               })}},
      needing({face_chain_entry}), std::move(cases));
}

// ---- Counts

/// A law with one case a level.
Law once_a_level(Law law, Lacks lacks, std::function<Finding(const AttributeSubject&, Level)> check) {
  Cases<Level> cases;
  cases.count = 1;
  cases.number = [](Level n, std::uint64_t, std::uint64_t) { return n; };
  cases.text = [](Level n, Level) { return fmt::format("level={}", n); };
  cases.read = [](Level n, const std::string& at) {
    if (at != fmt::format("level={}", n)) throw BadCase(fmt::format("'{:.60}': write level={}", at, n));
    return n;
  };
  cases.check = [check](const AttributeSubject& s, Level n, Level) { return check(s, n); };
  law.domain = "the level";
  return on_cases(std::move(law), std::move(lacks), std::move(cases));
}

std::function<void(Functions&)> sizing(bool faces, std::function<std::uint64_t(Level, std::uint64_t)> by) {
  return [faces, by](Functions& f) {
    auto& size = faces ? f.mips.face_chain_size : f.mips.vertex_chain_size;
    size = [by, real = size](Level m) { return by(m, real(m)); };
  };
}

/// The counts of levels below m, one after the other.
std::uint64_t summed(Level m, std::uint64_t (*of)(Level)) {
  std::uint64_t sum = 0;
  for (Level l = 0; l < m; ++l) sum += of(l);
  return sum;
}

Law mip_counts_law() {
  return once_a_level(
      {.id = "attribute.face_mip_counts",
       .says = "the levels below n have (4^n - 1)/3 faces, less than a third of the map, and where each is "
               "stored apart ((4^n - 1)/3 + 3 (2^n - 1) + 2n)/2 vertices",
       .source = cam_44,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 0.01},
       .mutants = {mutant(
           "vertices without the corner's one", "attribute", {1, 16},
           sizing(false, [](Level m, std::uint64_t right) { return m == 12 ? right - 1 : right; }))}},
      needing({sizes_entry}), [](const AttributeSubject& s, Level n) {
        const std::uint64_t faces = s.functions.mips.face_chain_size(n),
                            vertices = s.functions.mips.vertex_chain_size(n);
        const std::uint64_t of_faces = summed(n, face_count), of_vertices = summed(n, vertex_count);
        if (faces != of_faces || vertices != of_vertices || 3 * faces >= face_count(n))
          return wrong(fmt::format("{} faces and {} vertices", of_faces, of_vertices),
                       fmt::format("{} and {}", faces, vertices));
        return Finding{.answer = faces ^ vertices << 1};
      });
}

Law mip_third_law() {
  return once_a_level(
      {.id = "paper.mip_third_is_faces_only",
       .says = "\"roughly 33 %\" of extra memory is so of faces, below 1/3 at every level; vertices stored "
               "apart take more than 1/3 at every level from 1 on, 60 % at level 2",
       .source = "Color and Attribute Micromaps, 4.4 and 4.4.1",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 0.01},
       .mutants =
           {mutant("vertices are a third of the map", "attribute-spec", {0, 16},
                   sizing(false, [](Level m, std::uint64_t) { return vertex_count(m) / 3; })),
            mutant("one vertex less at level 2", "attribute-spec", {2, 2},
                   sizing(false, [](Level m, std::uint64_t right) { return m == 2 ? right - 1 : right; })),
            mutant("vertices a third at level 9", "attribute-spec", {9, 9},
                   sizing(false,
                          [](Level m, std::uint64_t right) { return m == 9 ? vertex_count(m) / 3 : right; })),
            mutant("faces and the map's own", "attribute", {0, 16},
                   sizing(true, [](Level m, std::uint64_t) { return spec::attribute::face_chain(m + 1); }))},
       .general = false},
      needing({sizes_entry}), [](const AttributeSubject& s, Level n) {
        const std::uint64_t faces = s.functions.mips.face_chain_size(n),
                            vertices = s.functions.mips.vertex_chain_size(n);
        if (3 * faces >= face_count(n))
          return wrong("less than a third of the faces", fmt::format("{} of {}", faces, face_count(n)));
        if (n != 0 && 3 * vertices <= vertex_count(n))
          return wrong("more than a third of the vertices",
                       fmt::format("{} of {}", vertices, vertex_count(n)));
        if (n == 2 && vertices != 9) return wrong("9 of 15 vertices", fmt::format("{}", vertices));
        return Finding{.answer = faces ^ vertices << 1};
      });
}

/// A vertex of a lower level, in an order.
struct LowerVertex {
  VertexOrder order;
  Level level;
  std::uint32_t number;
};

Finding is_same_place(const AttributeSubject& s, Level n, const LowerVertex& x) {
  const std::uint32_t got = s.functions.mips.vertex_mip_source(x.order, x.number, x.level, n);
  if (x.order == VertexOrder::bird && got != x.number)
    return wrong(fmt::format("{}, its own number", x.number), fmt::format("{}", got));
  // The same place of the triangle, by both vertices.
  const Vertex there = spec::attribute::vertex_at(x.order, x.number, x.level);
  const Vertex scaled{there.i << (n - x.level), there.j << (n - x.level)};
  if (got >= vertex_count(n) || !(spec::attribute::vertex_at(x.order, got, n) == scaled))
    return wrong("the index of " + text_of(scaled), fmt::format("{}", got));
  return {.answer = got};
}

LowerVertex read_lower_vertex(Level n, const std::string& at) {
  const Groups g = groups_of(at, "([a-z-]+):level=(\\d+),vertex=(\\d+)");
  if (!g) throw BadCase(fmt::format("'{:.60}': write bird:level=1,vertex=3", at));
  const auto level = static_cast<Level>(number_of((*g)[2], at, n));
  for (const VertexOrder order : spec::attribute::vertex_orders)
    if ((*g)[1] == name_of(order))
      return LowerVertex{order, level,
                         static_cast<std::uint32_t>(number_of((*g)[3], at, vertex_count(level) - 1))};
  throw BadCase(fmt::format("'{:.60}': orders are w-minor, u-major and bird", at));
}

Law vertex_mip_law() {
  Cases<LowerVertex> cases;
  cases.count = [](Level n, const Run&) { return 3 * spec::attribute::vertex_chain(n + 1); };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) {
    const std::uint64_t all = spec::attribute::vertex_chain(n + 1);
    Level m = 0;
    while (k % all >= spec::attribute::vertex_chain(m + 1)) ++m;
    return LowerVertex{spec::attribute::vertex_orders[k / all], m,
                       static_cast<std::uint32_t>(k % all - spec::attribute::vertex_chain(m))};
  };
  cases.text = [](Level, const LowerVertex& x) {
    return fmt::format("{}:level={},vertex={}", name_of(x.order), x.level, x.number);
  };
  cases.read = read_lower_vertex;
  cases.check = is_same_place;
  cases.kind = Kind::vertex;
  const auto sourcing = [](const char* name, Levels levels, auto by) {
    return mutant(name, "attribute-spec", levels, [by](Functions& f) {
      f.mips.vertex_mip_source = [by, real = f.mips.vertex_mip_source](VertexOrder order, std::uint32_t k,
                                                                       Level m, Level n) {
        return static_cast<std::uint32_t>(by(order, k, m, n, real(order, k, m, n)));
      };
    });
  };
  return on_cases(
      {.id = "attribute.vertex_mip_is_prefix",
       .says = "a map's vertices of each lower level lie in it: in the Bird order they are its first V(m) "
               "values, in the others they are read at a stride of 2^(n-m) along rows or columns",
       .source = cam_441,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 7}, .long_run = {0, 11}, .seconds = 0.3},
       .domain = "the vertices of levels 0..n, in 3 orders",
       .mutants = {sourcing("one vertex of Bird's level 7", {7, 7},
                            [](VertexOrder order, std::uint32_t k, Level m, Level n, std::uint32_t right) {
                              return order == VertexOrder::bird && n == 7 && m == 6 && k == 1000 ? right + 1
                                                                                                 : right;
                            })}},
      needing({source_entry}), std::move(cases));
}

}  // namespace

std::vector<Law> mip_laws() {
  std::vector<Law> all{face_mean_law(), mip_counts_law(), vertex_mip_law(), mip_sample_law()};
  for (const auto& group : {rounding_laws(), lod_laws()}) all.insert(all.end(), group.begin(), group.end());
  return all;
}

std::vector<Law> mip_paper_laws() {
  std::vector<Law> all{mip_third_law()};
  const std::vector<Law> lod = lod_paper_laws();
  all.insert(all.end(), lod.begin(), lod.end());
  return all;
}

}  // namespace mmverify::proofs::attribute
