#include <numeric>

#include "proofs/array/cases.hpp"
#include "proofs/array/law_parts.hpp"

namespace mmverify::proofs::array {

namespace maps = mmverify::spec::micromap;

Bundle bundle_of(const BuildCase& c) {
  std::vector<maps::Map> before, all;
  for (const PackedMap& m : c.before) before.push_back({m.level, m.format, states_of(m)});
  for (const PackedMap& m : c.maps) all.push_back({m.level, m.format, states_of(m)});
  const spec::array::Built b = spec::array::build(before, all, c.options);
  return {b.array, {b.part}};
}

namespace {

/// A stream number that keeps the samples of bundles apart from those of builds.
constexpr std::uint64_t bundle_stream = 307;

/// An array whose records all have a map in the data; the maps lie there in any order, with gaps, and some over others.
spec::array::Array any_array(Level n, Random& random) {
  const bool many = random.below(6) == 0;
  std::vector<PackedMap> all(many ? 250 + random.below(351) : random.below(46));
  for (PackedMap& map : all) map = any_map(many ? 0 : n, random);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
  spec::array::Array array;
  array.records.resize(all.size());
  const auto gap = [&] {
    for (std::uint64_t left = random.below(4) == 0 ? random.below(4) : 0; left > 0; --left)
      array.data.push_back(static_cast<std::uint8_t>(random.next()));
  };
  for (const std::size_t r : order) {
    gap();
    array.records[r] = {static_cast<std::uint32_t>(array.data.size()),
                        static_cast<std::uint16_t>(all[r].level), static_cast<std::uint16_t>(all[r].format)};
    const bool over_others = all[r].bytes.size() <= array.data.size() && random.below(5) == 0;
    if (over_others) {
      array.records[r].offset =
          static_cast<std::uint32_t>(random.below(array.data.size() - all[r].bytes.size() + 1));
      continue;
    }
    array.data.insert(array.data.end(), all[r].bytes.begin(), all[r].bytes.end());
  }
  gap();
  return array;
}

Part any_part(std::uint64_t records, Random& random) {
  const std::uint64_t base = random.below(2) == 0 ? 0 : random.below(records + 1);
  Part part{maps::encodings[random.below(5)], static_cast<std::uint32_t>(base), {}};
  const std::uint64_t named = std::min<std::uint64_t>(records - part.base, maps::index_limit(part.encoding));
  for (std::uint64_t left = random.below(41); left > 0; --left) {
    const bool special = named == 0 || random.below(4) == 0;
    const std::uint32_t code = special
                                   ? maps::special_code(static_cast<State>(random.below(4)), part.encoding)
                                   : static_cast<std::uint32_t>(random.below(named));
    for (unsigned j = 0; j < maps::width(part.encoding) / 8; ++j)
      part.indices.push_back(static_cast<std::uint8_t>(code >> 8 * j));
  }
  return part;
}

std::string text_of_triangle(const Bundle& b, const Part& part, std::uint64_t t) {
  const Target to = spec::array::target(b, part, t);
  if (to.kind == Target::Kind::special) return fmt::format("special {}", maps::name_of(to.state));
  if (to.kind != Target::Kind::record) return "outside";
  try {
    const maps::Map map = spec::array::map_of(b.array, to.record);
    std::string text = fmt::format("format {} ", static_cast<unsigned>(map.format));
    for (const State s : map.states) text += static_cast<char>('0' + maps::code(s));
    return text;
  } catch (const std::invalid_argument& bad) {
    return bad.what();
  }
}

}  // namespace

Bundle sample_bundle(Level n, std::uint64_t seed, std::uint64_t k) {
  Random random(seed, bundle_stream + n, k);
  Bundle b{any_array(n, random), {}};
  for (std::uint64_t left = random.below(9); left > 0; --left)
    b.parts.push_back(any_part(b.array.records.size(), random));
  return b;
}

std::optional<std::pair<std::string, std::string>> resolved_differently(const Bundle& was, const Bundle& is) {
  if (was.parts.size() != is.parts.size())
    return std::pair(fmt::format("{} geometries", was.parts.size()), fmt::format("{}", is.parts.size()));
  for (std::size_t p = 0; p < was.parts.size(); ++p) {
    if (was.parts[p].indices.size() != is.parts[p].indices.size())
      return std::pair(fmt::format("geometry {}: {} bytes of indices", p, was.parts[p].indices.size()),
                       fmt::format("{}", is.parts[p].indices.size()));
    for (std::uint64_t t = 0; t < spec::array::triangles(was.parts[p]); ++t) {
      const std::string a = text_of_triangle(was, was.parts[p], t), b = text_of_triangle(is, is.parts[p], t);
      if (a != b) return std::pair(fmt::format("geometry {} triangle {}: {}", p, t, a), b);
    }
  }
  return std::nullopt;
}

}  // namespace mmverify::proofs::array
