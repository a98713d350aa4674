#include "proofs/micromap/arrays.hpp"

#include "proofs/engine/shape.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace slow = mmverify::spec::micromap;

PackedMap any_map(Level n, Random& random) {
  const Level level = static_cast<Level>(random.below(n + 1));
  const auto taken = [](const Map& map) { return PackedMap{map.level, map.format, map.packed}; };
  if (random.below(6) == 0)
    return taken(map_of(level, chosen_apart(level, random.below(chosen_apart_count(level)))));
  const std::uint64_t kind = random.below(10);
  return taken(sample_map(level, random.next() >> 32, kind));
}

// The map but for one state, the last or any.
PackedMap nearly(PackedMap map, Random& random) {
  const std::uint64_t states = slow::micro_triangles(map.level), b = bits(map.format),
                      bit = (random.below(2) == 0 ? states - 1 : random.below(states)) * b + random.below(b);
  map.bytes[bit / 8] = static_cast<std::uint8_t>(map.bytes[bit / 8] ^ 1u << bit % 8);
  return map;
}

// New, or one that is there already, or nearly.
PackedMap next_map(const std::vector<PackedMap>& there, Level n, Random& random) {
  const std::uint64_t way = random.below(6);
  if (there.empty() || way > 2) return any_map(n, random);
  const PackedMap& one = there[random.below(there.size())];
  return way == 2 ? nearly(one, random) : one;
}

// Mostly small, now and then of any size.
std::uint64_t any_number(Random& random) {
  return random.below(4) != 0 ? random.below(10) : random.next() >> random.below(64);
}

std::uint32_t any_word(Random& random) { return static_cast<std::uint32_t>(any_number(random)); }

void spoil_bytes(Bytes& bytes, Random& random) {
  if (!bytes.empty() && random.below(3) != 0)
    bytes[random.below(bytes.size())] = static_cast<std::uint8_t>(any_number(random));
  else
    bytes.resize(random.below(bytes.size() + 9));
}

void spoil_counts(std::vector<UsageCount>& counts, Random& random) {
  if (counts.empty() || random.below(3) == 0) {
    counts.push_back({any_word(random), any_word(random), any_word(random)});
    return;
  }
  UsageCount& c = counts[random.below(counts.size())];
  std::uint32_t* const parts[] = {&c.count, &c.level, &c.format};
  *parts[random.below(3)] = any_word(random);
}

void spoil(Handed& h, Random& random) {
  Input& in = h.in;
  switch (random.below(16)) {
    case 0:
    case 1:
    case 2: return spoil_bytes(h.records, random);
    case 3: return spoil_bytes(h.data, random);
    case 4:
    case 5: return spoil_bytes(h.indices, random);
    case 6: return spoil_counts(h.array_counts, random);
    case 7: return spoil_counts(h.geometry_counts, random);
    case 8: in.record_count = any_number(random); return;
    case 9: in.record_stride = any_number(random); return;
    case 10: in.index_stride = any_number(random); return;
    case 11:
      // Without a buffer every triangle is a reference: the specification walks them all.
      in.indexed = !in.indexed;
      return;
    case 12: in.triangles = any_number(random); return;
    case 13: in.base_triangle = any_word(random); return;
    case 14:
      in.data_address = any_number(random);
      in.records_address = any_number(random);
      in.indices_address = any_number(random);
      return;
    default: h.array_counts.swap(h.geometry_counts);
  }
}

}  // namespace

BuildCase sample_build(Level n, std::uint64_t seed, std::uint64_t k) {
  Random random(seed, 31 + n, k);
  BuildCase c;
  std::vector<PackedMap> all;
  const auto add = [&](std::vector<PackedMap>& to) {
    all.push_back(next_map(all, n, random));
    to.push_back(all.back());
  };
  if (random.below(2) == 0)
    for (std::uint64_t left = random.below(6); left > 0; --left) add(c.before);
  for (std::uint64_t left = random.below(24); left > 0; --left) add(c.maps);
  c.options = {slow::encodings[random.below(5)],
               static_cast<std::uint32_t>(random.below(c.before.size() + 1)), random.below(4) != 0,
               random.below(2) == 0};
  return c;
}

void Handed::point() {
  in.records = records;
  in.data = data;
  in.indices = indices;
  in.array_counts = array_counts;
  in.geometry_counts = geometry_counts;
}

void hand_over(const BuildCase& c, Handed& h) {
  const Built built = built_in("micromap-spec")->functions.build(c.before, c.maps, c.options);
  h.records = built.records;
  h.data = built.data;
  h.indices = built.indices;
  h.array_counts = built.array_counts;
  h.geometry_counts = built.geometry_counts;
  h.in = {};
  h.in.sets = slow::glTF;
  h.in.record_count = built.records.size() / slow::record_bytes;
  h.in.triangles = c.maps.size();
  h.in.indexed = true;
  h.in.encoding = c.options.encoding;
  h.in.index_stride = slow::width(c.options.encoding) / 8;
  h.in.base_triangle = c.options.base_triangle;
  h.point();
}

void sample_spoilt(Level n, std::uint64_t seed, std::uint64_t k, Handed& h) {
  hand_over(sample_build(n, seed, k), h);
  Random random(seed, 61 + n, k);
  Input& in = h.in;
  in.sets = static_cast<slow::Sets>(1 + random.below(15));
  in.lossy = random.below(3) == 0;
  const auto limit = [&] { return static_cast<std::uint32_t>(random.below(3) == 0 ? random.below(4) : 12); };
  in.limits = {limit(), limit(), limit(), random.below(3) == 0 ? random.below(20) : 1'000};
  for (std::uint64_t left = random.below(4); left > 0; --left) spoil(h, random);
  h.point();
}

std::string text_of(std::uint64_t seed, std::uint64_t k) { return fmt::format("sample:{}:{}", seed, k); }

std::pair<std::uint64_t, std::uint64_t> sample_from(const std::string& text) {
  const Groups parts = groups_of(text, "sample:([0-9]{1,19}):([0-9]{1,19})");
  if (!parts) throw BadCase("'" + text + "': write sample:SEED:K");
  return {std::stoull((*parts)[1]), std::stoull((*parts)[2])};
}

}  // namespace mmverify::proofs::micromap
