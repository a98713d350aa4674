// Weighted vertices of an interpolated value, sorted so that two can be compared.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

}  // namespace mmverify::proofs::attribute
