// impl's packed maps against the specification, function by function.
//
// Input: a byte, its low bit the format (0: 2-state), its second bit whether the number of states is 4^n; a
// byte, n mod 7 or the number of states; then packed bytes, zeros where they end early.  Padding is as it
// comes.
//
// Covers: impl/common/bits.hpp impl/micromap/micromap.* impl/micromap/level.* impl/micromap/reorder.*
// Covers: impl/micromap/words.hpp
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "impl/micromap/level.hpp"
#include "impl/micromap/reorder.hpp"
#include "spec/index/index.hpp"
#include "spec/micromap/level.hpp"
#include "spec/micromap/lossy.hpp"

namespace {

namespace fast = mmverify::impl::micromap;
namespace slow = mmverify::spec::micromap;
using slow::Bytes;
using slow::States;

struct Map {
  slow::Format format;
  std::uint64_t count;
  Bytes bytes;
  States states;
};

[[noreturn]] void mismatch(const char* what, const Map& map) {
  std::fprintf(stderr, "micromap_codec: %s differs on %llu states, format %u\n", what,
               static_cast<unsigned long long>(map.count), static_cast<unsigned>(map.format));
  std::abort();
}

void require(bool holds, const char* what, const Map& map) {
  if (!holds) mismatch(what, map);
}

Map map_of(const std::uint8_t* data, std::size_t size) {
  Map map;
  map.format = (data[0] & 1) != 0 ? slow::Format::four_state : slow::Format::two_state;
  map.count = (data[0] & 2) != 0 ? slow::micro_triangles(data[1] % 7) : data[1];
  data += 2;
  size -= 2;
  // Vectors of the exact size: the sanitizer sees any step over their ends.
  map.bytes.resize(static_cast<std::size_t>(slow::packed_bytes(map.count, map.format)));
  for (std::size_t k = 0; k < map.bytes.size() && k < size; ++k) map.bytes[k] = data[k];
  map.states = slow::unpack(map.bytes, map.format, map.count);
  return map;
}

Bytes room(std::uint64_t count, slow::Format f) {
  return Bytes(static_cast<std::size_t>(slow::packed_bytes(count, f)), 0xa5);
}

/// The corners of a micro-triangle, in any order, on a triangle whose vertex k is vertex order[k].
using Place = std::array<std::pair<std::uint32_t, std::uint32_t>, 3>;
Place place(std::uint32_t index, mmverify::spec::Level n, const fast::VertexOrder& order) {
  Place out;
  const auto corners = mmverify::spec::index::corners(index, n);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::array<std::uint32_t, 3> here{(1u << n) - corners[c].i - corners[c].j, corners[c].i,
                                            corners[c].j};
    std::array<std::uint32_t, 3> there{};
    for (std::size_t k = 0; k < 3; ++k) there[order[k]] = here[k];
    out[c] = {there[1], there[2]};
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Checks that a piece of the surface keeps its state in every order of the vertices.
void check_orders(const Map& map, mmverify::spec::Level n) {
  fast::VertexOrder order{0, 1, 2};
  const auto count = static_cast<std::uint32_t>(map.count);
  std::vector<Place> places(count);
  for (std::uint32_t k = 0; k < count; ++k) places[k] = place(k, n, order);
  do {
    Bytes out = room(count, map.format);
    fast::reorder(map.bytes, n, static_cast<fast::Format>(map.format), order, out);
    const States states = slow::unpack(out, map.format, count);
    require(out == slow::pack(states, map.format), "the padding of reorder", map);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto was = std::find(places.begin(), places.end(), place(k, n, order)) - places.begin();
      require(states[k] == map.states[static_cast<std::size_t>(was)], "reorder", map);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

/// Checks codes of indices: the first two words of the bytes, and codes at and below those of all states.
void check_codes(const Map& map) {
  for (const slow::Encoding e : slow::encodings) {
    const auto encoding = static_cast<fast::Encoding>(e);
    const auto mask = static_cast<std::uint32_t>((std::uint64_t{1} << slow::width(e)) - 1);
    const auto check = [&](std::uint32_t code) {
      const slow::Meaning meaning = slow::meaning(code, e);
      const auto state = fast::special_state(code, encoding);
      require(state.has_value() == (meaning.kind == slow::Meaning::Kind::special) &&
                  fast::is_index(code, encoding) == (meaning.kind == slow::Meaning::Kind::index) &&
                  (!state || static_cast<unsigned>(*state) == slow::code(meaning.state)),
              "the meaning of a code", map);
    };
    for (std::size_t at = 0; at + 4 <= map.bytes.size() && at < 8; at += 4) {
      std::uint32_t code;
      std::memcpy(&code, map.bytes.data() + at, sizeof code);
      check(code & mask);
    }
    for (const slow::State s : {slow::State::T, slow::State::O, slow::State::UT, slow::State::UO}) {
      const std::uint32_t code = slow::special_code(s, e);
      require(fast::special_code(static_cast<fast::State>(slow::code(s)), encoding) == code, "a special code",
              map);
      check(code);
      check((code - 4) & mask);
    }
  }
}

/// Checks force-2-state and the two-state modes of a 4-state map.
void check_to_two_states(const Map& map) {
  constexpr auto two = slow::Format::two_state, four = slow::Format::four_state;
  const std::uint64_t count = map.count;
  Bytes out = room(count, two);
  fast::force2(map.bytes, count, out);
  require(out == slow::pack(slow::force2(map.states), two), "force2", map);
  for (const auto mode : {slow::Mode::T_O, slow::Mode::T_C, slow::Mode::O_C}) {
    fast::to_mode(map.bytes, count, static_cast<fast::Mode>(mode), out);
    Bytes back = room(count, four);
    fast::from_mode(out, count, static_cast<fast::Mode>(mode), back);
    const States through = slow::through(map.states, mode);
    require(back == slow::pack(through, four), "modes", map);
    const auto pairs = fast::substitutions(map.bytes, back, count);
    require(pairs.allowed() == slow::everywhere(map.states, through, slow::allowed), "allowed", map);
    require(pairs.conservative() == slow::everywhere(map.states, through, slow::conservative), "conservative",
            map);
    require(pairs.force2_stable() == slow::everywhere(map.states, through, slow::force2_stable),
            "force2_stable", map);
  }
}

void check(const Map& map) {
  check_codes(map);
  constexpr auto two = slow::Format::two_state, four = slow::Format::four_state;
  const auto format = static_cast<fast::Format>(map.format);
  const std::uint64_t count = map.count;

  std::vector<fast::State> states(static_cast<std::size_t>(count));
  fast::unpack(map.bytes, format, states);
  for (std::size_t i = 0; i < states.size(); ++i)
    require(static_cast<unsigned>(states[i]) == slow::code(map.states[i]), "unpack", map);
  Bytes out = room(count, map.format);
  fast::pack(states, format, out);
  require(out == slow::pack(map.states, map.format), "pack", map);

  const auto one = slow::uniform(map.states);
  const auto got = fast::uniform(map.bytes, format, count);
  require(one.has_value() == got.has_value() && (!one || slow::code(*one) == static_cast<unsigned>(*got)),
          "uniform", map);
  fast::StateCounts counts{};
  for (const slow::State s : map.states) ++counts[slow::code(s)];
  require(fast::count_states(map.bytes, format, count) == counts, "count_states", map);

  out = room(4 * count, map.format);
  fast::up(map.bytes, format, count, out);
  require(out == slow::pack(slow::up(map.states), map.format), "up", map);
  Bytes back = room(count, map.format);
  fast::down(out, format, count, back);
  require(back == slow::pack(map.states, map.format), "down after up", map);
  if (count != 0 && count % 4 == 0) {
    out = room(count / 4, map.format);
    fast::down(map.bytes, format, count / 4, out);
    require(out == slow::pack(map.format == two ? slow::down_two_state(map.states) : slow::down(map.states),
                              map.format),
            "down", map);
  }

  // Maps with few micro-triangles alone: each micro-triangle is searched among all.
  for (mmverify::spec::Level n = 0; n <= 3; ++n)
    if (count == slow::micro_triangles(n)) check_orders(map, n);

  if (map.format == two) {
    out = room(count, four);
    fast::widen(map.bytes, count, out);
    require(out == slow::pack(map.states, four), "widen", map);
    return;
  }
  check_to_two_states(map);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size >= 2) check(map_of(data, size));
  return 0;
}
