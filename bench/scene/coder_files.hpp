// Files that go in and out of programs that compress textures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/attribute/texture_coder.hpp"

namespace mmverify::bench {

/// Writes a file.  Errors: std::runtime_error if the disk is full.
void write_file(const std::string& path, const std::vector<unsigned char>& bytes);

/// The colours of a picture that a program wrote.  Errors: std::runtime_error if it is no picture, or of
/// another size than its source.
std::vector<std::uint8_t> rgb_of_png(const std::string& path, const scene::TexturePixels& pixels,
                                     const std::string& program);

/// Checks the size of a file.  Errors: std::runtime_error if the file has another size, or is missing.
void expect_size(const std::string& file, std::uint64_t bytes, const std::string& program);

}  // namespace mmverify::bench
