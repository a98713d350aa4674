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

/// Whether a relative name, with /, stays in the folder that it starts from.
bool stays_within(const std::string& name);

/// The path of a name that stays within the folder of `file`.
/// Errors: BadScene where a link leads out of that folder: what is read may end up in what is written.
std::filesystem::path in_folder_of(const std::string& file, const std::string& name,
                                   const std::string& place);

/// The path that a relative URI names, in the folder of `file` or below it: percent-decoded.
/// Errors: BadScene for a URI with a scheme, an absolute one, and one that leaves the folder, by its name or by a link.
std::filesystem::path beside(const std::string& file, const std::string& uri, const std::string& place);

}  // namespace mmverify::scene
