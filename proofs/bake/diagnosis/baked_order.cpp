#include "proofs/bake/diagnosis/baked_order.hpp"

#include "proofs/index/diagnosis.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint32_t texels_along = 16;  ///< a micro-triangle's side

/// Transparent, but for four texels about the centroid of a micro-triangle: no other one meets what is sampled of them.
Case dotted(const points::MicroTriangle& m, Level n) {
  Case one;
  one.width = one.height = texels_along << n;
  one.wrap_u = one.wrap_v = Wrap::clamp_to_edge;
  one.uv = {0, 0, 1, 0, 0, 1};
  one.alpha.assign(std::size_t{one.width} * one.height, 0);
  const std::uint32_t third = texels_along * (m.inverted ? 2 : 1) / 3;
  const std::uint32_t i = m.i * texels_along + third, j = m.j * texels_along + third;
  for (const std::uint32_t row : {j - 1, j})
    for (const std::uint32_t column : {i - 1, i}) one.alpha[column + std::size_t{one.width} * row] = 255;
  return one;
}

/// The one micro-triangle that is not transparent; 4^n where it is none, or not the only one.
std::uint32_t dot_of(const Baked& baked) {
  const auto count = static_cast<std::uint32_t>(baked.states.size());
  std::uint32_t found = count;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (baked.states[k] == State::T) continue;
    if (found != count) return count;
    found = k;
  }
  return found;
}

}  // namespace

std::string order_of(const BakeSubject& s, Level n) {
  const std::uint32_t none = std::uint32_t{1} << 2 * n;
  if (texels_along << n > s.functions.support.max_side) return {};
  bool all = true;
  const std::string order = index::name_order(n, [&](const points::MicroTriangle& m) {
    if (!all) return none;
    const std::optional<Baked> baked =
        s.functions.bake(fitted(s.functions.support, dotted(m, n), 0), n, Format::four_state);
    const std::uint32_t found = baked ? dot_of(*baked) : none;
    all = all && found != none;
    return found;
  });
  return all ? order : std::string();
}

}  // namespace mmverify::proofs::bake
