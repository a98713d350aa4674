// The address modes of an axis: where an index lies, and from where on indices look alike.
#include "tests/foreign/bake/addressing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/bake/faults.hpp"

namespace mmverify::tests::foreign::bake {

Index wrapped(Index i, Index size, unsigned mode, bool along_u) {
  const auto modulo = [](Index a, Index n) { return ((a % n) + n) % n; };
  switch (mode) {
    case MMVERIFY_REPEAT:
      if (has(repeat_of_negatives)) return std::abs(i % size);
      if (has(repeat_by_mask)) return i & (size - 1);
      if (has(repeat_by_reciprocal)) {
        const float reciprocal = 1.0f / static_cast<float>(size);
        const Index r = i - size * static_cast<Index>(std::floor(static_cast<float>(i) * reciprocal));
        return std::clamp<Index>(r, 0, size - 1);
      }
      return modulo(i, size);
    case MMVERIFY_MIRRORED_REPEAT: {
      if (has(mirror_about_centre) && size > 1) {
        const Index k = modulo(i, 2 * size - 2);
        return k < size ? k : 2 * size - 2 - k;
      }
      if (has(mirror_parity_of_negatives) && i < -size) return modulo(i, size);
      const Index k = modulo(i, 2 * size);
      return k < size ? k : 2 * size - 1 - k;
    }
    case MMVERIFY_CLAMP_TO_EDGE: return std::clamp<Index>(i, 0, size - 1);
    case MMVERIFY_CLAMP_TO_BORDER:
      if (has(border_a_texel_late) && along_u && i == size) return size - 1;
      return i < 0 || i >= size ? -1 : i;
    default: {
      if (has(mirror_once_is_clamp_far) && i < -size) return 0;
      if (i < 0) i = has(mirror_once_negative) ? -i : -1 - i;
      return std::min(i, size - 1);
    }
  }
}

Range distinct(Index size, unsigned mode, bool nearest) {
  switch (mode) {
    case MMVERIFY_CLAMP_TO_EDGE: return nearest ? Range{0, size - 1} : Range{-1, size - 1};
    case MMVERIFY_CLAMP_TO_BORDER: return nearest ? Range{-1, size} : Range{-2, size};
    case MMVERIFY_MIRROR_CLAMP_TO_EDGE: return nearest ? Range{-size, size - 1} : Range{-size - 1, size - 1};
    default: return {-endless, endless};
  }
}
Index period(Index size, unsigned mode) {
  if (mode == MMVERIFY_MIRRORED_REPEAT && !has(interior_one_period)) return 2 * size;
  if (mode == MMVERIFY_MIRRORED_REPEAT || mode == MMVERIFY_REPEAT) return size;
  return endless;
}

}  // namespace mmverify::tests::foreign::bake
