#include "proofs/scene/cause/cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "proofs/scene/cause/changes.hpp"
#include "proofs/scene/cause/cutoff.hpp"
#include "proofs/scene/cause/links.hpp"
#include "proofs/scene/cause/rewritten_indices.hpp"
#include "proofs/scene/cause/texture_age.hpp"
#include "proofs/scene/cause/trials.hpp"

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::State;
using mmverify::scene::BakedTriangle;
using mmverify::scene::VertexOrder;
using Maps = Trials::Maps;
using Triangles = std::vector<std::size_t>;

/// Micro-triangles of the triangles that are looked at, at most.
constexpr std::uint64_t most_looked_at = std::uint64_t{1} << 24;
/// Micro-triangles that are baked anew for pairs of changes, at most.
constexpr std::uint64_t most_of_pairs = std::uint64_t{1} << 23;

/// The place of a map that needs no record.
const std::string uniform_place = "a special index";

class Search {
 public:
  Search(const Judged& judged, std::uint64_t most) : examined_(judged, most) {
    std::set<std::size_t> wrong;
    for (const std::size_t k : examined_.tried())
      if (examined_.fit(k).wrong != 0) wrong.insert(examined_.link(k).primitive);
    for (const std::size_t k : examined_.tried())
      if (wrong.contains(examined_.link(k).primitive)) bound_.push_back(k);
    std::stable_sort(bound_.begin(), bound_.end(), [this](std::size_t a, std::size_t b) {
      return std::pair(examined_.fit(a).wrong == 0, examined_.level(a)) <
             std::pair(examined_.fit(b).wrong == 0, examined_.level(b));
    });
  }

  /// The cause of unknown states on the other side.
  std::optional<Cause> side_cause() const {
    if (examined_.fit().side < least_evidence || examined_.fit().side <= 3 * examined_.fit().same) return {};
    std::uint64_t triangles = 0;
    for (const std::size_t k : examined_.all())
      triangles += examined_.fit(k).side != 0 ? examined_.times(k) : 0;
    return Cause{
        "unknown_side",
        fmt::format(
            "{} of {} unknown states are on the other side: force-2-state makes O of them where alpha at "
            "the centroid is transparent, and T where it is opaque",
            examined_.fit().side, examined_.fit().side + examined_.fit().same),
        triangles, triangles};
  }

  std::optional<Cause> cause() {
    const Fit& was = examined_.fit();
    if (was.wrong + was.needless + was.side == 0) return {};
    if (is_one_state()) {  // such maps, never written perhaps, fit many changes
      try_links();
      return trials_.is_exact() ? std::optional(finished()) : std::nullopt;
    }
    try_maps();
    try_corners();
    try_links();
    try_inputs();
    try_cutoff();
    if (!trials_.is_exact() && try_special()) return finished();
    if (trials_.best() && trials_.is_doubtful()) return {};
    if (!trials_.best()) try_other_triangles();
    if (!trials_.best()) try_rewritten_indices();
    if (!trials_.best()) try_texture();
    if (!trials_.best()) try_two_inputs();
    if (!trials_.best()) return {};
    name_other_primitive();
    return finished();
  }

 private:
  /// Whether all stored states are one.
  bool is_one_state() const {
    const impl::micromap::State first = examined_.stored(examined_.all().front()).front();
    return std::all_of(examined_.all().begin(), examined_.all().end(), [&](std::size_t k) {
      const States& states = examined_.stored(k);
      return std::all_of(states.begin(), states.end(), [first](auto s) { return s == first; });
    });
  }

  Cause finished() {
    trials_.best_cause().wrong = examined_.wrong();
    return *trials_.best();
  }

  /// Whether one of the maps that a change has to put right has a wrong state under it: the change then explains
  /// nothing, and its other maps are spared.
  bool is_contradicted(const std::function<bool(std::size_t triangle)>& has_wrong) const {
    return std::any_of(bound_.begin(), bound_.end(), [&](std::size_t k) {
      stop_if_due(examined_.judged());
      return has_wrong(k);
    });
  }

  /// Whether a change of states or order gives a known state of a triangle that is not the expected one.
  bool has_wrong_state(const MapChange& change, std::size_t k) const {
    if (!examined_.link(k).record) return examined_.fit(k).wrong != 0;
    const States &stored = examined_.stored(k), &right = examined_.right(k);
    constexpr std::uint32_t far =
        2'654'435'761;  // odd, so all are visited; neighbours, often alike, long after
    for (std::uint32_t i = 0; i < stored.size(); ++i) {
      const std::uint32_t at = i * far % static_cast<std::uint32_t>(stored.size());
      const auto state = change.state(stored, examined_.level(k), at);
      if ((state == State::T || state == State::O) && state != right[at]) return true;
    }
    return false;
  }

