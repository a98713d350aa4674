// C programs at random that work on buffers: loops whose ends depend on data, pointers, copies, allocations, recursion.
#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/source/random_statements.hpp"

namespace mmverify::tests {

/// The function `uint64_t run(uint64_t x, uint64_t y)`, which is defined for all x and y.
class RandomBuffers : private RandomStatements {
 public:
  explicit RandomBuffers(std::uint64_t seed) : RandomStatements(seed, 2) {
    text_ = "static uint64_t run(uint64_t x, uint64_t y) {\n";
    text_ +=
        "  struct all s = {{1, 2, 3}, {4, 5}, {6}, {7, 8}, 9};\n  uint8_t other[16] = {3, 1, 4, 1, 5};\n";
    text_ +=
        "  uint64_t a0 = x, a1 = y, a2 = x * 0x9E3779B97F4A7C15u, a3 = 7, x0 = ~y, x1 = x - y, x2 = y << 56, "
        "x3 = y;\n";
    statements(9, 0, "  ");
    text_ += "  uint64_t sum = a0 ^ a1 * 3 ^ a2 * 5 ^ a3 * 7 ^ x0 ^ x1 << 1 ^ x2 << 2 ^ x3 << 3;\n";
    text_ += "  for (unsigned k = 0; k < 16; ++k) sum = sum * 31 + s.bytes[k] + (uint64_t)other[k] * 7;\n";
    text_ +=
        "  for (unsigned k = 0; k < 4; ++k) sum = sum * 17 + s.halves[k] + s.words[k] * 3u + s.longs[k];\n";
    text_ += "  return sum + (uint64_t)(int64_t)s.small;\n}\n";
  }
  std::string text() const { return head + text_; }

 private:
  static constexpr const char* head = R"(#include <stdint.h>
#include <stdlib.h>
#include <string.h>
struct all { uint8_t bytes[16]; uint16_t halves[4]; uint32_t words[4]; uint64_t longs[4]; int8_t small; };
static const uint8_t table[2][8] = {{1, 200, 3, 4, 50, 6, 7, 8}, {90, 1, 2, 3, 4, 5, 6, 7}};
static uint64_t deep(unsigned n, uint64_t v) { return n == 0 ? v + 1 : v & 1 ? deep(n - 1, v >> 1) + 3 : deep(n - 1, v * 5); }
static void walk(const uint8_t* from, uint8_t* to, unsigned n) {
  while (n-- > 0) {
    if (*from == 3) continue;
    *to++ = (uint8_t)(*from++ + n);
  }
}
static uint64_t by_value(struct all t) { t.bytes[1] ^= 7; t.small = 3; return t.bytes[1] + t.longs[0]; }
static uint64_t some(uint64_t n, uint64_t v) {
  uint8_t* p = malloc(n & 7);
  uint64_t sum = 0;
  for (unsigned k = 0; k < (n & 7); ++k) p[k] = (uint8_t)(v >> k);
  for (unsigned k = 0; k < (n & 7); ++k) sum = sum * 3 + p[k];
  free(p);
  return sum;
}
)";

  std::string condition() override {
    switch (random_.below(5)) {
      case 0: return fmt::format("({}) < ({})", word(), word());
      case 1: return fmt::format("(int64_t)({}) < (int64_t)({})", word(), word());
      case 2: return fmt::format("({}) & 1", word());
      case 3: return fmt::format("memcmp(s.bytes, other, ({}) & 15) > 0", word());
      default: return fmt::format("(int8_t)({}) <= s.small", word());
    }
  }
  std::string number() override { return word(); }
  std::string word() override {
    switch (random_.below(16)) {
      case 0: return fmt::format("({} + {})", a(), x());
      case 1: return fmt::format("({} - {})", x(), a());
      case 2: return fmt::format("({} & 0xffff) * ({} & 0xff)", a(), x());
      case 3: return fmt::format("({} >> ({} & 63))", a(), x());
      case 4: return fmt::format("({} << ({} & 7))", x(), a());
      case 5: return fmt::format("(uint64_t)((int64_t){} >> ({} & 31))", a(), a());
      case 6: return fmt::format("(uint64_t)s.bytes[{} & 15]", a());
      case 7: return fmt::format("(uint64_t)s.halves[{} & 3]", x());
      case 8: return fmt::format("s.longs[{} & 3] + s.words[{} & 3]", a(), x());
      case 9: return fmt::format("(uint64_t)table[{} & 1][{} & 7]", x(), a());
      case 10:
        return fmt::format("(({} & 255) {} (({} & 15) | 1))", a(), random_.below(2) == 0 ? "/" : "%", x());
      case 11:
        return fmt::format("(uint64_t)((int64_t)(int8_t){} {} ((int64_t)({} & 7) + 1))", a(),
                           random_.below(2) == 0 ? "/" : "%", x());
      case 12: return fmt::format("(uint64_t)__builtin_popcountll({})", a());
      case 13: return fmt::format("(uint64_t)__builtin_ctz((uint32_t){} | 16u)", x());
      case 14: return fmt::format("(uint64_t){}u", random_.below(300));
      default: return fmt::format("(({} ^ {}) | {})", a(), x(), a());
    }
  }
  bool has_further() const override { return true; }
  std::string further() override {
    switch (random_.below(13)) {
      case 0: return fmt::format("s.bytes[{} & 15] = (uint8_t)({});\n", a(), word());
      case 1: return fmt::format("s.words[{} & 3] = (uint32_t)({});\n", x(), word());
      case 2: return fmt::format("memcpy(other + ({} & 3), s.bytes, {} & 7);\n", a(), x());
      case 3: return fmt::format("memmove(s.bytes + ({} & 3), s.bytes + ({} & 3), {} & 7);\n", a(), x(), a());
      case 4: return fmt::format("memset(other, (int)({} & 255), {} & 15);\n", word(), x());
      case 5:
        return fmt::format("{{ uint8_t* p = {} ? s.bytes : other; p[{} & 7] ^= 5; }}\n", condition(), a());
      case 6: return fmt::format("{} = deep((unsigned)({} & 3), {});\n", a(), x(), a());
      case 7: return fmt::format("walk(s.bytes, other, (unsigned)({} & 7));\n", a());
      case 8: return fmt::format("if ({}) {} = some({}, {});\n", condition(), x(), a(), x());
      case 9:
        return fmt::format(
            "for (unsigned k = 0; k < ({} & 7); ++k) {{ if (k == ({} & 7)) break; {} += k + s.bytes[k]; }}\n",
            a(), x(), a());
      case 10:
        return fmt::format("{{ struct all t = s; t.small = (int8_t){}; if ({}) s = t; }}\n", a(),
                           condition());
      case 11: return fmt::format("{} += by_value(s) * 5 + s.bytes[1];\n", x());
      default: return fmt::format("memcpy(&{}, s.bytes + ({} & 7), 8);\n", x(), a());
    }
  }
};

}  // namespace mmverify::tests
