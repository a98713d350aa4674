// Functions at random that are GLSL and C at once: the C side defines GLSL's names.
#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/source/random_statements.hpp"

namespace mmverify::tests {

/// Functions f0, f1, ... of two floats, and `all`, which takes the number of one of them for a level.
class RandomShader : private RandomStatements {
 public:
  RandomShader(std::uint64_t seed, unsigned functions) : RandomStatements(seed, 1) {
    for (unsigned k = 0; k < functions; ++k) function(k);
    text_ += "uint all(uint level, float u, float v) {\n  switch (level) {\n";
    for (unsigned k = 0; k < functions; ++k) text_ += fmt::format("    case {0}u: return f{0}(u, v);\n", k);
    text_ += "  }\n  return 0u;\n}\n";
  }
  std::string glsl() const { return std::string(glsl_head) + common + text_; }
  std::string c() const { return std::string(c_head) + common + text_; }

 private:
  static constexpr const char* glsl_head = R"(
#define OF_TWO(a, b) vec2(a, b)
#define OF_THREE(a, b, c) vec3(a, b, c)
#define TABLE(name) const uint name[7] = uint[7](3u, 0x80000000u, 77u, 0xffffffffu, 0u, 5u, 1234567u)
#define BOTH(f, p, q) f(p, q)
#define HALVE(x) fract(x)
#define uint_of(x) uint(x)
#define word_of(x) uint(x)
#define float_of(x) float(x)
#define PAIR Pair
)";
  static constexpr const char* c_head = R"(#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
typedef uint32_t uint;
typedef float vec2 __attribute__((ext_vector_type(2)));
typedef float vec3 __attribute__((ext_vector_type(3)));
#define OF_TWO(a, b) ((vec2){a, b})
#define OF_THREE(a, b, c) ((vec3){a, b, c})
#define TABLE(name) static const uint name[7] = {3u, 0x80000000u, 77u, 0xffffffffu, 0u, 5u, 1234567u}
#define BOTH(f, p, q) ((vec2){f((p).x, (q).x), f((p).y, (q).y)})
#define HALVE(x) ((x) - floorf(x))
#define uint_of(x) ((uint)(x))
#define word_of(x) ((uint)(x))
#define float_of(x) ((float)(x))
#define PAIR struct Pair
#define floor floorf
#define ceil ceilf
#define trunc truncf
#define roundEven rintf
#define abs(x) fabsf(x)
static uint floatBitsToUint(float x) { uint b; memcpy(&b, &x, 4); return b; }
static float uintBitsToFloat(uint b) { float x; memcpy(&x, &b, 4); return x; }
static uint umin(uint a, uint b) { return a < b ? a : b; }
static uint umax(uint a, uint b) { return a < b ? b : a; }
#define min(a, b) _Generic((a), float: fminf, default: umin)(a, b)
#define max(a, b) _Generic((a), float: fmaxf, default: umax)(a, b)
#define clamp(a, b, c) min(max(a, b), c)
static float step(float edge, float x) { return x < edge ? 0 : 1; }
static int bitCount(uint x) { return __builtin_popcount(x); }
static int findMSB(uint x) { return x == 0 ? -1 : 31 - __builtin_clz(x); }
static int findLSB(uint x) { return x == 0 ? -1 : __builtin_ctz(x); }
static uint bitfieldReverse(uint x) { return __builtin_bitreverse32(x); }
static uint bitfieldExtract(uint x, int at, int count) {
  return count == 0 ? 0 : x << (32 - count - at) >> (32 - count);
}
static uint bitfieldInsert(uint x, uint y, int at, int count) {
  uint mask = count == 0 ? 0 : 0xffffffffu >> (32 - count) << at;
  return (x & ~mask) | (count == 0 ? 0 : y << at & mask);
}
)";
  // NaN has many bits, and which of 0 and -0 is the lesser is left open.
  static constexpr const char* common = R"(