  void try_maps() {
    for (const MapChange& change : map_changes()) {
      if (is_contradicted([&](std::size_t k) { return has_wrong_state(change, k); })) continue;
      trials_.attempt(change.code, change.says, [&](const Triangles& triangles) {
        Maps maps{examined_.stored(triangles), examined_.right(triangles)};
        for (std::size_t k = 0; k < triangles.size(); ++k)
          if (examined_.link(triangles[k]).record)  // a special index has no order and no codes
            maps.stored[k] = change.undo(maps.stored[k], examined_.level(triangles[k]));
        return maps;
      });
    }
  }

  void try_corners() {
    static constexpr VertexOrder orders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                             {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    std::array<std::uint64_t, 6> counts{};
    const auto make = [&](const Triangles& triangles) {
      Maps maps{{}, examined_.right(triangles)};
      counts = {};
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        std::size_t best = 0;
        std::array<States, 6> turns;
        std::array<Fit, 6> fits;
        for (std::size_t turn = 0; turn < 6; ++turn) {
          turns[turn] = turned(examined_.stored(triangles[k]), examined_.level(triangles[k]), orders[turn]);
          fits[turn] = fit(turns[turn], maps.expected[k]);
          if (fits[turn] < fits[best]) best = turn;
        }
        counts[best] += examined_.times(triangles[k]);
        maps.stored.push_back(turns[best]);
      }
      return maps;
    };
    if (!trials_.attempt("corners", "", make)) return;
    make(examined_.all());
    std::vector<std::string> parts;
    for (std::size_t turn = 1; turn < 3; ++turn)
      if (counts[turn] != 0) parts.push_back(fmt::format("{} turned by {}", counts[turn], turn));
    if (const std::uint64_t wound = counts[3] + counts[4] + counts[5]; wound != 0)
      parts.push_back(fmt::format("{} wound the other way", wound));
    trials_.best_cause().says =
        fmt::format("the corners of triangles are not those of their maps: {}", fmt::join(parts, ", "));
  }

  /// Whether right maps tell that the baker leaves no state needlessly unknown.
  bool is_exact_baker() const {
    Fit right;
    for (const std::size_t k : examined_.all())
      if (examined_.fit(k).wrong + examined_.fit(k).needless == 0) right += examined_.fit(k);
    return right.unknown() >= least_evidence_of_many;
  }

  void try_links() {
    const bool exact = is_exact_baker();
    for (const LinkChange& change : link_changes(examined_.judged())) {
      const bool contradicted = is_contradicted([&](std::size_t k) {
        const std::optional<BakedTriangle> map = change.map(k);
        return (map ? fit(states_of(*map), examined_.right_at(k, map->level)) : examined_.fit(k)).wrong != 0;
      });
      if (contradicted) continue;
      trials_.attempt(
          change.code, change.says,
          [&](const Triangles& triangles) {
            Maps maps;
            std::set<impl::micromap::State> of_wrong;
            for (const std::size_t k : triangles) {
              const std::optional<BakedTriangle> map = change.map(k);
              maps.stored.push_back(map ? states_of(*map) : examined_.stored(k));
              maps.expected.push_back(examined_.right_at(k, map ? map->level : examined_.level(k)));
              if (!examined_.is_right(k))
                of_wrong.insert(maps.stored.back().begin(), maps.stored.back().end());
            }
            // Maps of one state fit many triangles, wherever they come from.
            if (of_wrong.size() < 2) maps.stored = examined_.stored(triangles);
            return maps;
          },
          least_evidence_of_many, exact);
    }
  }

  void try_inputs() {
    for (const InputChange& change : input_changes(examined_.judged()))
      trials_.attempt(change.code, change.says, [&](const Triangles& triangles) {
        Inputs changed = examined_.inputs();
        change.make(changed);
        return Maps{examined_.stored(triangles), expected(examined_.judged(), changed, triangles)};
      });
  }

  /// The tried triangles of primitives that have a wrong one; the baker had the right cutoff of the others.
  std::vector<std::size_t> tried_of_wrong_primitives() const {
    const auto primitive = [this](std::size_t k) { return examined_.link(k).primitive; };
    std::set<std::size_t> wrong;
    for (const std::size_t k : examined_.tried())
      if (examined_.fit(k).wrong + examined_.fit(k).needless != 0) wrong.insert(primitive(k));
    std::vector<std::size_t> some;
    std::copy_if(examined_.tried().begin(), examined_.tried().end(), std::back_inserter(some),
                 [&](std::size_t k) { return wrong.contains(primitive(k)); });
    return some;
  }

