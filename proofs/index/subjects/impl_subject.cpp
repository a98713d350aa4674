// Our own library, as a subject.
#include "impl/index/wide.hpp"
#include "proofs/index/subjects/rounded_subject.hpp"

namespace mmverify::proofs::index {
namespace {

namespace fast = impl::index;

/// Calls a batched function of impl on grid points; they are exact in binary32 up to the grid of level 17.
template <class Batched>
void on_floats(Batch batch, std::span<std::uint32_t> out, Batched batched) {
  constexpr std::size_t piece = 4096;
  std::array<float, piece> u, v;
  for (std::size_t from = 0; from < out.size(); from += piece) {
    const std::size_t count = std::min(piece, out.size() - from);
    for (std::size_t t = 0; t < count; ++t) {
      constexpr float scale = 1.0f / (1 << Fixed64::fraction_bits);
      u[t] = static_cast<float>(static_cast<std::int32_t>(batch.points[from + t].u.raw())) * scale;
      v[t] = static_cast<float>(static_cast<std::int32_t>(batch.points[from + t].v.raw())) * scale;
    }
    batched(std::span<const float>(u.data(), count), std::span<const float>(v.data(), count),
            out.subspan(from, count));
  }
}

/// Calls a batched index -> corners function of impl.
template <class Batched>
void to_corners(std::span<const std::uint32_t> indices, std::span<Corners> out, Batched batched) {
  std::array<std::vector<std::uint32_t>, 6> c;
  for (auto& coordinate : c) coordinate.resize(indices.size());
  batched(indices, fast::CornerSpans{c[0], c[1], c[2], c[3], c[4], c[5]});
  for (std::size_t t = 0; t < out.size(); ++t) {
    using spec::index::Vertex;
    out[t] = {Vertex{c[0][t], c[1][t]}, Vertex{c[2][t], c[3][t]}, Vertex{c[4][t], c[5][t]}};
  }
}

/// A batch of one point over and over: a replay goes through the same vector code as the sweep.
template <class Batched>
std::uint32_t repeated(const RationalPoint& p, Batched batched) {
  constexpr std::size_t vectors = 64;
  std::array<float, vectors> u, v;
  std::array<std::uint32_t, vectors> out;
  u.fill(static_cast<float>(nearest(p.u)));
  v.fill(static_cast<float>(nearest(p.v)));
  batched(std::span<const float>(u), std::span<const float>(v), std::span<std::uint32_t>(out));
  return out.front();
}

Functions library_functions() {
  Functions f;
  f.arithmetic = Arithmetic::binary32;
  f.max_level = fast::max_level;
  f.receive_at = [](const RationalPoint& p) -> RationalPoint {
    return {rounded<float>(p.u), rounded<float>(p.v)};
  };

  f.index = [](Level n, Batch batch, std::span<std::uint32_t> out) {
    on_floats(batch, out, [n](auto u, auto v, auto to) { fast::from_barycentrics(u, v, n, to); });
  };
  f.index_floats = [](Level n, FloatBatch batch, std::span<std::uint32_t> out) {
    fast::from_barycentrics(batch.u, batch.v, n, out);
  };
  f.index_at = [](Level n, const RationalPoint& p) {
    return repeated(p, [n](auto u, auto v, auto to) { fast::from_barycentrics(u, v, n, to); });
  };
  f.corner_order = CornerOrder::of_children;
  f.corners = [](Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) {
    to_corners(indices, out, [n](auto k, const auto& to) { fast::corners(k, n, to); });
  };

  f.row_index = [](Level n, Batch batch, std::span<std::uint32_t> out) {
    on_floats(batch, out, [n](auto u, auto v, auto to) { fast::w_minor(u, v, n, to); });
  };
  f.row_index_floats = [](Level n, FloatBatch batch, std::span<std::uint32_t> out) {
    fast::w_minor(batch.u, batch.v, n, out);
  };
  f.row_index_at = [](Level n, const RationalPoint& p) {
    return repeated(p, [n](auto u, auto v, auto to) { fast::w_minor(u, v, n, to); });
  };
  f.row_corners = [](Level, std::span<const std::uint32_t> indices, std::span<Corners> out) {
    to_corners(indices, out, [](auto k, const auto& to) { fast::w_minor_corners(k, to); });
  };

  f.max_wide_level = 21;  // whose representatives have 24 bits
  f.wide_index = [](Level n, const Row& row, std::span<std::uint64_t> out) {
    const float scale = 1.0f / static_cast<float>(std::uint32_t{4} << n),
                v = static_cast<float>(row.kv) * scale;
    auto k = static_cast<std::int32_t>(row.ku);
    for (std::uint64_t t = 0; t < row.count; ++t, k += static_cast<std::int32_t>(row.stride))
      out[t] = fast::from_barycentrics_wide(static_cast<float>(k) * scale, v, n);
  };
  f.wide_index_at = [](Level n, const RationalPoint& p) {
    return fast::from_barycentrics_wide(static_cast<float>(nearest(p.u)), static_cast<float>(nearest(p.v)),
                                        n);
  };
  return f;
}

}  // namespace

IndexSubjectPtr impl_subject() {
  return std::make_shared<IndexSubject>("impl", "this project's library, batched", library_functions());
}

}  // namespace mmverify::proofs::index
