// The judges on samples.
#include <cmath>

#include "proofs/engine/random.hpp"
#include "proofs/index/floats/published.hpp"
#include "proofs/index/floats/stiff_doubles.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr std::uint64_t floats_per_chunk = 1 << 14;
constexpr std::uint64_t floats_per_batch = 1024;
constexpr std::uint64_t rationals_per_chunk = 64;

/// The kind of the cell that holds the point, by the number of grid lines through it.
template <class Q>
Kind kind_at(const spec::Point<Q>& p, Level n) {
  const Q u = times(side(n), p.u), v = times(side(n), p.v), zero(0), one(1);
  const Q uf = u - Q(whole(u)), vf = v - Q(whole(v));
  if (uf == zero || vf == zero) return uf == zero && vf == zero ? Kind::vertex : Kind::edge;
  return uf + vf == one ? Kind::edge : Kind::interior;
}

Counterexample at_rational(const RationalPoint& p, Level n, std::uint32_t expected, std::uint32_t got) {
  return {simplicity(p),         n, case_text(p, n), hex_text(p), fmt::format("{}", expected),
          fmt::format("{}", got)};
}

/// The same for a pair of floats, whose zeros keep their signs.
template <class F>
Counterexample at_floats(F u, F v, Level n, std::uint32_t expected, std::uint32_t got) {
  const RationalPoint p{rational(u), rational(v)};
  Counterexample found = at_rational(p, n, expected, got);
  const bool negative_u = u == 0 && std::signbit(u), negative_v = v == 0 && std::signbit(v);
  if (!negative_u && !negative_v) return found;
  std::string& text = found.at;
  if (negative_u) text.insert(text.find("u=") + 2, "-");
  if (negative_v) text.insert(text.find("v=") + 2, "-");
  found.hex = fmt::format("({:a},{:a})", u, v);
  return found;
}

/// A random point in a random open cell of the level, in general on no finer grid, and that cell's representative.
struct InCell {
  RationalPoint anywhere, representative;
  Kind kind;
};

InCell random_in_cell(Level n, Random& random) {
  const std::uint64_t N = side(n), j = random.below(N), i = random.below(N - j);
  // The offsets a/d and b/d with a, b > 0 and a+b < d lie inside the upright half of the square.  d is odd, so the
  // point is not dyadic.
  const std::int64_t d = 2 * random.between(1, 1 << 20) + 1, a = random.between(1, d - 2),
                     b = random.between(1, d - 1 - a);
  const auto point = [&](const Rational& du, const Rational& dv) {
    const spec::Integer whole_N(N);
    return RationalPoint{(Rational(spec::Integer(i)) + du) / whole_N,
                         (Rational(spec::Integer(j)) + dv) / whole_N};
  };
  const auto part = [](std::int64_t k, std::int64_t of) {
    return Rational(spec::Integer(k), spec::Integer(of));
  };
  const Rational zero = part(0, 1), one = part(1, 1);
  switch (random.below(5)) {
    case 0: return {point(part(a, d), zero), point(part(1, 2), zero), Kind::edge};
    case 1: return {point(zero, part(a, d)), point(zero, part(1, 2)), Kind::edge};
    case 2: return {point(part(a, d), one - part(a, d)), point(part(1, 2), part(1, 2)), Kind::edge};
    case 3:
      if (i + j + 1 < N)
        return {point(one - part(a, d), one - part(b, d)), point(part(3, 4), part(3, 4)), Kind::interior};
      [[fallthrough]];
    default: return {point(part(a, d), part(b, d)), point(part(1, 4), part(1, 4)), Kind::interior};
  }
}

/// A stiff pair on no grid line of the level: the sample's, or the first one of further seeds.
template <class Draw>
auto inside_pair(Level n, std::uint64_t seed, std::uint64_t sample, Draw draw) {
  for (std::uint64_t further = 0;; ++further) {
    const auto pair = draw(n, seed + further * 0x9E3779B97F4A7C15u, sample + 7 * further);
    const bool inside = on_exact(pair.u, pair.v, [n]<class Q>(const spec::Point<Q>& p) {
      return kind_at(p, n) == Kind::interior && p.u + p.v < Q(1);
    });
    if (inside) return pair;
  }
}

/// The right answer on a pair.
struct Due {
  std::uint32_t index;
  bool allowed = false;  ///< the dialect allows the answer, and exact arithmetic gives another
};