  /// Whether a cutoff leaves few needlessly unknown states; none if only T, or only O, bounds it.
  bool is_tight(const Triangles& triangles, double cutoff, bool bounded) const {
    const std::vector<States> right =
        expected(examined_.judged(), with_cutoff(examined_.inputs(), cutoff), triangles);
    Fit all;
    for (std::size_t k = 0; k < triangles.size(); ++k) all += fit(examined_.stored(triangles[k]), right[k]);
    return bounded ? 8 * all.needless <= all.unknown() : all.needless == 0;
  }

  void try_cutoff() {
    const std::vector<std::size_t> of_wrong = tried_of_wrong_primitives();
    const std::optional<CutoffRange> range =
        cutoffs(examined_.judged(), of_wrong, examined_.stored(of_wrong));
    if (!range) return;
    const bool blend = std::any_of(examined_.all().begin(), examined_.all().end(), [this](std::size_t k) {
      return !examined_.is_right(k) &&
             examined_.inputs().surfaces[examined_.judged().maps.plan.triangles[k].surface].mode ==
                 mmverify::scene::AlphaMode::blend;
    });
    const double middle = (range->least + range->greatest) / 2;
    const bool bounded = range->least > 0 && range->greatest < 1;
    if (!is_tight(of_wrong, middle, bounded)) return;
    trials_.attempt(
        blend ? "blend_by_cutoff" : "cutoff",
        fmt::format("{}: all maps are right under any from {:.4f} to {:.4f}",
                    blend ? "alphaMode BLEND was baked by a cutoff" : "the baker had another cutoff",
                    range->least, range->greatest),
        [&](const Triangles& triangles) {
          return Maps{examined_.stored(triangles),
                      expected(examined_.judged(), with_cutoff(examined_.inputs(), middle), triangles)};
        });
  }

