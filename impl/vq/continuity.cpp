#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq {
namespace {

/// The number of discontinuous vectors, of side x side regions each, in a map of 8 side x 8 side.
template <std::uint32_t side, class Map>
std::uint32_t discontinuous(const Map& map) {
  std::uint32_t vectors = 0;
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const std::uint32_t corner = vector % 8 * side + 8 * side * (vector / 8 * side);
    bool any = false;
    for (std::uint32_t y = 0; y + 1 < side; ++y)
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        bool o = false, t = false;
        for (const std::uint32_t at : {0u, 1u, 8 * side, 8 * side + 1}) {
          const State s = map[corner + x + 8 * side * y + at];
          o = o || s == State::O;
          t = t || s == State::T;
        }
        any = any || (o && t);
      }
    vectors += any ? 1 : 0;
  }
  return vectors;
}

}  // namespace

std::uint32_t discontinuous_vectors(const Map2& map) { return discontinuous<2>(map); }
std::uint32_t discontinuous_vectors(const Map4& map) { return discontinuous<4>(map); }

}  // namespace mmverify::impl::vq
