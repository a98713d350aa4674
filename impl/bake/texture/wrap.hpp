// The texels that indices mean beyond a texture's edges.
#pragma once

#include <algorithm>
#include <cstdint>

namespace mmverify::impl::bake {

/// Source: Vulkan, "Wrapping Operation"; mirror_once is its MIRROR_CLAMP_TO_EDGE.
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge, clamp_to_border, mirror_once };

namespace detail {

/// k mod n, not below 0.  Domain: n > 0.
constexpr std::int64_t modulo(std::int64_t k, std::int64_t n) noexcept {
  const std::int64_t r = k % n;
  return r < 0 ? r + n : r;
}

}  // namespace detail

/// The texel of a row of n that index i means, or -1 for the border.
///   repeat i mod n; mirrored n-1 - mirror(i mod 2n - n); mirror once: clamp(mirror(i)), mirror(k) = k or,
///   below 0, -(1+k)
/// Domain: n in 1..2^31, |i| < 2^62.
/// Test: impl_bake_parts_test
constexpr std::int64_t wrapped(Wrap wrap, std::int64_t i, std::int64_t n) noexcept {
  if (i >= 0 && i < n) return i;
  switch (wrap) {
    case Wrap::repeat: return detail::modulo(i, n);
    case Wrap::mirrored_repeat: {
      const std::int64_t k = detail::modulo(i, 2 * n);
      return k < n ? k : 2 * n - 1 - k;
    }
    case Wrap::clamp_to_border: return -1;
    case Wrap::mirror_once: return std::min(i < 0 ? -1 - i : i, n - 1);
    case Wrap::clamp_to_edge: break;
  }
  return i < 0 ? 0 : n - 1;
}

namespace detail {

/// The indices of an axis that mean distinct texels: those below `first` mean the same as first, those beyond `last`
/// the same as last.  With a period, k and k + period mean the same, and first and last are beyond all indices.
struct Extent {
  std::int64_t first, last;
  std::int64_t period;  ///< 0: none

  constexpr bool ends() const noexcept { return period == 0; }
};

/// The extent of an axis of n texels.  Domain: n in 1..2^31.
constexpr Extent extent(Wrap wrap, std::int64_t n) noexcept {
  constexpr std::int64_t beyond = std::int64_t{1} << 61;
  switch (wrap) {
    case Wrap::repeat: return {-beyond, beyond, n};
    case Wrap::mirrored_repeat: return {-beyond, beyond, 2 * n};
    case Wrap::clamp_to_border: return {-1, n, 0};
    case Wrap::mirror_once: return {-n, n - 1, 0};
    case Wrap::clamp_to_edge: break;
  }
  return {0, n - 1, 0};
}

/// The texels that the indices [from, to] mean together: at most two runs, ends included, and perhaps the border.
struct Runs {
  int count = 0;
  bool border = false;
  std::int64_t from[2] = {}, to[2] = {};

  constexpr void add(std::int64_t low, std::int64_t high) noexcept {
    from[count] = low;
    to[count++] = high;
  }
};

/// The texels that the indices [from, to] mean.  Domain: from <= to, n in 1..2^31, sizes below 2^62.
constexpr Runs runs(Wrap wrap, std::int64_t from, std::int64_t to, std::int64_t n) noexcept {
  Runs r;
  const std::int64_t last = n - 1;
  if (from >= 0 && to <= last) {
    r.add(from, to);
    return r;
  }
  switch (wrap) {
    case Wrap::repeat: {
      const std::int64_t a = modulo(from, n), b = a + (to - from);
      if (to - from >= last) {
        r.add(0, last);
      } else if (b <= last) {
        r.add(a, b);
      } else {
        r.add(a, last);
        r.add(0, b - n);
      }
      break;
    }
    case Wrap::mirrored_repeat: {
      // The period is 2n: [0, n) forward, [n, 2n) backward.  A run without a turn stays a run; a run over one turn
      // starts or ends at the texture's edge; a run over two turns is everything.
      const std::int64_t a = modulo(from, 2 * n), b = a + (to - from);
      if (a < n) {
        if (b < n)
          r.add(a, b);
        else if (b < 2 * n)
          r.add(std::min(a, 2 * n - 1 - b), last);
        else
          r.add(0, last);
      } else if (b < 2 * n) {
        r.add(2 * n - 1 - b, 2 * n - 1 - a);
      } else if (b < 3 * n) {
        r.add(0, std::max(2 * n - 1 - a, b - 2 * n));
      } else {
        r.add(0, last);
      }
      break;
    }
    case Wrap::clamp_to_edge:
      r.add(std::clamp<std::int64_t>(from, 0, last), std::clamp<std::int64_t>(to, 0, last));
      break;
    case Wrap::mirror_once: {
      const std::int64_t a = from >= 0 ? from : to < 0 ? -1 - to : 0;
      const std::int64_t b = from >= 0 ? to : std::max(to, -1 - from);
      r.add(std::min(a, last), std::min(b, last));
      break;
    }
    case Wrap::clamp_to_border:
      r.border = true;
      if (to >= 0 && from <= last) r.add(std::max<std::int64_t>(from, 0), std::min(to, last));
      break;
  }
  return r;
}

}  // namespace detail
}  // namespace mmverify::impl::bake
