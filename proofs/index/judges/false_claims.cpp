#include "proofs/engine/interrupt.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/judges/on_cells.hpp"

namespace mmverify::proofs::index {
namespace {

/// A sweep that an interrupt cut short may have missed the difference that a law asks for: it says nothing.
Tally unless_interrupted(Tally sweep) {
  if (interrupted()) throw Interrupted();
  return sweep;
}

/// The cases and the digest of a sweep, its mismatches forgotten: here they are what the law asks for.
Tally counted(const Tally& sweep, const Run& run) {
  Tally tally(run.errors);
  for (const Kind kind : {Kind::vertex, Kind::edge, Kind::interior})
    tally.count(kind, sweep.by_kind()[static_cast<std::size_t>(kind)].cases);
  tally.digest_sum(sweep.digest());
  return tally;
}

std::string said(const Tally& sweep) {
  if (sweep.found().empty()) return "no difference";
  const Counterexample& c = sweep.found().front();
  return fmt::format("{} there instead of {}, first at {}", c.got, c.expected, c.at);
}

Run keeping_one(const Run& run) {
  Run one = run;
  one.errors = 1;
  return one;
}

/// Significant bits of the subject's numbers.
int precision(Arithmetic a) {
  switch (a) {
    case Arithmetic::binary16: return 11;
    case Arithmetic::binary32: return 24;
    default: return 53;
  }
}

}  // namespace

Tally differs_first(const IndexSubject& s, Level n, const Run& run, const std::vector<Difference>& stated) {
  const Tally sweep = unless_interrupted(equals_reference(s, n, keeping_one(run)));
  Tally tally = counted(sweep, run);
  const auto next =
      std::find_if(stated.begin(), stated.end(), [n](const Difference& d) { return d.from_level > n; });
  const bool begun = next != stated.begin();
  const Difference& d = begun ? *std::prev(next) : stated.front();
  const GridPoint where{coordinate(d.ku, d.from_level), coordinate(d.kv, d.from_level)};
  const std::string at = case_text(rational(where), n);

  bool holds = sweep.found().empty();
  std::string expected = "no difference";
  if (begun && n > d.from_level) {
    expected = "a first difference at " + at;
    holds = !sweep.found().empty() && sweep.found().front().at == at;
  } else if (begun) {
    expected = fmt::format("{} there instead of {}, first at {}", d.got, d.expected, at);
    holds = said(sweep) == expected;
  }
  if (!holds)
    tally.mismatch(kind_of(rational(where), n), {},
                   [&] { return at_point(where, n, expected, said(sweep)); });
  return tally;
}

Tally differs_on_hypotenuse(const IndexSubject& s, Level n, const Run& run) {
  const Tally sweep = unless_interrupted(equals_reference(s, n, keeping_one(run)));
  Tally tally = counted(sweep, run);
  const auto wrong = [&](Kind kind) { return sweep.by_kind()[static_cast<std::size_t>(kind)].mismatches; };
  const std::uint64_t due = n == 0 ? 1 : side(n) + 1;
  std::uint64_t there = 0;
  for (std::uint64_t k = 0; k <= side(n); ++k) {
    const auto i = static_cast<std::int64_t>(k), N = static_cast<std::int64_t>(side(n));
    const RationalPoint p = rational(GridPoint{coordinate(4 * i, n), coordinate(4 * (N - i), n)});
    if (s.functions.index_at(n, p) != spec::index::reference(p, n)) ++there;
  }
  if (there != due || wrong(Kind::vertex) != due || wrong(Kind::edge) + wrong(Kind::interior) != 0)
    tally.mismatch(Kind::vertex, {}, [&] {
      return at_point(GridPoint{coordinate(0, n), coordinate(4 * static_cast<std::int64_t>(side(n)), n)}, n,
                      fmt::format("{} wrong vertices, all on the hypotenuse", due),
                      fmt::format("{} on the hypotenuse, {} vertices, {} edges and {} interiors in all",
                                  there, wrong(Kind::vertex), wrong(Kind::edge), wrong(Kind::interior)));
    });
  return tally;
}

Tally floats_err(const IndexSubject& s, Level n, const Run& run) {
  const int p = precision(s.functions.arithmetic);
  const auto power = [](int e) { return Rational(spec::Integer(1), spec::Integer(1) << e); };
  const Rational one(spec::Integer(1)), N(spec::Integer(side(n)));
  const std::array points{RationalPoint{(one - power(p)) / N, power(p + 1) / N},
                          RationalPoint{power(2), power(2) - power(p + 2)}};
  Tally tally(run.errors);
  tally.count(Kind::interior, 1);
  std::uint64_t wrong = 0, number = 0;
  for (const RationalPoint& point : points) {
    const std::uint32_t got = s.functions.index_at(n, s.functions.receive_at(point));
    tally.digest(number++, got);
    wrong += got != spec::index::reference(s.functions.receive_at(point), n) ? 1 : 0;
  }
  if (wrong == 0)
    tally.mismatch(Kind::interior, {}, [&] {
      return Counterexample{
          {}, n, case_text(points[0], n), hex_text(points[0]), "a wrong index", "the right one"};
    });
  return tally;
}

Tally binary32_root_errs(const IndexSubject& s, Level n, const Run& run) {
  constexpr std::uint32_t first_wrong = 4097 * 4097 - 2;
  const Tally sweep = unless_interrupted(row_corners(s, n, keeping_one(run)));
  Tally tally = counted(sweep, run);
  const bool wrong_in_range = first_wrong < triangle_count(n);
  const std::string at = fmt::format("k={}", first_wrong);
  const bool holds =
      wrong_in_range ? !sweep.found().empty() && sweep.found().front().at == at : sweep.found().empty();
  if (!holds)
    tally.mismatch(Kind::interior, {}, [&] {
      return Counterexample{
          {}, n, at, {}, wrong_in_range ? "a first difference at " + at : "no difference", said(sweep)};
    });
  return tally;
}

}  // namespace mmverify::proofs::index
