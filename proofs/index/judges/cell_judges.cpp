// The judges that compare answers on cells.
#include <fmt/format.h>

#include <array>

#include "proofs/index/floats/published.hpp"
#include "proofs/index/grid/reference_sweep.hpp"
#include "proofs/index/in_rationals.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/options.hpp"
#include "proofs/index/picture.hpp"
#include "spec/rational.hpp"

namespace mmverify::proofs::index {
namespace {

template <class At>
Answers one_by_one(At at) {
  return [at](Batch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(batch.points[t]);
  };
}

/// The subject's answers of level n on the cells of `grid`.
Answers asked(const IndexSubject& s, Level n, Level grid) {
  return {[&s, n](Batch batch, std::span<std::uint32_t> out) { s.functions.index(n, batch, out); },
          [&s, n, grid](std::span<const Row> rows, std::span<std::uint32_t> out) {
            s.functions.index_rows(n, grid, rows, out);
          }};
}
Answers asked(const IndexSubject& s, Level n) { return asked(s, n, n); }

/// The subject's answers in rationals: Boost's, or above boost_levels our own.
Answers asked_in_rationals(const IndexSubject& s, Level n) {
  const auto& at = n <= boost_levels ? s.functions.index_on_boost : s.functions.index_at;
  return one_by_one([&at, n](const GridPoint& p) { return at(n, rational(p)); });
}

/// The reference's, in the same rationals.
std::uint32_t reference_in_rationals(const GridPoint& point, Level n) {
  const RationalPoint p = rational(point);
  if (n <= boost_levels) return spec::index::reference(p, n);
  return in_rationals(p, [n](const auto& q) { return spec::index::reference(q, n); });
}

/// The micro-triangle that a point of a grid line belongs to: on its +u, +v side; on the hypotenuse, which
/// has no such side, the one at -u, and at the v-corner the last one.
template <class Q>
MicroTriangle rounded_away_from_w(const spec::Point<Q>& p, Level n) {
  const std::uint32_t N = side(n);
  const Q u = times(N, p.u), v = times(N, p.v), one(1);
  std::uint32_t i = whole(u), j = whole(v);
  const bool upper_half = !(u - Q(i) + (v - Q(j)) < one);
  if (i + j < N) return {i, j, upper_half && i + j + 1 < N};
  return i > 0 ? MicroTriangle{i - 1, j, false} : MicroTriangle{0, N - 1, false};
}

Replayed compared(Level n, const RationalPoint& p, std::uint32_t want, std::uint32_t got,
                  Order order = Order::curve) {
  return {want == got, fmt::format("{}", want), fmt::format("{}", got), picture(n, p, want, got, order)};
}

}  // namespace

RationalPoint received_point(const IndexSubject& s, const std::string& at) {
  const RationalPoint p = parse_point(at), q = s.functions.receive_at(p);
  if (p.u != q.u || p.v != q.v)
    throw BadCase(fmt::format("'{}' is not a pair of {} numbers, which {} takes", at,
                              to_string(s.functions.arithmetic), s.name()));
  return p;
}

Tally equals_reference(const IndexSubject& s, Level n, const Run& run) {
  if (s.exact() && !has(run.options, in_fixed_point_alone) && n <= rational_levels) {
    const Answers oracle = one_by_one([n](const GridPoint& p) { return reference_in_rationals(p, n); });
    return compare_on_cells(s, n, run, oracle, asked_in_rationals(s, n));
  }
  const Answers oracle{
      [n](Batch batch, std::span<std::uint32_t> out) { reference_batch(n, batch.points, out); },
      [n](std::span<const Row> rows, std::span<std::uint32_t> out) { reference_rows(n, n, rows, out); }};
  return compare_on_cells(s, n, run, oracle, asked(s, n));
}

namespace {

/// A coordinate as a number; -0 for a zero whose text has a minus sign.
template <class F>
std::array<F, 1> signed_number(const Rational& x, bool negative) {
  const auto near = static_cast<F>(nearest(x));
  return {negative && near == 0 ? -F{0} : near};
}

/// The subject's index at the point of a text, in the subject's own arithmetic.
std::uint32_t index_at_text(const IndexSubject& s, Level n, const RationalPoint& p, const std::string& at) {
  const bool u_is = at.find("u=-0") != std::string::npos, v_is = at.find("v=-0") != std::string::npos;
  std::array<std::uint32_t, 1> got{};
  if (u_is || v_is) {
    if (s.functions.arithmetic == Arithmetic::binary64 && s.functions.index_doubles) {
      const auto u = signed_number<double>(p.u, u_is), v = signed_number<double>(p.v, v_is);
      s.functions.index_doubles(n, DoubleBatch{u, v}, got);
      return got[0];
    }
    if (s.functions.arithmetic == Arithmetic::binary32 && s.functions.index_floats) {
      const auto u = signed_number<float>(p.u, u_is), v = signed_number<float>(p.v, v_is);
      s.functions.index_floats(n, FloatBatch{u, v}, got);
      return got[0];
    }
  }
  return s.functions.index_at(n, p);
}

}  // namespace

Replayed replay_equals_reference(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  const std::uint32_t want = spec::index::reference(p, n), got = index_at_text(s, n, p, at);
  return compared(n, p, want, got == want && n <= boost_levels ? s.functions.index_on_boost(n, p) : got);
}

Replayed replay_equals_published(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  const std::uint32_t want = published(n, static_cast<float>(nearest(p.u)), static_cast<float>(nearest(p.v)));
  return compared(n, p, want, index_at_text(s, n, p, at));
}

Replayed replay_exact_or_published(const IndexSubject& s, Level n, const std::string& at) {
  const Replayed by_code = replay_equals_published(s, n, at);
  return by_code.holds ? by_code : replay_equals_reference(s, n, at);
}

Tally in_range(const IndexSubject& s, Level n, const Run& run) {
  const auto last = static_cast<std::uint32_t>(triangle_count(n) - 1);
  const Answers kept = [&](Batch batch, std::span<std::uint32_t> out) {
    s.functions.index(n, batch, out);
    for (std::uint32_t& index : out) index = std::min(index, last);
  };
  return compare_on_cells(s, n, run, kept, asked(s, n),
                          [n](std::uint32_t) { return fmt::format("below 4^{}", n); });
}

Replayed replay_in_range(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  const std::uint32_t got = s.functions.index_at(n, p);
  return {got < triangle_count(n), fmt::format("below 4^{}", n), fmt::format("{}", got),
          picture(n, p, spec::index::reference(p, n), got, Order::curve)};
}

Tally nested(const IndexSubject& s, Level n, const Run& run) {
  const Answers quarter = [&s, n](Batch batch, std::span<std::uint32_t> out) {
    s.functions.index(n + 1, batch, out);
    for (std::uint32_t& index : out) index /= 4;
  };
  return compare_on_cells(s, n + 1, run, asked(s, n, n + 1), quarter);
}

Replayed replay_nested(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  return compared(n, p, s.functions.index_at(n, p), s.functions.index_at(n + 1, p) / 4);
}

Tally rounding(const IndexSubject& s, Level n, const Run& run) {
  const Answers inside = [&s, n](Batch batch, std::span<std::uint32_t> out) {
    std::vector<GridPoint> points;
    for (const GridPoint& p : batch.points) points.push_back(representative(rounded_away_from_w(p, n), n));
    s.functions.index(n, {points, false}, out);
  };
  return compare_on_cells(s, n, run, inside, asked(s, n));
}

Replayed replay_rounding(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  const std::uint32_t want = s.functions.index_at(n, rational(representative(rounded_away_from_w(p, n), n)));
  return compared(n, p, want, s.functions.index_at(n, p));
}

Tally fixed_is_rational(const IndexSubject& s, Level n, const Run& run) {
  const Answers alone = [&s, n](Batch batch, std::span<std::uint32_t> out) {
    s.functions.index(n, {batch.points, false}, out);
    if (n > boost_levels) return;
    // Our own rationals are held to Boost's as well: where they err and fixed point does not, their answer is shown.
    for (std::size_t t = 0; t < out.size(); ++t) {
      const RationalPoint p = rational(batch.points[t]);
      const std::uint32_t ours = s.functions.index_at(n, p);
      if (ours != out[t] && out[t] == s.functions.index_on_boost(n, p)) out[t] = ours;
    }
  };
  return compare_on_cells(s, n, run, asked_in_rationals(s, n), alone);
}

Tally sweep_is_spec(const IndexSubject& s, Level n, const Run& run) {
  const Answers alone = [&s, n](Batch batch, std::span<std::uint32_t> out) {
    s.functions.index(n, {batch.points, false}, out);
  };
  return compare_on_cells(s, n, run, alone, asked(s, n));
}

Tally row_order(const IndexSubject& s, Level n, const Run& run) {
  const Answers figure_4 = one_by_one([n](const GridPoint& p) { return spec::index::w_minor(p, n); });
  return compare_on_cells(s, n, run, figure_4, [&s, n](Batch batch, std::span<std::uint32_t> out) {
    s.functions.row_index(n, batch, out);
  });
}

namespace {
/// Whether the closed micro-triangle with these corners holds the point: on no edge's outer side.
template <class Q>
bool holds(const Corners& c, const spec::Point<Q>& p, Level n) {
  const Q u = times(side(n), p.u), v = times(side(n), p.v);
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = c[k], &b = c[(k + 1) % 3];
    // The edges of micro-triangles run along u, v or their difference, so the cross product needs no products
    // of points.
    const auto times_signed = [](std::int64_t f, const Q& q) {
      return f == 0  ? Q(0)
             : f > 0 ? times(static_cast<std::uint32_t>(f), q)
                     : Q(0) - times(static_cast<std::uint32_t>(-f), q);
    };
    const std::int64_t di = std::int64_t{b.i} - a.i, dj = std::int64_t{b.j} - a.j;
    const Q cross = times_signed(di, v - Q(a.j)) - times_signed(dj, u - Q(a.i));
    left += cross < Q(0) ? 0 : 1;
    right += Q(0) < cross ? 0 : 1;
  }
  return left == 3 || right == 3;
}
}  // namespace

