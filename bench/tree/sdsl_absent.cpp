// Stands in for sdsl.cpp in a build without sdsl: the constructor throws the reason.
#include <stdexcept>

#include "bench/tree/sdsl.hpp"

namespace mmverify::bench {

struct SdslTree::Sequences {};

SdslTree::SdslTree(impl::tree::Level, impl::tree::Format, std::span<const std::uint8_t>) {
  throw std::runtime_error(
      "bench tree compares with sdsl, which this build leaves out, as its licence is the GPL: build mmverify "
      "from its sources, or name the other topics");
}
SdslTree::~SdslTree() = default;
SdslTree::SdslTree(SdslTree&&) noexcept = default;
SdslTree& SdslTree::operator=(SdslTree&&) noexcept = default;

// No tree can be made, so these are never called.
std::uint8_t SdslTree::operator[](std::uint32_t) const { return 0; }
void SdslTree::lookup(std::span<const SdslTree>, std::span<const std::uint32_t>,
                      std::span<const std::uint32_t>, std::span<std::uint8_t>) {}
std::uint8_t SdslTree::chain(std::span<const SdslTree>, std::span<const std::uint32_t>,
                             std::span<const std::uint32_t>) {
  return 0;
}
std::uint64_t SdslTree::bits() const { return 0; }
std::size_t SdslTree::lines(std::uint32_t) const { return 0; }

}  // namespace mmverify::bench
