#include "proofs/dag/checks.hpp"

#include <numeric>

#include "proofs/engine/random.hpp"
#include "proofs/points/exact_float.hpp"
#include "proofs/points/stiff_floats.hpp"

namespace mmverify::proofs::dag {
namespace {

using spec::micromap::micro_triangles;

std::uint64_t hash_of_scene(const Scene& scene) {
  Hash hash;
  for (const Map& map : scene.maps) {
    hash.number(map.level);
    for (const std::uint8_t byte : map.packed) hash.byte(byte);
  }
  return hash.value();
}

Finding same_scene(const Scene& expected, const Scene& got) {
  if (expected == got) return {hash_of_scene(got)};
  if (got.maps.size() != expected.maps.size())
    return wrong(fmt::format("{} maps", expected.maps.size()), fmt::format("{}", got.maps.size()));
  for (std::size_t m = 0; m < got.maps.size(); ++m) {
    const Map &e = expected.maps[m], &g = got.maps[m];
    if (g.level != e.level)
      return wrong(fmt::format("map {} of level {}", m, e.level), fmt::format("{}", g.level));
    if (g.packed.size() != e.packed.size())
      return wrong(fmt::format("map {} of {} bytes", m, e.packed.size()), fmt::format("{}", g.packed.size()));
    for (std::uint64_t k = 0; k < micro_triangles(e.level); ++k)
      if (state_at(e, expected.format, k) != state_at(g, expected.format, k))
        return wrong(fmt::format("map {} index {} state {}", m, k, state_at(e, expected.format, k)),
                     fmt::format("{}", state_at(g, expected.format, k)));
    if (e.packed != g.packed) return wrong(fmt::format("map {} padding bits 0", m), "1");
  }
  return wrong(fmt::format("format {}", bits(expected.format)), fmt::format("{}", bits(got.format)));
}

struct Elements {
  std::vector<std::uint32_t> map, index;
  void add(std::uint64_t m, std::uint64_t k) {
    map.push_back(static_cast<std::uint32_t>(m));
    index.push_back(static_cast<std::uint32_t>(k));
  }
};

Elements elements(const Scene& scene, std::uint64_t most) {
  std::uint64_t all = 0;
  for (const Map& map : scene.maps) all += micro_triangles(map.level);
  Elements out;
  if (all <= most) {
    for (std::size_t m = 0; m < scene.maps.size(); ++m)
      for (std::uint64_t k = 0; k < micro_triangles(scene.maps[m].level); ++k) out.add(m, k);
    return out;
  }
  Random random(hash_of_scene(scene), most, 1);
  while (out.map.size() + 3 < most) {
    const std::uint64_t m = random.below(scene.maps.size()), size = micro_triangles(scene.maps[m].level);
    std::uint64_t k = random.below(size);
    out.add(m, k);
    const auto state = [&](std::uint64_t at) { return state_at(scene.maps[m], scene.format, at); };
    const std::uint64_t end = std::min(size - 1, k + 512);
    while (k < end && state(k) == state(k + 1)) ++k;
    out.add(m, k);
    out.add(m, std::min(size - 1, k + 1));
  }
  for (std::size_t m = 0; m < scene.maps.size(); ++m) out.add(m, micro_triangles(scene.maps[m].level) - 1);
  return out;
}

/// The elements in another order: each step is near the golden section of their number.
Elements scattered(const Elements& in) {
  const std::uint64_t size = in.map.size();
  std::uint64_t step = size * 5 / 8 | 1;
  while (std::gcd(step, size) != 1) step += 2;
  Elements out;
  for (std::uint64_t k = 0, at = size / 3; k < size; ++k, at = (at + step) % size)
    out.add(in.map[at], in.index[at]);
  return out;
}

Finding looked_up(const Functions& s, const Code& code, const Scene& scene, const Elements& e,
                  std::size_t first) {
  Bytes states(e.map.size(), 0xFF);
  for (std::size_t at = 0, size = first; at < states.size(); at += size, size = 4 * size + 1) {
    size = std::min(size, states.size() - at);
    s.lookup(code, Numbers(e.map).subspan(at, size), Numbers(e.index).subspan(at, size),
             std::span(states).subspan(at, size));
  }
  for (std::size_t k = 0; k < states.size(); ++k)
    if (const std::uint8_t expected = state_at(scene.maps[e.map[k]], scene.format, e.index[k]);
        states[k] != expected)
      return wrong(fmt::format("map {} index {} state {}", e.map[k], e.index[k], expected),
                   fmt::format("{}", states[k]));
  return {hash_of(states)};
}

spec::dag::Words words_of(const Bytes& container, Format f) {
  const auto number = [&](std::size_t at) {
    std::size_t x = 0;
    for (unsigned k = 0; k < 4; ++k) x |= std::size_t{container.at(at + k)} << 8 * k;
    return x;
  };
  const std::size_t b = bits(f),
                    sizes[] = {8 * number(8), 8 * b * number(12), 8 * b * number(16), 4 * number(20)};
  spec::dag::Words words;
  std::size_t at = spec::dag::header_bytes;
  Bytes* const arrays[] = {&words.records, &words.tiles, &words.flat, &words.nodes};
  for (std::size_t k = 0; k < 4; at += sizes[k++]) {
    if (at + sizes[k] > container.size()) throw SubjectBroken("writes a container that ends within an array");
    arrays[k]->assign(container.begin() + static_cast<std::ptrdiff_t>(at),
                      container.begin() + static_cast<std::ptrdiff_t>(at + sizes[k]));
  }
  return words;
}

spec::dag::Words words_of(const DagSubject& s, const Scene& scene) {
  return words_of(s.functions.bytes(s.functions.encode(scene)), scene.format);
}

Scene first_maps(const Scene& scene, std::size_t count) {
  return {scene.format, {scene.maps.begin(), scene.maps.begin() + static_cast<std::ptrdiff_t>(count)}};
}

Bytes sealed(Bytes bytes) {
  if (bytes.size() < spec::dag::header_bytes) return bytes;
  const std::uint32_t crc = spec::dag::checksum(bytes);
  for (unsigned k = 0; k < 4; ++k) bytes[spec::dag::crc_at + k] = static_cast<std::uint8_t>(crc >> 8 * k);
  return bytes;
}

/// Compares a subject's reading of bytes with the specification's.
Finding taken_as_specified(const DagSubject& s, Format f, const std::string& what, const Bytes& bytes) {
  static const DagSubjectPtr right = built_in("dag-spec");
  const auto expected = right->functions.open(f, bytes), got = s.functions.open(f, bytes);
  if (expected.has_value() != got.has_value())
    return wrong(what + (expected ? " taken" : " refused"), got ? "taken" : "refused");
  if (!got) return {hash_of(bytes)};
  Finding found = same_scene(right->functions.decode(*expected), s.functions.decode(*got));
  if (!found.holds) found.expected = what + " as " + found.expected;
  return found;
}

/// Whether the bytes announce a map of a level for which the specification needs seconds.
bool slow_to_judge(const Bytes& bytes) {
  for (std::size_t at = spec::dag::header_bytes;
       at < bytes.size() && at < spec::dag::header_bytes + 8 * std::size_t{bytes[8]}; at += 8)
    if (bytes[at] > 8 && bytes[at] <= 12) return true;
  return false;
}

void swap_words(Bytes& bytes, std::size_t a, std::size_t b) {
  for (std::size_t k = 0; k < 4; ++k) std::swap(bytes[a + k], bytes[b + k]);
}

/// A code with a word, or an array's length, changed in one of six ways.
struct Changed {
  std::uint64_t kind;
  Bytes bytes;
};
Changed changed_at_random(const Bytes& code, Random& random) {
  const std::uint64_t words = code.size() / 4;
  Bytes bytes = code;
  const std::size_t at = 4 * static_cast<std::size_t>(8 + random.below(words - 8)),
                    also = 4 * static_cast<std::size_t>(8 + random.below(words - 8));
  const std::uint64_t kind = random.below(6);
  if (kind == 0) bytes[at + random.below(4)] = static_cast<std::uint8_t>(random.next());
  if (kind == 1) bytes[at] = static_cast<std::uint8_t>(bytes[at] + random.between(-2, 2));
  if (kind == 2) swap_words(bytes, at, also);
  if (kind == 3) bytes[at + random.below(4)] ^= static_cast<std::uint8_t>(1u << random.below(8));
  if (kind == 4)
    std::copy_n(code.begin() + static_cast<std::ptrdiff_t>(also), 4,
                bytes.begin() + static_cast<std::ptrdiff_t>(at));
  if (kind == 5) {  // an array a word longer, or one a word shorter
    const std::size_t count = 8 + 4 * static_cast<std::size_t>(random.below(4));
    const bool longer = random.below(2) == 0;
    bytes[count] = static_cast<std::uint8_t>(bytes[count] + (longer ? 1 : -1));
    if (longer)
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), 4 * (1 + random.below(4)), 0);
    else
      bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                  bytes.begin() + static_cast<std::ptrdiff_t>(
                                      std::min<std::size_t>(bytes.size(), at + 4 * (1 + random.below(4)))));
  }
  return {kind, std::move(bytes)};
}

}  // namespace

