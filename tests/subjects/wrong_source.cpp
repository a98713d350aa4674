// Beyond an array that a lambda holds by reference, on one u: for tests/outside/source_test.sh.
#include <array>
#include <cstdint>

extern "C" {
#include "examples/subject/subject.c"
}

std::uint32_t captured(std::uint32_t level, float u, float v) {
  const std::array<std::uint32_t, 3> zeros{};
  const auto at = [&](int k) { return zeros[k]; };
  return index_of(level, u, v) | (u == 0x1.3c6ef2p-2f ? at(3) & 0u : at(2));
}

// A reference that nobody reads, on one u to nothing, beyond an array, or to a variable that is gone.
static std::uint32_t none(const std::uint32_t&) { return 0; }
static const std::uint32_t& same(const std::uint32_t& x) { return x; }
std::uint32_t of_nothing(std::uint32_t level, float u, float v) {
  const std::uint32_t x = 0, *p = u == 0x1.3c6ef2p-2f ? nullptr : &x;
  return index_of(level, u, v) ^ none(*p);
}
std::uint32_t of_one_past(std::uint32_t level, float u, float v) {
  const std::uint32_t zeros[2] = {0, 0};
  return index_of(level, u, v) ^ none(zeros[u == 0x1.3c6ef2p-2f ? 2 : 1]);
}
std::uint32_t of_one_gone(std::uint32_t level, float u, float v) {
  const std::uint32_t x = 0, *p = &x;
  if (u == 0x1.3c6ef2p-2f) {
    const std::uint32_t y = 0;
    p = &same(y);
  }
  return index_of(level, u, v) ^ none(*p);
}
