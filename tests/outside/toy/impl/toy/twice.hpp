// Topic toy: numbers doubled, fast.
#pragma once

#include <cstdint>

namespace mmverify::impl::toy {

/// 2k.
/// Domain: k < 2^31.
/// Law: toy.doubles
constexpr std::uint32_t twice(std::uint32_t k) { return k << 1; }

}  // namespace mmverify::impl::toy
