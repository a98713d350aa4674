// A specification algorithm in exact arithmetic, as a subject has it.
#pragma once

#include "proofs/index/in_rationals.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

template <class Algorithm>
Functions exactly() {
  Functions f;
  f.index = [](Level n, Batch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = Algorithm::at(batch.points[t], n);
  };
  f.index_floats = [](Level n, FloatBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = on_exact(batch.u[t], batch.v[t], [n](const auto& p) { return Algorithm::at(p, n); });
  };
  f.index_doubles = [](Level n, DoubleBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = on_exact(batch.u[t], batch.v[t], [n](const auto& p) { return Algorithm::at(p, n); });
  };
  f.index_at = [](Level n, const RationalPoint& p) {
    return in_rationals(p, [n](const auto& q) { return Algorithm::at(q, n); });
  };
  f.index_on_boost = [](Level n, const RationalPoint& p) { return Algorithm::at(p, n); };
  f.corner_order = CornerOrder::of_children;
  f.corners = [](Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = spec::index::corners(indices[t], n);
  };
  if constexpr (requires(const RationalPoint& p) { Algorithm::wide_at(p, Level{}); }) {
    f.max_wide_level = 28;  // Fixed64 holds the points of its grid.
    f.wide_index = [](Level n, const Row& row, std::span<std::uint64_t> out) {
      for (std::uint64_t t = 0; t < row.count; ++t) out[t] = Algorithm::wide_at(representative(row, t, n), n);
    };
    f.wide_index_at = [](Level n, const RationalPoint& p) {
      return in_rationals(p, [n](const auto& q) { return Algorithm::wide_at(q, n); });
    };
  }
  return f;
}

}  // namespace mmverify::proofs::index
