#include <algorithm>

#include "impl/vq/two/search.hpp"
#include "impl/vq/two/sets.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq {

using namespace detail;

Encoded2 encode_optimal(const Map2& map) {
  const Vectors2 vectors = vectors_of(map);
  Sources sources{};
  std::array<std::uint32_t, 4> found{};  // vectors that are not uniform
  std::array<bool, entries> useful{};
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const Sets& v = vectors[vector];
    if (v.uniform()) continue;
    const std::uint32_t q = quadrant_of_vector(vector), place = found[q]++;
    sources.of_quadrant[q] += std::max(size(v.t), size(v.o));
    sources.all += std::max(size(v.t), size(v.o));
    for (std::uint32_t t = 0; t < (q == 0 ? 1 : 8); ++t) {
      const Sets as_stored = stored(t, v);
      for (Entry e = 0; e < entries; ++e) {
        const std::uint32_t kept = keeps(e, as_stored);
        useful[e] = useful[e] || kept > 0;
        for (std::uint32_t j = 0; j < kept; ++j)
          sources.kept[q][t][e] |= std::uint64_t{1} << (16 * j + place);
      }
    }
  }
  for (Entry e = 0; e < entries; ++e)
    if (useful[e]) sources.useful.push_back(e);
  return written(vectors, sources.useful.empty() ? Choice{} : best_choice(sources));
}

}  // namespace mmverify::impl::vq
