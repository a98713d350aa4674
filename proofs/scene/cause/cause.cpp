#include "proofs/scene/cause/cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "proofs/engine/interrupt.hpp"
#include "proofs/scene/cause/changes.hpp"
#include "proofs/scene/cause/cutoff.hpp"
#include "proofs/scene/cause/links.hpp"
#include "proofs/scene/cause/texture_age.hpp"

namespace mmverify::proofs::scene {
namespace {

using mmverify::scene::BakedTriangle;
using mmverify::scene::VertexOrder;

/// A change is tried on so many triangles, of so many micro-triangles in all; the best one is then judged by all.
constexpr std::size_t most_tried = 64;
constexpr std::uint64_t most_micro_triangles = std::uint64_t{1} << 18;
/// Micro-triangles of the triangles that are looked at, at most; beyond it every n-th triangle is.
constexpr std::uint64_t most_looked_at = std::uint64_t{1} << 24;
/// So many states have to speak for a change: few states fit many changes by chance.  More are wanted where each record
/// is tried.
constexpr std::uint64_t least_evidence = 8, least_evidence_of_records = 16;

/// A cause with the fit that it gives.
struct Candidate {
  Cause cause;
  Fit fit;
};

class Search {
 public:
  /// Looks at about `most` micro-triangles.
  Search(const Judged& judged, std::uint64_t most) : judged_(judged), inputs_(inputs_of(judged)) {
    choose_all(most);
    const std::vector<States> right = expected(judged, inputs_, all_);
    for (std::size_t k = 0; k < all_.size(); ++k) {
      stored_[all_[k]] = states_of(judged.maps.baked.triangles[all_[k]]);
      right_[all_[k]] = right[k];
      const Fit here = fits_[all_[k]] = fit(stored_[all_[k]], right[k]);
      as_stored_ += here;
      wrong_ += here.wrong + here.needless != 0 ? times(all_[k]) : 0;
    }
    choose();
  }

  /// The cause of unknown states on the other side.
  std::optional<Cause> side_cause() const {
    if (as_stored_.side < least_evidence || as_stored_.side <= 3 * as_stored_.same) return {};
    std::uint64_t triangles = 0;
    for (const std::size_t k : all_) triangles += fits_.at(k).side != 0 ? times(k) : 0;
    return Cause{
        "unknown_side",
        fmt::format(
            "{} of {} unknown states are on the other side: force-2-state makes O of them where alpha at "
            "the centroid is transparent, and T where it is opaque",
            as_stored_.side, as_stored_.side + as_stored_.same),
        triangles, triangles};
  }

  std::optional<Cause> cause() {
    if (as_stored_.wrong + as_stored_.needless + as_stored_.side == 0) return {};
    try_maps();
    try_corners();
    try_links();
    try_inputs();
    try_cutoff();
    if ((best_ == nullptr || tried_fit_.needless != 0) && try_special()) return finished();
    if (best_ != nullptr && is_doubtful()) return {};
    if (best_ == nullptr) try_other_triangles();
    if (best_ == nullptr) try_texture();
    if (best_ == nullptr) return {};
    name_other_primitive();
    return finished();
  }

 private:
  Cause finished() {
    best_->cause.wrong = wrong_;
    return best_->cause;
  }

  /// Chooses the triangles to look at.
  void choose_all(std::uint64_t most) {
    const std::size_t count = judged_.maps.plan.triangles.size();
    std::uint64_t micro_triangles = 0;
    for (std::size_t k = 0; k < count; ++k) micro_triangles += impl::micromap::micro_triangles(level(k));
    const std::uint64_t step = 1 + (micro_triangles - 1) / most;
    for (std::size_t k = 0; k < count; k += step) all_.push_back(k);
  }

  /// The triangles of the file that a planned one stands for.
  std::uint64_t times(std::size_t k) const { return judged_.maps.plan.triangles[k].unique; }

  Level level(std::size_t k) const { return judged_.maps.baked.triangles[k].level; }

