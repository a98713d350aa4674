// The reference code that Khronos publishes, run as it stands in binary32.
#pragma once

#include <cstdint>

#include "proofs/engine/result.hpp"

namespace mmverify::proofs::index {

/// The index of (u, v): each operation rounded to nearest, none contracted; written apart from spec/index/index.hpp,
/// which is a template for all numbers.
///   u and v are clamped to [0, 1]; iu = trunc(uN), iv = trunc(vN) and their fractions uf, vf; iu and iv are kept below
///   N, iu lowered until iu + iv < N; the upper half of a square is uf + vf >= 1; then the curve's bits.
/// Domain: finite floats; n in 0..16.
/// Source: VK_EXT_opacity_micromap and VK_KHR_opacity_micromap, appendix "Reference Code".
std::uint32_t published(Level n, float u, float v);

}  // namespace mmverify::proofs::index