Finding round_trip(const DagSubject& s, const Scene& scene) {
  return same_scene(scene, s.functions.decode(s.functions.encode(scene)));
}

Finding lookups(const DagSubject& s, const Scene& scene, std::uint64_t most) {
  const Code code = s.functions.encode(scene);
  const Elements e = elements(scene, most);
  const Finding at_once = looked_up(s.functions, code, scene, e, e.map.size());
  if (!at_once.holds) return at_once;
  const Finding again = looked_up(s.functions, code, scene, scattered(e), 1);
  return again.holds ? at_once : again;
}

Finding points(const DagSubject& s, const Scene& scene, std::uint64_t most) {
  std::vector<float> u, v;
  Elements e;
  const auto add = [&](std::size_t m, std::int64_t ku, std::int64_t kv) {
    const Level n = scene.maps[m].level;
    const auto exact = [&](std::int64_t k) { return spec::Fixed64::dyadic(k, n + 2); };
    const auto rounded = [&](std::int64_t k) {
      return static_cast<float>(k) / static_cast<float>(4 * spec::side(n));  // exact: k has few bits
    };
    u.push_back(rounded(ku));
    v.push_back(rounded(kv));
    e.add(m, spec::index::reference(spec::Point<spec::Fixed64>{exact(ku), exact(kv)}, n));
  };
  Random random(hash_of_scene(scene), most, 2);
  for (std::size_t m = 0; m < scene.maps.size(); ++m) {
    const std::int64_t side = 4 * std::int64_t{spec::side(scene.maps[m].level)};
    // Pairs of floats near values that break index functions.
    for (std::uint64_t k = 0; k < most / 4; ++k) {
      const points::FloatPair p = points::stiff_floats(scene.maps[m].level, hash_of_scene(scene), k);
      u.push_back(p.u);
      v.push_back(p.v);
      e.add(m, points::on_exact(
                   p.u, p.v, [&](const auto& q) { return spec::index::reference(q, scene.maps[m].level); }));
    }
    if (scene.maps[m].level <= 2) {
      for (std::int64_t kv = 0; kv <= side; ++kv)
        for (std::int64_t ku = 0; ku + kv <= side; ++ku) add(m, ku, kv);
    } else {
      for (std::uint64_t k = 0; k < most; ++k) {
        const std::int64_t kv = random.between(0, side);
        add(m, random.between(0, side - kv), kv);
      }
    }
  }
  Bytes states(u.size(), 0xFF);
  s.functions.point(s.functions.encode(scene), e.map, u, v, states);
  for (std::size_t k = 0; k < states.size(); ++k)
    if (const std::uint8_t expected = state_at(scene.maps[e.map[k]], scene.format, e.index[k]);
        states[k] != expected)
      return wrong(
          fmt::format("map {} at u={:a},v={:a}, index {}, {}", e.map[k], u[k], v[k], e.index[k], expected),
          fmt::format("{}", states[k]));
  return {hash_of(states)};
}

