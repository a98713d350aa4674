// Our own library, as a subject.
#include <array>
#include <vector>

#include "impl/index/wide.hpp"
#include "proofs/index/built_in.hpp"
#include "proofs/index/rounded_subject.hpp"

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

class ImplSubject : public IndexSubject {
 public:
  ImplSubject()
      : IndexSubject("impl", "this project's library, batched", Arithmetic::binary32, fast::max_level) {}

  bool has(Entry) const override { return true; }

  RationalPoint receive(const RationalPoint& p) const override { return {rounded(p.u), rounded(p.v)}; }

  void index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    on_floats(batch, out, [n](auto u, auto v, auto to) { fast::from_barycentrics(u, v, n, to); });
  }
  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    fast::from_barycentrics(batch.u, batch.v, n, out);
  }
  std::uint32_t index(Level n, const RationalPoint& p) const override {
    return at_point(p, [n](auto u, auto v, auto to) { fast::from_barycentrics(u, v, n, to); });
  }
  Level max_wide_level() const override { return 21; }  // whose representatives have 24 bits
  void wide_index(Level n, const Row& row, std::span<std::uint64_t> out) const override {
    const float scale = 1.0f / static_cast<float>(std::uint32_t{4} << n),
                v = static_cast<float>(row.kv) * scale;
    auto k = static_cast<std::int32_t>(row.ku);
    for (std::uint64_t t = 0; t < row.count; ++t, k += static_cast<std::int32_t>(row.stride))
      out[t] = fast::from_barycentrics_wide(static_cast<float>(k) * scale, v, n);
  }
  std::uint64_t wide_index(Level n, const RationalPoint& p) const override {
    return fast::from_barycentrics_wide(static_cast<float>(nearest(p.u)), static_cast<float>(nearest(p.v)),
                                        n);
  }
  void corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const override {
    to_corners(indices, out, [n](auto k, const auto& to) { fast::corners(k, n, to); });
  }
  void row_index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    on_floats(batch, out, [n](auto u, auto v, auto to) { fast::w_minor(u, v, n, to); });
  }
  void row_index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    fast::w_minor(batch.u, batch.v, n, out);
  }
  std::uint32_t row_index(Level n, const RationalPoint& p) const override {
    return at_point(p, [n](auto u, auto v, auto to) { fast::w_minor(u, v, n, to); });
  }
  void row_corners(Level, std::span<const std::uint32_t> indices, std::span<Corners> out) const override {
    to_corners(indices, out, [](auto k, const auto& to) { fast::w_minor_corners(k, to); });
  }

 private:
  /// A batch of one point over and over: a replay goes through the same vector code as the sweep.
  template <class Batched>
  static std::uint32_t at_point(const RationalPoint& p, Batched batched) {
    constexpr std::size_t vectors = 64;
    std::array<float, vectors> u, v;
    std::array<std::uint32_t, vectors> out;
    u.fill(static_cast<float>(nearest(p.u)));
    v.fill(static_cast<float>(nearest(p.v)));
    batched(std::span<const float>(u), std::span<const float>(v), std::span<std::uint32_t>(out));
    return out.front();
  }
  static Rational rounded(const Rational& q) { return rational(static_cast<float>(nearest(q))); }
};

}  // namespace

std::shared_ptr<const IndexSubject> impl_subject() { return std::make_shared<ImplSubject>(); }

}  // namespace mmverify::proofs::index
