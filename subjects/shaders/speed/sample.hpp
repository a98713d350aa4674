// Compares a sample of what a kernel read and wrote with the library.
#pragma once

#include <cstdint>

#include "subjects/shaders/speed/lookups.hpp"
#include "subjects/shaders/speed/on_device.hpp"
#include "subjects/shaders/speed/speed.hpp"

namespace mmverify::shaders {

/// Compares blocks of neighbouring hits, evenly spread, the first and the last hit among them: the inputs with the hits'
/// definition, the answers with lookup.right. Returns the number of hits compared. Throws WrongAnswer.
/// Domain: hits a power of two, whose inputs and answers lie in the device's buffers.
std::uint64_t compare_sample(OnDevice& device, const Lookup& lookup, std::uint64_t hits, Order order);

/// The place of hit k of 2^log_hits, as kernels/inputs.glsl has it.
std::uint32_t place(std::uint32_t k, std::uint32_t log_hits, Order order);

}  // namespace mmverify::shaders