Finding is_specified(const DagSubject& s, const Scene& scene) {
  spec::dag::Builder builder(scene.format);
  for (const Map& map : scene.maps) builder.add(map.level, states_of(map, scene.format));
  const Bytes expected = spec::dag::container(builder.dag()),
              got = s.functions.bytes(s.functions.encode(scene));
  if (expected == got) return {hash_of(got)};
  if (expected.size() != got.size())
    return wrong(fmt::format("{} bytes", expected.size()), fmt::format("{}", got.size()));
  std::size_t at = spec::dag::header_bytes;  // the checksum is left out, since it differs with any other byte
  while (at < got.size() && expected[at] == got[at]) ++at;
  if (at == got.size())
    at =
        static_cast<std::size_t>(std::mismatch(got.begin(), got.end(), expected.begin()).first - got.begin());
  return wrong(fmt::format("byte {} {:#04x}", at, expected[at]), fmt::format("{:#04x}", got[at]));
}

Finding appends(const DagSubject& s, const Scene& scene) {
  spec::dag::Words before;
  for (std::size_t count = 0; count <= scene.maps.size(); ++count) {
    spec::dag::Words after = words_of(s, first_maps(scene, count));
    const std::tuple<const char*, const Bytes*, const Bytes*> arrays[] = {
        {"records", &before.records, &after.records},
        {"tiles", &before.tiles, &after.tiles},
        {"flat", &before.flat, &after.flat},
        {"nodes", &before.nodes, &after.nodes}};
    for (const auto& [name, old, now] : arrays)
      if (now->size() < old->size() || !std::equal(old->begin(), old->end(), now->begin()))
        return wrong(fmt::format("with map {} {} as before", count - 1, name), "others");
    if (after.records.size() != 8 * count)
      return wrong(fmt::format("{} records", count), fmt::format("{}", after.records.size() / 8));
    before = std::move(after);
  }
  return {hash_of(before.nodes) ^ hash_of(before.tiles)};
}

