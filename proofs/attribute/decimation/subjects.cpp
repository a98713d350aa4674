// Edge decimation of the built-in subjects.
#include "impl/attribute/decimation.hpp"
#include "proofs/attribute/subject_parts.hpp"

namespace mmverify::proofs::attribute {

namespace slow = mmverify::spec::attribute;
namespace fast = mmverify::impl::attribute;

namespace {

double in_double(const spec::Fixed64& q) {
  return static_cast<double>(q.raw()) / static_cast<double>(std::int64_t{1} << spec::Fixed64::fraction_bits);
}

Vertex vertex(const fast::Vertex& x) { return {x.i, x.j}; }
fast::Vertex vertex(const Vertex& x) { return {x.i, x.j}; }

WeightedVertices looked_up(Level n, EdgeFlags flags, float u, float v) {
  const fast::VertexWeights found = fast::decimated_lookup(u, v, n, flags);
  WeightedVertices place{};
  for (std::size_t c = 0; c < 3; ++c) {
    place.corners[c] = vertex(found.vertices[c]);
    place.weights[c] = static_cast<double>(found.weights[c]);
  }
  return place;
}

}  // namespace

Decimation specified_decimation() {
  Decimation f;
  f.snapped = [](Level n, EdgeFlags flags, std::span<const Vertex> at, std::span<Vertex> out) {
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = slow::snapped(at[k], n, flags);
  };
  f.averaged = [](Level n, EdgeFlags flags, std::span<const Vertex> at,
                  std::span<std::array<Vertex, 2>> out) {
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = slow::averaged(at[k], n, flags);
  };
  f.mean = [](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(slow::rounded(std::uint64_t{x} + y, 2, slow::Rounding::half_up));
  };
  f.place = [](Level n, EdgeFlags flags, const DyadicPoint& p) {
    const auto place = slow::decimated_place(p, n, flags);
    WeightedVertices found{place.corners, {}};
    for (std::size_t c = 0; c < 3; ++c)
      found.weights[c] = in_double(place.shares[c]) / static_cast<double>(place.area);
    return found;
  };
  return f;
}

Decimation library_decimation() {
  Decimation f;
  f.snapped = [](Level n, EdgeFlags flags, std::span<const Vertex> at, std::span<Vertex> out) {
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = vertex(fast::snapped(vertex(at[k]), n, flags));
  };
  f.averaged = [](Level n, EdgeFlags flags, std::span<const Vertex> at,
                  std::span<std::array<Vertex, 2>> out) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      const auto [a, b] = fast::averaged(vertex(at[k]), n, flags);
      out[k] = {vertex(a), vertex(b)};
    }
  };
  f.mean = [](std::uint8_t x, std::uint8_t y) {
    // The mean of one code in a word whose other three codes have other means.
    const std::uint32_t word =
        fast::mean_rgba8(0xff0001u | std::uint32_t{x} << 24, 0x01ff00u | std::uint32_t{y} << 24);
    return static_cast<std::uint8_t>(word >> 24);
  };
  f.place = [](Level n, EdgeFlags flags, const DyadicPoint& p) {
    return looked_up(n, flags, static_cast<float>(in_double(p.u)), static_cast<float>(in_double(p.v)));
  };
  f.place_f32 = looked_up;
  return f;
}

}  // namespace mmverify::proofs::attribute
