// C programs at random, of all that a function in a source may have.
#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/source/random_statements.hpp"

namespace mmverify::tests {

/// Functions f0, f1, ... of two floats, and `all`, which takes the number of one of them for a level.
class RandomSource : private RandomStatements {
 public:
  RandomSource(std::uint64_t seed, unsigned functions) : RandomStatements(seed, 0) {
    for (unsigned k = 0; k < functions; ++k) function(k);
    text_ += "uint32_t all(uint32_t level, float u, float v) {\n  switch (level) {\n";
    for (unsigned k = 0; k < functions; ++k) text_ += fmt::format("    case {0}: return f{0}(u, v);\n", k);
    text_ += "  }\n  return 0;\n}\n";
    // A caller gets a narrow result as its type says.
    for (const char* type : narrow)
      text_ += fmt::format(
          "{0} all_{0}(uint32_t level, float u, float v) {{ return ({0})all(level, u, v); }}\n", type);
  }
  /// The types that the functions all_TYPE return.
  static constexpr const char* narrow[] = {"int8_t", "uint8_t", "int16_t", "uint16_t"};
  std::string text() const { return head + text_; }

 private:
  static constexpr const char* head = R"(#include <math.h>
#include <stdint.h>
#include <string.h>
static const uint32_t words[11] = {3, 1u << 31, 77, 0xffffffffu, 0, 5, 1234567, 0x80000001u, 9, 10, 11};
static const int8_t bytes[2][4] = {{1, -1, 127, -128}, {0, 5, -7, 64}};
static const float floats[5] = {0.5f, -3.25f, 0x1p-30f, 1e20f, 0x1.fffffep-1f};
static uint32_t bits(float x) { uint32_t b; memcpy(&b, &x, 4); return b; }
static float of_bits(uint32_t b) { float x; memcpy(&x, &b, 4); return x; }
struct pair { uint32_t x, y; };
struct mixed { uint8_t tag; uint32_t x; uint16_t y; };
struct large { uint32_t x[5]; float y; };
struct fields { uint32_t a : 5, b : 16, c : 11; };
union sizes { uint64_t all; float x; uint32_t words[2]; uint8_t bytes[8]; };
static struct pair paired(uint32_t x, uint32_t y) { struct pair p; p.y = y; p.x = x; return p; }
static uint32_t of_pair(struct pair p) { return p.x * 3u ^ p.y; }
static struct mixed mixed_of(uint32_t x, int with_y) {
  struct mixed m;
  m.x = x;
  if (with_y) m.y = (uint16_t)(x >> 7);
  return m;
}
static uint32_t of_mixed(struct mixed m, int with_y) { return with_y ? m.x + m.y : m.x; }
static struct large large_of(uint32_t x, float y) { struct large l; l.x[1] = x; l.x[4] = ~x; l.y = y; return l; }
static uint32_t of_large(struct large l) { return l.x[1] + (l.x[4] ^ bits(l.y)); }
static uint32_t second(uint32_t x, uint32_t y) {
  struct fields s;
  s.b = x & 0xffffu;
  struct fields t = s;
  t.c = y & 0x7ffu;
  return t.b * 5u ^ t.c;
}
static uint32_t lower(float x) { union sizes s; s.x = x; return (uint32_t)s.all; }
static uint32_t put_together(uint32_t x) {
  uint8_t b[8];
  for (int k = 0; k < 4; ++k) b[k] = (uint8_t)(x >> 8 * k);
  uint64_t w;
  memcpy(&w, b, 8);
  return (uint32_t)w << 3;
}
static uint32_t turned(uint32_t x) {
  uint32_t a[4], sum = 0;
  for (int k = 0; k < 4; ++k) a[k] = x >> 8 * k & 255u;
  for (int k = 3; k >= 0; --k) sum = sum << 4 ^ a[3 - k];
  return sum;
}
static int8_t narrow_i8(uint32_t x) { return (int8_t)x; }
static uint16_t narrow_u16(uint32_t x) { return (uint16_t)x; }
static int16_t narrow_i16(uint32_t x) { return (int16_t)x; }
uint32_t add_up_to(uint32_t, uint32_t) __asm__("llvm.uadd.sat.i32");
uint32_t less_down_to(uint32_t, uint32_t) __asm__("llvm.usub.sat.i32");
int32_t signed_up_to(int32_t, int32_t) __asm__("llvm.sadd.sat.i32");
int32_t signed_down_to(int32_t, int32_t) __asm__("llvm.ssub.sat.i32");
uint32_t word_up_to(float) __asm__("llvm.fptoui.sat.i32.f32");
)";

