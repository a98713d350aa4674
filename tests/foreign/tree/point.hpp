// The index of a point.
#pragma once

#include <cstdint>

namespace mmverify::tests::foreign::tree {

/// Vulkan's index of (u, v); its one sum is asked so that nothing rounds: 1 - u is exact in binary64 unless u is
/// below 2^-29, and then no binary32 number below 1 reaches it, rounded or not.
std::uint32_t index_of(unsigned level, float u, float v);

}  // namespace mmverify::tests::foreign::tree
