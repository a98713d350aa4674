// The succinct tree, on a scene's own maps.
#include "impl/tree/tree.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/scene/law_parts.hpp"
#include "proofs/scene/laws.hpp"

namespace mmverify::proofs::scene {
namespace {

namespace micromap = impl::micromap;
namespace tree = impl::tree;

/// A record's map; of 4-state it is judged, of 2-state as well.
struct Map {
  micromap::Format format;
  std::span<const std::uint8_t> bytes;
};

Map map_of(const Data& data, const micromap::Record& record) {
  const auto format = static_cast<micromap::Format>(record.format);
  return {format, std::span(data.arrays.array.data)
                      .subspan(record.offset,
                               micromap::packed_bytes(micromap::micro_triangles(record.level), format))};
}

unsigned state_at(const Map& map, std::uint64_t index) {
  const unsigned b = micromap::bits(map.format);
  return map.bytes[index * b / 8] >> (index * b % 8) & ((1u << b) - 1);
}

Finding round_trip(const Codecs& codecs, const Map& map, Level n) {
  micromap::Bytes back(map.bytes.size());
  const tree::Stream stream = codecs.stream(n, map.format, map.bytes);
  if (!tree::decode_stream(n, map.format, stream, back) ||
      !std::equal(back.begin(), back.end(), map.bytes.begin()))
    return wrong("the map, from its two bit sequences", "another");
  const tree::Tree form = codecs.tree(n, map.format, map.bytes);
  form.decode(back);
  if (!std::equal(back.begin(), back.end(), map.bytes.begin()))
    return wrong("the map, from the form for random access", "another");
  const std::uint64_t count = micromap::micro_triangles(n);
  for (std::uint64_t k = 0; k < 256; ++k) {
    // All digits meet: both ends, and places drawn.
    const std::uint64_t index = k == 0 ? 0 : k == 1 ? count - 1 : Random(1, n, k).below(count);
    if (const unsigned got = form[index], expected = state_at(map, index); got != expected)
      return wrong(fmt::format("state {} at {}", expected, index), fmt::format("{}", got));
    if (k < 8) {
      const unsigned got = tree::lookup_stream(n, map.format, stream, index), expected = state_at(map, index);
      if (got != expected)
        return wrong(fmt::format("state {} at {}, by Algorithm 3", expected, index), fmt::format("{}", got));
    }
  }
  return {stream.nodes * 0x9E3779B97F4A7C15u + hash_of(stream.tree)};
}

}  // namespace

std::vector<Law> tree_laws(const Data& data) {
  auto by_level = std::make_shared<std::vector<std::vector<micromap::Record>>>(17);
  for (const micromap::Record& record : data.arrays.array.records)
    (*by_level)[record.level].push_back(record);
  return {on_cases(
      {.id = "tree.round_trip",
       .topic = "tree",
       .says = "a map's tree, as two bit sequences and as the form for random access, is the map again",
       .source = "Succinct Opacity Micromaps, Algorithms 1 to 3"},
      {"micromaps", [by_level](Level n) { return (*by_level)[n].size(); },
       [by_level, &data](Level n, std::uint64_t k) {
         return round_trip(data.codecs, map_of(data, (*by_level)[n][k]), n);
       }})};
}

}  // namespace mmverify::proofs::scene
