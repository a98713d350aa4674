#include "proofs/bake/packed.hpp"

namespace mmverify::proofs::bake {
namespace {

std::size_t bits_of(Format format) { return static_cast<std::size_t>(format); }

}  // namespace

std::size_t packed_bytes(Level n, Format format) {
  return ((std::size_t{1} << 2 * n) * bits_of(format) + 7) / 8;
}

std::vector<std::uint8_t> packed(const std::vector<State>& states, Format format) {
  const std::size_t bits = bits_of(format);
  std::vector<std::uint8_t> bytes((states.size() * bits + 7) / 8);
  for (std::size_t k = 0; k < states.size(); ++k)
    bytes[k * bits / 8] =
        static_cast<std::uint8_t>(bytes[k * bits / 8] | static_cast<unsigned>(states[k]) << k * bits % 8);
  return bytes;
}

Baked unpacked(std::span<const std::uint8_t> bytes, Level n, Format format) {
  const std::size_t bits = bits_of(format), count = std::size_t{1} << 2 * n;
  const auto state = [&](std::size_t k) { return bytes[k * bits / 8] >> k * bits % 8 & ((1u << bits) - 1); };
  Baked baked;
  for (std::size_t k = 0; k < count; ++k) baked.states.push_back(static_cast<State>(state(k)));
  for (std::size_t k = count; k * bits < 8 * bytes.size(); ++k) baked.padded = baked.padded && state(k) == 0;
  return baked;
}

}  // namespace mmverify::proofs::bake
