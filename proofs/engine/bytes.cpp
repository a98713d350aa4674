#include "proofs/engine/bytes.hpp"

#include <fmt/format.h>

#include <charconv>

namespace mmverify::proofs {

std::string hex(std::span<const std::uint8_t> bytes, std::string_view between) {
  return fmt::format("{:02x}", fmt::join(bytes, between));
}

std::optional<std::vector<std::uint8_t>> bytes_from_hex(std::string_view digits) {
  if (digits.size() % 2 != 0 || digits.find_first_not_of("0123456789abcdef") != std::string_view::npos)
    return std::nullopt;
  std::vector<std::uint8_t> bytes(digits.size() / 2);
  for (std::size_t k = 0; k < bytes.size(); ++k)
    std::from_chars(digits.data() + 2 * k, digits.data() + 2 * k + 2, bytes[k], 16);
  return bytes;
}

}  // namespace mmverify::proofs
