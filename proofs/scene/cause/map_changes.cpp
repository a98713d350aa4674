#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "impl/micromap/reorder.hpp"
#include "proofs/index/known_orders.hpp"
#include "proofs/scene/cause/changes.hpp"

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::State;

using Codes = std::array<State, 4>;
constexpr Codes as_they_are{State::T, State::O, State::UT, State::UO};

/// Names of the likely exchanges; the others are named by their codes.
const char* name_of(const Codes& codes) {
  constexpr auto T = State::T, O = State::O, UT = State::UT, UO = State::UO;
  struct Named {
    Codes codes;
    const char* says;
  };
  static constexpr Named all[] = {
      {{O, T, UT, UO}, "T and O are exchanged"},
      {{O, T, UO, UT}, "T and O, and the two unknown states, are exchanged"},
      {{T, O, UO, UT}, "the unknown states UT and UO are exchanged"},
      {{T, UT, O, UO}, "the two bits of each code are exchanged: O is 2 and UT is 1"},
      {{UT, UO, T, O}, "known and unknown states are exchanged"},
      {{UO, UT, O, T}, "all bits are inverted"},
  };
  for (const Named& one : all)
    if (one.codes == codes) return one.says;
  return nullptr;
}

void add_states(std::vector<MapChange>& all) {
  Codes codes = as_they_are;
  while (std::next_permutation(codes.begin(), codes.end())) {
    const char* const known = name_of(codes);
    const auto digit = [&](std::size_t k) { return static_cast<unsigned>(codes[k]); };
    all.push_back({codes == Codes{State::T, State::O, State::UO, State::UT} ? "unknown_side" : "states",
                   known != nullptr ? known
                                    : fmt::format("the codes 0, 1, 2, 3 stand for the states {}, {}, {}, {}",
                                                  digit(0), digit(1), digit(2), digit(3)),
                   [codes](const States& map, Level, std::uint32_t k) {
                     return codes[static_cast<std::size_t>(map[k])];
                   }});
  }
}

/// The place by an order of the micro-triangle with place k on the curve.
std::uint32_t place(const index::KnownOrder& order, Level n, std::uint32_t k) {
  std::uint32_t i = 0, j = 0;
  for (const auto& corner : spec::index::corners(k, n)) {
    i += corner.i;
    j += corner.j;
  }
  const points::MicroTriangle m{i / 3, j / 3, i % 3 == 2};
  return order.index(points::representative(m, n), n);
}

void add_orders(std::vector<MapChange>& all) {
  for (const index::KnownOrder& order : index::known_orders())
    all.push_back({"order", "the states lie in another order: " + order.name,
                   [&order](const States& map, Level n, std::uint32_t k) {
                     return map[place(order, n, k) % map.size()];
                   }});
}

}  // namespace

States MapChange::undo(const States& map, Level n) const {
  States right(map.size());
  for (std::uint32_t k = 0; k < map.size(); ++k) right[k] = state(map, n, k);
  return right;
}

const std::vector<MapChange>& map_changes() {
  static const std::vector<MapChange> all = [] {
    std::vector<MapChange> changes;
    add_states(changes);
    add_orders(changes);
    return changes;
  }();
  return all;
}

States turned(const States& map, Level n, const mmverify::scene::VertexOrder& order) {
  using namespace impl::micromap;
  const auto bytes = packed_bytes(map.size(), Format::four_state);
  Bytes packed(bytes), out(bytes);
  pack(map, Format::four_state, packed);
  reorder(packed, n, Format::four_state, order, out);
  States states(map.size());
  unpack(out, Format::four_state, states);
  return states;
}

}  // namespace mmverify::proofs::scene
