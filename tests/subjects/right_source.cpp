// Right functions of std::pair, std::array and a lambda: as right_source.c.
#include <algorithm>
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

// References of std::min and std::max, and iterators over a constant array.
static constexpr std::array<std::uint32_t, 3> zeros{};
std::uint32_t of_references(std::uint32_t level, float u, float v) {
  const float x = std::max(u, 0.0f), y = std::min(std::max(v, 0.0f), 1.0f);
  std::uint32_t sum = 0;
  for (const std::uint32_t& zero : zeros) sum += zero;
  return index_of(level, x, y) + sum + zeros.back();
}
