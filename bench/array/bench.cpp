#include "bench/array/bench.hpp"

#include <map>
#include <stdexcept>

#include "bench/rounds.hpp"
#include "bench/tree/maps.hpp"
#include "impl/array/build.hpp"

namespace mmverify::bench {
namespace {

namespace array = impl::array;
using array::Bytes;
using array::Format;
using array::PackedMap;
using Level = impl::micromap::Level;

/// Maps in turns of three: a new map; a copy of it; a copy with three states made unknown or known.
std::vector<Bytes> made(Level level, std::size_t count, std::uint64_t seed) {
  std::vector<Bytes> all;
  const std::uint64_t states = impl::micromap::micro_triangles(level);
  for (std::size_t t = 0; t < count; ++t) {
    if (t % 3 == 0) {
      all.push_back(leaf_map(level, Format::four_state, seed * 1'000'003 + t));
      continue;
    }
    all.push_back(all[t / 3 * 3]);
    if (t % 3 == 2)
      for (std::uint64_t k = 1; k <= 3; ++k) {
        const std::uint64_t i = (t * 2654435761u + k * 40503u) % states;
        all.back()[static_cast<std::size_t>(i / 4)] ^= static_cast<std::uint8_t>(2u << i % 4 * 2);
      }
  }
  return all;
}

/// The records and indices of the same array, built the obvious way: a std::map from level, format and bytes
/// to the record.
std::size_t obvious(const std::vector<PackedMap>& maps) {
  std::map<std::pair<std::pair<Level, Format>, Bytes>, std::uint32_t> known;
  impl::micromap::Array out;
  std::vector<std::uint32_t> indices;
  for (const PackedMap& m : maps) {
    if (const auto state =
            impl::micromap::uniform(m.bytes, m.format, impl::micromap::micro_triangles(m.level))) {
      indices.push_back(impl::micromap::special_code(*state, array::Encoding::u32));
      continue;
    }
    const auto [at, fresh] = known.try_emplace({{m.level, m.format}, Bytes(m.bytes.begin(), m.bytes.end())},
                                               static_cast<std::uint32_t>(out.records.size()));
    if (fresh) {
      out.records.push_back({static_cast<std::uint32_t>(out.data.size()), static_cast<std::uint16_t>(m.level),
                             static_cast<std::uint16_t>(m.format)});
      out.data.insert(out.data.end(), m.bytes.begin(), m.bytes.end());
    }
    indices.push_back(at->second);
  }
  return out.records.size() + indices.size();
}

/// The number of micro-triangles that became unknown; throws if one changed in any other way.
std::uint64_t resolved(const array::Built& b, const std::vector<PackedMap>& maps) {
  std::uint64_t changed = 0;
  for (std::size_t t = 0; t < maps.size(); ++t) {
    std::uint32_t code = 0;
    for (unsigned j = 4; j-- > 0;) code = code << 8 | b.part.indices[4 * t + j];
    const auto to =
        array::target(code, b.part.encoding, false, 0, static_cast<std::uint32_t>(b.array.records.size()));
    const std::uint64_t states = impl::micromap::micro_triangles(maps[t].level);
    for (std::uint64_t i = 0; i < states; ++i) {
      const auto state_at = [i](const std::uint8_t* bytes) { return bytes[i / 4] >> i % 4 * 2 & 3; };
      const int was = state_at(maps[t].bytes.data());
      const int is =
          to.kind == array::Target::Kind::special
              ? static_cast<int>(to.state)
              : state_at(b.array.data.data() + b.array.records[static_cast<std::size_t>(to.record)].offset);
      if (is != was && (was > 1 || is < 2))
        throw std::runtime_error("array: a triangle resolves to something else");
      changed += is != was ? 1 : 0;
    }
  }
  return changed;
}

ArrayFigures measured(Level level, const ArrayBenchOptions& options) {
  const std::vector<Bytes> bytes = made(level, options.triangles, options.seed);
  std::vector<PackedMap> maps;
  for (const Bytes& b : bytes) maps.push_back({level, Format::four_state, b});
  array::BuildOptions shared, all, merged;
  all.share = false;
  merged.bound = 4;
  const array::Built with = array::build({}, maps, shared), near = array::build({}, maps, merged);
  if (resolved(with, maps) != 0) throw std::runtime_error("array: sharing changed a state");
  ArrayFigures f;
  f.level = level;
  f.triangles = maps.size();
  f.records_all = array::build({}, maps, all).array.records.size();
  f.records_shared = with.array.records.size();
  f.records_merged = near.array.records.size();
  f.unknown_added = static_cast<double>(resolved(near, maps)) /
                    static_cast<double>(maps.size() * impl::micromap::micro_triangles(level));
  std::size_t kept = 0;
  const RoundTimes times =
      times_in_rounds({{maps.size(), [&] { kept += array::build({}, maps, shared).array.records.size(); }},
                       {maps.size(), [&] { kept += obvious(maps); }},
                       {maps.size(), [&] { kept += array::build({}, maps, merged).array.records.size(); }}},
                      options.rounds);
  if (kept == 0) throw std::runtime_error("array: nothing was built");
  f.shared_ns = median(times[0]);
  f.obvious_ns = median(times[1]);
  f.merged_ns = median(times[2]);
  f.obvious_over_shared = median_ratio(times[1], times[0]);
  return f;
}

}  // namespace

std::vector<ArrayFigures> array_figures(const ArrayBenchOptions& options) {
  if (options.first > options.last || options.last > 8 || options.rounds == 0 || options.triangles == 0)
    throw std::invalid_argument("array_figures: levels up to 8, rounds and triangles above 0");
  std::vector<ArrayFigures> all;
  for (Level n = options.first; n <= options.last; ++n) {
    if (options.progress) options.progress("level " + std::to_string(n));
    all.push_back(measured(n, options));
  }
  return all;
}

}  // namespace mmverify::bench
