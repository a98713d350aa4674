#include "proofs/index/altered.hpp"

namespace mmverify::proofs::index {
namespace {

class Altered : public IndexSubject {
 public:
  Altered(std::string name, SubjectOfIndex base, Alteration alteration, bool rows_only)
      : IndexSubject(std::move(name), "broken on purpose", base->arithmetic(), base->max_level()),
        base_(std::move(base)),
        alteration_(std::move(alteration)),
        rows_only_(rows_only) {}

  bool has(Entry e) const override { return base_->has(e); }
  void receive(std::span<GridPoint> points) const override { base_->receive(points); }
  void receive(std::span<float> u, std::span<float> v) const override { base_->receive(u, v); }
  RationalPoint receive(const RationalPoint& p) const override { return base_->receive(p); }

  void index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    base_->index(n, batch, out);
    change_points(n, batch, out);
  }
  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    base_->index(n, batch, out);
    change_floats(n, batch, out);
  }
  void index(Level n, DoubleBatch batch, std::span<std::uint32_t> out) const override {
    base_->index(n, batch, out);
    if (!alteration_.on_doubles) return;
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = alteration_.on_doubles(n, batch.u[t], batch.v[t], out[t]);
  }
  std::uint32_t index(Level n, const RationalPoint& p) const override {
    return changed(n, p, base_->index(n, p));
  }

  void corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const override {
    base_->corners(n, indices, out);
    change_corners(n, indices, out);
  }
  void row_index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    base_->row_index(n, batch, out);
    change_points(n, batch, out);
  }
  void row_index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    base_->row_index(n, batch, out);
    change_floats(n, batch, out);
  }
  std::uint32_t row_index(Level n, const RationalPoint& p) const override {
    return changed(n, p, base_->row_index(n, p));
  }
  void row_corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const override {
    base_->row_corners(n, indices, out);
    change_corners(n, indices, out);
  }

 private:
  /// The answer at one point, changed as it is among others.
  std::uint32_t changed(Level n, const RationalPoint& p, std::uint32_t answer) const {
    const double u64 = nearest(p.u), v64 = nearest(p.v);
    if (alteration_.on_doubles && rational(u64) == p.u && rational(v64) == p.v)
      answer = alteration_.on_doubles(n, u64, v64, answer);
    const auto u32 = static_cast<float>(u64), v32 = static_cast<float>(v64);
    if (alteration_.on_floats && rational(u32) == p.u && rational(v32) == p.v)
      answer = alteration_.on_floats(n, u32, v32, answer);
    if (!alteration_.on_rationals || !alteration_.on_point) return answer;
    const Rational scale(spec::Integer(1) << Fixed64::fraction_bits), u = p.u * scale, v = p.v * scale;
    if (u.denominator() != 1 || v.denominator() != 1) return answer;
    const auto fixed = [](const Rational& q) {
      return Fixed64::from_raw(static_cast<std::int64_t>(q.numerator()));
    };
    return alteration_.on_point(n, {fixed(u), fixed(v)}, answer);
  }
  void change_floats(Level n, FloatBatch batch, std::span<std::uint32_t> out) const {
    if (!alteration_.on_floats) return;
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = alteration_.on_floats(n, batch.u[t], batch.v[t], out[t]);
  }
  void change_points(Level n, Batch batch, std::span<std::uint32_t> out) const {
    if (!alteration_.on_point || (rows_only_ && !batch.row)) return;
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = alteration_.on_point(n, batch.points[t], out[t]);
  }
  void change_corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const {
    if (!alteration_.on_corners) return;
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = alteration_.on_corners(n, indices[t], out[t]);
  }

  SubjectOfIndex base_;
  Alteration alteration_;
  bool rows_only_;
};

}  // namespace

std::shared_ptr<const IndexSubject> altered(std::string name, SubjectOfIndex base, Alteration alteration) {
  return std::make_shared<Altered>(std::move(name), std::move(base), std::move(alteration), false);
}

std::shared_ptr<const IndexSubject> altered_in_rows(std::string name, SubjectOfIndex base,
                                                    Alteration alteration) {
  return std::make_shared<Altered>(std::move(name), std::move(base), std::move(alteration), true);
}

Alteration only_at_point(Level level, std::int64_t ku, std::int64_t kv, Level grid, std::uint32_t flip) {
  const GridPoint where{coordinate(ku, grid), coordinate(kv, grid)};
  return {.on_point =
              [=](Level n, const GridPoint& p, std::uint32_t answer) {
                return n == level && p.u == where.u && p.v == where.v ? answer ^ flip : answer;
              },
          .on_floats = {},
          .on_corners = {},
          .on_rationals = true,
          .on_doubles = {}};
}

Alteration only_at_index(Level level, std::uint32_t index) {
  return {.on_point = {},
          .on_floats = {},
          .on_corners =
              [=](Level n, std::uint32_t k, Corners c) {
                if (n == level && k == index) std::swap(c[0], c[1]);
                return c;
              },
          .on_rationals = true,
          .on_doubles = {}};
}

}  // namespace mmverify::proofs::index