/// Compares answers on pairs of F that `draw` makes, received in that arithmetic, with the right ones: due(u, v, p,
/// n, got) of the pair, the same in exact arithmetic, the level and the answer.
template <class F, class Draw, class Ask, class WhatIsDue>
Tally judged_on_pairs(Level n, const Run& run, std::uint64_t samples, Draw draw, Ask ask, WhatIsDue due,
                      Arithmetic arithmetic) {
  return sweep(
      run, samples, floats_per_chunk,
      [&](Chunk chunk, Tally& tally) {
        std::array<F, floats_per_batch> u, v;
        std::array<std::uint32_t, floats_per_batch> got;
        for (std::uint64_t from = chunk.begin; from < chunk.end; from += floats_per_batch) {
          const std::uint64_t count = std::min(floats_per_batch, chunk.end - from);
          for (std::uint64_t t = 0; t < count; ++t) {
            const auto p = has(run.options, interiors_only) ? inside_pair(n, run.seed, from + t, draw)
                                                            : draw(n, run.seed, from + t);
            u[t] = p.u;
            v[t] = p.v;
          }
          ask(std::span<F>(u.data(), count), std::span<F>(v.data(), count),
              std::span<std::uint32_t>(got.data(), count));
          for (std::uint64_t t = 0; t < count; ++t) {
            const auto [want, kind] = on_exact(u[t], v[t], [&](const auto& p) {
              return std::pair{due(u[t], v[t], p, n, got[t]), kind_at(p, n)};
            });
            tally.count(kind, 1);
            tally.digest(from + t, got[t]);
            if (want.index == got[t] && !want.allowed) continue;
            const RationalPoint p{rational(u[t]), rational(v[t])};
            if (want.allowed || (run.near != 0 && reaches(p, n, got[t], arithmetic, run.near)))
              tally.allow(kind);
            else
              tally.mismatch(kind, simplicity(p),
                             [&, w = want.index] { return at_floats(u[t], v[t], n, w, got[t]); });
          }
        }
      },
      as_one_case(Kind::interior));
}

/// Judges pairs against a specification in exact arithmetic.
template <class F, class Draw, class Ask, class Specified>
Tally exact_on_pairs(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples, Draw draw,
                     Ask ask, Specified specified) {
  return judged_on_pairs<F>(
      n, run, samples, draw, ask,
      [&](F, F, const auto& p, Level level, std::uint32_t) { return Due{specified(p, level)}; },
      s.functions.arithmetic);
}

constexpr auto by_reference = [](const auto& p, Level n) { return spec::index::reference(p, n); };
constexpr auto by_figure_4 = [](const auto& p, Level n) { return spec::index::w_minor(p, n); };

auto asked_on_floats(const IndexSubject& s, Level n) {
  return [&s, n](std::span<float> u, std::span<float> v, std::span<std::uint32_t> got) {
    s.functions.receive_floats(u, v);
    s.functions.index_floats(n, FloatBatch{u, v}, got);
  };
}

}  // namespace

Tally exact_on_floats(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  return exact_on_pairs<float>(s, n, run, samples, stiff_floats, asked_on_floats(s, n), by_reference);
}

Tally equals_published(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  return judged_on_pairs<float>(
      n, run, samples, stiff_floats, asked_on_floats(s, n),
      [](float u, float v, const auto&, Level level, std::uint32_t) { return Due{published(level, u, v)}; },
      Arithmetic::binary32);
}

Tally exact_or_published(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  return judged_on_pairs<float>(
      n, run, samples, stiff_floats, asked_on_floats(s, n),
      [](float u, float v, const auto& p, Level level, std::uint32_t got) {
        const std::uint32_t exact = spec::index::reference(p, level);
        return got != exact && got == published(level, u, v) ? Due{got, true} : Due{exact};
      },
      Arithmetic::binary32);
}

Tally exact_on_doubles(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  const auto ask = [&](std::span<double> u, std::span<double> v, std::span<std::uint32_t> got) {
    s.functions.index_doubles(n, DoubleBatch{u, v}, got);
  };
  return exact_on_pairs<double>(s, n, run, samples, stiff_doubles, ask, by_reference);
}

Tally row_exact_on_floats(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  const auto ask = [&](std::span<float> u, std::span<float> v, std::span<std::uint32_t> got) {
    s.functions.receive_floats(u, v);
    s.functions.row_index_floats(n, FloatBatch{u, v}, got);
  };
  return exact_on_pairs<float>(s, n, run, samples, stiff_rows, ask, by_figure_4);
}

Tally cells_decide(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  return sweep(
      run, samples, rationals_per_chunk,
      [&](Chunk chunk, Tally& tally) {
        for (std::uint64_t sample = chunk.begin; sample < chunk.end; ++sample) {
          Random random(run.seed, n, sample);
          InCell in = random_in_cell(n, random);
          while (has(run.options, interiors_only) && in.kind != Kind::interior)
            in = random_in_cell(n, random);
          const std::uint32_t want = s.functions.index_at(n, in.representative),
                              got = s.functions.index_at(n, in.anywhere);
          tally.count(in.kind, 1);
          tally.digest(sample, got);
          if (want != got)
            tally.mismatch(in.kind, simplicity(in.anywhere),
                           [&] { return at_rational(in.anywhere, n, want, got); });
        }
      },
      as_one_case(Kind::interior));
}

}  // namespace mmverify::proofs::index
