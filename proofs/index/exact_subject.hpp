// A specification algorithm in exact arithmetic, as a subject.
#pragma once

#include "proofs/index/exact_float.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

template <class Algorithm>
class ExactSubject : public IndexSubject {
 public:
  ExactSubject(std::string name, std::string about, Level max_level = 16)
      : IndexSubject(std::move(name), std::move(about), Arithmetic::exact, max_level) {}

  bool has(Entry e) const override {
    return e == Entry::index || e == Entry::corners || (e == Entry::wide_index && wide);
  }

  void index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = Algorithm::at(batch.points[t], n);
  }
  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = on_exact(batch.u[t], batch.v[t], [n](const auto& p) { return Algorithm::at(p, n); });
  }
  void index(Level n, DoubleBatch batch, std::span<std::uint32_t> out) const override {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = on_exact(batch.u[t], batch.v[t], [n](const auto& p) { return Algorithm::at(p, n); });
  }
  std::uint32_t index(Level n, const RationalPoint& p) const override { return Algorithm::at(p, n); }

  // Fixed64 holds the points of grids up to level 28.
  Level max_wide_level() const override { return wide ? 28 : 0; }
  void wide_index(Level n, const Row& row, std::span<std::uint64_t> out) const override {
    if constexpr (wide)
      for (std::uint64_t t = 0; t < row.count; ++t) out[t] = Algorithm::wide_at(representative(row, t, n), n);
    else
      IndexSubject::wide_index(n, row, out);
  }
  std::uint64_t wide_index(Level n, const RationalPoint& p) const override {
    if constexpr (wide)
      return Algorithm::wide_at(p, n);
    else
      return IndexSubject::wide_index(n, p);
  }

  void corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const override {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = spec::index::corners(indices[t], n);
  }

 private:
  static constexpr bool wide = requires(const RationalPoint& p) { Algorithm::wide_at(p, Level{}); };
};

}  // namespace mmverify::proofs::index
