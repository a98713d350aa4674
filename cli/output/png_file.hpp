// Pictures as PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cli/output/output_file.hpp"

namespace mmverify::cli {

/// Puts a picture of rows of RGB into its place.  Errors: as of scene::png() and OutputFile.
void commit_png(OutputFile& file, std::uint32_t width, std::uint32_t height,
                std::span<const std::uint8_t> rgb);

/// The check of a picture's name, for CLI11: a complaint if it does not end in .png, else empty.
std::string png_name(const std::string& name);

}  // namespace mmverify::cli
