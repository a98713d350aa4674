#include "proofs/scene/repair/fitting.hpp"

#include <algorithm>

#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::Format;
using impl::micromap::State;
using mmverify::scene::BakedTriangle;
using mmverify::scene::VertexOrder;

constexpr VertexOrder orders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
constexpr const char* names[] = {"",
                                 "turned by 1 corner",
                                 "turned by 2 corners",
                                 "wound the other way",
                                 "wound the other way",
                                 "wound the other way"};

using Counts = std::array<std::uint64_t, 3>;  ///< T, O, unknown

Counts counts_of(const States& states) {
  Counts counts{};
  for (const State s : states) ++counts[std::min<std::size_t>(2, static_cast<std::size_t>(s))];
  return counts;
}

/// The counts of a map after a change, which moves states, or exchanges them.
Counts counts_of(const BakedTriangle& map, const MapChange* change) {
  States codes{State::T, State::O, State::UT, State::UO};
  if (change != nullptr && change->code != "order") codes = change->undo(codes, 1);
  Counts counts{};
  for (std::size_t s = 0; s < 4; ++s)
    counts[std::min<std::size_t>(2, static_cast<std::size_t>(codes[s]))] += map.states[s];
  return counts;
}

}  // namespace

const States& Fitting::right(std::size_t triangle, Level n) {
  States& states = right_[{triangle, n}];
  if (states.empty()) states = expected_at(judged_, inputs_, triangle, n);
  return states;
}

const BakedTriangle& Fitting::map(std::size_t array, std::uint64_t record) {
  const auto [at, is_new] = maps_.try_emplace({array, record});
  if (is_new) at->second = mmverify::scene::stored_map(judged_.maps.arrays.at(array), record);
  return at->second;
}

std::optional<Fitting::Turn> Fitting::turn(std::size_t triangle, const BakedTriangle& map,
                                           std::optional<std::size_t> number, bool turns) {
  if (interrupted()) throw Interrupted();
  const MapChange* const change = number ? &map_changes()[*number] : nullptr;
  const States& wanted = right(triangle, map.level);
  if (counts_of(map, change) != counts_of(wanted)) return {};
  States states = states_of(map);
  if (change != nullptr) states = change->undo(states, map.level);
  std::optional<Turn> best;
  for (const VertexOrder& order : orders) {
    if (order != orders[0] && !turns) break;
    const Fit is = fit(order == orders[0] ? states : turned(states, map.level, order), wanted);
    if (holds(is) && (!best || is.side < best->side)) best = Turn{order, is.side};
    if (best && best->side == 0) break;
  }
  return best;
}

const char* name_of(const VertexOrder& order) {
  return names[std::find(std::begin(orders), std::end(orders), order) - std::begin(orders)];
}

BakedTriangle packed(const States& states, Level n, Format format) {
  const bool is_known =
      std::all_of(states.begin(), states.end(), [](State s) { return s == State::T || s == State::O; });
  BakedTriangle map;
  map.level = n;
  map.format = is_known ? format : Format::four_state;
  for (const State s : states) ++map.states[static_cast<std::size_t>(s)];
  impl::micromap::Bytes bytes(impl::micromap::packed_bytes(states.size(), map.format));
  impl::micromap::pack(states, map.format, bytes);
  map.map = std::move(bytes);
  return map;
}

}  // namespace mmverify::proofs::scene
