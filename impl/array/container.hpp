// Arrays as files.  Both layouts are in docs/ARRAYS.md, "Files".
#pragma once

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

inline constexpr std::uint32_t newest_version = 2;

/// The file of a bundle.  Version 1 holds one part with indices of 32 bits, version 2 any; else std::invalid_argument,
/// as for a bundle whose counts do not fit 32 bits.
/// Law: array.files, array.files_on_samples
Bytes written(const Bundle& bundle, std::uint32_t version = newest_version);

/// The bundle of a file of either version.  The values are not checked: micromap::validate() does.
/// Domain: any bytes.  Bytes that written() cannot produce: std::invalid_argument, with the fault and its place.
/// Law: array.files, array.malformed_files
Bundle read(std::span<const std::uint8_t> file);

/// Whether the bytes begin with MMARRAYS, as such a file does.
/// Law: array.malformed_files
bool is_container(std::span<const std::uint8_t> file) noexcept;

}  // namespace mmverify::impl::array
