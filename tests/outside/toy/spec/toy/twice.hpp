// Topic toy: numbers doubled.
#pragma once

#include <cstdint>

namespace mmverify::spec::toy {

/// 2k.
/// Domain: k < 2^31.
constexpr std::uint32_t twice(std::uint32_t k) { return 2 * k; }

}  // namespace mmverify::spec::toy