  std::string condition() final {
    switch (random_.below(6)) {
      case 0: return fmt::format("{} {} {}", x(), one_of({"<", "<=", ">", ">=", "==", "!="}), x());
      case 1: return fmt::format("{} < {}", x(), one_of({"0.5f", "0.25f", "0x1p-20f", "0.0f", "-1.0f"}));
      case 2: return fmt::format("{} {} {}", a(), one_of({"<", "<=", ">", "==", "!="}), a());
      case 3: return fmt::format("(int32_t){} {} (int32_t){}", a(), one_of({"<", "<=", ">", ">="}), a());
      case 4: return fmt::format("({} & 1)", a());
      default: return fmt::format("!({} >= {})", x(), x());
    }
  }

  std::string number() final {
    switch (random_.below(18)) {
      case 0: return fmt::format("{} + {}", x(), x());
      case 1: return fmt::format("{} - {}", x(), x());
      case 2: return fmt::format("{} * {}", x(), x());
      case 3:
        return fmt::format("{} * {}", x(),
                           one_of({"512.0f", "3.0f", "0.1f", "-0x1.fffffep3f", "0x1p-130f", "1e30f"}));
      case 4: return fmt::format("1.0f - {}", x());
      case 5:
        return fmt::format("{}({})", one_of({"fabsf", "floorf", "ceilf", "truncf", "rintf", "roundf"}), x());
      case 6: return fmt::format("-{}", x());
      case 7: return fmt::format("{} ? {} : {}", condition(), x(), x());
      case 8: return fmt::format("(float){}", a());
      case 9: return fmt::format("(float)(int32_t){}", a());
      case 10: return fmt::format("fmaf({}, {}, {})", x(), x(), x());
      case 11: return fmt::format("(float)((double){} * (double){} + (double){})", x(), x(), x());
      case 12: return fmt::format("{} / {}", x(), one_of({"8.0f", "0x1p-3f", "-2.0f"}));
      case 13: return fmt::format("of_bits({} & 0xbfffffffu)", a());
      case 14: return fmt::format("copysignf({}, {})", x(), x());
      case 15: return fmt::format("floats[{} % 5]", a());
      case 16: return fmt::format("{}({}, {})", one_of({"fminf", "fmaxf"}), x(), x());
      default: return fmt::format("{} - (float)(int32_t)({} * 4.0f)", x(), one_of({"u", "v"}));
    }
  }

  std::string word() final {
    const std::uint64_t kind = random_.below(35);
    return kind >= 22 ? word_of_call(kind) : word_of_operator(kind);
  }

  /// Calls of the functions above, and of two that compilers know.
  std::string word_of_call(std::uint64_t kind) {
    switch (kind) {
      case 22: return fmt::format("of_pair(paired({}, {}))", a(), a());
      case 23: return fmt::format("paired({}, {}).{}", a(), a(), one_of({"x", "y"}));
      case 24: {
        const std::string with = condition();
        return fmt::format("of_mixed(mixed_of({}, {}), {})", a(), with, with);
      }
      case 25: return fmt::format("of_large(large_of({}, {}))", a(), x());
      case 26: return fmt::format("second({}, {})", a(), a());
      case 27: return fmt::format("lower({})", x());
      case 28: return fmt::format("{}({})", one_of({"put_together", "turned"}), a());
      case 29: return fmt::format("(uint32_t){}({})", one_of({"narrow_i8", "narrow_u16", "narrow_i16"}), a());
      case 30: return fmt::format("{}({}, {})", one_of({"add_up_to", "less_down_to"}), a(), a());
      case 31:
        return fmt::format("(uint32_t){}((int32_t){}, (int32_t){})",
                           one_of({"signed_up_to", "signed_down_to"}), a(), a());
      case 32: return fmt::format("__builtin_elementwise_{}({}, {})", one_of({"min", "max"}), a(), a());
      case 33:
        return fmt::format("(uint32_t)__builtin_elementwise_{}((int32_t){}, (int32_t){})",
                           one_of({"min", "max"}), a(), a());
      default: {
        const std::string y = x();
        return fmt::format("{0} == {0} ? word_up_to({0}) : 3u", y);
      }
    }
  }

