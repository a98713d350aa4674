// Right functions of std::pair, std::array and a lambda: as right_source.c.
#include <array>
#include <cstdint>
#include <utility>

extern "C" {
#include "examples/subject/subject.c"
}

static std::pair<std::uint32_t, std::uint32_t> pair_of(std::uint32_t x) { return {x & 0xffffu, x >> 16}; }
static std::array<std::uint32_t, 2> array_of(std::uint32_t x) {
  std::array<std::uint32_t, 2> a;
  a[0] = x & 0xffffu;
  a[1] = x >> 16;
  return a;
}

std::uint32_t of_pair(std::uint32_t level, float u, float v) {
  const auto p = pair_of(index_of(level, u, v));
  return p.first | p.second << 16;
}

std::uint32_t of_array(std::uint32_t level, float u, float v) {
  std::uint32_t index = 0, at = 0;
  const auto add = [&](std::uint32_t x) { index |= x << at, at += 16; };
  for (const std::uint32_t x : array_of(index_of(level, u, v))) add(x);
  return index;
}
