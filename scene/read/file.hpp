// Files and the GLB container, before anything in them is believed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mmverify::scene {

using Bytes = std::vector<unsigned char>;

/// Of what is read.  Sizes and offsets within it are below 2^31, so that the sum of two is no overflow.
inline constexpr std::uintmax_t largest_file = std::numeric_limits<std::int32_t>::max();

/// All of a file.  `place` is who asks for it, for the message.
/// Errors: BadScene where it is missing, no regular file (a pipe would block, a device never end), empty or
/// beyond 2^31 - 1 bytes.
Bytes read_file(const std::filesystem::path& path, const std::string& file, const std::string& place);

/// The same errors, without reading.  Returns the size.
std::uintmax_t check_file(const std::filesystem::path& path, const std::string& file,
                          const std::string& place);

/// The two parts of a glTF file.
struct Container {
  std::string json;
  std::optional<Bytes> binary;  ///< GLB's BIN chunk
};

/// Errors: BadScene where a GLB's header or chunks are not as glTF 2.0, 4.4 says.
Container split(std::span<const unsigned char> bytes, const std::string& file);

/// The path that a relative URI names, beside `file`: percent-decoded.
/// Errors: BadScene for a URI with a scheme, or an absolute one.
std::filesystem::path beside(const std::string& file, const std::string& uri, const std::string& place);

}  // namespace mmverify::scene
