// The places of single snapped vertices, at levels whose edges are too long for the fast tier.
#include "proofs/attribute/decimation/mesh.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

constexpr std::uint64_t stream = 0x646563;

/// A vertex and the flags of its case.
struct FlaggedVertex {
  EdgeFlags flags = 0;
  Vertex at{};
};

/// A vertex mostly on an edge, near its ends and its middle; some a step from an edge, some anywhere.
FlaggedVertex flagged_vertex(Level n, std::uint64_t k, std::uint64_t seed) {
  Random random(seed, stream + n, k);
  const std::uint32_t N = spec::side(n);
  const auto below = [&](std::uint64_t limit) { return static_cast<std::uint32_t>(random.below(limit)); };
  const std::array<std::uint32_t, 4> about{0, N / 2, N, below(N + 1)};
  const std::uint32_t middle = about[below(4)], off = below(4),
                      at = below(2) == 0 ? std::min(N, middle + off) : middle - std::min(middle, off);
  FlaggedVertex one{static_cast<EdgeFlags>(k % spec::attribute::edge_flag_sets),
                    spec::attribute::on_edge(below(3), at, n)};
  const std::uint32_t kind = below(8);
  if (kind == 0 && one.at.i > 0) --one.at.i;
  if (kind == 1 && one.at.j > 0) --one.at.j;
  if (kind == 3 && one.at.i + one.at.j < N) ++one.at.i;
  if (kind == 4 && one.at.i + one.at.j < N) ++one.at.j;
  if (kind == 2) {
    one.at.i = below(N + 1);
    one.at.j = below(N - one.at.i + 1);
  }
  return one;
}

std::string text_of_vertex(const Vertex& v) { return fmt::format("i={},j={}", v.i, v.j); }

FlaggedVertex flagged_vertex_of(Level n, const std::string& text) {
  const Groups g = groups_of(text, "flags=([0-7]),i=(\\d{1,5}),j=(\\d{1,5})");
  if (!g) throw BadCase(fmt::format("'{:.60}': write flags=5,i=0,j=3", text));
  const FlaggedVertex one{
      static_cast<EdgeFlags>(std::stoul((*g)[1])),
      {static_cast<std::uint32_t>(std::stoul((*g)[2])), static_cast<std::uint32_t>(std::stoul((*g)[3]))}};
  if (one.at.i + one.at.j > spec::side(n))
    throw BadCase(fmt::format("'{:.60}': no vertex of level {}", text, n));
  return one;
}

Finding goes_where_it_may(const AttributeSubject& s, Level n, const FlaggedVertex& one) {
  Vertex got{};
  s.functions.decimation.snapped(n, one.flags, {&one.at, 1}, {&got, 1});
  const Finding fine{std::uint64_t{got.i} << 32 | got.j};
  const auto place = spec::attribute::decimated_at(one.at, n, one.flags);
  if (!place.decimated) return got == one.at ? fine : wrong(text_of_vertex(one.at), text_of_vertex(got));
  const Vertex before = spec::attribute::on_edge(place.edge, place.at - 1, n),
               after = spec::attribute::on_edge(place.edge, place.at + 1, n);
  if (got == before || got == after) return fine;
  return wrong(fmt::format("{} or {}", text_of_vertex(before), text_of_vertex(after)), text_of_vertex(got));
}

/// A mutant that snaps vertices at levels above 12 as `moves` says.
Mutant wrong_above_12(const char* name, Vertex (*moves)(Level n, const Vertex& asked, const Vertex& right)) {
  return mutant(name, "attribute-spec", {13, 16},
                spoils(&Functions::decimation, &Decimation::snapped,
                       [moves](Level n, EdgeFlags, std::span<const Vertex> at, std::span<Vertex> out) {
                         for (std::size_t k = 0; n > 12 && k < at.size(); ++k)
                           out[k] = moves(n, at[k], out[k]);
                       }));
}

}  // namespace

Law decimation_sample_law() {
  Cases<FlaggedVertex> cases;
  cases.count = {2'048, 262'144};
  cases.number = flagged_vertex;
  cases.text = [](Level, const FlaggedVertex& one) {
    return fmt::format("flags={},{}", one.flags, text_of_vertex(one.at));
  };
  cases.read = flagged_vertex_of;
  cases.check = goes_where_it_may;
  return on_cases({.id = "attribute.decimation_on_samples",
                   .says = "an odd vertex of a flagged edge goes to one of its two even neighbours on it, "
                           "every other one stays",
                   .source = cam_3,
                   .method = Method::sample,
                   .subjects = {"attribute-spec", "attribute"},
                   .tiers = {.fast = {9, 16}, .long_run = {9, 16}, .seconds = 0.2},
                   .domain = "the 8 sets of flags; vertices about the ends and middles of base edges, a step "
                             "from them, and anywhere",
                   .mutants = {wrong_above_12("a vertex beside the edge v-w goes there",
                                              [](Level, const Vertex&, const Vertex& right) {
                                                return Vertex{right.i == 1 ? 0 : right.i, right.j};
                                              })}},
                  needing({snapped_entry}), std::move(cases));
}

}  // namespace mmverify::proofs::attribute