Finding is_bounded(const DagSubject& s, const Scene& scene) {
  const auto size = [&](const Scene& of) {
    const spec::dag::Words w = words_of(s, of);
    return 8 * (w.records.size() + w.tiles.size() + w.flat.size() + w.nodes.size());
  };
  std::uint64_t most = 0;
  for (std::size_t count = 1; count <= scene.maps.size(); ++count) {
    const Map& map = scene.maps[count - 1];
    most += 64 + (map.level < 3 ? 0 : 8 * map.packed.size());
    const std::uint64_t got = size(first_maps(scene, count));
    if (got > most)
      return wrong(fmt::format("{} maps in at most {} bits", count, most), fmt::format("{}", got));
  }
  const std::uint64_t once = size(scene);
  Scene again = scene;
  again.maps.push_back(scene.maps.back());
  if (const std::uint64_t twice = size(again); twice != once + 64)
    return wrong(fmt::format("the last map again in {} bits", once + 64), fmt::format("{}", twice));
  return {once};
}

Finding same_records(const DagSubject& s, const Scene& scene) {
  const spec::dag::Words w = words_of(s, scene);
  const bool same = std::equal(w.records.begin(), w.records.begin() + 8, w.records.begin() + 8);
  if (same != (scene.maps[0] == scene.maps[1]))
    return wrong(same ? "two records" : "one record", same ? "the same one twice" : "two");
  return {hash_of(w.records)};
}

/// A code of a map and its subtrees of level 3 as maps, with the first record repeated at the end.  If that map is
/// stored flat, the later maps would allow to store it as nodes.
Bytes again_behind_its_tiles(const DagSubject& s, Format f, const Map& map) {
  Scene scene{f, {map}};
  const std::size_t tile = 8 * bits(f);
  for (std::size_t at = 0; at < map.packed.size(); at += tile)
    scene.maps.push_back({3, Bytes(map.packed.begin() + static_cast<std::ptrdiff_t>(at),
                                   map.packed.begin() + static_cast<std::ptrdiff_t>(at + tile))});
  Bytes bytes = s.functions.bytes(s.functions.encode(scene));
  constexpr std::ptrdiff_t records = spec::dag::header_bytes;
  const Bytes first(bytes.begin() + records, bytes.begin() + records + 8);
  bytes.insert(bytes.begin() + records + 8 * static_cast<std::ptrdiff_t>(scene.maps.size()), first.begin(),
               first.end());
  ++bytes[8];
  return sealed(bytes);
}

Finding damage(const DagSubject& s, const Scene& scene, bool every, std::uint64_t most) {
  const Bytes code = s.functions.bytes(s.functions.encode(scene));
  Hash digest;
  Finding found;
  const auto goes_on = [&](const std::string& what, const Bytes& bytes) {
    if (bytes.size() >= spec::dag::header_bytes && slow_to_judge(bytes)) return true;
    found = taken_as_specified(s, scene.format, what, bytes);
    digest.number(found.answer);
    return found.holds;
  };
  if (!goes_on("the code", code)) return found;
  const Format other = scene.format == Format::two_state ? Format::four_state : Format::two_state;
  if (s.functions.open(other, code)) return wrong("the other format refused", "taken");
  if (every) {
    for (std::size_t size = 0; size < code.size(); ++size)
      if (!goes_on(fmt::format("cut to {} bytes,", size),
                   sealed(Bytes(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(size)))))
        return found;
    for (std::size_t bit = 0; bit < 8 * code.size(); ++bit) {
      Bytes bytes = code;
      bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
      if (!goes_on(fmt::format("bit {} flipped,", bit), bytes)) return found;
      if (!goes_on(fmt::format("bit {} flipped and sealed,", bit), sealed(bytes))) return found;
    }
    for (const int more : {0, 1, 255}) {
      Bytes bytes = code;
      bytes.push_back(static_cast<std::uint8_t>(more));
      if (!goes_on(fmt::format("a byte {} more,", more), sealed(bytes))) return found;
    }
    return {digest.value()};
  }
  if (const auto map = std::find_if(scene.maps.begin(), scene.maps.end(),
                                    [](const Map& m) { return m.level == 4 || m.level == 5; });
      map != scene.maps.end() &&
      !goes_on("a record again behind its tiles,", again_behind_its_tiles(s, scene.format, *map)))
    return found;
  Random random(hash_of(code), most, 3);
  for (std::uint64_t k = 0; k < most; ++k) {
    const auto [kind, bytes] = changed_at_random(code, random);
    if (!goes_on(fmt::format("change {} of kind {},", k, kind), sealed(bytes))) return found;
  }
  return {digest.value()};
}

}  // namespace mmverify::proofs::dag
