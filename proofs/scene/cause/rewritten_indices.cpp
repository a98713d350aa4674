#include "proofs/scene/cause/rewritten_indices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "proofs/scene/cause/changes.hpp"
#include "proofs/scene/cause/trials.hpp"

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::State;
using mmverify::scene::VertexOrder;

constexpr std::array<VertexOrder, 6> orders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
/// The numbers of the orders that undo them.
constexpr std::array<std::size_t, 6> undone{0, 2, 1, 3, 4, 5};
/// Micro-triangles of the records that are looked at, about.
constexpr std::uint64_t most_of_records = std::uint64_t{1} << 24;

/// Triangles that fit no record, at most: each is compared with all of them.
constexpr std::size_t most_unfit = 256;

/// A map whose unknown states are on one side.
States without_sides(States states) {
  for (State& s : states) s = s == State::UO ? State::UT : s;
  return states;
}

/// States unlike the most frequent one: those by which a map is told from others.
std::uint64_t telling(const States& states) {
  std::array<std::uint64_t, 4> counts{};
  for (const State s : states) ++counts[static_cast<std::size_t>(s)];
  return states.size() - *std::max_element(counts.begin(), counts.end());
}

class Rewritten {
 public:
  explicit Rewritten(const Examined& examined) : examined_(examined) {
    std::uint64_t micro_triangles = 0;
    for (const auto& array : examined.judged().maps.arrays)
      for (std::uint64_t r = 0; r < array->records.size() && micro_triangles < most_of_records; ++r) {
        const auto map = mmverify::scene::stored_map(array, r);
        levels_.insert(map.level);
        micro_triangles += impl::micromap::micro_triangles(map.level);
        records_.insert(without_sides(states_of(map)));
      }
  }

  std::optional<Cause> cause() {
    for (const std::size_t k : examined_.all())
      if (examined_.fit(k).wrong + examined_.fit(k).needless != 0) look_at(k);
    if (4 * fitting_ < 3 * wrong_ || 4 * told_ < 3 * tellable_ || evidence_ < least_evidence_of_pairs)
      return {};
    if (unfit_.size() > most_unfit ||
        !std::all_of(unfit_.begin(), unfit_.end(), [this](std::size_t k) { return fits_nearly(k); }))
      return {};
    const std::uint64_t turns = turned_[1] + turned_[2] + turned_[3];
    std::string says = "index buffers were rewritten";
    if (moved_ != 0) says += fmt::format(", {} triangles have the maps of others", moved_);
    for (std::size_t by = 1; by < 3; ++by)
      if (turned_[by] != 0) says += fmt::format(", {} turned by {}", turned_[by], by);
    if (turned_[3] != 0) says += fmt::format(", {} wound the other way", turned_[3]);
    if (fitting_ != wrong_)
      says += fmt::format("; {} fit nearly, as if their UVs had changed by little", wrong_ - fitting_);
    return Cause{moved_ == 0  ? "corners"
                 : turns == 0 ? "other_triangles"
                              : "corners+other_triangles",
                 says, 0, fitting_};
  }

 private:
  void look_at(std::size_t k) {
    stop_if_due(examined_.judged());
    const std::uint64_t times = examined_.times(k);
    wrong_ += times;
    const State whole = examined_.right_at(k, 0).front();
    if (whole == State::T || whole == State::O) {  // it needs a special index alone
      fitting_ += times;
      return;
    }
    const bool has_record = examined_.link(k).record.has_value();
    if (has_record && take(k, examined_.level(k))) return;
    for (const Level n : levels_)
      if ((!has_record || n != examined_.level(k)) && take(k, n)) return;
    tellable_ += times;
    unfit_.push_back(k);
  }

  /// Whether a record has all but a sixteenth of a triangle's states, in some order of its corners.
  bool fits_nearly(std::size_t k) const {
    for (const Level n : levels_) {
      const States right = without_sides(examined_.right_at(k, n));
      for (const VertexOrder& order : orders) {
        const States stored = without_sides(turned(right, n, order));
        const auto is_near = [&](const States& record) {
          if (record.size() != stored.size()) return false;
          std::size_t left = stored.size() / 16;
          for (std::size_t at = 0; at < stored.size(); ++at)
            if (record[at] != stored[at] && left-- == 0) return false;
          return true;
        };
        if (std::any_of(records_.begin(), records_.end(), is_near)) return true;
      }
    }
    return false;
  }

  /// Whether a record of a level fits, in some order of the triangle's corners; counts it then.
  bool take(std::size_t k, Level n) {
    const States right = without_sides(examined_.right_at(k, n));
    const bool has_level = examined_.link(k).record && n == examined_.level(k);
    const States own = has_level ? without_sides(examined_.stored(k)) : States();
    const std::uint64_t times = examined_.times(k), tells = telling(right);
    for (const bool is_own : {true, false})
      for (std::size_t order = 0; order < orders.size(); ++order) {
        const States stored = without_sides(turned(right, n, orders[order]));
        if (is_own ? stored != own : !records_.contains(stored)) continue;
        fitting_ += times;
        moved_ += is_own ? 0 : times;
        turned_[std::min<std::size_t>(undone[order], 3)] += times;
        if (tells < least_evidence) return true;
        told_ += times, tellable_ += times;
        evidence_ += tells;
        return true;
      }
    return false;
  }

  const Examined& examined_;
  std::set<States> records_;
  std::set<Level> levels_;
  std::vector<std::size_t> unfit_;
  std::uint64_t wrong_ = 0, fitting_ = 0;  ///< triangles
  std::uint64_t tellable_ = 0, told_ = 0;  ///< those whose maps are told from others
  std::uint64_t moved_ = 0, evidence_ = 0;
  std::array<std::uint64_t, 4> turned_{};  ///< triangles by turn; 3: wound the other way
};

}  // namespace

std::optional<Cause> rewritten_indices(const Examined& examined) { return Rewritten(examined).cause(); }

}  // namespace mmverify::proofs::scene
