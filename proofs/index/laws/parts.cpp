#include "proofs/index/laws/parts.hpp"

#include <fmt/format.h>

#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {

std::function<Tally(const Subject&, Level, const Run&)> judged_by(Judge judge) {
  return [judge](const Subject& s, Level n, const Run& run) {
    return judge(subject_as<IndexSubject>(s), n, run);
  };
}
std::function<Replayed(const Subject&, Level, const std::string&)> replayed_by(Replay replay) {
  return [replay](const Subject& s, Level n, const std::string& at) {
    return replay(subject_as<IndexSubject>(s), n, at);
  };
}

std::uint64_t all_cells(Level n, const Run& run) {
  return has(run.options, interiors_only) ? triangle_count(n) : cell_count(n);
}
std::uint64_t next_cells(Level n, const Run& run) { return all_cells(n + 1, run); }
std::uint64_t all_triangles(Level n, const Run&) { return triangle_count(n); }

std::string points(const Subject& subject, Level n) {
  const IndexSubject& s = subject_as<IndexSubject>(subject);
  if (s.exact()) return "every rational point of the triangle, by its 3N^2+3N+1 cells";
  const bool representable = s.functions.arithmetic != Arithmetic::binary16 || n + 2 <= 11;
  return fmt::format("the 3N^2+3N+1 representatives, {} {} numbers", representable ? "as" : "rounded to",
                     to_string(s.functions.arithmetic));
}
std::string next_points(const Subject& s, Level n) { return points(s, n + 1) + " of level n+1"; }
std::string triangles(const Subject& subject, Level) {
  return subject_as<IndexSubject>(subject).exact() ? "the 4^n open micro-triangles"
                                                   : "one point inside each of the 4^n micro-triangles";
}
std::string indices(const Subject&, Level) { return "the 4^n indices"; }

std::string in_fixed_point(const Subject& s, Level) {
  return s.exact() ? "exhaustive, 64-bit fixed point" : "exhaustive, against 64-bit fixed point";
}
namespace {
const char* rationals_of(Level n) { return n <= boost_levels ? "Boost.Rational" : "rationals of 63 bits"; }
}  // namespace
std::string in_rationals_then_fixed_point(const Subject& s, Level n) {
  return s.exact() && n <= rational_levels ? fmt::format("exhaustive, {}", rationals_of(n))
                                           : in_fixed_point(s, n);
}
std::string against_rationals(const Subject& s, Level n) {
  return fmt::format("{}, against {}", in_fixed_point(s, n), rationals_of(n));
}
std::string exhaustively(const Subject&, Level) { return "exhaustive"; }
std::string by_sample(const Subject&, Level) { return "sample, against exact arithmetic"; }
std::string by_witness(const Subject&, Level) { return "witness, against exact arithmetic"; }

Unfit needing(std::vector<Entry> entries, Level above) {
  return unless_of_topic<IndexSubject>(lacking<IndexSubject>(
      std::move(entries),
      [above](const IndexSubject& s, Level n) { return above_its_levels(s, n + above); }));
}

Unfit needing_exact(std::vector<Entry> entries) {
  return [fits = needing(std::move(entries))](const Subject& subject, Level n) -> std::optional<std::string> {
    if (!subject.exact()) return subject.name() + " does not compute in exact arithmetic";
    return fits(subject, n);
  };
}

}  // namespace mmverify::proofs::index