  /// Chooses the triangles that changes are tried on: three wrong ones for a right one.
  void choose() {
    std::vector<std::size_t> wrong, right;
    for (const std::size_t k : all_)
      (fits_[k].wrong + fits_[k].needless + fits_[k].side != 0 ? wrong : right).push_back(k);
    std::uint64_t micro_triangles = 0;
    const auto take = [&](const std::vector<std::size_t>& from, std::size_t most) {
      const std::size_t step = std::max<std::size_t>(1, from.size() / most);
      for (std::size_t k = 0; k < from.size() && most-- != 0; k += step) {
        micro_triangles += stored_[from[k]].size();
        if (!tried_.empty() && micro_triangles > most_micro_triangles) return;
        tried_.push_back(from[k]);
      }
    };
    take(wrong, most_tried - most_tried / 4);
    take(right, most_tried - tried_.size());
  }

  /// The maps of a change, in the order of `triangles`: the stored ones and the expected ones.
  struct Maps {
    std::vector<States> stored, expected;
  };
  using Make = std::function<Maps(const std::vector<std::size_t>&)>;

  /// The sum of fits, primitive by primitive: a primitive that is better as it is stored stays so.
  struct Sum {
    Fit fit;
    std::uint64_t explained = 0;
    bool all_right = true;
  };
  Sum sum(const std::vector<std::size_t>& triangles, const Maps& maps) const {
    std::map<std::size_t, std::array<Sum, 2>> of_primitive;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      auto& [now, changed] = of_primitive[judged_.maps.link(triangles[k]).primitive];
      const Fit& was = fits_.at(triangles[k]);
      const Fit is = fit(maps.stored[k], maps.expected[k]);
      now.fit += was;
      now.all_right = now.all_right && was.is_right();
      changed.fit += is;
      changed.all_right = changed.all_right && is.wrong == 0;
      const bool is_wrong = was.wrong + was.needless != 0;
      changed.explained += is_wrong && is < was && is.wrong == 0 ? times(triangles[k]) : 0;
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

  /// Whether the sum is right, and decidedly better than the maps as they are stored.
  bool explains(const Sum& is, const Fit& was, std::uint64_t evidence) const {
    if (is.fit.wrong != 0 || !is.all_right || is.fit.evidence() < evidence) return false;
    if (2 * is.fit.needless > is.fit.unknown()) return false;
    if (was.wrong != 0) return is.fit.needless <= is.fit.equal / 4;
    if (was.needless != 0) return 4 * is.fit.needless <= was.needless;
    return 4 * is.fit.side <= was.side;
  }

  Fit as_stored(const std::vector<std::size_t>& triangles) const {
    Fit all;
    for (const std::size_t k : triangles) all += fits_.at(k);
    return all;
  }

  /// Tries a change; keeps it if it explains all triangles, better than those before.
  void attempt(const std::string& code, const std::string& says, const Make& make,
               std::uint64_t evidence = least_evidence) {
    if (interrupted()) throw Interrupted();
    try {
      attempt_within_domain(code, says, make, evidence);
    } catch (const std::invalid_argument&) {
      // The changed UVs, or factors, are beyond what can be baked: no baker made these maps so.
    }
  }

  void attempt_within_domain(const std::string& code, const std::string& says, const Make& make,
                             std::uint64_t evidence) {
    const Sum here = sum(tried_, make(tried_));
    if (!explains(here, as_stored(tried_), evidence)) return;
    fitting_.emplace_back(code, here.fit);
    if (best_ != nullptr && !(here.fit < tried_fit_)) return;
    const Sum everywhere = tried_.size() == all_.size() ? here : sum(all_, make(all_));
    if (!explains(everywhere, as_stored_, evidence)) return;
    tried_fit_ = here.fit;
    best_ = std::make_unique<Candidate>(Candidate{{code, says, 0, everywhere.explained}, everywhere.fit});
  }

  /// Whether a change of another kind fits nearly as well as the best one, which leaves needlessly unknown states.
  bool is_doubtful() const {
    return tried_fit_.needless != 0 &&
           std::any_of(fitting_.begin(), fitting_.end(), [this](const auto& other) {
             return other.first != best_->cause.code && other.second.needless < 2 * tried_fit_.needless;
           });
  }

  std::vector<States> picked(const std::map<std::size_t, States>& from,
                             const std::vector<std::size_t>& triangles) const {
    std::vector<States> some;
    for (const std::size_t k : triangles) some.push_back(from.at(k));
    return some;
  }

  void try_maps() {
    for (const MapChange& change : map_changes())
      attempt(change.code, change.says, [&](const std::vector<std::size_t>& triangles) {
        Maps maps{picked(stored_, triangles), picked(right_, triangles)};
        for (std::size_t k = 0; k < triangles.size(); ++k)
          if (judged_.maps.link(triangles[k]).record)  // a special index has no order and no codes
            maps.stored[k] = change.undo(maps.stored[k], level(triangles[k]));
        return maps;
      });
  }

  void try_corners() {
    static constexpr VertexOrder orders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                             {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    std::array<std::uint64_t, 6> counts{};
    const auto make = [&](const std::vector<std::size_t>& triangles) {
      Maps maps{{}, picked(right_, triangles)};
      counts = {};
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        std::size_t best = 0;
        std::array<States, 6> turns;
        std::array<Fit, 6> fits;
        for (std::size_t turn = 0; turn < 6; ++turn) {
          turns[turn] = turned(stored_[triangles[k]], level(triangles[k]), orders[turn]);
          fits[turn] = fit(turns[turn], maps.expected[k]);
          if (fits[turn] < fits[best]) best = turn;
        }
        counts[best] += times(triangles[k]);
        maps.stored.push_back(turns[best]);
      }
      return maps;
    };
    const Candidate* const before = best_.get();
    attempt("corners", "", make);
    if (best_.get() == before) return;
    make(all_);
    std::vector<std::string> parts;
    for (std::size_t turn = 1; turn < 3; ++turn)
      if (counts[turn] != 0) parts.push_back(fmt::format("{} turned by {}", counts[turn], turn));
    if (const std::uint64_t wound = counts[3] + counts[4] + counts[5]; wound != 0)
      parts.push_back(fmt::format("{} wound the other way", wound));
    best_->cause.says =
        fmt::format("the corners of triangles are not those of their maps: {}", fmt::join(parts, ", "));
  }

  void try_links() {
    for (const LinkChange& change : link_changes(judged_))
      attempt(
          change.code, change.says,
          [&](const std::vector<std::size_t>& triangles) {
            Maps maps;
            for (const std::size_t k : triangles) {
              const std::optional<BakedTriangle> map = change.map(k);
              maps.stored.push_back(map ? states_of(*map) : stored_.at(k));
              maps.expected.push_back(right_at(k, map ? map->level : level(k)));
            }
            return maps;
          },
          least_evidence_of_records);
  }

  /// The expected map of a triangle at another level.
  const States& right_at(std::size_t k, Level n) {
    if (n == level(k)) return right_[k];
    States& states = at_level_[{k, n}];
    if (states.empty()) states = expected_at(judged_, inputs_, k, n);
    return states;
  }

  void try_inputs() {
    for (const InputChange& change : input_changes(judged_))
      attempt(change.code, change.says, [&](const std::vector<std::size_t>& triangles) {
        Inputs changed = inputs_;
        change.make(changed);
        return Maps{picked(stored_, triangles), expected(judged_, changed, triangles)};
      });
  }

  /// The tried triangles of primitives that have a wrong one; the baker had the right cutoff of the others.
  std::vector<std::size_t> tried_of_wrong_primitives() const {
    const auto primitive = [this](std::size_t k) { return judged_.maps.link(k).primitive; };
    std::set<std::size_t> wrong;
    for (const std::size_t k : tried_)
      if (fits_.at(k).wrong + fits_.at(k).needless != 0) wrong.insert(primitive(k));
    std::vector<std::size_t> some;
    std::copy_if(tried_.begin(), tried_.end(), std::back_inserter(some),
                 [&](std::size_t k) { return wrong.contains(primitive(k)); });
    return some;
  }

  /// Whether a cutoff leaves few needlessly unknown states; none if only T, or only O, bounds it.
  bool is_tight(const std::vector<std::size_t>& triangles, double cutoff, bool bounded) const {
    const std::vector<States> right = expected(judged_, with_cutoff(inputs_, cutoff), triangles);
    Fit all;
    for (std::size_t k = 0; k < triangles.size(); ++k) all += fit(stored_.at(triangles[k]), right[k]);
    return bounded ? 8 * all.needless <= all.unknown() : all.needless == 0;
  }

  void try_cutoff() {
    const std::vector<std::size_t> of_wrong = tried_of_wrong_primitives();
    const std::optional<CutoffRange> range = cutoffs(judged_, of_wrong, picked(stored_, of_wrong));
    if (!range) return;
    const bool blend = std::any_of(all_.begin(), all_.end(), [this](std::size_t k) {
      return !fits_[k].is_right() && inputs_.surfaces[judged_.maps.plan.triangles[k].surface].mode ==
                                         mmverify::scene::AlphaMode::blend;
    });
    const double middle = (range->least + range->greatest) / 2;
    const bool bounded = range->least > 0 && range->greatest < 1;
    if (!is_tight(of_wrong, middle, bounded)) return;
    attempt(
        blend ? "blend_by_cutoff" : "cutoff",
        fmt::format("{}: all maps are right under any from {:.4f} to {:.4f}",
                    blend ? "alphaMode BLEND was baked by a cutoff" : "the baker had another cutoff",
                    range->least, range->greatest),
        [&](const std::vector<std::size_t>& triangles) {
          return Maps{picked(stored_, triangles), expected(judged_, with_cutoff(inputs_, middle), triangles)};
        });
  }

  /// Each wrong triangle has a map that fits one record of the file.
  void try_other_triangles() {
    std::vector<std::pair<std::size_t, std::string>> found;
    constexpr std::size_t most = 256;
    Fit all;
    bool all_special = true;
    for (const std::size_t k : all_) {
      if (fits_[k].is_right()) continue;
      if (found.size() == most) return;
      const bool special = !judged_.maps.link(k).record;
      all_special = all_special && special;
      // A map that is nearly right is its triangle's: nearly uniform maps fit many triangles.
      if (!special && 16 * (fits_[k].wrong + fits_[k].needless) < stored_[k].size()) return;
      const auto record = fitting_record(k);
      if (!record) return;
      all += record->second;
      found.emplace_back(k, record->first);
    }
    if (found.empty() || all.equal < least_evidence) return;
    const auto& [first, place] = found[0];
    Cause cause{"other_triangles",
                fmt::format("triangles have each other's maps: triangle {} fits {}", first, place), 0,
                found.size()};
    if (all_special)
      cause = {
          "special_index",
          fmt::format("triangles have special indices in place of maps: triangle {} fits {}", first, place),
          0, found.size()};
    else if (indices_are_equal())
      cause = {"indices_equal",
               fmt::format("the indices of all triangles are equal: triangle {} fits {}", first, place), 0,
               found.size()};
    best_ = std::make_unique<Candidate>(Candidate{cause, all});
  }

  /// Whether all triangles of each primitive have one record, and some primitive has several triangles.
  bool indices_are_equal() const {
    std::map<std::size_t, std::uint64_t> record_of;
    bool several = false;
    for (const mmverify::scene::MapLink& link : judged_.maps.links) {
      if (!link.record) return false;
      const auto [of, is_new] = record_of.try_emplace(link.primitive, *link.record);
      if (of->second != *link.record) return false;
      several = several || !is_new;
    }
    return several;
  }

  /// The place of a record whose map fits a triangle.  A triangle that is uniform needs none.
  std::optional<std::pair<std::string, Fit>> fitting_record(std::size_t k) {
    constexpr std::uint64_t most = 4096;
    const Fit uniform = fit_of_uniform(k);
    if (uniform.is_right() && uniform.evidence() >= least_evidence)
      return std::pair("a special index", uniform);
    for (std::size_t a = 0; a < judged_.maps.arrays.size(); ++a)
      for (std::uint64_t r = 0; r < std::min<std::uint64_t>(most, judged_.maps.arrays[a]->records.size());
           ++r) {
        const BakedTriangle map = mmverify::scene::stored_map(judged_.maps.arrays[a], r);
        const Fit is = fit(states_of(map), right_at(k, map.level));
        if (is.is_right() && is.equal >= least_evidence)
          return std::pair(fmt::format("record {} of micromap {}", r, a), is);
      }
    return {};
  }

  /// The fit of a triangle whose micro-triangles are all T, or all O, as if it had that special index.
  Fit fit_of_uniform(std::size_t k) {
    const States& right = right_[k];
    return fit(States(right.size(), right.front()), right);
  }

  /// Names the primitive whose records a wrong one has, if the best change gives it other records.
  void name_other_primitive() {
    if (best_->cause.code != "base_triangle" && best_->cause.code != "other_triangles") return;
    using Records = std::vector<std::pair<std::size_t, std::optional<std::uint64_t>>>;
    std::map<std::size_t, Records> records;
    for (const mmverify::scene::MapLink& link : judged_.maps.links) {
      if (link.base != 0) return;  // the file sets primitives apart by their bases
      records[link.primitive].emplace_back(link.array, link.record);
    }
    std::set<std::size_t> wrong;
    for (const std::size_t k : all_)
      if (!fits_[k].is_right()) wrong.insert(judged_.maps.link(k).primitive);
    std::string pairs;
    for (const std::size_t one : wrong) {
      const auto other = std::find_if(records.begin(), records.end(), [&](const auto& of) {
        return !wrong.contains(of.first) && of.second == records[one];
      });
      if (other == records.end()) return;
      pairs += fmt::format("{} has the maps of {}; ", primitive_name(one), primitive_name(other->first));
    }
    best_->cause.code = "other_primitive";
    best_->cause.says = pairs + best_->cause.says;
  }

  std::string primitive_name(std::size_t primitive) const {
    const auto& of = judged_.scene.primitives[primitive];
    return fmt::format("mesh {} primitive {}", of.mesh, of.number);
  }

  /// All wrong triangles have special indices, and most others are right.
  bool try_special() {
    std::uint64_t wrong = 0, triangles = 0;
    Fit others;
    for (const std::size_t k : all_) {
      if (fits_[k].is_right()) {
        others += fits_[k];
        continue;
      }
      if (judged_.maps.link(k).record) return false;
      wrong += times(k);
      ++triangles;
    }
    if (wrong == 0 || 2 * triangles > all_.size() || others.evidence() < least_evidence) return false;
    best_ = std::make_unique<Candidate>(
        Candidate{{"special_index",
                   fmt::format("{} triangle{} a special index that is another's; all maps are right", wrong,
                               wrong == 1 ? " has" : "s have"),
                   0, wrong},
                  as_stored_});
    return true;
  }

  void try_texture() {
    const std::optional<std::string> says =
        older_texture(judged_, all_, picked(stored_, all_), picked(right_, all_));
    if (says)
      best_ = std::make_unique<Candidate>(Candidate{{"texture_changed", *says, 0, wrong_}, as_stored_});
  }

  const Judged& judged_;
  const Inputs inputs_;
  std::vector<std::size_t> all_, tried_;
  // These have an entry for each triangle that is looked at.
  std::map<std::size_t, States> stored_, right_;
  std::map<std::size_t, Fit> fits_;
  Fit as_stored_, tried_fit_;
  std::uint64_t wrong_ = 0;
  std::map<std::pair<std::size_t, Level>, States> at_level_;
  std::vector<std::pair<std::string, Fit>> fitting_;  ///< codes and fits of the tried triangles
  std::unique_ptr<Candidate> best_;
};

}  // namespace

std::optional<Cause> cause_of(const Judged& judged) { return Search(judged, most_looked_at).cause(); }

std::optional<Cause> side_cause_of(const Judged& judged) {
  return Search(judged, most_micro_triangles).side_cause();
}

}  // namespace mmverify::proofs::scene
