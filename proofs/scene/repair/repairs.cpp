#include "proofs/scene/repair/repairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "proofs/scene/repair/fitting.hpp"

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::State;
using mmverify::scene::BakedTriangle;
using mmverify::scene::MapLink;
using mmverify::scene::StoredMaps;
using mmverify::scene::VertexOrder;
using Kind = MapRepair::Kind;

/// Micro-triangles that are baked at a time.
constexpr std::uint64_t most_at_once = std::uint64_t{1} << 22;
/// A change of states is tried on so many triangles, of so many micro-triangles in all.
constexpr std::size_t most_tried = 32;
constexpr std::uint64_t most_micro_triangles = std::uint64_t{1} << 18;
/// A change of states has to agree with so many known states: few states fit many changes by chance.
constexpr std::uint64_t least_known = 8;
/// Maps of other levels than a triangle's own are tried up to this one.
constexpr Level finest_other_level = 8;

class RepairSearch {
 public:
  RepairSearch(const Judged& judged, const std::set<std::size_t>& unlinked)
      : judged_(judged),
        maps_(judged.maps),
        unlinked_(unlinked),
        fitting_(judged),
        all_(maps_.plan.triangles.size()) {}

  std::vector<MapRepair> all() {
    judge();
    for (std::size_t a = 0; a < maps_.arrays.size(); ++a) change_states(a);
    for (std::size_t k = 0; k < all_.size(); ++k) {
      // Maps on the other side fit better where they come from.
      if (all_[k].kind == Kind::none || (all_[k].kind == Kind::found && found_[k].side == 0)) continue;
      const bool has_record = maps_.link(k).record.has_value();
      if (has_record || !try_special(k)) try_records(k);
      if (has_record && all_[k].kind == Kind::baked) try_special(k);
    }
    for (std::size_t a = 0; a < maps_.arrays.size(); ++a) flip_sides(a);
    for (const std::size_t k : left()) bake(k);
    return std::move(all_);
  }

 private:
  /// Unknown states of a triangle's map that is right, and those among them on the other side than the right ones.
  struct Sides {
    std::uint64_t unknown = 0, side = 0;
  };

