// The header's entry points for square maps.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mmverify::tests::foreign::vq {

void vq2_decode(const std::uint8_t* block, std::uint8_t* map);
void vq2_region(const std::uint8_t* block, const std::uint32_t* x, const std::uint32_t* y,
                std::uint8_t* state, std::size_t count);
void vq2_encode(const std::uint8_t* map, std::uint8_t* block);
void vq4_decode(const std::uint8_t* block, std::uint8_t* map);
void vq4_region(const std::uint8_t* block, const std::uint32_t* x, const std::uint32_t* y,
                std::uint8_t* state, std::size_t count);
void vq4_encode(const std::uint8_t* map, std::uint8_t* block);

}  // namespace mmverify::tests::foreign::vq