  std::string word_of_operator(std::uint64_t kind) {
    switch (kind) {
      case 0: return fmt::format("{} {} {}", a(), one_of({"+", "-", "*", "&", "|", "^"}), a());
      case 1:
        return fmt::format("{} {} {}", a(), one_of({"+", "-", "*", "&", "|", "^"}),
                           one_of({"1u", "0x55555555u", "77u", "0x80000000u"}));
      case 2: return fmt::format("{} {} ({} & 31)", a(), one_of({"<<", ">>"}), a());
      case 3: return fmt::format("{} {} {}", a(), one_of({"<<", ">>"}), one_of({"1", "4", "8", "17", "31"}));
      case 4: return fmt::format("(uint32_t)((int32_t){} >> ({} & 31))", a(), a());
      case 5: return fmt::format("{} ? {} : {}", condition(), a(), a());
      case 6: {
        const std::string y = x();
        return fmt::format("{0} >= 0 && {0} < 4294967040.0f ? (uint32_t){0} : 7", y);
      }
      case 7: {
        const std::string y = x();
        return fmt::format("fabsf({0}) < 2147483000.0f ? (uint32_t)(int32_t){0} : 9", y);
      }
      case 8: return fmt::format("(uint32_t)({} * 100.0f)", one_of({"u", "v"}));
      case 9: return fmt::format("words[{} % 11]", a());
      case 10: return fmt::format("(uint32_t)bytes[{} & 1][{} & 3]", a(), a());
      case 11: return fmt::format("(uint32_t)__builtin_clz({} | 1)", a());
      case 12: return fmt::format("(uint32_t)__builtin_ctz({} | 0x80000000u)", a());
      case 13:
        return fmt::format(
            "{}({})", one_of({"__builtin_bswap32", "__builtin_bitreverse32", "(uint32_t)__builtin_popcount"}),
            a());
      case 14: {
        const std::string b = a(), k = a();
        return fmt::format("({0} << ({1} & 31)) | ({0} >> (-{1} & 31))", b, k);
      }
      case 15: return fmt::format("(uint32_t)(((uint64_t){} * {}) >> 32)", a(), a());
      case 16: return fmt::format("(uint32_t)({})(uint8_t){}", one_of({"int8_t", "uint8_t"}), a());
      case 17: return fmt::format("(uint32_t)(int32_t)(int16_t){}", a());
      case 18: return fmt::format("{} {} ({} | 1)", a(), one_of({"/", "%"}), a());
      case 19:
        return fmt::format("(uint32_t)((int32_t){} {} (int32_t)(({} & 0xffff) | 1))", a(), one_of({"/", "%"}),
                           a());
      case 20: return fmt::format("bits({})", x());
      default: return fmt::format("({}) + ({}) * 2u", condition(), condition());
    }
  }

  /// A variable that is set where it is used, and not elsewhere.
  bool has_further() const final { return true; }
  std::string further() final {
    const std::string set = condition(), to = a();
    return fmt::format("{{ int c = {}; uint32_t late; if (c) late = {}; {} ^= c ? late * 3u : 5u; }}\n", set,
                       word(), to);
  }

  void function(unsigned number) {
    text_ += fmt::format("static uint32_t f{}(float u, float v) {{\n", number);
    text_ += "  float x0 = u, x1 = v, x2 = u - v, x3 = 0.3f;\n";
    text_ += fmt::format("  uint32_t a0 = {}u, a1 = (uint32_t)(u * 1000.0f), a2 = bits(v), a3 = {}u;\n",
                         random_.below(1u << 30), random_.below(10));
    statements(7, 0, "  ");
    // Each function has the operations that are rare by chance: a sum that wraps, an order of words, a floor below 0. A bit-field is in
    // every other one: a mistake in its shifts reads bits that are never set, so the whole result is undefined
    // and differs from nothing.
    text_ += fmt::format("  a1 += {} ^ of_pair(paired(a1, a3)) ^ lower(x0);\n",
                         number % 2 == 0 ? "second(a0, a2)" : "a0 >> 5 ^ a2");
    text_ +=
        "  a0 += a1 * 3u + (a2 < a3 ? 17u : 0u) + (uint32_t)(int32_t)floorf((u - v) * 8.3f) * 19u;\n"
        "  return a0 ^ a2 * 5u ^ a3 * 7u ^ bits(x0) ^ bits(x1) * 9u ^ bits(x2) * 11u ^ bits(x3) * 13u;\n}\n";
  }
};

}  // namespace mmverify::tests