  std::vector<std::size_t> left() const {
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < all_.size(); ++k)
      if (all_[k].kind == Kind::baked) some.push_back(k);
    return some;
  }

  const BakedTriangle& stored(std::size_t k) const { return maps_.baked.triangles[k]; }

  /// Finds the triangles whose maps are right, and those that need their corners turned alone.
  void judge() {
    for (std::size_t begin = 0; begin < all_.size();) {
      std::vector<std::size_t> some;
      for (std::uint64_t sum = 0; begin < all_.size() && (some.empty() || sum < most_at_once); ++begin) {
        some.push_back(begin);
        sum += impl::micromap::micro_triangles(stored(begin).level);
      }
      std::vector<States> right = expected(judged_, fitting_.inputs(), some);
      for (std::size_t i = 0; i < some.size(); ++i) judge(some[i], std::move(right[i]));
    }
  }

  void judge(std::size_t k, States right) {
    const Fit is = fit(states_of(stored(k)), right);
    all_[k].may_stay = holds(is) && unlinked_.contains(k);
    if (holds(is) && !all_[k].may_stay) {
      found_[k] = {unknown_of(stored(k)), is.side};
      return;
    }
    fitting_.set_right(k, stored(k).level, std::move(right));
    all_[k].kind = Kind::baked;
    if (maps_.link(k).record) try_map(k, stored(k), {}, "");
  }

  static std::uint64_t unknown_of(const BakedTriangle& map) { return map.states[2] + map.states[3]; }

  /// Takes a map for a triangle if it fits, and better than the one it has; whether none can fit better.
  bool try_map(std::size_t k, const BakedTriangle& map, std::optional<std::size_t> change,
               const std::string& from, bool turns = true) {
    const std::optional<Fitting::Turn> turn = fitting_.turn(k, map, change, turns);
    if (!turn || (all_[k].kind == Kind::found && found_[k].side <= turn->side)) return false;
    States states = states_of(map);
    if (change) states = map_changes()[*change].undo(states, map.level);
    if (turn->order != VertexOrder{0, 1, 2}) states = turned(states, map.level, turn->order);
    std::string did = from;
    for (const std::string& more :
         {change ? "recoded: " + map_changes()[*change].says : "", std::string(name_of(turn->order))})
      if (!more.empty()) did += (did.empty() ? "" : "; ") + more;
    all_[k] = {Kind::found, packed(states, map.level, map.format), did, false};
    found_[k] = {unknown_of(all_[k].map), turn->side};
    return turn->side == 0;
  }

  /// Finds the one change of states, or order, under which most of a micromap's wrong maps fit.
  void change_states(std::size_t array) {
    std::vector<std::size_t> wrong, tried;
    std::uint64_t micro_triangles = 0;
    for (const std::size_t k : left())
      if (maps_.link(k).array == array && maps_.link(k).record) wrong.push_back(k);
    for (std::size_t i = 0; i < wrong.size() && tried.size() < most_tried;
         i += std::max<std::size_t>(1, wrong.size() / most_tried)) {
      micro_triangles += impl::micromap::micro_triangles(stored(wrong[i]).level);
      if (!tried.empty() && micro_triangles > most_micro_triangles) break;
      tried.push_back(wrong[i]);
    }
    std::optional<std::size_t> best;
    std::size_t most = tried.size() / 2;
    for (std::size_t change = 0; change < map_changes().size(); ++change) {
      std::size_t fitting = 0;
      std::uint64_t known = 0;
      for (const std::size_t k : tried) {
        if (!fitting_.turn(k, stored(k), change)) continue;
        ++fitting;
        for (const State s : fitting_.right(k, stored(k).level)) known += s == State::T || s == State::O;
      }
      if (fitting <= most || known < least_known) continue;
      most = fitting;
      best = change;
    }
    if (!best) return;
    for (const std::size_t k : wrong) try_map(k, stored(k), best, "");
  }

  /// Another special index.
  bool try_special(std::size_t k) {
    const State right = fitting_.right(k, 0)[0];
    if (right != State::T && right != State::O) return false;
    all_[k] = {Kind::found,
               {},
               right == State::T ? "linked to the special index T, being transparent all over"
                                 : "linked to the special index O, being opaque all over",
               false};
    all_[k].map.uniform = right;
    return true;
  }

  struct RecordPlace {
    std::size_t array;
    std::uint64_t record;
  };
  using Key = std::array<std::uint64_t, 4>;  ///< level, T, O, unknown

  /// The file's records by level and states.
  const std::map<Key, std::vector<RecordPlace>>& records() {
    if (records_.empty())
      for (std::size_t a = 0; a < maps_.arrays.size(); ++a)
        for (std::uint64_t r = 0; r < maps_.arrays[a]->records.size(); ++r) {
          const auto& [T, O, UT, UO] = fitting_.map(a, r).states;
          records_[{fitting_.map(a, r).level, T, O, UT + UO}].push_back({a, r});
          levels_[fitting_.map(a, r).level] = true;
        }
    return records_;
  }

  void try_records(std::size_t k) {
    records();
    const MapLink& link = maps_.link(k);
    const Level own = stored(k).level;
    if (levels_[own] && try_records(k, own, link.array)) return;
    for (Level n = 0; n < levels_.size() && (n <= finest_other_level || !link.record); ++n)
      if (n != own && levels_[n] && try_records(k, n, link.array)) return;
  }

  /// Tries the records of a level, those of the triangle's own micromap first.
  bool try_records(std::size_t k, Level n, std::size_t own) {
    Key key{n, 0, 0, 0};
    for (const State s : fitting_.right(k, n))
      ++key[1 + std::min<std::size_t>(2, static_cast<std::size_t>(s))];
    const auto found = records().find(key);
    if (found == records().end()) return false;
    for (const bool turns : {false, true})
      for (const bool is_own : {true, false})
        for (const RecordPlace& place : found->second)
          if ((place.array == own) == is_own && try_record(k, place, is_own, turns)) return true;
    return false;
  }

  bool try_record(std::size_t k, const RecordPlace& place, bool is_own, bool turns) {
    return try_map(k, fitting_.map(place.array, place.record), {},
                   is_own ? fmt::format("linked to the map of record {}, which fits", place.record)
                          : fmt::format("linked to the map of record {} of micromap {}, which fits",
                                        place.record, place.array),
                   turns);
  }

  /// Exchanges UT and UO in the maps of a micromap, if all of them are on the other side.
  void flip_sides(std::size_t array) {
    std::uint64_t unknown = 0, other = 0;
    for (const auto& [k, sides] : found_)
      if (maps_.link(k).array == array && maps_.link(k).record) {
        unknown += sides.unknown;
        other += sides.side;
      }
    if (unknown < least_known || other != unknown) return;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (maps_.link(k).array != array || !maps_.link(k).record || all_[k].kind == Kind::baked) continue;
      const BakedTriangle& from = all_[k].kind == Kind::none ? stored(k) : all_[k].map;
      if (from.uniform || from.states[2] + from.states[3] == 0) continue;
      States states = states_of(from);
      for (State& s : states) s = s == State::UT ? State::UO : s == State::UO ? State::UT : s;
      const std::string did =
          all_[k].did + (all_[k].did.empty() ? "" : "; ") + "recoded: UT and UO are exchanged";
      all_[k] = {Kind::found, packed(states, from.level, from.format), did, false};
    }
  }

  void bake(std::size_t k) {
    const MapLink& link = maps_.link(k);
    const Level n = link.record ? stored(k).level : usual_level(link.array);
    const States& right = fitting_.right(k, n);
    const auto format = link.record ? stored(k).format : impl::micromap::Format::four_state;
    all_[k] = {Kind::baked, packed(right, n, format), "", all_[k].may_stay};
  }

  /// The level of most records of an array.
  Level usual_level(std::size_t array) const {
    std::map<Level, std::size_t> counts;
    for (const auto& record : maps_.arrays[array]->records) ++counts[record.level];
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? 4 : most->first;
  }

  const Judged& judged_;
  const StoredMaps& maps_;
  const std::set<std::size_t>& unlinked_;
  Fitting fitting_;
  std::vector<MapRepair> all_;
  std::map<Key, std::vector<RecordPlace>> records_;
  std::array<bool, 13> levels_{};
  std::map<std::size_t, Sides> found_;  ///< of triangles whose map is right, stored or found
};

}  // namespace

std::vector<MapRepair> map_repairs(const Judged& judged, const std::set<std::size_t>& unlinked) {
  return RepairSearch(judged, unlinked).all();
}

}  // namespace mmverify::proofs::scene
