#include "proofs/index/mutants.hpp"

#include "proofs/engine/spoils.hpp"

namespace mmverify::proofs::index {
namespace {

Change each_point(PointChange change, bool rows_alone) {
  return [=](Functions& f) {
    const auto spoil = [=](Level n, Batch batch, std::span<std::uint32_t> out) {
      if (rows_alone && !batch.row) return;
      for (std::size_t t = 0; t < out.size(); ++t) out[t] = change(n, batch.points[t], out[t]);
    };
    spoils(&Functions::index, spoil)(f);
    spoils(&Functions::row_index, spoil)(f);
    f.index_rows = {};  // the altered `index` stands in for it
  };
}

/// The answers in any rationals.
Change each_rational(const PointChange& change) {
  return [=](Functions& f) {
    for (const auto which : {&Functions::index_at, &Functions::index_on_boost, &Functions::row_index_at})
      on_rationals(which, change)(f);
  };
}

}  // namespace

Change on_rationals(std::function<std::uint32_t(Level, const RationalPoint&)> Functions::*which,
                    PointChange change) {
  return [=](Functions& f) {
    const auto spoil = [=](Level n, const RationalPoint& p, std::uint32_t& answer) {
      const Rational scale(spec::Integer(1) << Fixed64::fraction_bits), u = p.u * scale, v = p.v * scale;
      if (u.denominator() != 1 || v.denominator() != 1) return;
      const auto fixed = [](const Rational& q) {
        return Fixed64::from_raw(static_cast<std::int64_t>(q.numerator()));
      };
      answer = change(n, {fixed(u), fixed(v)}, answer);
    };
    spoils(which, spoil)(f);
  };
}

Change on_points(PointChange change, bool on_rationals) {
  return [=](Functions& f) {
    each_point(change, false)(f);
    if (on_rationals) each_rational(change)(f);
  };
}

Change in_rows(PointChange change) {
  return [=](Functions& f) {
    each_point(change, true)(f);
    each_rational(change)(f);
  };
}

Change on_floats(std::function<std::uint32_t(Level, float, float, std::uint32_t)> change) {
  return [=](Functions& f) {
    const auto spoil = [=](Level n, FloatBatch batch, std::span<std::uint32_t> out) {
      for (std::size_t t = 0; t < out.size(); ++t) out[t] = change(n, batch.u[t], batch.v[t], out[t]);
    };
    const auto spoil_at = [=](Level n, const RationalPoint& p, std::uint32_t& answer) {
      const auto u = static_cast<float>(nearest(p.u)), v = static_cast<float>(nearest(p.v));
      if (rational(u) == p.u && rational(v) == p.v) answer = change(n, u, v, answer);
    };
    spoils(&Functions::index_floats, spoil)(f);
    spoils(&Functions::row_index_floats, spoil)(f);
    spoils(&Functions::index_at, spoil_at)(f);
    spoils(&Functions::row_index_at, spoil_at)(f);
  };
}

Change on_doubles(std::function<std::uint32_t(Level, double, double, std::uint32_t)> change) {
  return [=](Functions& f) {
    spoils(&Functions::index_doubles, [=](Level n, DoubleBatch batch, std::span<std::uint32_t> out) {
      for (std::size_t t = 0; t < out.size(); ++t) out[t] = change(n, batch.u[t], batch.v[t], out[t]);
    })(f);
    spoils(&Functions::index_at, [=](Level n, const RationalPoint& p, std::uint32_t& answer) {
      const double u = nearest(p.u), v = nearest(p.v);
      if (rational(u) == p.u && rational(v) == p.v) answer = change(n, u, v, answer);
    })(f);
  };
}

Change on_indices(std::function<Corners(Level, std::uint32_t, Corners)> change) {
  return [=](Functions& f) {
    const auto spoil = [=](Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) {
      for (std::size_t t = 0; t < out.size(); ++t) out[t] = change(n, indices[t], out[t]);
    };
    spoils(&Functions::corners, spoil)(f);
    spoils(&Functions::row_corners, spoil)(f);
  };
}

PointChange only_at_point(Level level, std::int64_t ku, std::int64_t kv, Level grid, std::uint32_t flip) {
  const GridPoint where{coordinate(ku, grid), coordinate(kv, grid)};
  return [=](Level n, const GridPoint& p, std::uint32_t answer) {
    return n == level && p.u == where.u && p.v == where.v ? answer ^ flip : answer;
  };
}

Mutant single(const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv,
              std::uint32_t flip) {
  return mutant(name, base, {level, level}, on_points(only_at_point(level, ku, kv, level, flip)));
}

Mutant swapped_corners(const char* name, const char* base, Level level, std::uint32_t index) {
  return mutant(name, base, {level, level}, on_indices([=](Level n, std::uint32_t k, Corners c) {
                  if (n == level && k == index) std::swap(c[0], c[1]);
                  return c;
                }));
}

bool on_u_line(const GridPoint& p, Level n) {
  return times(side(n), p.u) == Fixed64(whole(times(side(n), p.u)));
}

}  // namespace mmverify::proofs::index
