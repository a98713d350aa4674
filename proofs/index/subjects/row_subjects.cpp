// The row order of Color and Attribute Micromaps, figure 4, as subjects: exact, and with its roundings.
#include "proofs/index/subjects/rounded_subject.hpp"

namespace mmverify::proofs::index {
namespace {

/// Figure 4 with the row of an index from a root that the caller chooses.
template <class Root>
Corners corners_by_root(std::uint32_t index, Root root) {
  const std::uint32_t row = root(index), col = index - row * row;
  const auto at = [](std::uint32_t r, std::uint32_t c) { return spec::index::Vertex{r - c, c}; };
  if (col % 2 == 0) return {at(row, col / 2), at(row + 1, col / 2), at(row + 1, col / 2 + 1)};
  return {at(row, col / 2), at(row + 1, col / 2 + 1), at(row, col / 2 + 1)};
}

Functions exact_rows() {
  Functions f;
  f.row_index = [](Level n, Batch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = spec::index::w_minor(batch.points[t], n);
  };
  f.row_index_floats = [](Level n, FloatBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = on_exact(batch.u[t], batch.v[t], [n](const auto& p) { return spec::index::w_minor(p, n); });
  };
  f.row_index_at = [](Level n, const RationalPoint& p) { return spec::index::w_minor(p, n); };
  f.row_corners = [](Level, std::span<const std::uint32_t> indices, std::span<Corners> out) {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = spec::index::w_minor_corners(indices[t]);
  };
  return f;
}

template <class F>
IndexSubjectPtr rounded_rows(const char* name) {
  constexpr auto at = [](Level n, double u, double v) -> std::uint32_t {
    return spec::index::w_minor(spec::Point<F>{Rounding<F>::from(u), Rounding<F>::from(v)}, n);
  };
  Functions f;
  f.arithmetic = Rounding<F>::arithmetic;
  f.row_index = [at](Level n, Batch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, as_double(batch.points[t].u), as_double(batch.points[t].v));
  };
  f.row_index_floats = [at](Level n, FloatBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, static_cast<double>(batch.u[t]), static_cast<double>(batch.v[t]));
  };
  f.row_index_at = [at](Level n, const RationalPoint& p) { return at(n, nearest(p.u), nearest(p.v)); };
  f.row_corners = [](Level, std::span<const std::uint32_t> indices, std::span<Corners> out) {
    const auto root = [](std::uint32_t k) {
      return static_cast<std::uint32_t>(std::sqrt(static_cast<F>(k)));
    };
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = corners_by_root(indices[t], root);
  };
  return std::make_shared<IndexSubject>(
      name, "row order, figure 4 and its square root in " + to_string(f.arithmetic), f);
}

}  // namespace

std::vector<IndexSubjectPtr> row_subjects() {
  return {std::make_shared<IndexSubject>(
              "w-minor", "row order, Color and Attribute Micromaps figure 4, exact", exact_rows()),
          rounded_rows<float>("w-minor-f32"), rounded_rows<double>("w-minor-f64")};
}

}  // namespace mmverify::proofs::index
