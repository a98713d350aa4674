// The times of mips of maps and of levels of detail.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "bench/attribute/bench.hpp"
#include "bench/attribute/points.hpp"
#include "bench/rounds.hpp"
#include "impl/attribute/mip.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::attribute;
using Words = std::vector<std::uint32_t>;

constexpr std::uint32_t highest_base = 10;

Words random_words(std::size_t count, std::mt19937_64& random) {
  Words words(count);
  for (std::uint32_t& x : words) x = static_cast<std::uint32_t>(random());
  return words;
}

/// Computes the means of four children byte by byte, halves rounded up.
void plain_mip(const std::uint32_t* children, std::size_t parents, std::uint32_t* out) {
  for (std::size_t k = 0; k < parents; ++k) {
    std::uint32_t word = 0;
    for (int shift = 0; shift < 32; shift += 8) {
      std::uint32_t sum = 2;
      for (std::size_t c = 0; c < 4; ++c) sum += children[4 * k + c] >> shift & 0xff;
      word |= sum / 4 << shift;
    }
    out[k] = word;
  }
}

void plain_chain(const Words& base, std::uint32_t level, Words& chain) {
  const std::uint32_t* from = base.data();
  for (std::uint32_t m = level; m-- > 0;) {
    std::uint32_t* const to = chain.data() + fast::face_chain_size(m);
    plain_mip(from, std::size_t{1} << 2 * m, to);
    from = to;
  }
}

/// Makes the map of level n-1 from that of level n: it has every other vertex.
template <fast::VertexOrder order>
void vertex_mip(const Words& map, std::uint32_t level, Words& out) {
  for (std::uint32_t k = 0; k < out.size(); ++k)
    out[k] = map[fast::vertex_mip_source(order, k, level - 1, level)];
}

MipLevel mips_of(std::uint32_t level, const AttributeBenchOptions& o) {
  std::mt19937_64 random(o.seed + 200 + level);
  const Words base = random_words(std::size_t{1} << 2 * level, random),
              vertices = random_words(fast::vertex_count(level), random);
  Words mip(base.size() / 4), chain(fast::face_chain_size(level)), coarser(fast::vertex_count(level - 1));
  std::vector<std::string> names;
  std::vector<Work> works;
  const auto add = [&](const char* name, std::size_t elements, std::function<void()> pass) {
    names.push_back(name);
    works.push_back({elements, std::move(pass)});
  };
  add("mip, in plain bytes", base.size(), [&] { plain_mip(base.data(), mip.size(), mip.data()); });
  constexpr std::pair<const char*, fast::Rounding> roundings[] = {
      {"mip, half up", fast::Rounding::half_up},
      {"mip, half to even", fast::Rounding::half_to_even},
      {"mip, truncate", fast::Rounding::truncate},
      {"mip, halves up", fast::Rounding::halves_up}};
  for (const auto& [name, rounding] : roundings)
    add(name, base.size(), [&, rounding = rounding] { fast::face_mip(base, rounding, mip); });
  add("chain, in plain bytes", base.size(), [&] { plain_chain(base, level, chain); });
  add("chain, half up", base.size(),
      [&] { fast::face_chain(level, base, fast::Rounding::half_up, fast::ChainOf::level_above, chain); });
  add("chain, of exact sums", base.size(),
      [&] { fast::face_chain(level, base, fast::Rounding::half_up, fast::ChainOf::exact_sums, chain); });
  add("vertices taken out, W-minor", vertices.size(),
      [&] { vertex_mip<fast::VertexOrder::w_minor>(vertices, level, coarser); });
  add("vertices taken out, U-major", vertices.size(),
      [&] { vertex_mip<fast::VertexOrder::u_major>(vertices, level, coarser); });
  const RoundTimes times = times_in_rounds(works, o.rounds);
  MipLevel result{level, {}};
  for (std::size_t k = 0; k < names.size(); ++k)
    result.ways.push_back({names[k], median(times[k]), median_ratio(times[0], times[k])});
  return result;
}

/// The formula as it is printed, in binary32.  Source: Color and Attribute Micromaps, 4.4.2.
std::uint32_t level_by_log(float cone, float triangle, std::uint32_t n) {
  const float half = std::floor(0.5f * std::log2(triangle / cone));
  return static_cast<std::uint32_t>(std::clamp(half, 0.0f, static_cast<float>(n)));
}

