#include "proofs/attribute/lookup/grid_cases.hpp"

namespace mmverify::proofs::attribute {

using spec::times;
using spec::whole;

void fill(Level n, std::uint64_t first, std::span<GridCase> out) {
  std::vector<Vertex> at(out.size());
  fill(n + 2, first, std::span(at));
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto [i, j] = at[k];
    const int lines = (i % 4 == 0 ? 1 : 0) + (j % 4 == 0 ? 1 : 0) + ((i + j) % 4 == 0 ? 1 : 0);
    out[k] = {{points::coordinate(i, n), points::coordinate(j, n)},
              lines == 0   ? Kind::interior
              : lines == 1 ? Kind::edge
                           : Kind::vertex};
  }
}

std::string text_of(const GridCase& of) {
  // Its kind, "v:" and so on, is left out: it follows from the point.
  return points::case_text(points::rational(of.at), 0).substr(2);
}

void read(Level n, const std::string& text, GridCase& of) {
  const RationalPoint p = points::parse_point(text);
  const spec::Integer grid(4 * std::uint64_t{spec::side(n)});
  const auto number = [&](const spec::Rational& q) {
    const spec::Rational k = q * grid;
    if (k.denominator() != 1 || k < spec::Integer(0))
      throw BadCase(
          fmt::format("'{:.60}': at level {} a multiple of 1/{}", text, n, 4 * std::uint64_t{spec::side(n)}));
    return static_cast<std::int64_t>(k.numerator());
  };
  const std::int64_t u = number(p.u), v = number(p.v);
  if (u + v > static_cast<std::int64_t>(grid))
    throw BadCase(fmt::format("'{:.60}' lies outside the triangle", text));
  of = {{points::coordinate(u, n), points::coordinate(v, n)}, points::kind_of(p, n)};
}

std::vector<Looked> looked_up(const AttributeSubject& s, VertexOrder order, Level n,
                              std::span<const GridPoint> at) {
  std::vector<Triplet> triplets(at.size());
  std::vector<FixedWeights> weights(at.size());
  s.functions.lookup.triplet(order, n, at, triplets);
  s.functions.lookup.weights(n, at, weights);
  std::vector<Looked> found;
  for (std::size_t k = 0; k < at.size(); ++k) found.push_back({triplets[k], weights[k]});
  return found;
}

std::string text_of(const Looked& found) {
  const auto number = [](const Fixed64& w) {
    return static_cast<double>(w.raw()) / static_cast<double>(std::uint32_t{1} << Fixed64::fraction_bits);
  };
  const auto& [t, w] = found;
  return fmt::format("vertices {} {} {} at {} {} {}", t[0], t[1], t[2], number(w[0]), number(w[1]),
                     number(w[2]));
}

void Blend::add(std::uint64_t vertex, const Fixed64& weight) {
  if (weight == Fixed64(0)) return;
  parts_[size_++] = {vertex, weight};
  std::sort(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(size_),
            [](const auto& a, const auto& b) { return a.first < b.first; });
}

Blend blend_of(const Looked& found) {
  Blend blend;
  for (std::size_t c = 0; c < 3; ++c) blend.add(found.triplet[c], found.weights[c]);
  return blend;
}

Blend blend_on(const MicroTriangle& t, VertexOrder order, Level n, const GridPoint& at) {
  const auto x = spec::attribute::triplet(order, t, n);
  const FixedWeights w = spec::attribute::weights_by_pattern(at, t, n);
  Blend blend;
  for (std::size_t c = 0; c < 3; ++c) blend.add(x[c], w[c]);
  return blend;
}

std::vector<MicroTriangle> all_holders(Level n, const GridPoint& at) {
  const std::int64_t N = spec::side(n), iu = whole(times(spec::side(n), at.u)),
                     iv = whole(times(spec::side(n), at.v));
  std::vector<MicroTriangle> found;
  for (std::int64_t i = std::max<std::int64_t>(iu - 1, 0); i <= iu; ++i)
    for (std::int64_t j = std::max<std::int64_t>(iv - 1, 0); j <= iv; ++j)
      for (const bool upper : {false, true}) {
        if (i + j + (upper ? 1 : 0) >= N) continue;
        const MicroTriangle t{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), upper};
        const FixedWeights w = spec::attribute::weights_by_pattern(at, t, n);
        if (std::none_of(w.begin(), w.end(), [](const Fixed64& q) { return q < Fixed64(0); }))
          found.push_back(t);
      }
  return found;
}

}  // namespace mmverify::proofs::attribute
