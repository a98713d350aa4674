#include "proofs/index/laws/parts.hpp"

#include <numeric>

#include "proofs/index/laws.hpp"
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

Law over_points(Law law, const Entry& asked, Judge judge, Replay replay) {
  if (!law.cases) law.cases = all_cells;
  if (!law.domain) law.domain = points;
  if (!law.how) law.how = in_fixed_point;
  if (!law.unfit) law.unfit = needing({asked});
  if (law.heeds.empty()) law.heeds = {&interiors_only};
  law.divisible = true;
  law.judge = judged_by(judge);
  if (replay != nullptr) law.replay = replayed_by(replay);
  return law;
}

Law over_indices(Law law, Judge judge, Replay replay) {
  law.cases = all_triangles;
  law.domain = "the 4^n indices";
  law.how = "exhaustive";
  law.divisible = true;
  law.judge = judged_by(judge);
  law.replay = replayed_by(replay);
  return law;
}

Law over_samples(Law law, const CaseCount& samples, SampleJudge judge, Replay replay) {
  law.method = Method::sample;
  law.cases = samples;
  if (!law.how) law.how = by_sample;
  if (!law.unfit) law.unfit = needing({entry::index});
  law.divisible = true;
  law.judge = [samples, judge](const Subject& s, Level n, const Run& run) {
    return judge(subject_as<IndexSubject>(s), n, run, samples(n, run));
  };
  if (replay != nullptr) law.replay = replayed_by(replay);
  return law;
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

namespace {

struct Named {
  CornerOrder order;
  std::array<const char*, 3> corners;
  const char* words;
};
constexpr Named known[] = {{CornerOrder::base_u_v, {"base", "+u", "+v"}, ""},
                           {CornerOrder::of_children, {"0", "2", "3"}, "children "}};

/// The corners in the order of the places.
Corners arranged(const Corners& c, const std::array<std::size_t, 3>& places) {
  return {c[places[0]], c[places[1]], c[places[2]]};
}

}  // namespace

std::string name_corner_order(const IndexSubject& subject, Level n) {
  std::vector<std::uint32_t> indices(std::min<std::uint64_t>(triangle_count(n), 1024));
  std::iota(indices.begin(), indices.end(), 0u);
  std::vector<Corners> got(indices.size());
  subject.functions.corners(n, indices, got);
  for (const Named& one : known) {
    std::array<std::size_t, 3> places{0, 1, 2};
    do {
      if (std::all_of(indices.begin(), indices.end(), [&](std::uint32_t k) {
            return got[k] == arranged(corners_in(one.order, k, n), places);
          }))
        return fmt::format("{}{}, {}, {}", one.words, one.corners[places[0]], one.corners[places[1]],
                           one.corners[places[2]]);
    } while (std::next_permutation(places.begin(), places.end()));
  }
  return "no order that is the same for all";
}

std::optional<std::string> declares_no_order(const Subject& subject, Level n) {
  if (const auto why = needing({entry::corners})(subject, n)) return why;
  const IndexSubject& s = subject_as<IndexSubject>(subject);
  if (s.functions.corner_order != CornerOrder::undeclared) return std::nullopt;
  const Level at = std::min<Level>(3, s.functions.max_level);
  try {
    return fmt::format("{} declares no order of corners; at level {} it is {}", s.name(), at,
                       name_corner_order(s, at));
  } catch (const SubjectBroken&) {  // the laws that ask it on say so
    return s.name() + " declares no order of corners";
  }
}

std::vector<std::string> diagnose_corner_order(const Subject& subject, const std::vector<Result>& results) {
  const Level level = std::find_if(results.begin(), results.end(), [](const Result& r) {
                        return r.verdict == Verdict::refuted;
                      })->level;
  return {fmt::format("its order of corners at level {}: {}", level,
                      name_corner_order(subject_as<IndexSubject>(subject), level))};
}

}  // namespace mmverify::proofs::index