struct Areas {
  std::vector<float> cone, triangle;
};

/// Areas around 4^m cone = triangle: exactly on it, or a step or two of binary32 below.
Areas stiff_areas(std::size_t count, std::uint32_t level, std::mt19937_64& random) {
  Areas areas;
  for (std::size_t k = 0; k < count; ++k) {
    const float cone = 1 + static_cast<float>(random() % (1 << 23)) / static_cast<float>(1 << 23);
    float triangle = std::ldexp(cone, static_cast<int>(2 * (random() % (level + 1))));
    for (std::uint64_t steps = random() % 3; steps > 0; --steps) triangle = std::nextafter(triangle, 0.0f);
    areas.cone.push_back(cone);
    areas.triangle.push_back(triangle);
  }
  return areas;
}

}  // namespace

std::vector<MipLevel> attribute_mips(const AttributeBenchOptions& o) {
  std::vector<MipLevel> levels;
  for (std::uint32_t level = std::max(1u, o.first); level <= std::min(highest_base, o.last); ++level) {
    if (o.progress) o.progress("mips of level " + std::to_string(level));
    levels.push_back(mips_of(level, o));
  }
  return levels;
}

std::vector<LodFigure> attribute_lods(const AttributeBenchOptions& o) {
  if (o.progress) o.progress("levels of detail");
  constexpr std::size_t count = points_timed;
  constexpr std::uint32_t n = 8;
  std::mt19937_64 random(o.seed + 300);
  const Areas areas = stiff_areas(count, n, random);
  std::vector<fast::Level> levels(count);
  std::vector<float> blends(count);
  const std::vector<Work> works{{count,
                                 [&] {
                                   for (std::size_t k = 0; k < count; ++k)
                                     levels[k] = level_by_log(areas.cone[k], areas.triangle[k], n);
                                 }},
                                {count,
                                 [&] {
                                   for (std::size_t k = 0; k < count; ++k)
                                     levels[k] = fast::lod_level(areas.cone[k], areas.triangle[k], n);
                                 }},
                                {count, [&] { fast::lod_level(areas.cone, areas.triangle, n, levels); }},
                                {count, [&] {
                                   for (std::size_t k = 0; k < count; ++k) {
                                     const fast::Lod lod = fast::lod(areas.cone[k], areas.triangle[k], n);
                                     levels[k] = lod.level;
                                     blends[k] = lod.blend;
                                   }
                                 }}};
  const RoundTimes times = times_in_rounds(works, o.rounds);
  std::vector<LodFigure> figures{{"1/2 log2(A_t / A_c) in binary32", 0, o.samples, 0},
                                 {"ours, level", 0, o.samples, 0},
                                 {"ours, level, batched", 0, o.samples, 0},
                                 {"ours, level and blend", 0, o.samples, 0}};
  for (std::size_t k = 0; k < figures.size(); ++k) figures[k].ns = median(times[k]);
  const Areas judged = stiff_areas(static_cast<std::size_t>(o.samples), n, random);
  for (std::size_t k = 0; k < judged.cone.size(); ++k) {
    const float cone = judged.cone[k], triangle = judged.triangle[k];
    // The greatest m with 4^m cone <= triangle; both sides are exact.
    fast::Level right = 0;
    while (right < n && std::ldexp(cone, static_cast<int>(2 * (right + 1))) <= triangle) ++right;
    figures[0].wrong += level_by_log(cone, triangle, n) != right ? 1 : 0;
    figures[1].wrong += fast::lod_level(cone, triangle, n) != right ? 1 : 0;
    figures[3].wrong += fast::lod(cone, triangle, n).level != right ? 1 : 0;
  }
  std::vector<fast::Level> batched(judged.cone.size());
  fast::lod_level(judged.cone, judged.triangle, n, batched);
  for (std::size_t k = 0; k < batched.size(); ++k)
    figures[2].wrong += batched[k] != fast::lod_level(judged.cone[k], judged.triangle[k], n) ? 1 : 0;
  return figures;
}

}  // namespace mmverify::bench
