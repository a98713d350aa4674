// How settings of a texture are written, by their values.
#pragma once

#include <array>

namespace mmverify::proofs::attribute {

inline constexpr std::array<const char*, 5> wrap_names{"repeat", "mirror", "clamp", "border", "mirror-once"};
inline constexpr std::array<const char*, 2> filter_names{"bilinear", "nearest"};
inline constexpr std::array<const char*, 4> meaning_names{"linear", "srgb", "normal", "normal+length"};

}  // namespace mmverify::proofs::attribute
