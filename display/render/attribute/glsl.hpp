// GLSL's types and functions in C++, as far as subjects/shaders/attribute_api.glsl needs them, so that both read one text.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace mmverify::render::glsl {

using uint = std::uint32_t;

struct vec2 {
  float x, y;
  vec2(float a, float b) : x(a), y(b) {}
};

struct vec3 {
  float x, y, z;
  vec3() : x(0), y(0), z(0) {}
  vec3(float a, float b, float c) : x(a), y(b), z(c) {}
};
inline vec3 operator-(const vec3& a, const vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vec3 cross(const vec3& a, const vec3& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
inline float length(const vec3& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

struct vec4 {
  float x, y, z, w;
  vec4() : x(0), y(0), z(0), w(0) {}
  vec4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {}
};
inline vec4 operator+(const vec4& a, const vec4& b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
inline vec4 operator*(float s, const vec4& a) { return {s * a.x, s * a.y, s * a.z, s * a.w}; }

struct ivec2 {
  int x, y;
  ivec2(uint a, uint b) : x(static_cast<int>(a)), y(static_cast<int>(b)) {}
  ivec2(int a, uint b) : x(a), y(static_cast<int>(b)) {}
};

struct uvec2 {
  uint x, y;
  uvec2() : x(0), y(0) {}
  uvec2(uint a, uint b) : x(a), y(b) {}
};
inline uvec2& operator+=(uvec2& a, const uvec2& b) {
  a.x += b.x;
  a.y += b.y;
  return a;
}
inline uvec2 operator<<(const uvec2& a, uint by) { return {a.x << by, a.y << by}; }

struct uvec3 {
  uint x, y, z;
  uvec3(uint a, uint b, uint c) : x(a), y(b), z(c) {}
};

inline uint min(uint a, uint b) { return std::min(a, b); }
// Both functions return the first argument if either is NaN, as in GLSL.
inline float min(float a, float b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
inline float clamp(float x, float low, float high) { return min(max(x, low), high); }
inline float abs(float x) { return std::fabs(x); }
inline float tan(float x) { return std::tan(x); }
inline float log2(float x) { return std::log2(x); }
/// Domain of both: not 0.
inline int findLSB(uint x) { return std::countr_zero(x); }
inline int findMSB(uint x) { return 31 - std::countl_zero(x); }
inline uint floatBitsToUint(float x) { return std::bit_cast<uint>(x); }
inline float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }

}  // namespace mmverify::render::glsl
