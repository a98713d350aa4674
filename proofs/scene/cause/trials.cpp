#include "proofs/scene/cause/trials.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace mmverify::proofs::scene {
namespace {

/// Whether a fit is right, and decidedly better than that of the maps as they are stored.
bool explains(const Fit& is, const Fit& was) {
  if (2 * is.needless > is.unknown()) return false;
  if (was.wrong != 0) return is.needless <= is.equal / 4;
  if (was.needless != 0) return 4 * is.needless <= was.needless;
  return 4 * is.side <= was.side;
}

}  // namespace

/// The sum of fits, primitive by primitive: a primitive that is better as it is stored stays so.
Trials::Sum Trials::sum(const std::vector<std::size_t>& triangles, const Maps& maps) const {
  std::map<std::size_t, std::array<Sum, 2>> of_primitive;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    auto& [now, changed] = of_primitive[examined_.link(triangles[k]).primitive];
    const Fit& was = examined_.fit(triangles[k]);
    const Fit is = fit(maps.stored[k], maps.expected[k]);
    now.fit += was;
    now.all_right = now.all_right && was.is_right();
    changed.fit += is;
    changed.all_right = changed.all_right && is.wrong == 0;
    const bool is_wrong = was.wrong + was.needless != 0;
    changed.explained += is_wrong && is < was && is.wrong == 0 ? examined_.times(triangles[k]) : 0;
  }
  Sum all;
  for (const auto& [primitive, both] : of_primitive) {
    const Sum& better = both[1].fit < both[0].fit ? both[1] : both[0];
    all.fit += better.fit;
    all.explained += better.explained;
    all.all_right = all.all_right && better.all_right;
  }
  return all;
}

bool Trials::attempt(const std::string& code, const std::string& says, const Make& make,
                     std::uint64_t evidence, bool exact) {
  stop_if_due(examined_.judged());
  try {
    return keeps_within_domain(code, says, make, evidence, exact);
  } catch (const std::invalid_argument&) {
    return false;  // the changed UVs, or factors, are beyond what can be baked: no baker made these maps so
  }
}

bool Trials::keeps_within_domain(const std::string& code, const std::string& says, const Make& make,
                                 std::uint64_t evidence, bool exact) {
  const auto is_enough = [&](const Sum& is, const Fit& was) {
    return is.fit.wrong == 0 && is.all_right && is.fit.evidence() >= evidence && explains(is.fit, was) &&
           (!exact || is.fit.needless == 0);
  };
  const std::vector<std::size_t>&tried = examined_.tried(), &all = examined_.all();
  if (exact && !fits_first(make)) return false;
  const Sum here = sum(tried, make(tried));
  if (!is_enough(here, examined_.fit(tried))) return false;
  fitting_.emplace_back(code, here.fit);
  if (best_ && !(here.fit < tried_fit_)) return false;
  const Sum everywhere = tried.size() == all.size() ? here : sum(all, make(all));
  if (!is_enough(everywhere, examined_.fit())) return false;
  tried_fit_ = here.fit;
  best_ = Cause{code, says, 0, everywhere.explained};
  return true;
}

/// Whether a change fits each state of the first tried triangle: most changes do not, which spares the others.
bool Trials::fits_first(const Make& make) const {
  const std::vector<std::size_t> first{examined_.tried().front()};
  const Maps maps = make(first);
  const Fit is = fit(maps.stored[0], maps.expected[0]);
  return is.wrong == 0 && is.needless == 0;
}

bool Trials::is_doubtful() const {
  return tried_fit_.needless != 0 && std::any_of(fitting_.begin(), fitting_.end(), [this](const auto& other) {
           return other.first != best_->code && other.second.needless < 2 * tried_fit_.needless;
         });
}

}  // namespace mmverify::proofs::scene
