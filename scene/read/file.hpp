// Readers of files and of the GLB container, which trust nothing in them.
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

/// The largest file that is read.  Sizes and offsets within it are below 2^31, so that the sum of two does
/// not overflow.
inline constexpr std::uintmax_t largest_file = std::numeric_limits<std::int32_t>::max();

/// All bytes of a file.  `place` names the reader, for the message.
/// Errors: BadScene if it is missing, not a regular file (a pipe would block, a device never end), empty or
/// beyond 2^31 - 1 bytes.
Bytes read_file(const std::filesystem::path& path, const std::string& file, const std::string& place);

/// The size of a file, with the same errors, without reading.
std::uintmax_t check_file(const std::filesystem::path& path, const std::string& file,
                          const std::string& place);

/// The two parts of a glTF file.
struct Container {
  std::string json;
  std::optional<Bytes> binary;  ///< GLB's BIN chunk
};

/// Splits a glTF file into its parts.  Errors: BadScene if a GLB's header or chunks break glTF 2.0, 4.4.
Container split(std::span<const unsigned char> bytes, const std::string& file);

/// Whether a relative name, with /, stays in the folder that it starts from.
bool stays_within(const std::string& name);

/// The path of a name that stays within the folder of `file`.
/// Errors: BadScene if a link leads out of that folder, since the bytes that are read may end up in a written
/// file.
std::filesystem::path in_folder_of(const std::string& file, const std::string& name,
                                   const std::string& place);

/// The path that a relative URI names, percent-decoded, in the folder of `file` or below it.
/// Errors: BadScene for a URI with a scheme, an absolute URI, and a URI that leaves the folder by its name or
/// by a link.
std::filesystem::path beside(const std::string& file, const std::string& uri, const std::string& place);

}  // namespace mmverify::scene
