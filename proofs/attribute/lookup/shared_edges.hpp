// Two base triangles with a common edge, one of them of a lower level: the interpolated values at its points.
#pragma once

#include <cmath>

#include "proofs/attribute/decimation/mesh.hpp"
#include "proofs/attribute/subject.hpp"
#include "spec/attribute/decimation.hpp"

namespace mmverify::proofs::attribute {

/// Weights by place: the number of a vertex or a position on an edge.  No weight is 0.
using Hats = std::vector<std::pair<std::uint64_t, double>>;

/// Adds up the weights of each place, drops zeros and sorts by place.
inline Hats tidy(Hats hats) {
  std::sort(hats.begin(), hats.end());
  Hats sums;
  for (const auto& [place, weight] : hats) {
    if (!sums.empty() && sums.back().first == place)
      sums.back().second += weight;
    else
      sums.emplace_back(place, weight);
  }
  std::erase_if(sums, [](const auto& h) { return h.second == 0; });
  return sums;
}

inline Hats hats_of(const WeightedVertices& w) {
  Hats hats;
  for (std::size_t c = 0; c < 3; ++c) hats.emplace_back(number(w.corners[c]), w.weights[c]);
  return tidy(std::move(hats));
}

/// Whether all weights agree within a bound; a missing weight counts as 0.
inline bool same(const Hats& a, const Hats& b, double within) {
  Hats difference = a;
  for (const auto& [place, weight] : b) difference.emplace_back(place, -weight);
  for (const auto& [place, weight] : tidy(std::move(difference)))
    if (!(std::abs(weight) <= within)) return false;
  return true;
}

/// The hats as text, "1/2 of i=0,j=1 + ...", weights in decimal.
std::string text_of(const Hats& hats);
/// The hats by places on an edge as text, "0.5 of 2 + ...".
std::string text_of_places(const Hats& hats);

/// The number of binary64 nearest to a fixed-point number.
template <class Word, unsigned F>
double as_number(const spec::Fixed<Word, F>& q) {
  return std::ldexp(static_cast<double>(q.raw()), -static_cast<int>(F));
}

/// The hats of each live micro-triangle that holds the point once vertices have snapped.  A vertex moves one step
/// along its edge (level 1: a triangle of two steps), so the square of such a micro-triangle is at most two squares
/// away from the point's.
template <class Q>
std::vector<Hats> all_that_hold(const spec::Point<Q>& p, Level n, EdgeFlags flags) {
  std::vector<Hats> found;
  const spec::attribute::MicroTriangle at = spec::attribute::vulkan_triangle(p, n);
  const auto low = [](std::uint32_t x) { return x < 2 ? 0 : x - 2; };
  for (std::uint32_t iu = low(at.iu); iu <= at.iu + 2; ++iu)
    for (std::uint32_t iv = low(at.iv); iv <= at.iv + 2; ++iv)
      for (const bool upper : {false, true}) {
        if (iu + iv + (upper ? 1 : 0) >= spec::side(n)) continue;
        const auto place = spec::attribute::place_on(
            spec::attribute::snapped(spec::attribute::MicroTriangle{iu, iv, upper}, n, flags), p, n);
        if (!place.holds()) continue;
        Hats hats;
        for (std::size_t c = 0; c < 3; ++c)
          hats.emplace_back(number(place.corners[c]),
                            as_number(place.shares[c]) / static_cast<double>(place.area));
        found.push_back(tidy(std::move(hats)));
      }
  return found;
}

/// A point of the common edge, at/(4N) along it from the first end of the finer map's edge.  That end is the last end
/// of the neighbour's edge, since both triangles wind the same way.
struct SharedEdge {
  std::uint32_t edge;  ///< of the finer map, whose flags mark it
  EdgeFlags flags;
  std::uint32_t beside;  ///< the neighbour's edge, which its flags do not mark
  EdgeFlags its_flags;
  std::uint64_t at;
};

/// The number of cases: 3 edges and 4 sets of other flags on either side, 4N + 1 points.
std::uint64_t shared_edge_cases(Level n);
SharedEdge shared_edge(Level n, std::uint64_t k);
/// "edge=0,flags=1,beside=2,its-flags=0,at=3/8".
std::string text_of(Level n, const SharedEdge& e);
/// Reads what text_of() writes.  Throws BadCase for any other text.
SharedEdge shared_edge_of_text(Level n, const std::string& text);

/// The point on an edge of a map of any level.
DyadicPoint point_on(std::uint32_t edge, std::uint64_t at, Level n);

/// The interpolated values of the finer map of level n and of the neighbour of level `lower`, by places 0..N along
/// the finer map's edge.  Nothing if a vertex off the edge has a weight.
std::optional<Hats> of_finer(const AttributeSubject& s, Level n, const SharedEdge& e);
std::optional<Hats> of_neighbour(const AttributeSubject& s, Level n, Level lower, const SharedEdge& e);

/// The hat functions of an edge of `steps` steps at a point, by places of the finer map: the vertices on either side
/// share the weight.
Hats along_edge(Level n, std::uint64_t at, std::uint32_t steps);

}  // namespace mmverify::proofs::attribute
