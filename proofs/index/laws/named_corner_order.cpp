#include "proofs/index/laws/named_corner_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "proofs/index/judges/corner_order.hpp"
#include "proofs/index/laws/parts.hpp"

namespace mmverify::proofs::index {
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