Replayed replay_row_order(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  return compared(n, p, spec::index::w_minor(p, n), s.functions.row_index_at(n, p), Order::rows);
}

Tally row_holds_point(const IndexSubject& s, Level n, const Run& run) {
  // The answer is compared with itself where its micro-triangle holds the point, and with no index where not.
  const Answers held = [&s, n](Batch batch, std::span<std::uint32_t> out) {
    s.functions.row_index(n, batch, out);
    for (std::size_t t = 0; t < out.size(); ++t)
      if (out[t] >= triangle_count(n) || !holds(spec::index::w_minor_corners(out[t]), batch.points[t], n))
        out[t] = ~out[t];
  };
  return compare_on_cells(
      s, n, run, held,
      [&s, n](Batch batch, std::span<std::uint32_t> out) { s.functions.row_index(n, batch, out); },
      [](std::uint32_t) { return std::string("a micro-triangle that holds the point"); });
}

Replayed replay_row_holds_point(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  const std::uint32_t got = s.functions.row_index_at(n, p);
  return {got < triangle_count(n) && holds(spec::index::w_minor_corners(got), p, n),
          "a micro-triangle that holds the point", fmt::format("{}", got),
          picture(n, p, spec::index::w_minor(p, n), got, Order::rows)};
}

}  // namespace mmverify::proofs::index
