#include "proofs/tree/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "spec/fixed.hpp"

namespace mmverify::proofs::tree {
namespace {

using spec::micromap::micro_triangles;

std::vector<std::uint32_t> chosen_indices(Level n, std::uint64_t most) {
  const std::uint64_t all = micro_triangles(n);
  std::vector<std::uint32_t> indices;
  if (all <= most) {
    for (std::uint64_t k = 0; k < all; ++k) indices.push_back(static_cast<std::uint32_t>(k));
  } else {
    Random random(1, n, most);
    for (std::uint64_t k = 0; k < most; ++k) indices.push_back(static_cast<std::uint32_t>(random.below(all)));
    indices.front() = 0;
    indices.back() = static_cast<std::uint32_t>(all - 1);
  }
  return indices;
}

/// Points (ku/4N, kv/4N), as floats and with their index.
struct Points {
  std::vector<float> u, v;
  std::vector<std::uint32_t> index;

  void add(Level n, std::int64_t ku, std::int64_t kv) {
    const auto coordinate = [&](std::int64_t k) { return spec::Fixed64::dyadic(k, n + 2); };
    const auto rounded = [&](std::int64_t k) {
      return static_cast<float>(k) / static_cast<float>(4 * spec::side(n));  // exact: a few bits
    };
    u.push_back(rounded(ku));
    v.push_back(rounded(kv));
    index.push_back(spec::index::reference(spec::Point<spec::Fixed64>{coordinate(ku), coordinate(kv)}, n));
  }
};

Points chosen_points(Level n, std::uint64_t most) {
  const std::int64_t side = 4 * std::int64_t{spec::side(n)};
  Points points;
  if (static_cast<std::uint64_t>((side + 1) * (side + 2) / 2) <= most) {
    for (std::int64_t kv = 0; kv <= side; ++kv)
      for (std::int64_t ku = 0; ku + kv <= side; ++ku) points.add(n, ku, kv);
  } else {
    Random random(2, n, most);
    for (std::uint64_t k = 0; k < most; ++k) {
      const std::int64_t kv = random.between(0, side);
      points.add(n, random.between(0, side - kv), kv);
    }
  }
  return points;
}

/// The same for every map of a level, so made once.
const Points& all_points(Level n) {
  static const std::vector<Points> by_level = [] {
    std::vector<Points> all;
    for (Level level = 0; level <= 2; ++level) all.push_back(chosen_points(level, ~std::uint64_t{0}));
    return all;
  }();
  return by_level[n];
}

/// A hash of what was answered.
Finding answered(std::span<const std::uint8_t> states) { return {hash_of(states)}; }

}  // namespace

Finding round_trip(const TreeSubject& s, const Map& map) { return same_map(map, s.encode(map)->decode()); }

Finding round_trip_and_lookups_of_level_2(const TreeSubject& s, const Map& map) {
  static const std::vector<std::uint32_t> indices = chosen_indices(2, 16);
  const CodePtr code = s.encode(map);
  const Bytes decoded = code->decode();
  std::array<std::uint8_t, 16> states{};
  code->lookup(indices, states);
  bool same = decoded == map.packed;
  for (std::uint32_t k = 0; k < states.size(); ++k) same = same && states[k] == state_at(map, k);
  if (same) return {hash_of(decoded)};
  if (Finding found = same_map(map, decoded); !found.holds) return found;
  return lookups(s, map);
}

Finding lookups(const TreeSubject& s, const Map& map, std::uint64_t most) {
  const CodePtr code = s.encode(map);
  const std::vector<std::uint32_t> indices = chosen_indices(map.level, most);
  Bytes states(indices.size(), 0xFF);
  code->lookup(indices, states);
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (const std::uint8_t expected = state_at(map, indices[k]); states[k] != expected)
      return wrong(fmt::format("state {}", indices[k]), fmt::format("{}", expected),
                   fmt::format("{}", states[k]));
  return answered(states);
}

Finding points(const TreeSubject& s, const Map& map, std::uint64_t most) {
  const CodePtr code = s.encode(map);
  Points some;
  const bool all = map.level <= 2 && most == ~std::uint64_t{0};
  if (!all) some = chosen_points(map.level, most);
  const Points& points = all ? all_points(map.level) : some;
  Bytes states(points.index.size(), 0xFF);
  code->lookup(points.u, points.v, states);
  for (std::size_t k = 0; k < states.size(); ++k)
    if (const std::uint8_t expected = state_at(map, points.index[k]); states[k] != expected)
      return wrong(
          fmt::format("state at u={:a},v={:a}, index {},", points.u[k], points.v[k], points.index[k]),
          fmt::format("{}", expected), fmt::format("{}", states[k]));
  return answered(states);
}

Finding stream_is_specified(const TreeSubject& s, const Map& map) {
  const States states = spec::micromap::unpack(map.packed, map.format, micro_triangles(map.level));
  const Bytes expected = spec::tree::bytes(spec::tree::encode(states, map.level), map.format),
              got = s.encode(map)->bytes();
  if (got == expected) return {hash_of(got)};
  const auto [at, other] = std::mismatch(expected.begin(), expected.end(), got.begin(), got.end());
  const auto byte = at - expected.begin();
  return wrong(fmt::format("bytes from {} on", byte), hex({at, expected.end()}).substr(0, 64),
               hex({other, got.end()}).substr(0, 64));
}

Finding sizes(const TreeSubject& s, const Map& map) {
  const Bytes bytes = s.encode(map)->bytes();
  const auto tree = spec::tree::from_bytes(bytes, map.format);
  if (!tree) return wrong("bytes", "a tree and its values", hex(bytes).substr(0, 64));
  const std::uint64_t nodes = tree->tree.size(), leaves = tree->data.size(),
                      internal =
                          static_cast<std::uint64_t>(std::count(tree->tree.begin(), tree->tree.end(), true));
  if (leaves != 3 * internal + 1 || nodes != 4 * internal + 1)
    return wrong("leaves", fmt::format("{}", 3 * internal + 1), fmt::format("{}", leaves));
  const std::uint64_t most = spec::tree::most_nodes(map.level);
  if (nodes > most) return wrong("nodes, at most", fmt::format("{}", most), fmt::format("{}", nodes));
  // Closed forms of the sizes that a leaf count gives.
  const std::uint64_t expected = (nodes + 7) / 8 + (leaves * bits(map.format) + 7) / 8;
  if (bytes.size() != expected)
    return wrong("bytes", fmt::format("{}", expected), fmt::format("{}", bytes.size()));
  return {nodes};
}

Finding damage(const TreeSubject& s, const Map& map) {
  const Bytes whole = s.encode(map)->bytes();
  std::uint64_t taken = 0;
  const auto judge = [&](const Bytes& bytes, const std::string& what) -> std::optional<Finding> {
    const CodePtr code = s.open(map.level, map.format, bytes);
    if (code == nullptr) return std::nullopt;
    ++taken;
    const Map other{map.level, map.format, code->decode()};
    if (other.packed == map.packed) return wrong(what, "refused", "the same map");
    if (s.encode(other)->bytes() != bytes) return wrong(what, "refused", "a code that nobody encodes");
    return std::nullopt;
  };
  Bytes bytes = whole;
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
    if (auto found = judge(bytes, fmt::format("bit {} flipped,", bit))) return *found;
    bytes[bit / 8] = whole[bit / 8];
  }
  bytes.push_back(0);
  if (auto found = judge(bytes, "a byte more,")) return *found;
  bytes.pop_back();
  while (!bytes.empty()) {
    bytes.pop_back();
    if (auto found = judge(bytes, fmt::format("cut to {} bytes,", bytes.size()))) return *found;
  }
  return {taken};
}

Finding bytes_are_canonical(const TreeSubject& s, Level n, Format f, std::span<const std::uint8_t> bytes) {
  const auto tree = spec::tree::from_bytes(bytes, f);
  const auto meant = tree ? spec::tree::decode(*tree, n, f) : std::nullopt;
  const CodePtr code = s.open(n, f, bytes);
  if (meant.has_value() != (code != nullptr))
    return wrong("bytes", meant ? "taken" : "refused", meant ? "refused" : "taken");
  if (code == nullptr) return {0};
  const Map map{n, f, spec::micromap::pack(*meant, f)};
  if (Finding same = same_map(map, code->decode()); !same.holds) return same;
  const Bytes again = s.encode(map)->bytes();
  if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end()))
    return wrong("encoded again", hex(bytes), hex(again));
  return {hash_of(again)};
}

}  // namespace mmverify::proofs::tree
