#include "scene/plan/uv_duplicates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mmverify::scene {
namespace {

/// Shifts the least corner into the first period, unless the shift would round a corner.
void shift(UvTriangle& uvs, std::size_t axis, int period) {
  if (period == 0) return;
  const double least = std::min({uvs[0][axis], uvs[1][axis], uvs[2][axis]});
  const double by = std::floor(least / period) * period;
  if (by == 0) return;
  std::array<float, 3> shifted;
  for (std::size_t k = 0; k < 3; ++k) {
    const double from = uvs[k][axis], to = from - by;
    shifted[k] = static_cast<float>(to);
    // The shift is exact if the result is a float32 and the difference lost nothing; then both ways back give
    // the same.
    if (double{shifted[k]} != to || to + by != from || from - to != by) return;
  }
  for (std::size_t k = 0; k < 3; ++k) uvs[k][axis] = shifted[k];
}

}  // namespace

Periods periods(const Sampler& sampler) {
  const auto period = [](Wrap wrap) {
    return wrap == Wrap::repeat ? 1 : wrap == Wrap::mirrored_repeat ? 2 : 0;
  };
  return {period(sampler.wrap_u), period(sampler.wrap_v)};
}

std::size_t UvDuplicates::Hash::operator()(const Key& key) const {
  std::uint64_t hash = key.surface;
  // The multiplier of Fibonacci hashing: odd, with random bits.
  for (const Corner& corner : key.corners)
    for (const float x : corner)
      hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(hash ^ hash >> 32);
}

UvDuplicates::Match UvDuplicates::add(std::uint32_t surface, const UvTriangle& given, const Periods& periods,
                                      const CornerAlphas& alphas) {
  UvTriangle uvs = given;
  for (Uv& corner : uvs)
    for (float& x : corner) x += 0.0f;  // -0 + 0 is +0, so that equal floats hash alike
  for (std::size_t axis = 0; axis < 2; ++axis) shift(uvs, axis, periods[axis]);
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = {uvs[k][0], uvs[k][1], alphas[k] + 0.0f};
  Key key{surface, corners};
  std::sort(key.corners.begin(), key.corners.end());
  const auto [entry, is_new] = distinct_.try_emplace(key, First{distinct_.size(), corners});
  const Corners& first = entry->second.corners;
  VertexOrder order{0, 1, 2};
  while (corners[0] != first[order[0]] || corners[1] != first[order[1]] || corners[2] != first[order[2]])
    std::next_permutation(order.begin(), order.end());
  return {entry->second.number, order, is_new};
}

}  // namespace mmverify::scene