uint bits(float x) { return x != x || x == 0.0f ? 7u : floatBitsToUint(x); }
uint whole(float x) { return x >= 0.0f && x < 4294967040.0f ? uint_of(x) : 9u; }
struct Pair { float a; uint b; };
)";

  std::string condition() final {
    switch (random_.below(5)) {
      case 0: return fmt::format("{} {} {}", x(), one_of({"<", "<=", ">", ">=", "==", "!="}), x());
      case 1: return fmt::format("{} < {}", x(), one_of({"0.5f", "0.25f", "0.0f", "-1.0f"}));
      case 2: return fmt::format("{} {} {}", a(), one_of({"<", "<=", ">", ">=", "==", "!="}), a());
      case 3: return fmt::format("({} < {} && {} {} {})", x(), x(), a(), one_of({"<", ">"}), a());
      default: return fmt::format("(({} & 1u) != 0u || !({} >= {}))", a(), x(), x());
    }
  }

  std::string number() final {
    switch (random_.below(14)) {
      case 0: return fmt::format("{} {} {}", x(), one_of({"+", "-", "*"}), x());
      case 1:
        return fmt::format("{} * {}", x(),
                           one_of({"512.0f", "3.0f", "0.1f", "-15.9375f", "1e-30f", "1e30f"}));
      case 2: return fmt::format("1.0f - {}", x());
      case 3: return fmt::format("{}({})", one_of({"abs", "floor", "ceil", "trunc", "roundEven"}), x());
      case 4: return fmt::format("-{}", x());
      case 5: return fmt::format("{} ? {} : {}", condition(), x(), x());
      case 6: return fmt::format("float_of({})", a());
      case 7: return fmt::format("HALVE({})", x());
      case 8: return fmt::format("uintBitsToFloat({} & 0xbfffffffu)", a());
      case 9: return fmt::format("{}({}, {})", one_of({"min", "max", "step"}), x(), x());
      case 10:
        return fmt::format("clamp({}, {}, {})", x(), one_of({"0.0f", "-0.25f"}), one_of({"0.5f", "1.0f"}));
      case 11: return fmt::format("OF_THREE({}, {}, {}).{}", x(), x(), x(), one_of({"x", "y", "z"}));
      case 12:
        return fmt::format("(OF_THREE({}, {}, {}).{} * OF_TWO({}, {})).{}", x(), x(), x(),
                           one_of({"yx", "zy", "xz", "yz"}), x(), x(), one_of({"x", "y"}));
      default:
        return fmt::format("BOTH({}, OF_TWO({}, {}), OF_TWO({}, {})).{}", one_of({"min", "max"}), x(), x(),
                           x(), x(), one_of({"x", "y"}));
    }
  }

  std::string word() final {
    switch (random_.below(15)) {
      case 0: return fmt::format("{} {} {}", a(), one_of({"+", "-", "*", "&", "|", "^"}), a());
      case 1:
        return fmt::format("{} {} {}", a(), one_of({"+", "*", "&", "^"}),
                           one_of({"1u", "0x55555555u", "77u", "0x80000000u"}));
      case 2: return fmt::format("{} {} ({} & 31u)", a(), one_of({"<<", ">>"}), a());
      case 3: return fmt::format("~{}", a());
      case 4: return fmt::format("{} ? {} : {}", condition(), a(), a());
      case 5: return fmt::format("whole({})", x());
      case 6: return fmt::format("bits({})", x());
      case 7: return fmt::format("{}({}, {})", one_of({"min", "max"}), a(), a());
      case 8: return fmt::format("clamp({}, 5u, 0x7fffffffu)", a());
      case 9: return fmt::format("table[{} % 7u]", a());
      case 10: return fmt::format("{} {} ({} | 1u)", a(), one_of({"/", "%"}), a());
      case 11: return fmt::format("word_of({}({}))", one_of({"bitCount", "findMSB", "findLSB"}), a());
      case 12: return fmt::format("bitfieldReverse({})", a());
      case 13: return fmt::format("bitfieldExtract({}, {}, {})", a(), random_.below(17), random_.below(16));
      default:
        return fmt::format("bitfieldInsert({}, {}, {}, {})", a(), a(), random_.below(17), random_.below(16));
    }
  }

  bool has_further() const final { return true; }
  std::string further() final {
    if (random_.below(2) == 0) {
      // A variable that is set where it is used, and not elsewhere: spirv-opt makes OpUndef of it.
      const std::string set = condition(), to = a();
      return fmt::format("{{ bool c = {}; uint late; if (c) late = {}; {} ^= c ? late * 3u : 5u; }}\n", set,
                         word(), to);
    }
    const std::string from = x(), with = a();
    return fmt::format("pair.a = {}; pair.b ^= {}; {} += pair.b;\n", from, with, a());
  }

  void function(unsigned number) {
    text_ += fmt::format("uint f{}(float u, float v) {{\n  TABLE(table);\n", number);
    text_ += "  float x0 = u, x1 = v, x2 = u - v, x3 = 0.3f;\n";
    text_ += fmt::format("  uint a0 = {}u, a1 = whole(u * 1000.0f), a2 = bits(v), a3 = {}u;\n",
                         random_.below(1u << 30), random_.below(10));
    text_ += "  PAIR pair;\n  pair.a = 0.5f;\n  pair.b = 11u;\n";
    statements(7, 0, "  ");
    text_ += "  bool c = u > v; uint late; if (c) late = a0 * 3u; a1 += c ? late : 5u;\n";
    // Each function has the operations that are rare by chance. The product keeps the shuffle: glslang makes one extraction of .yx.x.
    text_ +=
        "  a0 += float_of(a2) < 2147483648.0f ? 1u : 2u;\n"
        "  a1 ^= table[a3 % 7u] + word_of(findMSB(a2 | 2u)) + bits((OF_THREE(x0, x1, x2).yx * OF_TWO(3.0f, "
        "0.5f)).x);\n"
        "  a3 += bits(clamp(u - v, 0.125f, 0.5f));\n"
        "  return a0 ^ a1 * 3u ^ a2 * 5u ^ a3 * 7u ^ bits(x0) ^ bits(x1) * 9u ^ bits(x2) * 11u ^ bits(x3) * "
        "13u ^\n"
        "         bits(pair.a) * 17u;\n}\n";
  }
};

}  // namespace mmverify::tests