  /// Each wrong triangle has a map that fits one record of the file.
  void try_other_triangles() {
    std::vector<std::pair<std::size_t, std::string>> found;
    const Triangles wrong = wrong_triangles();
    constexpr std::size_t most = 256;
    if (wrong.size() > most) return;
    Fit all;
    bool all_special = true;
    for (const std::size_t k : wrong) {
      const bool special = !examined_.link(k).record;
      all_special = all_special && special;
      const auto record = fitting_record(k);
      if (!record) return;
      // A map that is nearly right is its triangle's, as nearly uniform maps fit many triangles; and a texture that
      // changed may leave a triangle uniform.  A map that is right elsewhere is another one's all the same.
      const bool nearly_right =
          16 * (examined_.fit(k).wrong + examined_.fit(k).needless) < examined_.stored(k).size();
      if (!special && (nearly_right || record->first == uniform_place) && !is_anothers(k)) return;
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
    trials_.keep(cause);
  }

  Triangles wrong_triangles() const {
    Triangles wrong;
    std::copy_if(examined_.all().begin(), examined_.all().end(), std::back_inserter(wrong),
                 [this](std::size_t k) { return !examined_.is_right(k); });
    return wrong;
  }

  /// Whether the record of triangle k is right for a triangle that has it, too, or fits another one that needs a map.
  bool is_anothers(std::size_t k) const {
    std::size_t left = 1024;
    const mmverify::scene::MapLink& of = examined_.link(k);
    return std::any_of(examined_.all().begin(), examined_.all().end(), [&](std::size_t other) {
      const mmverify::scene::MapLink& link = examined_.link(other);
      if (examined_.fit(other).wrong + examined_.fit(other).needless == 0)
        return link.record == of.record && link.array == of.array;
      if (other == k || left == 0) return false;
      --left;
      return fit(examined_.stored(k), examined_.right_at(other, examined_.level(k))).is_right();
    });
  }

  /// Whether all triangles of each primitive have one record, and some primitive has several triangles.
  bool indices_are_equal() const {
    std::map<std::size_t, std::uint64_t> record_of;
    bool several = false;
    for (const mmverify::scene::MapLink& link : examined_.judged().maps.links) {
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
    if (uniform.is_right() && uniform.evidence() >= least_evidence) return std::pair(uniform_place, uniform);
    stop_if_due(examined_.judged());
    for (std::size_t a = 0; a < examined_.judged().maps.arrays.size(); ++a)
      for (std::uint64_t r = 0;
           r < std::min<std::uint64_t>(most, examined_.judged().maps.arrays[a]->records.size()); ++r) {
        const BakedTriangle map = mmverify::scene::stored_map(examined_.judged().maps.arrays[a], r);
        const Fit is = fit(states_of(map), examined_.right_at(k, map.level));
        if (is.is_right() && is.equal >= least_evidence)
          return std::pair(fmt::format("record {} of micromap {}", r, a), is);
      }
    return {};
  }

  /// The fit of a triangle whose micro-triangles are all T, or all O, as if it had that special index.
  Fit fit_of_uniform(std::size_t k) {
    const States& right = examined_.right_at(k, std::max<Level>(examined_.level(k), 2));  // enough states
    return fit(States(right.size(), right.front()), right);
  }

  /// Names the primitive whose records a wrong one has, if the best change gives it other records.
  void name_other_primitive() {
    if (trials_.best_cause().code != "base_triangle" && trials_.best_cause().code != "other_triangles")
      return;
    struct Records {
      std::vector<std::pair<std::size_t, std::optional<std::uint64_t>>> all;
      bool from_0 = false;  ///< it has the first record of a micromap
    };
    std::map<std::size_t, Records> records;
    bool bases = false;
    for (const mmverify::scene::MapLink& link : examined_.judged().maps.links) {
      bases = bases || link.base != 0;
      Records& of = records[link.primitive];
      of.all.emplace_back(link.array, link.record);
      of.from_0 = of.from_0 || link.record == std::uint64_t{0};
    }
    std::set<std::size_t> wrong;
    for (const std::size_t k : examined_.all())
      if (!examined_.is_right(k)) wrong.insert(examined_.link(k).primitive);
    std::string pairs;
    for (const std::size_t one : wrong) {
      // A file may set primitives apart by their bases: one without its own has the first records.
      if (bases && records[one].from_0 && trials_.best_cause().code == "base_triangle") return;
      const auto other = std::find_if(records.begin(), records.end(), [&](const auto& of) {
        return !wrong.contains(of.first) && of.second.all == records[one].all;
      });
      if (other == records.end()) return;
      pairs += fmt::format("{} has the maps of {}; ", primitive_name(one), primitive_name(other->first));
    }
    trials_.best_cause().code = "other_primitive";
    trials_.best_cause().says = pairs + trials_.best_cause().says;
  }

  std::string primitive_name(std::size_t primitive) const {
    const auto& of = examined_.judged().scene.primitives[primitive];
    return fmt::format("mesh {} primitive {}", of.mesh, of.number);
  }

  /// All wrong triangles have special indices, and most others are right.
  bool try_special() {
    std::uint64_t wrong = 0, triangles = 0;
    Fit others;
    for (const std::size_t k : examined_.all()) {
      if (examined_.is_right(k)) {
        others += examined_.fit(k);
        continue;
      }
      if (examined_.link(k).record) return false;
      wrong += examined_.times(k);
      ++triangles;
    }
    if (wrong == 0 || 2 * triangles > examined_.all().size() || others.evidence() < least_evidence)
      return false;
    trials_.keep({"special_index",
                  fmt::format("{} triangle{} a special index that is another's; all maps are right", wrong,
                              wrong == 1 ? " has" : "s have"),
                  0, wrong});
    return true;
  }

  void try_rewritten_indices() {
    if (const std::optional<Cause> cause = rewritten_indices(examined_)) trials_.keep(*cause);
  }

  void try_texture() {
    const std::optional<std::string> says =
        older_texture(examined_.judged(), examined_.all(), examined_.stored(examined_.all()),
                      examined_.right(examined_.all()));
    if (says) trials_.keep({"texture_changed", *says, 0, examined_.wrong()});
  }

  /// Two changes of inputs at once: they have to fit every state, since there are many pairs.
  void try_two_inputs() {
    const std::vector<InputChange> changes = input_changes(examined_.judged());
    const std::size_t pairs = changes.size() * changes.size() / 2;
    std::uint64_t micro_triangles = 0;
    for (const std::size_t k : examined_.tried()) micro_triangles += examined_.stored(k).size();
    if (micro_triangles * pairs > most_of_pairs) return;
    for (std::size_t a = 0; a < changes.size(); ++a)
      for (std::size_t b = a + 1; b < changes.size(); ++b) {
        if (changes[a].code == changes[b].code) continue;
        trials_.attempt(
            changes[a].code + "+" + changes[b].code,
            "two changes: " + changes[a].says + "; and " + changes[b].says,
            [&](const Triangles& triangles) {
              Inputs changed = examined_.inputs();
              changes[a].make(changed);
              changes[b].make(changed);
              return Maps{examined_.stored(triangles), expected(examined_.judged(), changed, triangles)};
            },
            least_evidence_of_pairs, true);
      }
  }

  const Examined examined_;
  /// The tried triangles of primitives with a wrong state, which a change has to put right; the wrong ones first, and
  /// small maps first.
  Triangles bound_;
  Trials trials_{examined_};
};

}  // namespace

std::optional<Cause> cause_of(const Judged& judged) { return Search(judged, most_looked_at).cause(); }

std::optional<Cause> side_cause_of(const Judged& judged) {
  return Search(judged, most_tried_micro_triangles).side_cause();
}

}  // namespace mmverify::proofs::scene
