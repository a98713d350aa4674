#include "bench/vq/rivals/two_states.hpp"

#include <bit>

namespace mmverify::bench::rivals {

const char* to_string(Reading reading) {
  switch (reading) {
    case Reading::transparent: return "C is T";
    case Reading::opaque: return "C is O";
    case Reading::nearer: return "nearer";
    case Reading::even_hash: return "even hash";
    case Reading::vector_hash: break;
  }
  return "vector's hash";
}

std::uint32_t opaque_eighths(States map, std::uint32_t side, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t corner = (x & ~1u) + side * (y & ~1u);
  std::uint32_t eighths = 0;
  for (const std::uint32_t at : {corner, corner + 1, corner + side, corner + side + 1})
    eighths += static_cast<std::uint32_t>(map[at]);  // T 0, C 1, O 2
  return eighths;
}

std::uint32_t hit_hash(float u, float v) {
  const auto low = [](float a) { return std::bit_cast<std::uint32_t>(a) & 0xfff; };
  std::uint32_t h = low(u) | low(v) << 12;
  // The multiplier is 2^32 over the golden ratio, odd.  The low half of a product depends on low bits alone,
  // so the shift moves high bits down.
  for (int round = 0; round < 3; ++round) {
    h *= 0x9e3779b1;
    h ^= h >> 15;
  }
  return h;
}

bool opaque(States map, std::uint32_t side, float u, float v, Reading reading) {
  const auto x = static_cast<std::uint32_t>(u * static_cast<float>(side)),
             y = static_cast<std::uint32_t>(v * static_cast<float>(side));
  const State s = map[x + side * y];
  if (s != State::C) return s == State::O;
  switch (reading) {
    case Reading::transparent: return false;
    case Reading::opaque: return true;
    case Reading::nearer: return opaque_eighths(map, side, x, y) > 4;
    case Reading::even_hash: return hit_hash(u, v) < 1u << 31;
    case Reading::vector_hash: break;
  }
  return hit_hash(u, v) < std::uint64_t{opaque_eighths(map, side, x, y)} << 29;
}

}  // namespace mmverify::bench::rivals
