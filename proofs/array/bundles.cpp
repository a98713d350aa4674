#include "proofs/array/bundles.hpp"

#include <fmt/format.h>

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
