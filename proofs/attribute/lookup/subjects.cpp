// The lookups of the built-in subjects.
#include "impl/attribute/lookup.hpp"
#include "proofs/attribute/subject_parts.hpp"
#include "proofs/points/exact_float.hpp"

namespace mmverify::proofs::attribute {

namespace {

namespace spec_ = mmverify::spec::attribute;
namespace impl_ = mmverify::impl::attribute;

impl_::VertexOrder of_impl(VertexOrder order) { return static_cast<impl_::VertexOrder>(order); }

Triplet narrow(const spec_::Triplet& t) {
  return {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
          static_cast<std::uint32_t>(t[2])};
}

/// Grid points as binary32 numbers: at most 19 bits each.
struct AsFloats {
  explicit AsFloats(Points p) {
    constexpr float scale = 1.0f / static_cast<float>(std::uint32_t{1} << Fixed64::fraction_bits);
    for (const GridPoint& at : p) {
      u.push_back(static_cast<float>(at.u.raw()) * scale);
      v.push_back(static_cast<float>(at.v.raw()) * scale);
    }
  }
  FloatPoints points() const { return {u, v}; }
  std::vector<float> u, v;
};

/// Weights of grid points are multiples of 1/4; of a subject that is wrong, what is nearest.
Fixed64 nearest_fixed(float w) {
  constexpr float scale = static_cast<float>(std::uint32_t{1} << Fixed64::fraction_bits);
  const bool sane = w > -4.0f && w < 4.0f;
  return Fixed64::from_raw(sane ? static_cast<std::int64_t>(w * scale) : -1);
}

}  // namespace

void answer_points_by_floats(Lookup& f) {
  if (f.triplet_of_floats)
    f.triplet = [ask = f.triplet_of_floats](VertexOrder order, Level n, Points p, std::span<Triplet> out) {
      ask(order, n, AsFloats(p).points(), out);
    };
  if (f.weights_of_floats)
    f.weights = [ask = f.weights_of_floats](Level n, Points p, std::span<FixedWeights> out) {
      std::vector<FloatWeights> found(out.size());
      ask(n, AsFloats(p).points(), found);
      for (std::size_t k = 0; k < out.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) out[k][c] = nearest_fixed(found[k][c]);
    };
}

Lookup specified_lookup() {
  Lookup f;
  f.triplet = [](VertexOrder order, Level n, Points p, std::span<Triplet> out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = narrow(spec_::triplet(order, spec_::vulkan_triangle(p[k], n), n));
  };
  f.weights = [](Level n, Points p, std::span<FixedWeights> out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = spec_::weights_by_pattern(p[k], spec_::vulkan_triangle(p[k], n), n);
  };
  f.holder = [](Ties ties, Level n, Points p, std::span<MicroTriangle> out) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = spec_::holder(ties, p[k], n);
  };
  f.remap = [](Remap way, Level n, const MicroTriangle& t, const RationalPoint& p) {
    if (way == Remap::pattern) return spec_::weights_by_pattern(p, t, n);
    if (way == Remap::two) return spec_::weights_by_two(p, spec_::corners_of(t), n);
    return spec_::weights_by_cramer(p, spec_::corners_of(t), n);
  };
  return f;
}

Lookup library_lookup() {
  Lookup f;
  f.triplet_of_floats = [](VertexOrder order, Level n, FloatPoints p, std::span<Triplet> out) {
    std::vector<std::uint32_t> x0(out.size()), x1(out.size()), x2(out.size());
    impl_::triplets(of_impl(order), p.u, p.v, n, {x0, x1, x2});
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = {x0[k], x1[k], x2[k]};
  };
  f.weights_of_floats = [](Level n, FloatPoints p, std::span<FloatWeights> out) {
    std::vector<float> w0(out.size()), w1(out.size()), w2(out.size());
    impl_::weights(p.u, p.v, n, {w0, w1, w2});
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = {w0[k], w1[k], w2[k]};
  };
  f.rgba8 = [](VertexOrder order, Level n, std::span<const std::uint32_t> map, FloatPoints p,
               std::span<std::uint32_t> out) {
    impl_::interpolated_rgba8(of_impl(order), map, p.u, p.v, n, out);
  };
  answer_points_by_floats(f);
  return f;
}

Lookup library_lookup_one_by_one() {
  Lookup f;
  f.triplet_of_floats = [](VertexOrder order, Level n, FloatPoints p, std::span<Triplet> out) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = impl_::triplet(of_impl(order), p.u[k], p.v[k], n);
  };
  f.weights_of_floats = [](Level n, FloatPoints p, std::span<FloatWeights> out) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = impl_::locate(p.u[k], p.v[k], n).weights;
  };
  f.rgba8 = [](VertexOrder order, Level n, std::span<const std::uint32_t> map, FloatPoints p,
               std::span<std::uint32_t> out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = impl_::interpolated_rgba8(of_impl(order), map, p.u[k], p.v[k], n);
  };
  answer_points_by_floats(f);
  return f;
}

Lookup rounded_lookup(Remap way) {
  Lookup f;
  f.weights_of_floats = [way](Level n, FloatPoints p, std::span<FloatWeights> out) {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const impl_::MicroTriangle t = impl_::locate(p.u[k], p.v[k], n).at;
      const MicroTriangle at{t.iu, t.iv, t.upper};
      const spec::Point<float> point{p.u[k], p.v[k]};
      out[k] = way == Remap::pattern ? spec_::weights_by_pattern(point, at, n)
               : way == Remap::two   ? spec_::weights_by_two(point, spec_::corners_of(at), n)
                                     : spec_::weights_by_cramer(point, spec_::corners_of(at), n);
    }
  };
  answer_points_by_floats(f);
  return f;
}

}  // namespace mmverify::proofs::attribute
