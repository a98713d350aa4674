#include "scene/attribute/equal_error.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mmverify::scene {

BytesAtError bytes_at_error(std::span<const BytesAndError> sizes, double error) {
  const bool fine =
      !sizes.empty() && error >= 0 &&
      std::all_of(sizes.begin(), sizes.end(), [](const auto& s) { return s.bytes > 0 && s.error >= 0; }) &&
      std::is_sorted(sizes.begin(), sizes.end(),
                     [](const auto& a, const auto& b) { return a.bytes > b.bytes; });
  if (!fine) throw std::invalid_argument("bytes_at_error: sizes from most to fewest bytes, errors from 0 on");
  if (error == sizes.back().error) return {AmongSizes::within, sizes.back().bytes};
  if (error > sizes.back().error) return {AmongSizes::coarsest_is_closer, 0};
  for (std::size_t k = sizes.size() - 1; k-- > 0;) {
    const BytesAndError &finer = sizes[k], &coarser = sizes[k + 1];
    if (finer.error > error) continue;
    const double t =
        finer.error == 0 ? 0 : std::log(error / finer.error) / std::log(coarser.error / finer.error);
    return {AmongSizes::within, finer.bytes * std::pow(coarser.bytes / finer.bytes, t)};
  }
  return {AmongSizes::finest_is_farther, 0};
}

}  // namespace mmverify::scene
