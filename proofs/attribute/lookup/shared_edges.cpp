#include "proofs/attribute/lookup/shared_edges.hpp"

#include <charconv>

#include "proofs/attribute/elements.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::side;

/// The place along an edge of level n, from its first end, if the vertex lies there.
std::optional<std::uint32_t> place_along(std::uint32_t edge, const Vertex& x, Level n) {
  const std::uint32_t at = edge == 0 ? x.i : edge == 1 ? x.j : side(n) - x.j;
  if (at > side(n) || !(spec::attribute::on_edge(edge, at, n) == x)) return std::nullopt;
  return at;
}

template <class Place>
std::optional<Hats> weights_along(std::uint32_t edge, Level n, const WeightedVertices& w, Place place) {
  Hats hats;
  for (std::size_t c = 0; c < 3; ++c) {
    if (w.weights[c] == 0) continue;
    const auto at = place_along(edge, w.corners[c], n);
    if (!at) return std::nullopt;
    hats.emplace_back(place(*at), w.weights[c]);
  }
  return tidy(std::move(hats));
}

}  // namespace

std::uint64_t shared_edge_cases(Level n) { return 144 * (4 * std::uint64_t{side(n)} + 1); }

SharedEdge shared_edge(Level n, std::uint64_t k) {
  const std::uint64_t points = 4 * std::uint64_t{side(n)} + 1;
  const auto setting = static_cast<std::uint32_t>(k / points);
  // Two bits to the edges after one.
  const auto others = [](std::uint32_t edge, std::uint32_t bits) {
    return (bits & 1) << (edge + 1) % 3 | (bits >> 1) << (edge + 2) % 3;
  };
  const std::uint32_t edge = setting / 48, beside = setting / 4 % 3;
  return {edge, 1u << edge | others(edge, setting / 12 % 4), beside, others(beside, setting % 4), k % points};
}

std::string text_of(Level n, const SharedEdge& e) {
  return fmt::format("edge={},flags={},beside={},its-flags={},at={}/{}", e.edge, e.flags, e.beside,
                     e.its_flags, e.at, 4 * std::uint64_t{side(n)});
}

SharedEdge shared_edge_of_text(Level n, const std::string& text) {
  const Groups groups =
      groups_of(text, "edge=([0-2]),flags=([0-7]),beside=([0-2]),its-flags=([0-7]),at=(\\d{1,9})/(\\d{1,9})");
  if (!groups) throw BadCase(fmt::format("'{:.60}': write edge=0,flags=1,beside=2,its-flags=0,at=1/8", text));
  std::array<std::uint64_t, 6> g{};
  for (std::size_t k = 0; k < g.size(); ++k) {
    const std::string& digits = (*groups)[k + 1];
    std::from_chars(digits.data(), digits.data() + digits.size(), g[k]);
  }
  const SharedEdge e{static_cast<std::uint32_t>(g[0]), static_cast<EdgeFlags>(g[1]),
                     static_cast<std::uint32_t>(g[2]), static_cast<EdgeFlags>(g[3]), g[4]};
  if (g[5] != 4 * std::uint64_t{side(n)} || e.at > g[5])
    throw BadCase(fmt::format("'{:.60}': at is K/{} at level {}", text, 4 * std::uint64_t{side(n)}, n));
  if ((e.flags >> e.edge & 1) == 0 || (e.its_flags >> e.beside & 1) != 0)
    throw BadCase(fmt::format("'{:.60}': the finer map's flags have the edge, the neighbour's do not", text));
  return e;
}

DyadicPoint point_on(std::uint32_t edge, std::uint64_t at, Level n) {
  const auto there = spec::Fixed64::dyadic(static_cast<std::int64_t>(at), n + 2);
  const spec::Fixed64 zero(0), left = spec::Fixed64(1) - there;
  return edge == 0   ? DyadicPoint{there, zero}
         : edge == 1 ? DyadicPoint{left, there}
                     : DyadicPoint{zero, left};
}

std::optional<Hats> of_finer(const AttributeSubject& s, Level n, const SharedEdge& e) {
  return weights_along(e.edge, n, s.functions.decimation.place(n, e.flags, point_on(e.edge, e.at, n)),
                       [](std::uint32_t at) { return std::uint64_t{at}; });
}

std::optional<Hats> of_neighbour(const AttributeSubject& s, Level n, Level lower, const SharedEdge& e) {
  const std::uint64_t all = 4 * std::uint64_t{side(n)}, apart = std::uint64_t{1} << (n - lower);
  return weights_along(e.beside, lower,
                       s.functions.decimation.place(lower, e.its_flags, point_on(e.beside, all - e.at, n)),
                       [&](std::uint32_t at) { return side(n) - apart * at; });
}

Hats along_edge(Level n, std::uint64_t at, std::uint32_t steps) {
  const std::uint64_t apart = side(n) / steps, whole = at / (4 * apart), rest = at % (4 * apart);
  const double next = static_cast<double>(rest) / static_cast<double>(4 * apart);
  return tidy({{apart * whole, 1 - next}, {apart * (whole + 1), next}});
}

namespace {

template <class Name>
std::string joined(const Hats& hats, Name name) {
  std::string text;
  for (const auto& [place, weight] : hats)
    text += fmt::format("{}{} of {}", text.empty() ? "" : " + ", weight, name(place));
  return text.empty() ? "nothing" : text;
}

}  // namespace

std::string text_of(const Hats& hats) {
  return joined(hats, [](std::uint64_t place) { return text_of(spec::attribute::w_minor_vertex(place)); });
}

std::string text_of_places(const Hats& hats) {
  return joined(hats, [](std::uint64_t place) { return fmt::format("vertex {}", place); });
}

}  // namespace mmverify::proofs::attribute
