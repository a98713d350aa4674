#include "proofs/tree/checks.hpp"

#include <initializer_list>
#include <numeric>

#include "spec/fixed.hpp"

namespace mmverify::proofs::tree {
namespace {

using spec::micromap::micro_triangles;

std::vector<std::uint32_t> every_index(Level n) {
  std::vector<std::uint32_t> indices(micro_triangles(n));
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

/// Some indices of a large map: the first, the last, and others that depend on the map.  Every second one is
/// anywhere; the rest are pairs at which the state changes, if it does so soon.
std::vector<std::uint32_t> some_indices(const Map& map, std::uint64_t most) {
  constexpr std::uint64_t soon = 512;
  const std::uint64_t all = micro_triangles(map.level);
  Random random(hash_of(map.packed), map.level, most);
  std::vector<std::uint32_t> indices{0};
  while (indices.size() + 3 < most) {
    std::uint64_t k = random.below(all);
    indices.push_back(static_cast<std::uint32_t>(k));
    k = random.below(all - 1);
    const std::uint64_t end = std::min(all - 2, k + soon);
    while (k < end && state_at(map, k) == state_at(map, k + 1)) ++k;
    indices.push_back(static_cast<std::uint32_t>(k));
    indices.push_back(static_cast<std::uint32_t>(k + 1));
  }
  indices.push_back(static_cast<std::uint32_t>(all - 1));
  return indices;
}

/// The indices in another order: each step is near the golden section of their number.
std::vector<std::uint32_t> scattered(std::span<const std::uint32_t> indices) {
  const std::uint64_t size = indices.size();
  std::uint64_t step = size * 5 / 8 | 1;
  while (std::gcd(step, size) != 1) step += 2;
  std::vector<std::uint32_t> out;
  for (std::uint64_t k = 0, at = size / 3; k < size; ++k, at = (at + step) % size) out.push_back(indices[at]);
  return out;
}

/// Compares lookups with the map's states, in batches of first, 4 first + 1, ... elements.
Finding looked_up(const Functions& subject, const Code& code, const Map& map,
                  std::span<const std::uint32_t> indices, std::size_t first) {
  Bytes states(indices.size(), 0xFF);
  for (std::size_t at = 0, size = first; at < indices.size(); at += size, size = 4 * size + 1) {
    size = std::min(size, indices.size() - at);
    subject.lookup(code, indices.subspan(at, size), std::span(states).subspan(at, size));
  }
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (const std::uint8_t expected = state_at(map, indices[k]); states[k] != expected)
      return wrong(fmt::format("state {}", indices[k]), fmt::format("{}", expected),
                   fmt::format("{}", states[k]));
  return {hash_of(states)};
}

/// Points (ku/4N, kv/4N), as floats and with their index.
struct Points {
  std::vector<float> u, v;
  std::vector<std::uint32_t> index;

  void add(Level n, std::int64_t ku, std::int64_t kv) {
    const auto coordinate = [&](std::int64_t k) { return spec::Fixed64::dyadic(k, n + 2); };
    const auto rounded = [&](std::int64_t k) {
      return static_cast<float>(k) / static_cast<float>(4 * spec::side(n));  // exact: k has few bits
    };
    u.push_back(rounded(ku));
    v.push_back(rounded(kv));
    index.push_back(spec::index::reference(spec::Point<spec::Fixed64>{coordinate(ku), coordinate(kv)}, n));
  }
};

Points chosen_points(Level n, std::uint64_t most, std::uint64_t seed = 1) {
  const std::int64_t side = 4 * std::int64_t{spec::side(n)};
  Points points;
  if (static_cast<std::uint64_t>((side + 1) * (side + 2) / 2) <= most) {
    for (std::int64_t kv = 0; kv <= side; ++kv)
      for (std::int64_t ku = 0; ku + kv <= side; ++ku) points.add(n, ku, kv);
  } else {
    Random random(seed, n, most);
    for (std::uint64_t k = 0; k < most; ++k) {
      const std::int64_t kv = random.between(0, side);
      points.add(n, random.between(0, side - kv), kv);
    }
  }
  return points;
}

/// The points of a level, made once for all its maps.
const Points& all_points(Level n) {
  static const std::vector<Points> by_level = [] {
    std::vector<Points> all;
    for (Level level = 0; level <= 2; ++level) all.push_back(chosen_points(level, ~std::uint64_t{0}));
    return all;
  }();
  return by_level[n];
}

/// The map with two siblings of the third quarter exchanged, at most four levels below the root.  Its code has the
/// same length and the same ends, and another tree if the two nodes have other shapes.
Map with_two_nodes_exchanged(const Map& map) {
  Map other = map;
  if (map.level == 0) return other;
  const Level depth = std::min<Level>(map.level, 4);
  const std::uint64_t run = micro_triangles(map.level - depth), quarter = micro_triangles(map.level) / 4;
  States states = spec::micromap::unpack(map.packed, map.format, micro_triangles(map.level));
  const auto first = states.begin() + static_cast<std::ptrdiff_t>(depth == 1 ? quarter : 2 * quarter);
  std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(run), first + static_cast<std::ptrdiff_t>(run));
  other.packed = spec::micromap::pack(states, map.format);
  return other;
}

/// The first eight indices of the third quarter, and eight at even steps.
std::vector<std::uint32_t> spread_over_the_third_quarter(Level n) {
  constexpr std::uint64_t most = 8;
  const std::uint64_t quarter = micro_triangles(n) / 4, step = std::max<std::uint64_t>(1, quarter / most);
  std::vector<std::uint32_t> indices;
  for (std::uint64_t k = 0; k < std::min(quarter, most); ++k) {
    indices.push_back(static_cast<std::uint32_t>(2 * quarter + k));
    indices.push_back(static_cast<std::uint32_t>(2 * quarter + k * step));
  }
  return indices;
}

}  // namespace

Finding round_trip(const TreeSubject& s, const Map& map) {
  return same_map(map, s.functions.decode(s.functions.encode(map)));
}

Finding round_trip_and_lookups_of_level_2(const TreeSubject& s, const Map& map) {
  static const std::vector<std::uint32_t> indices = every_index(2);
  const Code code = s.functions.encode(map);
  const Bytes decoded = s.functions.decode(code);
  std::array<std::uint8_t, 16> states{};
  s.functions.lookup(code, indices, states);
  bool same = decoded == map.packed;
  for (std::uint32_t k = 0; k < states.size(); ++k) same = same && states[k] == state_at(map, k);
  if (same) return {hash_of(decoded)};
  if (Finding found = same_map(map, decoded); !found.holds) return found;
  return lookups(s, map);
}

Finding lookups(const TreeSubject& s, const Map& map, std::uint64_t most) {
  const Code code = s.functions.encode(map);
  const std::vector<std::uint32_t> indices =
      micro_triangles(map.level) <= most ? every_index(map.level) : some_indices(map, most);
  const Finding at_once = looked_up(s.functions, code, map, indices, indices.size());
  if (!at_once.holds) return at_once;
  // An answer depends only on its index, not on its place, the size of its batch or earlier questions.
  const Finding again = looked_up(s.functions, code, map, scattered(indices), 1);
  return again.holds ? at_once : again;
}

Finding asked_in_turn(const TreeSubject& s, const Map& map) {
  const std::uint64_t last = micro_triangles(map.level) - 1;
  std::vector<std::uint32_t> indices{static_cast<std::uint32_t>(last), static_cast<std::uint32_t>(last / 2),
                                     0};
  for (const std::uint32_t k : spread_over_the_third_quarter(map.level)) indices.push_back(k);
  std::vector<Map> maps(3, map);
  for (std::size_t k = 1; k < 3; ++k) {
    const std::uint64_t bit = indices[k - 1] * std::uint64_t{bits(map.format)};
    maps[k].packed[bit / 8] = static_cast<std::uint8_t>(maps[k].packed[bit / 8] ^ 1u << bit % 8);
  }
  maps.push_back(with_two_nodes_exchanged(map));
  std::vector<Code> codes;
  for (const Map& one : maps) codes.push_back(s.functions.encode(one));
  for (const std::size_t k : {0u, 1u, 0u, 2u, 1u, 2u, 0u, 3u, 0u}) {
    if (s.functions.lookup)
      if (const Finding found = looked_up(s.functions, codes[k], maps[k], indices, indices.size());
          !found.holds)
        return found;
    if (const Finding found = same_map(maps[k], s.functions.decode(codes[k])); !found.holds) return found;
  }
  return {hash_of(maps[2].packed)};
}

Finding points(const TreeSubject& s, const Map& map, std::uint64_t most) {
  const Code code = s.functions.encode(map);
  Points some;
  const bool all = map.level <= 2 && most == ~std::uint64_t{0};
  if (!all) some = chosen_points(map.level, most, hash_of(map.packed));
  const Points& points = all ? all_points(map.level) : some;
  Bytes states(points.index.size(), 0xFF);
  s.functions.point(code, points.u, points.v, states);
  for (std::size_t k = 0; k < states.size(); ++k)
    if (const std::uint8_t expected = state_at(map, points.index[k]); states[k] != expected)
      return wrong(
          fmt::format("state at u={:a},v={:a}, index {},", points.u[k], points.v[k], points.index[k]),
          fmt::format("{}", expected), fmt::format("{}", states[k]));
  return {hash_of(states)};
}

Finding stream_is_specified(const TreeSubject& s, const Map& map) {
  const States states = spec::micromap::unpack(map.packed, map.format, micro_triangles(map.level));
  const Bytes expected = spec::tree::bytes(spec::tree::encode(states, map.level), map.format),
              got = s.functions.bytes(s.functions.encode(map));
  if (got == expected) return {hash_of(got)};
  const auto at = std::mismatch(expected.begin(), expected.end(), got.begin(), got.end()).first;
  const auto byte = static_cast<std::size_t>(at - expected.begin());
  const auto from = [byte](const Bytes& all) { return hex(std::span(all).subspan(byte), " ").substr(0, 64); };
  return wrong(fmt::format("bytes from {} on", byte), from(expected), from(got));
}

Finding sizes(const TreeSubject& s, const Map& map) {
  const Bytes bytes = s.functions.bytes(s.functions.encode(map));
  const auto tree = spec::tree::from_bytes(bytes, map.format);
  if (!tree) return wrong("bytes", "a tree and its values", hex(bytes, " ").substr(0, 64));
  const std::uint64_t nodes = tree->tree.size(), leaves = tree->data.size(),
                      internal =
                          static_cast<std::uint64_t>(std::count(tree->tree.begin(), tree->tree.end(), true));
  if (leaves != 3 * internal + 1 || nodes != 4 * internal + 1)
    return wrong("leaves", fmt::format("{}", 3 * internal + 1), fmt::format("{}", leaves));
  const std::uint64_t most = spec::tree::most_nodes(map.level);
  if (nodes > most) return wrong("nodes, at most", fmt::format("{}", most), fmt::format("{}", nodes));
  // The sizes by closed forms from the number of leaves.
  const std::uint64_t expected = (nodes + 7) / 8 + (leaves * bits(map.format) + 7) / 8;
  if (bytes.size() != expected)
    return wrong("bytes", fmt::format("{}", expected), fmt::format("{}", bytes.size()));
  return {nodes};
}

Finding damage(const TreeSubject& s, const Map& map) {
  const Bytes whole = s.functions.bytes(s.functions.encode(map));
  std::uint64_t taken = 0;
  const auto judge = [&](const Bytes& bytes, const std::string& what) -> std::optional<Finding> {
    const auto code = s.functions.open(map.level, map.format, bytes);
    if (!code) return std::nullopt;
    ++taken;
    const Map other{map.level, map.format, s.functions.decode(*code)};
    if (other.packed == map.packed) return wrong(what, "refused", "the same map");
    if (s.functions.bytes(s.functions.encode(other)) != bytes)
      return wrong(what, "refused", "a code that nobody encodes");
    return std::nullopt;
  };
  Bytes bytes = whole;
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
    if (auto found = judge(bytes, fmt::format("bit {} flipped,", bit))) return *found;
    bytes[bit / 8] = whole[bit / 8];
  }
  const auto longer = [&](std::initializer_list<std::uint8_t> more, const char* what) {
    bytes.insert(bytes.end(), more);
    auto found = judge(bytes, what);
    bytes = whole;
    return found;
  };
  if (auto found = longer({0}, "a byte more,")) return *found;
  if (auto found = longer({0xFF}, "a byte ff more,")) return *found;
  if (auto found = longer({0, 0}, "two bytes more,")) return *found;
  bytes.insert(bytes.end(), whole.begin(), whole.end());
  if (auto found = judge(bytes, "twice,")) return *found;
  bytes = whole;
  while (!bytes.empty()) {
    bytes.pop_back();
    if (auto found = judge(bytes, fmt::format("cut to {} bytes,", bytes.size()))) return *found;
  }
  return {taken};
}

Finding bytes_are_canonical(const TreeSubject& s, Level n, Format f, std::span<const std::uint8_t> bytes) {
  const auto tree = spec::tree::from_bytes(bytes, f);
  const auto meant = tree ? spec::tree::decode(*tree, n, f) : std::nullopt;
  const auto code = s.functions.open(n, f, bytes);
  if (meant.has_value() != code.has_value())
    return wrong("bytes", meant ? "taken" : "refused", meant ? "refused" : "taken");
  if (!code) return {0};
  const Map map{n, f, spec::micromap::pack(*meant, f)};
  if (Finding same = same_map(map, s.functions.decode(*code)); !same.holds) return same;
  const Bytes again = s.functions.bytes(s.functions.encode(map));
  if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end()))
    return wrong("encoded again", hex(bytes, " "), hex(again, " "));
  return {hash_of(again)};
}

}  // namespace mmverify::proofs::tree
