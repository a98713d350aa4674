// Arrays as files.  The layout of both versions is docs/ARRAYS.md's, "Files".
#pragma once

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

inline constexpr std::uint32_t newest_version = 2;

/// The file of a bundle.  Version 1 holds one part with indices of 32 bits, version 2 any; else std::invalid_argument,
/// as for a bundle whose counts do not fit 32 bits.
Bytes written(const Bundle& bundle, std::uint32_t version = newest_version);

/// The bundle of a file of either version.  What records and indices say is not judged: micromap::validate() does.
/// Domain: everything; what is no such file, byte for byte, is std::invalid_argument, which says what and where.
Bundle read(std::span<const std::uint8_t> file);

/// Whether bytes begin as such a file does.
bool is_container(std::span<const std::uint8_t> file) noexcept;

}  // namespace mmverify::impl::array
